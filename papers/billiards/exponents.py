#!/usr/bin/env python3
"""Lyapunov spectrum of the triangular Lorentz gas against the distance of the disks: exponents.py CAROM [--long]

Exponents in units of speed over radius. Gaspard and Baras give the largest to +-0.2 [GaspardBaras1995]; the column "other code"
is from an independent program. 1e6 collisions a distance, `--long` 1e7. Prints a table. Exit status 1 if the largest exponent is off by
more than 1 % and 4 standard errors, the free path by more than 5e-4 and 4, or the spectrum is not (l, 0, 0, -l) to 1e-3 l.
"""
from study import *

OTHER = {2.3: (1.7594, 3e-4), 2.5: (1.3432, 4e-4), 3.0: (0.8553, 8e-4), 3.5: (0.6253, 3e-4), 4.0: (0.4888, 3e-4)}
PUBLISHED = {2.5: 1.4, 3.0: 0.8, 3.5: 0.6, 4.0: 0.5}


def main():
    head("distance", "l_0", "error", "other code", "[GaspardBaras1995]", "l_1", "l_2", "l_0 + l_3", "free path", "error", "exact")
    for distance, (other, other_error) in OTHER.items():
        height = math.sqrt(3) * distance
        seen = run(HERE / "lorentz.toml", f"space.upper=[{distance!r}, {height!r}]",
                   f"ball.0.position=[{distance / 2!r}, {(height / 2 - 1) / 2!r}]", f"ball.2.position=[{distance / 2!r}, {height / 2!r}]",
                   "observe.lyapunov=true", "observe.mean_free_path=true", events=10_000_000 if LONG else 1_000_000)["observed"]
        l = [e["value"] for e in seen["lyapunov"]["exponents"]]
        error, path = seen["lyapunov"]["exponents"][0]["error"], seen["mean_free_path"]
        exact = (math.sqrt(3) * distance**2 / 2 - math.pi) / 2
        row(distance, f"{l[0]:.5f}", f"{error:.5f}", f"{other}({other_error * 1e4:.0f})", PUBLISHED.get(distance, ""), f"{l[1]:+.0e}",
            f"{l[2]:+.0e}", f"{l[0] + l[3]:+.0e}", f"{path['value']:.5f}", f"{path['error']:.5f}", f"{exact:.5f}")
        within("the largest exponent", l[0], other, max(0.01 * other, 4 * math.hypot(error, other_error)))
        within("the free path", path["value"], exact, max(5e-4 * exact, 4 * path["error"]))
        for what, value in (("l_1", l[1]), ("l_2", l[2]), ("l_0 + l_3", l[0] + l[3])):
            within(what, value, 0, 1e-3 * l[0])
    end()


if __name__ == "__main__":
    main()
