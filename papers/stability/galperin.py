#!/usr/bin/env python3
"""Digits of pi by collisions, mass ratios 100^0 .. 100^7: galperin.py CAROM [LARGEST POWER]

The number of collisions is ceil(pi / theta) - 1, theta = arctan sqrt(m / M) [Galperin2003]; after k impacts of the two balls
their velocities are -cos(2 k theta) and +-sqrt(M / m) sin(2 k theta). Prints a table. Exit status 1 if a count is not exact, or
an energy error is above 5e-13 (up to 100^5) or 5e-12.
"""
import json
import math
import pathlib
import subprocess
import sys

SCENE = pathlib.Path(__file__).parents[2] / "examples" / "galperin_pi" / "scene.toml"
PI = "314159265358979"


def main():
    carom = sys.argv[1] if len(sys.argv) > 1 else "carom"
    largest = int(sys.argv[2]) if len(sys.argv) > 2 else 7
    good = True
    print("| M | collisions | pi | ties | unresolved | energy error | heavy ball's speed off by |")
    print("|---|---|---|---|---|---|---|")
    for power in range(largest + 1):
        command = [carom, "run", str(SCENE), "--json", "--final", "--set", f"ball.1.mass=1e{2 * power}", "--until", "1000"]
        out = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
        events, error = out["events"], out["energy"]["relative_error"]
        count = events["ball_ball"] + events["ball_wall"]
        off = out["final"][1]["velocity"][0] + math.cos(2 * events["ball_ball"] * math.atan(10.0**-power))
        print(f"| 100^{power} | {count} | {PI[:power + 1]} | {events['ties']} | {out['exactness']['unresolved']} | {error:.1e} | {off:+.1e} |",
              flush=True)
        good &= str(count) == PI[:power + 1] and out["stopped_by"] == "no_events_left"
        good &= error <= (5e-13 if power <= 5 else 5e-12)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
