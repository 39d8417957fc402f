#!/usr/bin/env python3
"""Height of a ball dropped at restitution 1, bounce after bounce: drop.py CAROM [--quick]

`carom compare` ended at the moments of rest at the top, t_k = 2 k sqrt(2 h / g): there the energy error, over m g h, is
the change of height over h. It has no sign; the sign shown is that of the mean kinetic energy against the exact run's, up
to the last bounce. Writes drop.csv beside this file. Exit status 1 if the exact run does not come back to its height.
"""
import math
import sys

from study import ENGINES, QUICK, built, compare, name, number, save, table

HEIGHT, GRAVITY = 5.0, 9.81
BOUNCES = (1, 5, 20) if QUICK else (1, 2, 3, 5, 7, 10, 14, 20)
STEPS = (1 / 60, 1 / 240, 1 / 1000)


def main():
    names = ["discrete", "discrete:correction=none", "discrete:correction=baumgarte", "swept", "speculative", "penalty",
             *built(ENGINES)]
    heights, signs, saved = {}, {}, []
    good = True
    for k in BOUNCES:
        run = compare("drop.toml", STEPS, names, until=2 * k * math.sqrt(2 * HEIGHT / GRAVITY))
        good &= run["exact"]["energy"]["relative_error"] < 1e-12 and run["exact"]["events"]["ball_wall"] == k
        for row in run["rows"]:
            key = name(row), row["dt"]
            mean = row["averages"]
            heights[key, k] = row["energy_error"]
            signs[key] = mean["stepper"]["kinetic_energy"] - mean["exact"]["kinetic_energy"]
    for key, sign in signs.items():
        for k in BOUNCES:
            saved.append((*key, k, heights[key, k], 1 + math.copysign(heights[key, k], sign)))
    save("drop.csv", ("method", "dt", "bounce", "energy_error", "height"), saved)
    shown = [k for k in BOUNCES if k in (1, 5, 10, 20)]
    table(["method", "dt"] + [f"after {k}" for k in shown],
          [[n, f"1/{round(1 / dt)}"] + [("+" if sign > 0 else "-") + number(100 * heights[(n, dt), k]) + " %" for k in shown]
           for (n, dt), sign in signs.items()])
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
