#!/usr/bin/env python3
"""Lyapunov exponents of the stadium and of Sinai's billiard: chaos.py CAROM [--long]

Stadium, half circles of radius 1, straights of length 2, speed 1: 0.43 in [BenettinStrelcyn1978], 0.4304(4) by an independent program. The
spectrum is (l, 0, 0, -l). Finite-time exponents: over spans of T their mean is l, and their spread falls as 1 / sqrt(T) once T is
beyond the correlations, so spread^2 T settles.

Sinai's billiard, a disk of radius R in a periodic square of side 1 [Sinai1970]. As R -> 0 the exponent a collision is
    l tau = -2 ln R + C + O(R ln^2 R),   C = 1 - 4 ln 2 + 27 zeta(3) / (2 pi^2)   [Dahlqvist1997],
tau = (1 - pi R^2) / (2 R) the mean free time [Chernov1997].

5e5 collisions of each, `--long` 1e7. Exit status 1 if the stadium's exponent is off by more than 1 % and 4 standard errors of both values, a
spectrum is not (l, 0, 0, -l) to 1e-3 l, spread^2 T changes by more than 10 % (`--long`: 5 %) over the last doubling, or l tau is off by more
than R ln^2 R and 4 standard errors.
"""
from study import *

COUNT = 10_000_000 if LONG else 500_000
STADIUM = """
    [[table]]
    kind = "stadium"
    radius = 1
    length = 2
    [[ball]]
    position = [0.3, 0.1]
    velocity = [0.6, 0.8]
    radius = 0
    """
CONSTANT = 1 - 4 * math.log(2) + 27 * 1.2020569031595942 / (2 * math.pi**2)


def spectrum(scene, *settings):
    """The four exponents, the error of the first, and all that was observed of them."""
    seen = run(scene, *settings, events=COUNT)["observed"]["lyapunov"]
    values = [e["value"] for e in seen["exponents"]]
    for what, value in (("l_1", values[1]), ("l_2", values[2]), ("l_0 + l_3", values[0] + values[3])):
        within(what, value, 0, 1e-3 * values[0])
    return values, seen["exponents"][0]["error"], seen


def stadium():
    head("stadium, T", "l_0", "error", "l_1", "l_2", "l_0 + l_3", "mean over T", "spread", "spread^2 T")
    before = after = math.nan
    for span in (10, 20, 40, 80):
        l, error, seen = spectrum(STADIUM, f"observe.lyapunov={{ finite_time = {span} }}")
        finite = seen["finite_time"]
        centre, spread = (finite[k][0]["value"] for k in ("mean", "spread"))
        before, after = after, spread**2 * span
        row(span, f"{l[0]:.5f}", f"{error:.5f}", f"{l[1]:+.0e}", f"{l[2]:+.0e}", f"{l[0] + l[3]:+.0e}", f"{centre:.4f}", f"{spread:.4f}", f"{after:.4f}")
        within("the mean of finite-time exponents", centre, l[0], 1e-3)
    within("the stadium's exponent", l[0], 0.4304, max(0.0043, 4 * math.hypot(error, 0.0004)))
    within("spread^2 T", after / before, 1, 0.05 if LONG else 0.1)


def sinai():
    print(f"\nC = {CONSTANT:.6f}\n")
    head("R", "l_0", "error", "l_0 tau", "error", "-2 ln R + C", "off", "R ln^2 R")
    for radius in (0.4, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005):
        scene = f"""
            [space]
            kind = "periodic"
            lower = [0, 0]
            upper = [1, 1]
            [[ball]]
            position = [0.02, 0.05]
            velocity = [0.6, 0.8]
            radius = 0
            [[ball]]
            position = [0.5, 0.5]
            radius = {radius}
            fixed = true
            """
        l, error, _ = spectrum(scene, "observe.lyapunov=true")
        tau = (1 - math.pi * radius**2) / (2 * radius)
        known, order = -2 * math.log(radius) + CONSTANT, radius * math.log(radius) ** 2
        row(radius, f"{l[0]:.5f}", f"{error:.5f}", f"{l[0] * tau:.4f}", f"{error * tau:.4f}", f"{known:.4f}", f"{l[0] * tau - known:+.4f}", f"{order:.4f}")
        within("l_0 tau", l[0] * tau, known, order + 4 * error * tau)


def main():
    stadium()
    sinai()
    end()


if __name__ == "__main__":
    main()
