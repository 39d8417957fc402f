#!/usr/bin/env python3
"""The energy error along one run of 10^9 collisions of five disks: long_run.py CAROM [EVENTS]

The run is saved at each power of ten and each 10^8 and goes on from there, which changes nothing (README, --resume). Prints
collisions and signed relative error as CSV. Exit status 1 if an error is above 5e-12.
"""
import pathlib
import sys
import tempfile

from energy import BOUND, run

MOMENTS = [10**k for k in range(3, 9)] + [k * 10**8 for k in range(2, 11)]


def main():
    carom = sys.argv[1] if len(sys.argv) > 1 else "carom"
    last = int(sys.argv[2]) if len(sys.argv) > 2 else 10**9
    good = True
    print("collisions,relative_error")
    with tempfile.TemporaryDirectory() as folder:
        saved = pathlib.Path(folder) / "run.carom"
        for n in (n for n in MOMENTS if n <= last):
            going_on = ["--resume", str(saved)] if saved.exists() else []
            size, sign = run(carom, "five_balls.toml", n, 1, going_on + ["--checkpoint", str(saved)])
            print(f"{n},{size * (sign or 1)!r}", flush=True)
            good &= size <= BOUND
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
