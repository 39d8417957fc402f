#!/usr/bin/env python3
"""When and where a bouncing ball comes to rest: bouncing.py CAROM

From height h the bounces end at T = sqrt(2 h / g) (1 + e) / (1 - e), after a path of h (1 + e^2) / (1 - e^2)
(papers/collapse.md, eq. 9). T is found by bisection over run.until: the `other` event is the coming to rest. The path is summed
over the bounces in the log: h down to the first, then up and down between two. Prints a table. Exit status 1 if T or the
path is off by more than 1e-10, relatively, or the energy lost is not m g h to 1e-14.
"""
import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile

SCENE = pathlib.Path(__file__).parents[2] / "examples" / "bouncing_ball_at_rest" / "scene.toml"
G, H = 9.81, 1.0


def run(carom, e, *options):
    command = [carom, "run", str(SCENE), "--json", "--set", f"collision.restitution={e}", *options]
    return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


def bounces(carom, e):
    """Times of the bounces and upward speeds after them."""
    with tempfile.TemporaryDirectory() as folder:
        run(carom, e, "--until", "1000", "--out", folder, "--set", "output.events=\"events.csv\"")
        with open(pathlib.Path(folder) / "events.csv") as log:
            rows = list(csv.DictReader(line for line in log if not line.startswith("#")))
    return [(float(row["time"]), float(row["vy"])) for row in rows if row["kind"] == "ball_wall"]


def rest_time(carom, e, guess):
    """First `until` by which the ball has come to rest, to 1e-13 of it."""
    low, high = guess * (1 - 1.7e-9), guess * (1 + 1e-9)
    at_rest = [run(carom, e, "--until", repr(t))["events"]["other"] for t in (low, high)]
    assert at_rest == [0, 1]
    while high - low > 1e-13 * guess:
        middle = (low + high) / 2
        low, high = (low, middle) if run(carom, e, "--until", repr(middle))["events"]["other"] else (middle, high)
    return high


def main():
    carom = sys.argv[1] if len(sys.argv) > 1 else "carom"
    good = True
    print("| e | bounces | T | off by | path | off by | energy lost, off by |")
    print("|---|---|---|---|---|---|---|")
    for e in (0.5, 0.9, 0.99):
        expected = math.sqrt(2 * H / G) * (1 + e) / (1 - e), H * (1 + e * e) / (1 - e * e)
        log = bounces(carom, e)
        time, path = rest_time(carom, e, expected[0]), H + math.fsum(v * v / G for _, v in log)
        lost = run(carom, e, "--until", "1000")["energy"]["dissipated"]
        off = [time / expected[0] - 1, path / expected[1] - 1, lost / (G * H) - 1]
        print(f"| {e} | {len(log)} | {time:.13g} | {off[0]:+.1e} | {path:.13g} | {off[1]:+.1e} | {off[2]:+.1e} |", flush=True)
        good &= max(map(abs, off[:2])) <= 1e-10 and abs(off[2]) <= 1e-14
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
