#!/usr/bin/env python3
"""Digits lost by the SIAM photon [Trefethen2002]: photon.py CAROM

A displacement of the photon grows at each mirror like that of light at a convex mirror. With kappa = dv/dx of a narrow beam,
across the ray, R the radius and phi the angle of incidence [Sinai1970; papers/tangent_map.md],

  flight s:      kappa <- kappa / (1 + s kappa),   the width grows by the factor 1 + s kappa
  reflection:    kappa <- kappa + 2 / (R cos phi)

so a beam that starts parallel is 10^digits times as wide at the end. This follows the photon in 110 digits by itself, and sets
the digits beside those of `carom check`, and beside the errors of the final place in double .. 50 digits against 100.
Prints tables. Exit status 1 if the digits of `carom check`, which end with the last reflection, are off by more than 0.001, or
if fewer digits are left than those of a rounding less those lost.
"""
import decimal
import json
import math
import pathlib
import subprocess
import sys

SCENE = pathlib.Path(__file__).parents[2] / "examples" / "siam_photon" / "scene.toml"
D = decimal.Decimal
decimal.getcontext().prec = 110
UNIT_ROUNDOFF = {"double": 53 * math.log10(2), "long-double": 64 * math.log10(2), "20": 20, "30": 30, "50": 50}


def beam():
    """log10 of the width of a beam after each reflection, and at t = 10; by reflection at the mirrors of the plane."""
    x, v, left, radius = (D("0.5"), D("0.1")), (D(1), D(0)), D(10), D(1) / 3
    curvature, digits, rows = D(0), D(0), []
    mirrors = [(D(i), D(j)) for i in range(-3, 4) for j in range(-3, 4)]
    while True:
        hit = None
        for c in mirrors:
            d = (x[0] - c[0], x[1] - c[1])
            b, distance = d[0] * v[0] + d[1] * v[1], d[0] ** 2 + d[1] ** 2 - radius**2
            root = b * b - distance
            if b < 0 and root > 0 and (hit is None or -b - root.sqrt() < hit[0]):
                hit = (-b - root.sqrt(), c)
        s = min(hit[0], left) if hit else left
        digits += (1 + s * curvature).log10()
        curvature /= 1 + s * curvature
        x = (x[0] + s * v[0], x[1] + s * v[1])
        left -= s
        if left == 0:
            return x, rows, digits
        n = ((x[0] - hit[1][0]) / radius, (x[1] - hit[1][1]) / radius)
        cosine = -(n[0] * v[0] + n[1] * v[1])
        v = (v[0] + 2 * cosine * n[0], v[1] + 2 * cosine * n[1])
        curvature += 2 / (radius * cosine)
        rows.append((D(10) - left, hit[1], s, cosine, digits))


def final_place(carom, precision):
    done = subprocess.run([carom, "run", str(SCENE), "--json", "--final", "--precision", precision], check=True, capture_output=True,
                          text=True)
    return [D(str(x)) for x in json.loads(done.stdout)["final"][0]["unwrapped_position"]]


def main():
    carom = sys.argv[1] if len(sys.argv) > 1 else "carom"
    place, rows, digits = beam()
    print("| reflection | at time | mirror | flight before | cos phi | digits lost so far |")
    print("|---|---|---|---|---|---|")
    for i, (time, mirror, s, cosine, so_far) in enumerate(rows, 1):
        print(f"| {i} | {time:.6f} | ({mirror[0]}, {mirror[1]}) | {s:.4f} | {cosine:.4f} | {so_far:.2f} |")
    check = json.loads(subprocess.run([carom, "check", str(SCENE), "--json"], check=True, capture_output=True, text=True).stdout)
    horizon = check["horizon"]
    lost = rows[-1][-1]
    print(f"\nBeam at the last of {len(rows)} reflections: {lost:.4f} digits, {lost / len(rows):.4f} each; at t = 10: {digits:.4f}")
    print(f"carom check: {horizon['digits_lost']:.4f} digits, {horizon['digits_per_collision']:.4f} each; position error "
          f"{horizon['position_error']:.1e}, echo error {check['echo_error']:.1e}\n")
    good = abs(horizon["digits_lost"] - float(lost)) <= 1e-3

    truth = final_place(carom, "100")
    off = (sum((a - b) ** 2 for a, b in zip(truth, place))).sqrt()
    print(f"Distance from the origin, 100 digits: {(truth[0] ** 2 + truth[1] ** 2).sqrt():.40f}; the beam's own path is {off:.0e} off\n")
    print("| precision | digits of a rounding | error of the final place | digits left | digits less what is lost |")
    print("|---|---|---|---|---|")
    for precision, roundoff in UNIT_ROUNDOFF.items():
        error = (sum((a - b) ** 2 for a, b in zip(truth, final_place(carom, precision)))).sqrt()
        left, expected = -error.log10(), roundoff - float(digits)
        print(f"| {precision} | {roundoff:.1f} | {error:.1e} | {left:.1f} | {expected:.1f} |")
        good &= float(left) >= expected
    return 0 if good and off < D("1e-85") else 1


if __name__ == "__main__":
    sys.exit(main())
