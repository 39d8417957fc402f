#!/usr/bin/env python3
"""Energy error against the number of collisions, over many seeds: energy.py CAROM [--long]

Every elastic impact rounds each velocity component once. If that has no bias the error of the energy is a random walk: its
root mean square grows like sqrt(n), and its mean over seeds stays within its standard error. --long adds one run of 10^9
collisions. Writes energy_error.csv beside this file. Exit status 1 if a bound is broken.
"""
import json
import math
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).parent
SEEDS = 20


def run(carom, scene, events, seed):
    """Signed relative error of the energy."""
    command = [carom, "run", str(HERE / scene), "--json", "--events", str(events)]
    for gas in range(2 if scene == "five_balls.toml" else 1):
        command += ["--set", f"gas.{gas}.seed={seed}"]
    energy = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)["energy"]
    size = energy["relative_error"]
    return math.copysign(size, energy["final"] - energy["initial"])


def main():
    carom = sys.argv[1] if len(sys.argv) > 1 else "carom"
    good = True
    rows = []
    print("| scene | collisions | seeds | mean | its standard error | root mean square | over sqrt(n) |")
    print("|---|---|---|---|---|---|---|")
    for scene, powers in (("five_balls.toml", range(3, 8)), ("thousand_disks.toml", range(4, 7))):
        rms = {}
        for power in powers:
            n = 10**power
            errors = [run(carom, scene, n, seed) for seed in range(1, SEEDS + 1)]
            mean = sum(errors) / SEEDS
            rms[power] = math.sqrt(sum(e * e for e in errors) / SEEDS)
            error = math.sqrt(sum((e - mean) ** 2 for e in errors) / (SEEDS - 1) / SEEDS)
            print(f"| {scene} | 10^{power} | {SEEDS} | {mean:+.1e} | {error:.1e} | {rms[power]:.1e} "
                  f"| {rms[power] / math.sqrt(n):.1e} |", flush=True)
            rows.append((scene, n, mean, error, rms[power]))
            good &= abs(mean) < 4 * error
        first, last = min(rms), max(rms)
        slope = math.log10(rms[last] / rms[first]) / (last - first) if rms[first] > 0 else 0.0
        print(f"\n{scene}: root mean square grows like n^{slope:.2f}\n", flush=True)
        good &= slope < 0.6
    if "--long" in sys.argv:
        error = run(carom, "five_balls.toml", 10**9, 1)
        print(f"five_balls.toml, 10^9 collisions: {error:+.2e}")
        rows.append(("five_balls.toml", 10**9, error, math.nan, abs(error)))
        good &= abs(error) <= 5e-12
    with open(HERE / "energy_error.csv", "w") as table:
        table.write("scene,collisions,mean,standard_error,root_mean_square\n")
        for row in rows:
            table.write(",".join(map(str, row)) + "\n")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
