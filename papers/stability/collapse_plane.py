#!/usr/bin/env python3
"""Below which restitution three disks in the plane collapse: collapse_plane.py CAROM [DIGITS ...]

Of three balls in a chain, the relative normal speeds fall by mu_1 from one impact to the next and the times by mu_2 / mu_1,
mu_1 >= mu_2 the roots of  x^2 - x (1 + r) cos(theta) / 2 + r = 0,  theta the bend of the chain (papers/stability/README.md).
Real roots are collapse on a line, r <= 7 - 4 sqrt 3 at theta = 0. In the plane disks that slide past each other with a
transverse speed turn the normals, which changes normal speeds by as much as the times: nothing is left of a collapse unless
mu_2 / mu_1 < mu_1, r < 9 - 4 sqrt 5 at theta = 0 [ZhouKadanoff1996].

Bisects for the edge in three_disks_plane.toml, bent and straight, in several precisions. Exit status 1 if a bent chain's edge
does not fall with the digits, is below that for its bend by more than the width of the bisection, or at 400 digits is above by
more than 1e-4; or if a straight one's is not within 1e-4 of 7 - 4 sqrt 3.
"""
import json
import math
import pathlib
import subprocess
import sys

SCENE = pathlib.Path(__file__).parent / "three_disks_plane.toml"
STEPS = 14
LOW, HIGH = 0.05, 0.075


def run(carom, r, precision, straight):
    """Whether it collapsed, the impacts, and cos theta at the end."""
    command = [carom, "run", str(SCENE), "--json", "--final", "--precision", precision, "--set", f"collision.restitution={r!r}"]
    if straight:
        command += ["--set", "ball.2.position=[\"7/4\",\"0\"]"]
    out = json.loads(subprocess.run(command, capture_output=True, text=True).stdout)
    (ax, ay), (bx, by), (cx, cy) = ([float(x) for x in ball["position"]] for ball in out["final"])
    dot = (bx - ax) * (cx - bx) + (by - ay) * (cy - by)
    cosine = dot / (math.hypot(bx - ax, by - ay) * math.hypot(cx - bx, cy - by))
    assert out["stopped_by"] in ("collapse", "no_events_left")
    return out["stopped_by"] == "collapse", out["events"]["ball_ball"], cosine


def critical(cosine):
    """r at which mu_2 = mu_1^2: then mu_1 = r^(1/3) = x, and (1 - x + x^2) cos theta = 2 x."""
    b = 1 + 2 / cosine
    return ((b - math.sqrt(b * b - 4)) / 2) ** 3


def edge(carom, precision, straight):
    """Largest r found to collapse and smallest found not to, with their runs."""
    low, high = LOW, HIGH
    below, above = run(carom, low, precision, straight), run(carom, high, precision, straight)
    assert below[0] and not above[0]
    for _ in range(STEPS):
        middle = (low + high) / 2
        result = run(carom, middle, precision, straight)
        if result[0]:
            low, below = middle, result
        else:
            high, above = middle, result
    return low, high, below, above


def main():
    carom = sys.argv[1] if len(sys.argv) > 1 else "carom"
    precisions = sys.argv[2:] or ["double", "50", "100", "200", "400", "800"]
    good = True
    print(f"9 - 4 sqrt 5 = {critical(1):.6f}, 7 - 4 sqrt 3 = {7 - 4 * math.sqrt(3):.6f}\n")
    print("| chain | precision | collapses at r | impacts | ends at r | impacts | bend at the collapse | edge for that bend | above it by |")
    print("|---|---|---|---|---|---|---|---|---|")
    last = HIGH
    for straight in (False, True):
        for precision in precisions if not straight else ["double", "100"]:
            low, high, below, above = edge(carom, precision, straight)
            bend = math.acos(min(1.0, below[2]))
            expected = 7 - 4 * math.sqrt(3) if straight else critical(below[2])
            print(f"| {'straight' if straight else 'bent'} | {precision} | {low:.6f} | {below[1]} | {high:.6f} | {above[1]} | {bend:.4f} "
                  f"| {expected:.6f} | {low - expected:+.1e} |", flush=True)
            if straight:
                good &= abs(low - expected) <= (3e-3 if precision == "double" else 1e-4)
            else:
                good &= high > expected and low < last
                good &= precision != "400" or low - expected <= 1e-4
                last = low
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
