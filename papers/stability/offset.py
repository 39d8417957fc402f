#!/usr/bin/env python3
"""The same run started at 1, 10 ... 10^12: offset.py CAROM

The clock is an epoch and an offset in it (papers/clock.md). Started a whole number of epochs later, a run must have the same
log but for the epochs, all later by that number, and the column `time`, which is their sum in one double. The epoch here is
a power of two below 1, so a start that is an integer is a whole number of them. 1/3 and 10^12 + 1/3 are not, and are
rounded to the clock's grid: there the offsets differ too. Prints a table. Exit status 1 if a log or an energy differs.
"""
import csv
import json
import pathlib
import subprocess
import sys
import tempfile
from fractions import Fraction

HERE = pathlib.Path(__file__).parent
EVENTS = 20_000
WORD = {True: "yes", False: "no"}


def run(carom, start):
    """Summary, moments (epoch, offset), and the columns of the log beside those and `time`."""
    with tempfile.TemporaryDirectory() as folder:
        command = [carom, "run", str(HERE / "five_balls.toml"), "--json", "--events", str(EVENTS), "--out", folder,
                   "--set", "output.events=\"events.csv\"", "--set", f"run.start=\"{start}\""]
        summary = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
        with open(pathlib.Path(folder) / "events.csv") as log:
            rows = [line for line in csv.reader(log) if not line[0].startswith("#")]
    assert rows[0][:3] == ["time", "epoch", "offset"]
    return summary, [(int(row[1]), row[2]) for row in rows[1:]], [row[3:] for row in rows]


def main():
    carom = sys.argv[1] if len(sys.argv) > 1 else "carom"
    good = True
    summary, moments, columns = run(carom, 0)
    length = Fraction(float.fromhex(summary["epoch_length"]))
    print(f"{len(moments)} collisions, epochs of {summary['epoch_length']}\n")
    print("| start | whole epochs | offsets the same | other columns the same | energy error |")
    print("|---|---|---|---|---|")
    print(f"| 0 | yes | - | - | {summary['energy']['relative_error']:.3e} |")
    for start in [str(10**k) for k in range(13)] + ["1/3", "3000000000001/3"]:
        other, later, others = run(carom, start)
        shift = Fraction(start) / length
        whole = shift.denominator == 1
        same_offsets = [(epoch + shift, offset) for epoch, offset in moments] == later
        same = others == columns
        print(f"| {start} | {WORD[whole]} | {WORD[same_offsets]} | {WORD[same]} | {other['energy']['relative_error']:.3e} |", flush=True)
        good &= same and other["energy"] == summary["energy"] and same_offsets == whole
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
