#!/usr/bin/env python3
"""Boundary maps of four tables, as pictures, and the share of them that chaos fills: portraits.py CAROM [--long]

Arclength over the length of the boundary, and the sine of the angle of incidence; the map keeps the area. Draws NAME.png beside
this file with gnuplot (package gnuplot-nox), 40 points to a table, each orbit in its colour, and those of a chaotic sea in grey:

ellipse    semi-axes 2 and 1: every orbit stays on a curve L1 L2 = constant; rotation outside of the separatrix, libration inside
stadium    half circles of radius 1, straights of length 2: one orbit fills all [Bunimovich1979]
mushroom   cap of radius 1, stem of half width w = 0.25: whatever comes to the stem is chaotic, and the rest, with angular momentum
           above w about the middle of the cap, regular [Bunimovich2001]. Regular are |sine| > w of the arc, and |sine| < sqrt(1 - w^2 / x^2)
           of the shoulders at distance x from the middle, so of the area 2 |dQ|
               2 pi (1 - w) + 4 (sqrt(1 - w^2) - w arccos w)
cardioid   r = 1 + cos theta: one orbit fills all [Wojtkowski1986]

Then one orbit of 4e6 collisions, `--long` 4e7, on a grid of 200 by 200 cells, `--long` 400 by 400; in the cardioid a twentieth of the
collisions and half the cells a side. Exit status 1 if the share of the cells that it comes to is off by more than 2 over the cells a
side, 4 in the ellipse, where a curve crosses so many.
"""
from study import *

W = 0.25
REGULAR = 2 * math.pi * (1 - W) + 4 * (math.sqrt(1 - W * W) - W * math.acos(W))
BOUNDARY = math.pi + 2 * (1 - W) + 2 + 2 * W
TABLES = {
    "ellipse": ('kind = "ellipse"\naxes = [2, 1]', 0.0, [0.3, 0.2]),
    "stadium": ('kind = "stadium"\nradius = 1\nlength = 2', 1.0, [0.3, 0.2]),
    "mushroom": ('kind = "mushroom"\ncap_radius = 1\nstem_width = 0.5\nstem_length = 1', 1 - REGULAR / (2 * BOUNDARY), [0.1, -0.5]),
    "cardioid": ('kind = "cardioid"\nscale = 1', 1.0, [0.8, 0.3]),
}
CHAOTIC = {"ellipse": lambda walls: False, "mushroom": lambda walls: walls & {"2", "3", "4"}}  # left side, foot, right side
DRAW = """
set terminal pngcairo size 720,440 font "sans,11"
set output '%s.png'
set xrange [0:1]; set yrange [-1:1]
set xlabel 'arclength / length'; set ylabel 'sine of the angle of incidence'
unset key
plot '%s' using 1:2:3 with dots lc rgb variable
"""


def colour(k):
    """Far apart for successive k."""
    hue = 6 * ((k * 0.61803) % 1)
    part = [min(max(abs((hue + shift) % 6 - 3) - 1, 0), 1) for shift in (0, 4, 2)]
    return sum(int(190 * p) << s for p, s in zip(part, (16, 8, 0)))


def picture(name, keys, length):
    out = folder(name)
    run(f"[[table]]\n{keys}\n[[gas]]\ncount = 40\nradius = 0\nspeed = 1\nseed = 2\n", "observe.boundary_map={}", events=24000, out=out)
    seen, walls = [], {}
    for r in rows(out / "boundary_map.csv"):
        seen.append((float(r["arclength"]) / length, float(r["sine"]), r["ball"]))
        walls.setdefault(r["ball"], set()).add(r["wall"])
    chaotic = CHAOTIC.get(name, lambda walls: True)
    shade = {ball: 0x999999 if chaotic(met) else colour(int(ball)) for ball, met in walls.items()}
    data = out / "dots.txt"
    data.write_text("".join(f"{s:.5f} {p:.5f} {shade[ball]}\n" for s, p, ball in seen))
    subprocess.run(["gnuplot"], input=DRAW % (HERE / name, data), text=True, check=True)


def perimeter(name):
    return {"ellipse": 9.688448220547675, "stadium": 2 * math.pi + 4, "mushroom": BOUNDARY, "cardioid": 8}[name]


def main():
    head("table", "share that one orbit fills", "exact", "collisions", "cells")
    for name, (keys, share, start) in TABLES.items():
        picture(name, keys, perimeter(name))
        bins, count = (400, 40_000_000) if LONG else (200, 4_000_000)
        if name == "cardioid":
            bins, count = bins // 2, count // 20
        seen = run(f"[[table]]\n{keys}\n[[ball]]\nposition = {start}\nvelocity = [0.6, 0.8]\nradius = 0\n",
                   f"observe.phase_space_portion={{ bins = {bins} }}", events=count)["observed"]["phase_space_portion"]
        filled = seen["value"]
        row(name, f"{filled:.4f}", f"{share:.4f}", f"{count / 1e6:g}e6", f"{bins} x {bins}")
        within(f"the share filled in the {name}", filled, share, 4 / bins if name == "ellipse" else 2 / bins)
    end()


if __name__ == "__main__":
    main()
