#!/usr/bin/env python3
"""Diffusion in the triangular Lorentz gas against the distance of the disks: diffusion.py CAROM [--long]

A point at speed 1 among disks of radius 1, the distance d of their centres below 4 / sqrt 3, where no straight line is free. Between
three disks there is a trap of area Q = sqrt(3) d^2 / 4 - pi / 2 with three gaps w = d - 2; a stay in it lasts pi Q / (3 w) on average,
exactly. A point that forgets meanwhile how it came walks at random from trap to trap, d / sqrt 3 a step, so as w -> 0
    D -> w d^2 / (4 pi Q)                                                        [MachtaZwanzig1983].
Measured: the slope of the mean square displacement over lags of 4 to 8 stays, D of that over 6 to 12 beside it.

2e6 collisions a spacing, `--long` 2e7. Exit status 1 if the two differ by more than 4 standard errors, or if the ratio to the walk is
off 1 at the smallest gap by more than 4 standard errors or, with `--long`, 0.1.
"""
from study import *

COUNT = 20_000_000 if LONG else 2_000_000


def coefficient(d, lags):
    """The slope over the second half of so many lags of an eighth of a stay; its error; the formula of the walk."""
    area = math.sqrt(3) * d * d / 4 - math.pi / 2
    stay = math.pi * area / (3 * (d - 2))
    seen = run(f"""
        [[table]]
        kind = "lorentz"
        lattice = "triangular"
        spacing = {d}
        radius = 1
        [[ball]]
        position = [{d / 2}, {math.sqrt(3) * d / 6}]
        velocity = [0.6, 0.8]
        radius = 0
        """, f"observe.diffusion={{ every = {stay / 8}, lags = {lags} }}", events=COUNT)["observed"]["diffusion"]["coefficient"]
    return seen["value"], seen["error"], (d - 2) * d * d / (4 * math.pi * area)


def main():
    head("d", "D", "error", "at longer lags", "error", "walk", "D / walk", "error")
    ratios = []
    for d in (2.01, 2.025, 2.05, 2.1, 2.15, 2.2, 2.25, 2.3):
        value, error, walk = coefficient(d, 64)
        later, later_error, _ = coefficient(d, 96)
        ratios.append((value / walk, error / walk))
        row(d, f"{value:.5f}", f"{error:.5f}", f"{later:.5f}", f"{later_error:.5f}", f"{walk:.5f}", f"{value / walk:.3f}",
            f"{error / walk:.3f}")
        within("D at longer lags", later, value, math.inf, math.hypot(error, later_error))
    within("D over that of the walk", ratios[0][0], 1, 0.1 if LONG else math.inf, ratios[0][1])
    end()


if __name__ == "__main__":
    main()
