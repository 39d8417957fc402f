#!/usr/bin/env python3
"""The escape rate of the three-disk pinball, in two ways: pinball.py CAROM [--long]

Disks of radius 1 with centres 6 apart, points at speed 1, 1e6 of them a run, 10 runs (`--long`: 50). The rate is the leading zero of
the zeta function of the cycles [GaspardRice1989]: gamma = 0.410338407769, from a cycle expansion converged to 1e-12.

From departures: the mean over runs of `observed.survival.escape_rate` over 4 .. 20; the estimator and its error are in
include/carom/observe/survival.hpp. Flights are nearly equally long, so the number inside falls in steps, and estimators that end
abruptly depend on where in a step they do; this one does not.

From bounces: with t_n the time of a point's n-th bounce, A_n(g) = sum of exp(g t_n) over the points that bounce n times is at
g = gamma the same for all n, once the start is forgotten, as each bounce is one application of a transfer operator whose leading
eigenvalue is 1 there. So A_(n+1)(g_n) = A_n(g_n) defines g_n -> gamma, with an error that falls by the ratio of the next eigenvalue
to the first at each n, whatever the steps in time. Errors by the jackknife over runs.

Exit status 1 if the rate from departures is off by more than 0.5 % or 4 standard errors, or g_3 by more than 4 standard errors.
"""
from array import array

from study import *

GAMMA = 0.410338407769
SCENE = EXAMPLES / "pinball" / "scene.toml"
MOST = 6  # bounces that are followed


def one(seed):
    """The rate and its error, and the times of the n-th bounces for n = 1 .. MOST."""
    out = folder("pinball")
    seen = run(SCENE, "gas.0.count=1_000_000", f"gas.0.seed={seed}", "observe.boundary_map={}", "observe.survival={ from = 4, to = 20 }",
               until=40, out=out)["observed"]["survival"]
    bounces, times = {}, [array("d") for _ in range(MOST)]
    with open(out / "boundary_map.csv") as file:
        for line in file:
            if not line[0].isdigit() and line[0] != "-":
                continue
            _, _, _, _, ball, time = line.split(",")
            n = bounces.get(ball, 0)
            bounces[ball] = n + 1
            if n < MOST:
                times[n].append(float(time))
    return seen["escape_rate"]["value"], seen["escape_rate"]["error"], times


def sums(times, n, g):
    """A_n(g) of one run and its derivative."""
    terms = [math.exp(g * t) for t in times[n - 1]]
    return math.fsum(terms), math.fsum(e * t for e, t in zip(terms, times[n - 1]))


def step(parts):
    """Newton's for ln A_n+1 - ln A_n; parts has ((A_n, its derivative), (A_n+1, its derivative)) of each run."""
    (a, da), (b, db) = ((math.fsum(p[k][0] for p in parts), math.fsum(p[k][1] for p in parts)) for k in (0, 1))
    return math.log(b / a) / (db / b - da / a)


def rate_from(runs, n):
    """g with A_(n+1)(g) = A_n(g), and its error: the jackknife's, to which one step from g suffices."""
    g = 0.41
    for _ in range(30):
        parts = [(sums(times, n, g), sums(times, n + 1, g)) for times in runs]
        if abs(step(parts)) < 1e-9:
            break
        g -= step(parts)
    return g, (len(runs) - 1) * mean([step(parts[:k] + parts[k + 1:]) for k in range(len(runs))])[1]


def main():
    rates, errors, times = zip(*(one(100 + k) for k in range(50 if LONG else 10)))
    rate, spread = mean(rates)
    error = math.hypot(*errors) / len(errors)
    head("from", "points", "rate", "error", "off gamma")
    row("departures", f"{len(rates)}e6", f"{rate:.5f}", f"{error:.5f}", f"{100 * (rate / GAMMA - 1):+.2f} %")
    within("the rate from departures", rate, GAMMA, 0.005 * GAMMA, error)
    for n in range(1, 5):
        g, g_error = rate_from(times, n)
        row(f"bounces {n} to {n + 1}", sum(len(t[n - 1]) for t in times), f"{g:.5f}", f"{g_error:.5f}", f"{100 * (g / GAMMA - 1):+.2f} %")
        within(f"g_{n}", g, GAMMA, math.inf, g_error if n == 3 else None)
    row("cycles", "", GAMMA, "", "")
    print(f"\nStandard error of the mean from the scatter of the runs: {spread:.5f}.")
    end()


if __name__ == "__main__":
    main()
