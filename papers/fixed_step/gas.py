#!/usr/bin/env python3
"""Energy, pressure and cost of a gas in steps: gas.py CAROM [--quick]

Pressure is the impulse on the walls and time, over that of the exact run of the same gas from where they parted; energy the
error at the end; divergence the time at which some ball is a radius off. Cost is the time of a step, the least of several
short runs, times the steps, over the same for the exact run: what else the machine does can only add to it. Writes gas.csv
beside this file. Exit status 1 if the exact run, or carom's own sub-steps, lose energy.
"""
import math
import statistics
import sys

from study import ENGINES, QUICK, built, call, compare, json, HERE, name, number, save, table

SEEDS = (1,) if QUICK else (1, 2, 3)
UNTIL = 0.2 if QUICK else 1.5
SHORT = 0.02        # [time] of the runs that are timed
REPEATS = 3 if QUICK else 7
STEPS = (1e-2, 3e-3, 1e-3) if QUICK else (1e-2, 3e-3, 1e-3, 3e-4)
EARLY = 0.03        # [time] at which the places are compared


def reference_error():
    """Largest distance of a ball at EARLY, double precision against 50 digits: the error of the exact mode itself."""
    places = []
    for precision in ("double", "50"):
        text = call(["run", HERE / "gas.toml", "--json", "--final", "--until", EARLY, "--precision", precision])[1]
        places.append([list(map(float, ball["position"])) for ball in json.loads(text)["final"]])
    return max(math.dist(a, b) for a, b in zip(*places))


def exact_cost():
    """[s/time] of the exact run."""
    runs = [json.loads(call(["run", HERE / "gas.toml", "--json", "--quiet", "--until", 0.1])[1])["seconds"]
            for _ in range(REPEATS)]
    return min(runs) / 0.1


def main():
    names = ["discrete", "discrete:iterations=8:correction=baumgarte", "swept", "swept:substeps", "speculative", "penalty"]
    engines = [e for e in built(ENGINES) if e != "bullet:continuous"]
    if QUICK:
        engines = [e for e in engines if e in ("box2d", "chipmunk")]
    good, found = True, {}
    for seed in SEEDS:
        for group, steps in ((names, STEPS), (engines, STEPS[:2] if QUICK else STEPS[:3])):
            if not group:
                continue
            run = compare("gas.toml", steps, group, f"gas.0.seed={seed}", until=UNTIL)
            good &= run["exact"]["energy"]["relative_error"] < 1e-13
            for r in run["rows"]:
                found.setdefault((name(r), r["dt"]), []).append(r)
    exact = exact_cost()
    saved, shown = [], []
    for (which, dt), rows in found.items():
        repeats = [dt] * REPEATS
        early = compare("gas.toml", [dt], [which], until=EARLY)["rows"][0]
        timed = compare("gas.toml", repeats, [which], until=max(SHORT, 3 * dt))["rows"]
        cost = min(r["seconds"] / r["steps"] for r in timed) / dt / exact
        means = [r["averages"] for r in rows]
        ratios = [m["stepper"]["wall_impulse_rate"] / m["exact"]["wall_impulse_rate"] - 1 for m in means]
        pressure = statistics.mean(ratios)
        spread = statistics.stdev(ratios) / math.sqrt(len(ratios)) if len(ratios) > 1 else math.nan
        energy = statistics.mean(m["stepper"]["kinetic_energy"] / m["exact"]["kinetic_energy"] - 1 for m in means)
        drift = statistics.mean(r["energy_error"] for r in rows)
        parted = statistics.mean(r["diverged_at_time"] or r["time"] for r in rows)
        good &= which != "swept:substeps" or drift < 1e-12
        saved.append((which, dt, drift, energy, pressure, spread, parted, early["position_error"], cost))
        shown.append([which, f"{dt:g}", number(drift), f"{100 * energy:+.2g} %", f"{100 * pressure:+.2g} %",
                      number(100 * spread) + " %", number(parted), number(early["position_error"]), number(cost)])
    rounding = reference_error()
    saved.append(("exact", "", 0, 0, 0, 0, UNTIL, rounding, 1))
    save("gas.csv", ("method", "dt", "energy_error", "kinetic_energy", "pressure", "pressure_standard_error", "parted_at",
                     "early_position_error", "cost"), saved)
    table(["method", "dt", "energy error", "mean energy", "pressure", "its error", "parted at",
           f"position error at {EARLY}", "cost over exact"], shown)
    print(f"exact: {exact:.3g} s a unit of time, the least of {REPEATS} runs; position error at {EARLY}, against 50 digits: "
          f"{rounding:.1e}")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
