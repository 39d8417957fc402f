#!/usr/bin/env python3
"""What unbiased rounding would do to the energy: rounding_walk.py [SAMPLES]

An impact of two balls rounds each component v of their new velocities to the nearest double: an error uniform in half an ulp
either way, so the energy moves by m v delta, of variance (m v ulp(v))^2 / 12; impacts on faces of the box are exact. Summed over
both balls and averaged over impacts as they occur in equilibrium (energy fixed, pairs and lines of centres weighted by the
rate at which they meet) it is the step of a random walk, c^2 E^2. After n impacts, a share f of them of two balls, the root mean
square of the relative error is c sqrt(f n). Prints c for the two scenes, by Monte Carlo with a fixed seed.
"""
import math
import random
import sys

SCENES = {"five_balls.toml": [(1.0, 0.5)] * 3 + [(3.7, 0.7)] * 2, "thousand_disks.toml": [(1.0, 0.5)] * 1000}


def step(balls, samples, dice):
    """c: root of the mean square energy error of an impact, relative to the energy of all balls, N kT."""
    total = weights = 0.0
    dof = 2 * len(balls)
    for _ in range(samples):
        (m, r), (mm, rr) = dice.sample(balls, 2)
        v = [dice.gauss(0, 1) / math.sqrt(m) for _ in range(2)] + [dice.gauss(0, 1) / math.sqrt(mm) for _ in range(2)]
        pair = m * (v[0] ** 2 + v[1] ** 2) + mm * (v[2] ** 2 + v[3] ** 2)
        energy = pair + dice.gammavariate((dof - 4) / 2, 2.0)  # twice the energy of all: a sum of dof squares
        angle = dice.uniform(0, 2 * math.pi)
        n = (math.cos(angle), math.sin(angle))
        approach = (v[0] - v[2]) * n[0] + (v[1] - v[3]) * n[1]
        if approach <= 0:
            continue
        weight = (r + rr) * approach / math.sqrt(energy)
        scale = math.sqrt(dof / energy)  # to kT = 1, as the scenes have
        push = 2 * approach / (m + mm)
        after = [(m, v[0] - mm * push * n[0]), (m, v[1] - mm * push * n[1]), (mm, v[2] + m * push * n[0]), (mm, v[3] + m * push * n[1])]
        total += weight * sum((mass * scale * x * math.ulp(scale * x)) ** 2 for mass, x in after) / 12 / len(balls) ** 2
        weights += weight
    return math.sqrt(total / weights)


def main():
    samples = int(sys.argv[1]) if len(sys.argv) > 1 else 300_000
    for scene, balls in SCENES.items():
        print(f"{scene}: c = {step(balls, samples, random.Random(1)):.3e}")


if __name__ == "__main__":
    main()
