#!/usr/bin/env python3
"""A point that falls into a symmetric wedge: wedge.py CAROM [--long]

Half angle theta from the vertical, gravity 1, energy 1 above the vertex [LehtihetMiller1986]. At 45 degrees the walls are at right
angles and the motions along them independent, so the energy of each stays. Above, the wedge is the system of two falling balls whose
exponents are positive almost everywhere [Wojtkowski1990]; below, regular and chaotic orbits live side by side. The largest
exponent of three starts, in units of gravity over the speed at the vertex, sqrt(2).

2e5 collisions of each, `--long` 4e6. Exit status 1 if at 45 degrees an exponent is above 1e-3 or an energy is off by more than 1e-11 after 1e5
collisions, if above it the three starts differ by more than 4 standard errors or an exponent is not positive by 10, if
below it none is regular or none chaotic, or if a spectrum does not add up to 0.
"""
from study import *

STARTS = {"(0, 0.5), level": ((0, 0.5), (1, 0)), "(0.05, 0.8), up": ((0.05, 0.8), (0.1, math.sqrt(0.39))),
          "(-0.1, 0.6), down": ((-0.1, 0.6), (0.4, -0.8))}
RIGHT = '"1.57079632679489661923132169163975144209858469968755"'


def scene(theta, start):
    (x, y), (vx, vy) = start
    scale = math.sqrt((2 - 2 * y) / (vx * vx + vy * vy))
    angle = RIGHT if theta == 45 else repr(math.radians(2 * theta))
    return f"""
        [motion]
        acceleration = [0, -1]
        [[table]]
        kind = "wedge"
        length = 100
        angle = {angle}
        [[ball]]
        position = [{x}, {y}]
        velocity = [{vx * scale!r}, {vy * scale!r}]
        radius = 0
        """


def energies(ball):
    """Along the two walls of the right wedge."""
    (x, y), (vx, vy) = ball["position"], ball["velocity"]
    return [(vy + s * vx) ** 2 / 4 + (y + s * x) / 2 for s in (1, -1)]


def main():
    unit = math.sqrt(2)  # speed at the vertex over gravity
    kinds = set()
    head("theta", "start", "l_0", "error", "sum")
    for theta in (30, 40, 45, 50, 60, 70, 80):
        seen = []
        for name, start in STARTS.items():
            spectrum = run(scene(theta, start), "observe.lyapunov=true", events=4_000_000 if LONG else 200_000)["observed"]["lyapunov"]
            value, error = (spectrum["exponents"][0][k] * unit for k in ("value", "error"))
            seen.append((value, error))
            row(theta, name, f"{value:.5f}", f"{error:.5f}", f"{spectrum['sum']['value']:.0e}")
            within("the sum of the spectrum", spectrum["sum"]["value"], 0, 1e-9)
        if theta == 45:
            for value, _ in seen:
                within("an exponent at 45 degrees", value, 0, 1e-3)
        elif theta > 45:
            within("the number of starts that are not chaotic", sum(value < 10 * error for value, error in seen), 0, 0)
            for value, error in seen[1:]:
                within("the exponent of another start", value, seen[0][0], math.inf, math.hypot(error, seen[0][1]))
        else:
            kinds |= {value > 0.01 for value, _ in seen}
    within("kinds of orbits below 45 degrees", len(kinds), 2, 0)
    off = 0
    for start in STARTS.values():
        before, after = (run(scene(45, start), events=k, final=True)["final"][0] for k in (1, 100_000))
        off = max(off, *(abs(a - b) for a, b in zip(energies(before), energies(after))))
    print(f"\nEnergies along the walls at 45 degrees after 100000 collisions are off by {off:.0e}.")
    within("the energy along a wall", off, 0, 1e-11)
    end()


if __name__ == "__main__":
    main()
