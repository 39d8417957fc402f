#!/usr/bin/env python3
"""Where three points on a line collapse, by how many impacts: collapse.py CAROM

Above r_c = 7 - 4 sqrt 3 the number of impacts is ceil(pi / phi) - 1 with cos phi = (1 + r) / (4 sqrt r); below there are
infinitely many. On both sides of r_c, ever closer to it, in ever higher precision. Exit status 1 if one is otherwise.
"""
import decimal
import json
import math
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).parent
decimal.getcontext().prec = 60
D = decimal.Decimal
CRITICAL = 7 - 4 * D(3).sqrt()


def impacts(r):
    """ceil(pi / phi) - 1; near r_c cos phi is near 1, and phi = 2 asin sqrt((1 - cos phi) / 2) loses nothing."""
    cosine = (1 + r) / (4 * r.sqrt())
    return math.ceil(math.pi / (2 * math.asin(math.sqrt((1 - cosine) / 2)))) - 1


def run(carom, r, precision):
    command = [carom, "run", str(HERE / "collapse_line.toml"), "--json", "--precision", precision,
               "--set", f"collision.restitution=\"{r}\""]
    done = subprocess.run(command, capture_output=True, text=True)
    out = json.loads(done.stdout)
    return done.returncode, out["stopped_by"], out["events"]["ball_ball"]


def main():
    carom = sys.argv[1] if len(sys.argv) > 1 else "carom"
    good = True
    print("| precision | r - r_c | impacts | expected | stopped by |")
    print("|---|---|---|---|---|")
    for precision, distance in (("double", "2e-3"), ("100", "1e-5"), ("400", "1e-6")):
        for sign in (1, -1):
            r = CRITICAL + sign * D(distance)
            status, stopped, count = run(carom, r, precision)
            expected = str(impacts(r)) if sign > 0 else "infinitely many"
            print(f"| {precision} | {'+' if sign > 0 else '-'}{distance} | {count} | {expected} | {stopped} |", flush=True)
            good &= (status, stopped) == ((3, "collapse") if sign < 0 else (0, "no_events_left"))
            good &= sign < 0 or str(count) == expected
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
