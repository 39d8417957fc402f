#!/usr/bin/env python3
"""Exponents of the stadium and of Sinai's billiard, and over finite times: chaos.py CAROM [--long]

Stadium, half circles of radius 1, straights of length 2, speed 1: 0.43 in [BenettinStrelcyn1978], 0.4304(4) by an independent program. A
spectrum is (l, 0, 0, -l). Finite-time exponents: over spans of T their mean is l. In the Lorentz gas (spacing 2.3) their spread falls as
1 / sqrt(T), so spread^2 T settles; in the stadium it never does, as orbits stay between the straights for long [BalintGouezel2006].

Sinai's billiard, a disk of radius R in a periodic square of side 1 [Sinai1970]. As R -> 0 the exponent a collision is
    l tau = -2 ln R + C + O(R ln^2 R),   C = 1 - 4 ln 2 + 27 zeta(3) / (2 pi^2)   [Dahlqvist1997],
tau = (1 - pi R^2) / (2 R) the mean free time [Chernov1997].

5e5 collisions of each, `--long` 1e7. Exit status 1 if an exponent of the first two is off by more than 1 % and 4 standard errors, a
spectrum is not (l, 0, 0, -l) to 1e-3 l, spread^2 T of the Lorentz gas changes by more than 10 % over the last fourfold, or l tau is off by
more than a third of R ln^2 R and 4 standard errors.
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
LORENTZ = """
    [[table]]
    kind = "lorentz"
    lattice = "triangular"
    spacing = 2.3
    radius = 1
    [[ball]]
    position = [1.15, 0.1]
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


def finite_time():
    head("table", "T", "l_0", "error", "l_1", "l_2", "l_0 + l_3", "mean over T", "spread", "spread^2 T")
    for name, scene, known, known_error in (("stadium", STADIUM, 0.4304, 4e-4), ("Lorentz gas", LORENTZ, 1.7594, 3e-4)):
        widths = []
        for span in (5, 20, 80):
            l, error, seen = spectrum(scene, f"observe.lyapunov={{ finite_time = {span} }}")
            finite = seen["finite_time"]
            centre, spread = (finite[k][0]["value"] for k in ("mean", "spread"))
            widths.append(spread**2 * span)
            row(name, span, f"{l[0]:.5f}", f"{error:.5f}", f"{l[1]:+.0e}", f"{l[2]:+.0e}", f"{l[0] + l[3]:+.0e}", f"{centre:.4f}",
                f"{spread:.4f}", f"{widths[-1]:.4f}")
            within(f"the mean of finite-time exponents, {name}", centre, l[0], 1e-3 * l[0])
        within(f"the exponent, {name}", l[0], known, max(0.01 * known, 4 * math.hypot(error, known_error)))
        if name == "Lorentz gas":
            within("spread^2 T", widths[-1] / widths[-2], 1, 0.1)


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
            velocity = [{math.cos(1)!r}, {math.sin(1)!r}]
            radius = 0
            [[ball]]
            position = [0.5, 0.5]
            radius = {radius}
            fixed = true
            """
        l, error, _ = spectrum(scene, "observe.lyapunov=true")
        tau = (1 - math.pi * radius**2) / (2 * radius)
        known, order = -2 * math.log(radius) + CONSTANT, radius * math.log(radius) ** 2
        row(radius, f"{l[0]:.5f}", f"{error:.5f}", f"{l[0] * tau:.4f}", f"{error * tau:.4f}", f"{known:.4f}",
            f"{l[0] * tau - known:+.4f}", f"{order:.4f}")
        within("l_0 tau", l[0] * tau, known, order / 3 + 4 * error * tau)


def main():
    finite_time()
    sinai()
    end()


if __name__ == "__main__":
    main()
