#!/usr/bin/env python3
"""Lyapunov spectra of hard disks: hard_disks.py CAROM [COLLISIONS A DISK]

N disks in a periodic square have 4 N exponents in pairs that add up to 0; 6 of them are 0, for the centre of mass, its
momentum, the flow and energy [DellagoPosch1997]. Prints the largest, the entropy a disk, the largest sum of a pair and the
largest of the six, in units of sqrt(kT/m) / diameter. Exit status 1 if a sum or a zero is above 0.5 % of the largest exponent.
"""
import json
import pathlib
import subprocess
import sys

SCENE = pathlib.Path(__file__).parent / "hard_disks.toml"


def main():
    carom = sys.argv[1] if len(sys.argv) > 1 else "carom"
    each = int(sys.argv[2]) if len(sys.argv) > 2 else 10_000
    good = True
    print("| disks | packing | l_0 | error | smallest above 0 | entropy a disk | largest pair | largest zero |")
    print("|---|---|---|---|---|---|---|---|")
    for disks, packing in ((4, 0.2), (4, 0.4), (16, 0.2), (16, 0.4), (36, 0.4)):
        command = [carom, "run", str(SCENE), "--json", "--events", str(1000 + each * disks // 2), "--set", f"gas.0.count={disks}",
                   "--set", f"gas.0.packing_fraction={packing}", "--set", f"observe.lyapunov.exponents={4 * disks}"]
        seen = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)["observed"]["lyapunov"]
        spectrum = [e["value"] for e in seen["exponents"]]
        half = 2 * disks
        pair = max(abs(spectrum[k] + spectrum[-1 - k]) for k in range(half))
        zero = max(abs(x) for x in spectrum[half - 3:half + 3])
        print(f"| {disks} | {packing} | {spectrum[0]:.4f} | {seen['exponents'][0]['error']:.4f} | {spectrum[half - 4]:.4f} | "
              f"{seen['entropy']['value'] / disks:.4f} | {pair:.1e} | {zero:.1e} |", flush=True)
        good &= max(pair, zero) < 5e-3 * spectrum[0]
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
