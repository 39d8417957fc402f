#!/usr/bin/env python3
"""Diffusion in the triangular Lorentz gas against the distance of the disks: diffusion.py CAROM [--long]

A point at speed 1 among disks of radius 1, the distance d of their centres below 4 / sqrt 3, where no straight line is free. Between three disks
there is a trap of area Q = sqrt(3) d^2 / 4 - pi / 2 with three gaps w = d - 2; a point that has forgotten how it came leaves at the rate
3 w / (pi Q), to a trap d / sqrt 3 away, so
    D = d^2 / (12 pi Q / (3 w)) = w d^2 / (4 pi Q)                                [MachtaZwanzig1983]
as w -> 0. Measured: the slope of the mean square displacement over lags of 12 to 24 stays in a trap, and beside it the integral of the
autocorrelation of the velocity up to 12 stays (Green and Kubo), from the same orbit.

1e6 collisions a spacing, `--long` 2e7. Exit status 1 if the two values differ by more than 4 standard errors, or if a straight line
in w through the ratios to the formula is off 1 at w = 0 by more than 4 standard errors, `--long` also by more than 3 %.
"""
from study import *

COUNT = 20_000_000 if LONG else 1_000_000


def main():
    head("d", "D", "error", "from velocities", "error", "traps", "D / traps")
    ratios = []
    for d in (2.025, 2.05, 2.1, 2.15, 2.2, 2.25, 2.3):
        w, area = d - 2, math.sqrt(3) * d * d / 4 - math.pi / 2
        traps, stay = w * d * d / (4 * math.pi * area), math.pi * area / (3 * w)
        height = math.sqrt(3) * d / 6
        seen = run(f"""
            [[table]]
            kind = "lorentz"
            lattice = "triangular"
            spacing = {d}
            radius = 1
            [[ball]]
            position = [{d / 2}, {height}]
            velocity = [0.6, 0.8]
            radius = 0
            """, f"observe.diffusion={{ every = {stay / 4}, lags = 96 }}",
            f"observe.velocity_autocorrelation={{ every = {stay / 40}, lags = 480 }}", events=COUNT, out=folder("diffusion"))["observed"]
        slope = seen["diffusion"]["coefficient"]
        kubo = seen["velocity_autocorrelation"]["diffusion"]
        ratios.append((w, slope["value"] / traps, slope["error"] / traps))
        row(d, f"{slope['value']:.5f}", f"{slope['error']:.5f}", f"{kubo['value']:.5f}", f"{kubo['error']:.5f}", f"{traps:.5f}",
            f"{slope['value'] / traps:.4f}")
        within("the coefficient from velocities", kubo["value"], slope["value"], math.inf, math.hypot(slope["error"], kubo["error"]))
    weights = [1 / e**2 for _, _, e in ratios]
    s0, s1, s2 = (math.fsum(k * w**p for k, (w, _, _) in zip(weights, ratios)) for p in range(3))
    y0, y1 = (math.fsum(k * r * w**p for k, (w, r, _) in zip(weights, ratios)) for p in range(2))
    limit, error = (s2 * y0 - s1 * y1) / (s0 * s2 - s1 * s1), math.sqrt(s2 / (s0 * s2 - s1 * s1))
    print(f"\nD / traps as the gap closes, by a straight line in w: {limit:.4f} +- {error:.4f}.")
    within("D / traps as the gap closes", limit, 1, 0.03 if LONG else math.inf, error)
    end()


if __name__ == "__main__":
    main()
