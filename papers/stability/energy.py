#!/usr/bin/env python3
"""Energy error against the number of collisions, over seeds: energy.py CAROM [--scene NAME] [--seeds A B] [--decades A B]

Every elastic impact rounds each velocity component once. If that has no bias the error of the energy is a random walk: its
root mean square grows like sqrt(n), and its mean over seeds stays within its standard error. Prints CSV; the comments are
the verdicts. Exit status 1 if a mean is more than 4 of its standard errors from 0, the root mean square grows faster than
n^0.6, or an error is above 5e-12.
"""
import argparse
import json
import math
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).parent
BOUND = 5e-12
GASES = {"five_balls.toml": 2, "thousand_disks.toml": 1}
DECADES = {"five_balls.toml": range(3, 8), "thousand_disks.toml": range(3, 7)}


def run(carom, scene, events, seed, options=()):
    """Size and sign of the relative error of the energy; sign 0 where initial and final energy are the same double."""
    command = [carom, "run", str(HERE / scene), "--json", "--events", str(events), *options]
    for gas in range(GASES[scene]):
        command += ["--set", f"gas.{gas}.seed={seed}"]
    energy = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)["energy"]
    return energy["relative_error"], (energy["final"] > energy["initial"]) - (energy["final"] < energy["initial"])


def root_mean_square(values):
    return math.sqrt(sum(v * v for v in values) / len(values))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("carom", nargs="?", default="carom")
    parser.add_argument("--scene", choices=DECADES, action="append")
    parser.add_argument("--seeds", type=int, nargs=2, default=(1, 20), help="first and last")
    parser.add_argument("--decades", type=int, nargs=2, help="first and last power of ten of collisions")
    wanted = parser.parse_args()
    seeds = range(wanted.seeds[0], wanted.seeds[1] + 1)
    good = True
    print("scene,collisions,mean,standard_error,root_mean_square,largest")
    for scene in wanted.scene or DECADES:
        decades = range(wanted.decades[0], wanted.decades[1] + 1) if wanted.decades else DECADES[scene]
        rms = {}
        for power in decades:
            runs = [run(wanted.carom, scene, 10**power, seed) for seed in seeds]
            errors = [size * sign for size, sign in runs]
            mean = sum(errors) / len(seeds)
            spread = root_mean_square([e - mean for e in errors]) / math.sqrt(len(seeds) - 1)
            largest = max(size for size, _ in runs)
            rms[power] = root_mean_square([size for size, _ in runs])
            print(f"{scene},{10**power},{mean:.2e},{spread:.2e},{rms[power]:.2e},{largest:.2e}", flush=True)
            good &= abs(mean) < 4 * spread and largest <= BOUND
        first, last = decades[0], decades[-1]
        slope = math.log10(rms[last] / rms[first]) / max(last - first, 1)
        print(f"# {scene}: root mean square ~ n^{slope:.2f}", flush=True)
        good &= slope < 0.6
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
