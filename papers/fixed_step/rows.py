#!/usr/bin/env python3
"""Newton's cradle, and a ball that meets a row of seven: rows.py CAROM [--quick]

Writes rows.csv beside this file. Exit status 1 if the exact run is not what it must be: all of the velocity handed on.
"""
import sys

from study import ENGINES, QUICK, built, compare, name, number, save, table

SEVEN = "title = \"A ball meets a row of seven that touch\"\n" + "".join(
    f"[[ball]]\nposition = [{x}, 0]\nvelocity = [{v}, 0]\n" for x, v in [(-3.25, 10)] + [(k, 0) for k in range(7)]
) + "[run]\nuntil = 0.6\n"


def main():
    engines = [e for e in built(ENGINES) if ":" not in e]
    names = ["discrete", "discrete:iterations=8", "discrete:iterations=100", "swept", "swept:substeps", "speculative",
             "speculative:iterations=100", "penalty", *engines]
    steps = (1 / 60, 1 / 1000) if QUICK else (1 / 60, 1 / 240, 1 / 1000, 1 / 10000)
    saved, good = [], True
    for scene, text, until in (("cradle", "../../examples/newtons_cradle/scene.toml", 1.1), ("seven", SEVEN, 0.6)):
        faster = ["ball.0.velocity=[10]"] if scene == "cradle" else []  # slower, and the engines' thresholds are all one sees
        run = compare(text, steps, names, *faster, until=until)
        expected = {"cradle": 8, "seven": 7}[scene]
        good &= run["exact"]["events"]["ball_ball"] == expected and run["exact"]["energy"]["relative_error"] == 0
        for r in run["rows"]:
            saved.append((scene, name(r), r["dt"], r["collisions"], r["missed"], r["spurious"], r["swapped"],
                          r["deepest_overlap"], r["position_error"], r["energy_error"]))
        table([scene, "dt", "collisions", "position error", "energy error"],
              [[s[1], f"1/{round(1 / s[2])}", s[3], number(s[8]), number(s[9])] for s in saved if s[0] == scene])
    save("rows.csv", ("scene", "method", "dt", "collisions", "missed", "spurious", "swapped", "deepest_overlap",
                      "position_error", "energy_error"), saved)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
