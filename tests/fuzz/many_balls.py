#!/usr/bin/env python3
"""Random scenes of 40 to 900 balls by lists and by cells with a heap: the same log? many_balls.py CAROM [COUNT] [SEED]

Plane and space; periodic (narrow ones too), boxes, some with a circle inside, stadiums; one to three kinds of balls; elastic or
e = 0.9. 6000 events of each. COUNT scenes (default 200) from SEED (default 1) on, each a function of its number alone. Scenes that
lists do not take, or that cannot be placed, are refused and counted. Exit status 1 if a log differs; the scene is kept.
"""
import random
import subprocess
import sys
import tempfile
from pathlib import Path


def scene(number):
    dice = random.Random(number)
    dimension = dice.choice([2, 2, 3])
    kind = dice.choice(["periodic", "periodic", "box"] + ["table"] * (dimension == 2))
    text = f"dimension = {dimension}\n[collision]\nrestitution = {dice.choice([1, 1, 1, 0.9])}\n"
    if kind == "table":
        radius, length = dice.uniform(1, 3), dice.uniform(0.5, 4)
        text += f'[[table]]\nkind = "stadium"\nradius = {radius}\nlength = {length}\n'
        volume = 3.14 * radius**2 + 2 * radius * length
    else:
        edges = [dice.uniform(2, 12) for _ in range(dimension)]
        if dice.random() < 0.3:
            edges[0] = dice.uniform(1.2, 3)
        text += f'[space]\nkind = "{kind}"\nlower = {[0] * dimension}\nupper = {edges}\n'
        volume = 1
        for edge in edges:
            volume *= edge
        if kind == "box" and dimension == 2 and dice.random() < 0.5:
            centre = [edge * dice.uniform(0.3, 0.7) for edge in edges]
            text += f'[[wall]]\nkind = "circle"\ncentre = {centre}\nradius = {min(edges) * dice.uniform(0.05, 0.2)}\n'
    kinds, packing = dice.choice([1, 1, 2, 3]), 10 ** dice.uniform(-5, -0.5)
    for _ in range(kinds):
        count = dice.randint(40, 300)
        share = packing / kinds * volume / count
        radius = (share / 3.14) ** 0.5 if dimension == 2 else (share / 4.19) ** (1 / 3)
        text += f"[[gas]]\ncount = {count}\nradius = {radius}\nmass = {dice.choice([1, 1, 2.5])}\nseed = {dice.randint(1, 999)}\n"
    return text + "[run]\nevents = 6000\n"


def log(carom, folder, search, queue):
    """The log, or None where the scene is refused."""
    done = subprocess.run([carom, "run", "scene.toml", "--quiet", "--set", f'engine.search="{search}"', "--set", f'engine.queue="{queue}"',
                           "--set", 'output.events="log.csv"', "--out", "."], cwd=folder, capture_output=True, text=True)
    if done.returncode not in (0, 2, 3):
        sys.exit(f"exit status {done.returncode}: {done.stderr}")
    return None if done.returncode == 2 else (Path(folder) / "log.csv").read_bytes()


def main():
    carom = str(Path(sys.argv[1]).resolve())
    count, first = (int(x) for x in (sys.argv[2:] + ["200", "1"][len(sys.argv) - 2:]))
    refused = differ = 0
    with tempfile.TemporaryDirectory() as folder:
        for number in range(first, first + count):
            (Path(folder) / "scene.toml").write_text(scene(number))
            lists = log(carom, folder, "neighbour_list", "calendar")
            if lists is None:
                refused += 1
            elif lists != log(carom, folder, "cells", "heap"):
                differ += 1
                Path(f"differs_{number}.toml").write_text(scene(number))
                print(f"scene {number}: the logs differ", flush=True)
    print(f"{count} scenes, {refused} refused, {differ} differ")
    sys.exit(differ > 0)


main()
