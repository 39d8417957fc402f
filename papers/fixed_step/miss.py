#!/usr/bin/env python3
"""How often a fast ball passes through another, or through a plate: miss.py CAROM [--quick]

Measured shares, from many phases of the step, against what follows from the definition of each method. Exit status 1 if
a share of carom's own methods is off by more than 3 standard errors. Writes miss.csv and plate.csv beside this file.
"""
import math
import random
import sys

from study import ENGINES, QUICK, built, compare, is_engine, off, phased_steps, save, table

PHASES = 500 if QUICK else 2000
ENGINE_PHASES = PHASES // 5
STEPS_BEFORE = 40      # of the flight to the contact
SPEED = 1000.0
AFTER = 22             # steps beyond the contact: penalty:steps=10 reports it up to 20 steps late


def pair(b, distance):
    start = -distance - (math.sqrt(1 - b * b) if b < 1 else 0.0)
    return f"""title = "A fast ball passes another at the distance b = {b}; the radii add up to 1"
[[ball]]
position = [{start!r}, {b!r}]
velocity = [{SPEED!r}, 0]
radius = 0.25
[[ball]]
position = [0, 0]
radius = 0.75
[run]
until = 1
"""


def plate(w, distance, front_first=False):
    if front_first:
        wall = f'kind = "polygon"\nvertices = [[0, 300], [0, -300], [{w!r}, -300], [{w!r}, 300]]'
    elif w == 0:
        wall = 'kind = "segment"\nfrom = [0, -300]\nto = [0, 300]'
    else:
        wall = f'kind = "polygon"\nvertices = [[0, -300], [{w!r}, -300], [{w!r}, 300], [0, 300]]'
    return f"""title = "A fast ball meets a plate of thickness {w}"
[[wall]]
{wall}
[[ball]]
position = [{-distance - 0.5!r}, 0]
velocity = [{SPEED!r}, {0.3 * SPEED!r}]
radius = 0.5
[run]
until = 1
"""


def phases(which):
    return ENGINE_PHASES if is_engine(which) else PHASES


def shares(scene_of, length, names, dice):
    """For each name: shares of the phases in which nothing is seen, and in which no impulse is given."""
    distance = (STEPS_BEFORE + 0.5) * length
    until = (distance + AFTER * length) / SPEED
    result = {}
    for group in ([n for n in names if not is_engine(n)], [n for n in names if is_engine(n)]):
        if not group:
            continue
        n = phases(group[0])
        rows = compare(scene_of(distance), phased_steps(distance, SPEED, length, n, dice), group, until=until)["rows"]
        for k, which in enumerate(group):
            mine = rows[k * n:(k + 1) * n]
            result[which] = (sum(r["deepest_overlap"] == 0 and r["collisions"] == 0 for r in mine) / n,
                             sum(r["collisions"] == 0 for r in mine) / n)
    return result


def missed(zone, length):
    """Probability that no step ends in a zone of that extent which begins `distance` away, the steps as phased_steps has them.

    With steps distance / (N + u) the next end lies (1 - u) distance / (N + u) inside it, which exceeds the zone for
    u < (1 - N q) / (1 + q), q = zone / distance. As N grows this is 1 - zone / length; for N = 40 up to 0.01 from it.
    """
    q = zone / ((STEPS_BEFORE + 0.5) * length)
    return max(0.0, (1 - STEPS_BEFORE * q) / (1 + q))


def expected_pair(which, b, length):
    """Probabilities (unseen, no impulse); None where the definition of the method does not give one in closed form."""
    chord = 2 * math.sqrt(1 - b * b)
    unseen, no_push = missed(chord, length), missed(chord / 2, length)
    kind = which.split(":")[0]
    if kind == "discrete":
        return unseen, no_push
    if kind == "penalty":
        return None, unseen
    if kind in ("swept", "speculative"):
        return None, 0.0
    return None, None


def expected_plate(which, w, length):
    kind = which.split(":")[0]
    if kind == "discrete":
        return missed(w + 1, length), missed(w + 0.5, length)
    if kind in ("swept", "speculative"):
        return None, 0.0
    return None, None


