#!/usr/bin/env python3
"""Cost of a proof against events and digits: cost.py CAROM [LAST]

Ten disks in a box (ten_disks.toml), from 250 events on, twice as many each time up to LAST (default 8000). Each proof is made in
one try, in the digits that the one before says are needed and a quarter more, and its certificate is verified. Prints CSV:
events, digits, digits lost an event, seconds of processor time to prove, of that to verify, peak memory [MB]. Exit status 1 if
something is not proven.
"""
import json
import pathlib
import resource
import subprocess
import sys
import tempfile

SCENE = pathlib.Path(__file__).with_name("ten_disks.toml")


def timed(*words):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    out = subprocess.run(words, capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if out.returncode:
        sys.exit(f"{' '.join(words)}: {out.stderr}")
    return json.loads(out.stdout), after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, after.ru_maxrss / 1024


def main():
    carom, last = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 8000
    print("events,digits,lost,prove,verify,memory")
    events, rate = 250, 0.12
    while events <= last:
        digits = int(30 + 1.25 * rate * events)
        with tempfile.TemporaryDirectory() as folder:
            report, prove, memory = timed(carom, "certify", str(SCENE), "--events", str(events), "--digits", str(digits),
                                          "--out", folder, "--json")
            checked, verify, _ = timed(carom, "certify", "--verify", f"{folder}/certified.csv", "--json")
        if report["tries"] != 1 or checked["events"] != events:
            sys.exit(f"{events} events: {report['tries']} tries, {checked['events']} verified")
        rate = report["digits_per_event"]
        print(f"{events},{digits},{rate:.4f},{prove:.2f},{verify:.2f},{memory:.0f}", flush=True)
        events *= 2


main()
