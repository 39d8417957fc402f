#!/usr/bin/env python3
"""What walls that move do to the speed of a ball: fermi.py CAROM [--long]

Wall that comes nearer at the speed u, another at rest: after the n-th hit of it v_n = v_0 + 2 n u, and it is met at
x_n = x_1 (v_0 + u) / (v_0 + (2 n - 1) u), as x_(n+1) / x_n = (v_n - u) / (v_n + u).

Fermi-Ulam model: a wall displaced by a sin(omega t) at the distance L from one at rest. Near a speed v the hits are a standard map with
K = 4 a L omega^2 / v^2, so up to K = 0.9716 speeds wander, and the invariant curve near v_b = 2 omega sqrt(a L / 0.9716) bounds them from
below and from above [LichtenbergLieberman1992, sec. 3.4]. Points that start below: their largest speed, to 25 %. Points that
start at 2 v_b: their spread, below 5 %.

Sinai box whose disk swings by a sin(omega t) along x: chaos makes the phases of hits random, and no curve bounds the speed. A hit at the
normal speed c of a wall at the speed w gains (c + 2 w)^2 - c^2, and comes at a rate c + w, so on average 8 <w^2>, where a fixed wall
with kicks gains half of that [Karlis2006]. With normals of all directions <w^2> = (a omega)^2 / 4, the gain in v^2 has the variance
(8 / 3) (v a omega)^2, and with k hits of the disk a length flown, k = 2 R / |Q|,
    <v^2> = v_0^2 + 2 A (v_0 t + A t^2 / 3),   A = k (a omega)^2.
Measured over 10000 points, `--long` 100000, with the standard error of the sample; bounds: 4 of these, and 5 % of the growth.
"""
from study import *


def staircase():
    head("wall at -u, u", "hits of it", "speed", "v_0 + 2 n u", "off, relative", "place, off")
    for u, n in ((0.01, 1000), (0.01, 100_000), (1e-5, 100_000)):
        scene = f"""
            dimension = 1
            [[wall]]
            kind = "plane"
            point = [0]
            normal = [1]
            [[wall]]
            kind = "plane"
            point = [1]
            normal = [-1]
            velocity = [-{u}]
            [[ball]]
            position = [0.5]
            velocity = [1]
            radius = 0
            """
        ball = run(scene, events=2 * n - 1, final=True)["final"][0]
        known = 1 + 2 * n * u
        first = 1 - u * 0.5 / (1 + u)
        place = first * (1 + u) / (1 + (2 * n - 1) * u)
        speed, at = abs(ball["velocity"][0]), ball["position"][0]
        row(u, n, repr(speed), repr(known), f"{speed / known - 1:.0e}", f"{at / place - 1:.0e}")
        within("the speed", speed, known, 1e-12 * known)
        within("the place", at, place, 1e-9 * place)


def speeds(start, hits):
    """Of 10 points in the Fermi-Ulam model, each at 2000 times: the least and the largest."""
    seen = []
    for k in range(10):
        scene = f"""
            dimension = 1
            [[wall]]
            kind = "plane"
            point = [0]
            normal = [1]
            [[wall]]
            kind = "plane"
            point = [1]
            normal = [-1]
            oscillation = {{ amplitude = [0.001], omega = 1 }}
            [[ball]]
            position = [{(k + 0.5) / 11}]
            velocity = [{start}]
            radius = 0
            [run]
            sample_every = {hits / 2000 / max(start, 0.04)}
            [output]
            trajectory = "trajectory.csv"
            """
        out = folder("ulam")
        run(scene, events=hits, out=out)
        seen += [abs(float(r["vx"])) for r in rows(out / "trajectory.csv")]
    return min(seen), max(seen)


def ulam():
    bound = 2 * math.sqrt(0.001 / 0.9716)
    hits = 2_000_000 if LONG else 200_000
    print(f"\nv_b = {bound:.5f}\n")
    head("start", "hits of each", "least", "largest", "largest / v_b")
    least, most = speeds(0.01, hits)
    row("0.01", hits, f"{least:.5f}", f"{most:.5f}", f"{most / bound:.3f}")
    within("the largest speed over v_b", most / bound, 1, 0.25)
    least, most = speeds(2 * bound, hits)
    row(f"{2 * bound:.5f}", hits, f"{least:.5f}", f"{most:.5f}", f"{most / bound:.3f}")
    within("the spread beyond v_b", (most - least) / (2 * bound), 0, 0.05)


def growth():
    a, omega, radius, count, until = 0.00002, 1000, 0.35, 100_000 if LONG else 10_000, 400
    scene = f"""
        [space]
        kind = "box"
        lower = [0, 0]
        upper = [1, 1]
        [[wall]]
        kind = "circle"
        centre = [0.5, 0.5]
        radius = {radius}
        side = "outside"
        oscillation = {{ amplitude = [{a}, 0], omega = {omega} }}
        [[gas]]
        count = {count}
        radius = 0
        speed = 1
        """
    rate = 2 * radius / (1 - math.pi * radius**2) * (a * omega) ** 2
    print(f"\nA = {rate:.4e}\n")
    head("time", "<v^2> - 1", "error", "known", "a fixed wall, kicked")
    for t in (until / 4, until):
        final = run(scene, until=t, final=True)["final"]
        value, error = mean([sum(x * x for x in ball["velocity"]) for ball in final])
        known = 2 * rate * (t + rate * t * t / 3)
        row(t, f"{value - 1:.4f}", f"{error:.4f}", f"{known:.4f}", f"{known / 2:.4f}")
        within("the growth of the energy", value - 1, known, max(0.05 * known, 4 * error), error)


def main():
    staircase()
    ulam()
    growth()
    end()


if __name__ == "__main__":
    main()