def study(what, head, scene_of, cases, names, expected, file):
    """Runs all cases (value, lengths); True if nothing is off."""
    dice = random.Random(1)
    saved, misses = [], []
    compared = 0
    shown = {}
    for value, lengths in cases:
        for length in lengths:
            for which, measured in shares(lambda d, v=value: scene_of(v, d), length, names, dice).items():
                theory = expected(which, value, length)
                for part, m, p in zip(("unseen", "no impulse"), measured, theory):
                    sigma = math.sqrt(m * (1 - m) / phases(which))
                    saved.append((which, value, length, part, m, sigma, "" if p is None else p))
                    if p is None:
                        continue
                    compared += 1
                    if off(m, p, PHASES):
                        misses.append(f"{what} {which}, {head} = {value}, step {length}, {part}: {m}, expected {p:.4f}")
                shown[value, length, which] = measured, theory
    save(file, ("method", head, "length", "what", "measured", "standard_error", "expected"), saved)
    first = names[0]
    table([head, "step"] + ["discrete unseen", "formula", "discrete no impulse", "formula"]
          + [f"{n} no impulse" for n in names if n != first],
          [[v, f"{length:.4g}"] + [f"{x:.4f}" for x in (shown[v, length, first][0][0], shown[v, length, first][1][0],
                                                      shown[v, length, first][0][1], shown[v, length, first][1][1])]
           + [f"{shown[v, length, n][0][1]:.4f}" for n in names if n != first] for v, lengths in cases for length in lengths])
    print(f"{what}: {compared} shares compared, {PHASES} phases each, {len(misses)} off by more than 3 standard errors\n")
    for miss in misses:
        print(miss)
    return not misses


def ghost_share(b, length):
    """Of phases in which `speculative` stops a ball that passes at b > 1.

    At the place x before the other it is stopped if its approach along the centres, length x / r, exceeds the gap r - 1,
    r^2 = x^2 + b^2. These x are one interval; its length over that of a step is the share.
    """
    def stopped(x):
        r = math.hypot(x, b)
        return length * x / r >= r - 1
    fine = 200000
    return min(1.0, sum(stopped((k + 0.5) / fine * (length + 2)) for k in range(fine)) / fine * (length + 2) / length)


def ghosts(dice):
    rows, good = [], True
    names = ["swept", "speculative"]
    for b in (1.01, 1.1, 1.3, 1.6):
        for length in (0.8, 2.5):
            measured = shares(lambda d: pair(b, d), length, names, dice)
            p = ghost_share(b, length)
            m = {n: 1 - measured[n][1] for n in names}
            rows.append((b, length, m["swept"], f"{m['speculative']:.4f}", f"{p:.4f}"))
            good &= m["swept"] == 0 and not off(m["speculative"], p, PHASES)
    table(["b", "step", "swept: stopped", "speculative: stopped", "formula"], rows)
    return good


def orders(dice):
    """The same plate, w = 0.4, its front edge listed before the back one: pushed out of the front, the ball is through."""
    rows, good = [], True
    for length in (0.98, 1.54):
        for front_first, zone in ((False, 0.9), (True, 0.5)):
            m = shares(lambda d, f=front_first: plate(0.4, d, f), length, ["discrete"], dice)["discrete"][1]
            p = missed(zone, length)
            rows.append(("front" if front_first else "back", length, f"{m:.4f}", f"{p:.4f}"))
            good &= not off(m, p, PHASES)
    table(["edge listed first", "step", "discrete no impulse", "formula"], rows)
    return good


def main():
    engines = built([e for e in ENGINES if not QUICK or e in ("box2d", "chipmunk")])
    own = ["discrete", "discrete:iterations=8:correction=baumgarte", "swept", "speculative", "penalty:steps=10"]
    lengths = (0.8, 1.6, 2.5, 4.0, 8.0)
    good = study("two balls", "b", pair, [(b, lengths) for b in (0.0, 0.5, 0.9)], own + engines, expected_pair, "miss.csv")
    own = ["discrete", "swept", "speculative"]
    cases = [(w, [share * (1 + w) for share in (0.45, 0.7, 0.9, 1.1, 1.5, 3.0)]) for w in (0.0, 0.4)]
    good &= study("plate", "w", plate, cases, own + engines, expected_plate, "plate.csv")
    good &= orders(random.Random(3))
    good &= ghosts(random.Random(2))
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
