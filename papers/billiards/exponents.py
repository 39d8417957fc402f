#!/usr/bin/env python3
"""Lyapunov spectrum of the triangular Lorentz gas against the distance of the disks: exponents.py CAROM [COLLISIONS]

Exponents in units of speed over radius. Gaspard and Baras give the largest to +-0.2 [GaspardBaras1995]; the column "other code"
is from an independent program. Diffusion: the Einstein slope over times 25 to 50, where the horizon is finite (distance below
4 / sqrt 3); beside it the random walk between traps of Machta and Zwanzig, exact as the gaps close [MachtaZwanzig1983].
Prints a table. Exit status 1 if the largest exponent is off by more than 1 % and 4 standard errors, or the spectrum is not
(l, 0, 0, -l) to 1e-3 l.
"""
import json
import math
import pathlib
import subprocess
import sys

SCENE = pathlib.Path(__file__).parent / "lorentz.toml"
OTHER = {2.3: (1.7594, 3e-4), 2.5: (1.3432, 4e-4), 3.0: (0.8553, 8e-4), 3.5: (0.6253, 3e-4), 4.0: (0.4888, 3e-4)}
PUBLISHED = {2.5: 1.4, 3.0: 0.8, 3.5: 0.6, 4.0: 0.5}


def settings(distance):
    height = math.sqrt(3) * distance
    return [f"space.upper=[{distance!r}, {height!r}]", f"ball.0.position=[{distance / 2!r}, {(height / 2 - 1) / 2!r}]",
            f"ball.2.position=[{distance / 2!r}, {height / 2!r}]", "observe.lyapunov=true", "observe.mean_free_path=true"]


def run(carom, distance, collisions, out=None):
    sets = settings(distance)
    command = [carom, "run", str(SCENE), "--json", "--events", str(collisions)]
    if out:
        sets.append("observe.diffusion={ every = 0.5, lags = 100 }")
        command += ["--out", out]
    for s in sets:
        command += ["--set", s]
    return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


def main():
    carom = sys.argv[1] if len(sys.argv) > 1 else "carom"
    collisions = int(sys.argv[2]) if len(sys.argv) > 2 else 1_000_000
    good = True
    print("| distance | l_0 | error | other code | [GaspardBaras1995] | l_1 | l_2 | l_0 + l_3 | free path | error | exact | diffusion | error | traps |")
    print("|---|---|---|---|---|---|---|---|---|---|---|---|---|---|")
    for distance, (other, other_error) in OTHER.items():
        finite = distance < 4 / math.sqrt(3)
        out = run(carom, distance, collisions, "results" if finite else None)
        seen = out["observed"]
        spectrum = [e["value"] for e in seen["lyapunov"]["exponents"]]
        error = seen["lyapunov"]["exponents"][0]["error"]
        path = seen["mean_free_path"]
        exact = (math.sqrt(3) * distance**2 / 2 - math.pi) / 2
        diffusion = ["", "", ""]
        if finite:
            d = seen["diffusion"]["coefficient"]
            w = distance - 2
            traps = w * distance**2 / (math.pi * (math.sqrt(3) * distance**2 - 2 * math.pi))
            diffusion = [f"{d['value']:.4f}", f"{d['error']:.4f}", f"{traps:.4f}"]
        print(f"| {distance} | {spectrum[0]:.5f} | {error:.5f} | {other}({other_error * 1e4:.0f}) | {PUBLISHED.get(distance, '')} | "
              f"{spectrum[1]:+.1e} | {spectrum[2]:+.1e} | {spectrum[0] + spectrum[3]:+.1e} | {path['value']:.5f} | {path['error']:.5f} | "
              f"{exact:.5f} | {' | '.join(diffusion)} |", flush=True)
        good &= abs(spectrum[0] - other) < max(0.01 * other, 4 * math.hypot(error, other_error))
        good &= max(abs(spectrum[1]), abs(spectrum[2]), abs(spectrum[0] + spectrum[3])) < 1e-3 * spectrum[0]
        good &= abs(path["value"] - exact) < max(5e-4 * exact, 4 * path["error"])
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
