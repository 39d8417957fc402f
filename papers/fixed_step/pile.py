#!/usr/bin/env python3
"""Where exact hard balls are the wrong tool, a pile that comes to rest: pile.py CAROM [--quick]

What the exact mode says of it, with each remedy that it names, and then, with the remedy that gets through (impacts within
contact_time of one another lose nothing), what it costs beside steps. Writes pile.csv beside this file. Exit status 1 if
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
    until = UNTIL if QUICK else 4.0
    settings = ["collision.contact_time=0.01"]
    run = compare("pile.toml", (1 / 60, 1 / 1000), names, *settings, until=until)
    exact = run["exact"]["seconds"]
    for r in run["rows"]:
        mean = r["averages"]
        saved.append((name(r), r["dt"], r["collisions"], r["deepest_overlap"], mean["stepper"]["kinetic_energy"],
                      mean["exact"]["kinetic_energy"], r["escaped"], r["seconds"] / exact))
    save("pile.csv", ("method", "dt", "collisions", "deepest_overlap", "kinetic_energy", "exact_kinetic_energy", "escaped",
                      "seconds_over_exact"), saved)
    impacts = run["exact"]["events"]
    print(f"exact, contact_time = 0.01, to {until}: {impacts['ball_ball'] + impacts['ball_wall']} impacts\n")
    table(["method", "dt", "collisions", "deepest overlap", "mean kinetic energy", "of the exact run", "escaped",
           "time over exact"],
          [[s[0], f"1/{round(1 / s[1])}", s[2], *map(number, s[3:6]), s[6], number(s[7])] for s in saved])
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
