#!/usr/bin/env python3
"""Where exact hard balls are the wrong tool, a pile that comes to rest: pile.py CAROM [--quick]

What the exact mode says of it, with each remedy that it names, and then, with the remedy that gets through (impacts within
contact_time of one another lose nothing), what remains of the motion, beside steps. Writes pile.csv beside this file. Exit status 1 if
the pile is not refused, or not by status 3.
"""
import sys

from study import ENGINES, HERE, QUICK, built, call, compare, json, name, number, save, table

REMEDIES = (("none", []),
            ('regularise = "rest"', ['collision.regularise="rest"']),
            ('regularise = "viscoelastic"', ['collision.regularise="viscoelastic"', "collision.reference_speed=1"]),
            ("contact_time = 0.01", ["collision.contact_time=0.01"]),
            ("contact_time = 0.001", ["collision.contact_time=0.001"]))
UNTIL = 2.0
WATCHED = (4.0, 8.0)


def main():
    good, rows, saved = True, [], []
    for remedy, settings in REMEDIES:
        command = ["run", HERE / "pile.toml", "--json", "--quiet", "--until", UNTIL]
        for setting in settings:
            command += ["--set", setting]
        status, text, _ = call(command)
        run = json.loads(text)
        impacts = run["events"]["ball_ball"] + run["events"]["ball_wall"]
        rows.append([f"`{remedy}`" if settings else remedy, status, run["stopped_by"], number(run["time"], 4), impacts])
        good &= remedy != "none" or status == 3
    table(["remedy", "exit status", "stopped by", "at", "impacts"], rows)
    names = ["discrete", "discrete:correction=baumgarte:iterations=8", "swept", "speculative", "penalty", *built(ENGINES)]
    settings = ["collision.contact_time=0.01"]
    fallen, end = (run["rows"] for run in (compare("pile.toml", (1 / 60, 1 / 1000), names, *settings, until=t) for t in WATCHED))
    for before, r in zip(fallen, end):
        saved.append((name(r), r["dt"], r["collisions"], r["deepest_overlap"], *between(before, r), r["escaped"]))
    save("pile.csv", ("method", "dt", "collisions", "deepest_overlap", "kinetic_energy", "exact_kinetic_energy", "escaped"),
         saved)
    print("Mean kinetic energy from t = {} to {}, beside the exact run with contact_time = 0.01:\n".format(*WATCHED))
    table(["method", "dt", "collisions", "deepest overlap", "kinetic energy", "of the exact run", "escaped"],
          [[s[0], f"1/{round(1 / s[1])}", s[2], *map(number, s[3:6]), s[6]] for s in saved])
    return 0 if good else 1


def between(before, after):
    """Means of the kinetic energies, of the stepper and of the exact run, between the ends of two runs that part alike."""
    spans = [r["averages"]["to"] - r["averages"]["from"] for r in (before, after)]
    sums = [[span * r["averages"][k]["kinetic_energy"] for k in ("stepper", "exact")]
            for span, r in zip(spans, (before, after))]
    return [(b - a) / (spans[1] - spans[0]) for a, b in zip(*sums)]


if __name__ == "__main__":
    sys.exit(main())
