#!/usr/bin/env python3
"""The first 20 collisions of the break shot, and the places after 3 s, in steps: break_shot.py CAROM [--quick]

Writes break_shot.csv beside this file. Exit status 1 if carom's own sub-steps do not find the 20 collisions in order.
"""
import csv
import sys

from study import ENGINES, HERE, QUICK, built, call, compare, name, number, save, table

SCENE = "../../examples/break_shot/scene.toml"
FIRST = 20


def time_of(collision):
    """[s] between that collision and the next of the exact run."""
    out = HERE / "out" / "break_shot"
    call(["run", HERE / SCENE, "--out", out, "--quiet", "--events", collision + 1])
    lines = [line for line in open(out / "events.csv") if not line.startswith("#")]
    times = [float(row["time"]) for row in csv.DictReader(lines)]
    return (times[collision - 1] + times[collision]) / 2


def main():
    names = ["discrete", "swept", "swept:substeps", "speculative", "penalty", *built(ENGINES)]
    steps = (1 / 60, 1e-3, 1e-4) if QUICK else (1 / 60, 1 / 240, 1e-3, 1e-4, 1e-5, 1e-6)
    until = time_of(FIRST)
    few = [s for s in steps if s >= 1e-4]
    early, late = {}, {}
    for group, some in ((names[:5], steps), (names[5:], [s for s in steps if s >= 1e-5])):
        if group:
            early.update({(name(r), r["dt"]): r for r in compare(SCENE, some, group, until=until)["rows"]})
            late.update({(name(r), r["dt"]): r for r in compare(SCENE, few, group)["rows"]})
    saved = []
    for key, r in early.items():
        end = late.get(key)
        saved.append((*key, r["collisions"], r["missed"], r["spurious"], r["swapped"], r["diverged_at_collision"],
                      r["position_error"], end and end["collisions"], end and end["position_error"],
                      end and end["diverged_at_collision"]))
    save("break_shot.csv", ("method", "dt", "collisions", "missed", "spurious", "swapped", "parted_at_collision",
                            "position_error", "collisions_3s", "position_error_3s", "parted_at_collision_3s"), saved)
    print(f"The {FIRST}th collision of the exact run is over at {until:.6f} s.\n")
    table(["method", "dt", "collisions of 20", "missed", "spurious", "swapped", "position error", "after 3 s", "parted at"],
          [[s[0], f"{s[1]:.2g}", *s[2:6], number(s[7]), number(s[9]), "-" if s[10] is None else s[10]] for s in saved])
    last = early["swept:substeps", steps[-1]]
    good = (last["collisions"], last["missed"], last["spurious"], last["swapped"]) == (FIRST, 0, 0, 0)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
