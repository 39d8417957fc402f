#!/usr/bin/env python3
"""At which collision double precision fails, for each scene in examples/: examples.py CAROM

Each scene that certify takes is proven to its end, or through so many events as EVENTS says; beside it stand the double run of the
same scene, and the digits a collision that a small error grows by (`carom check`, the tangent map). Prints CSV: scene, events
proven, digits of the last try, digits lost an event, of them by the tangent map, first collision at which a place is off by a
hundredth of the smallest radius (without one: edge), first with another partner, seconds; or the reason why there is no proof.
Exit status 1 if a log was refuted.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

EXAMPLES = pathlib.Path(__file__).parents[2] / "examples"
MOST = 1000
EVENTS = {"gas_in_a_box": 8000, "gas_periodic": 1000, "polygon_table": 2000, "bouncing_ball": 100}
FEW = 100  # balls, for the tangent map
SKIP = {"hard_sphere_fluid"}  # thousands of balls


def run(carom, *words):
    return subprocess.run((carom, *words), capture_output=True, text=True)


def main():
    carom, names, status = sys.argv[1], sys.argv[2:], 0
    print("scene,events,digits,lost,tangent,off,different,seconds,remark")
    for folder in sorted(EXAMPLES.iterdir()):
        if not (folder / "scene.toml").exists() or folder.name in SKIP or (names and folder.name not in names):
            continue
        scene, events = str(folder / "scene.toml"), str(EVENTS.get(folder.name, MOST))
        with tempfile.TemporaryDirectory() as out:
            proof = run(carom, "certify", scene, "--events", events, "--out", out, "--json")
        remark = proof.stderr.strip().splitlines()[-1].replace(scene, "").split(" (")[0].lstrip(":0123456789 ").replace(",", ";") if proof.stderr else ""
        if not proof.stdout:
            print(f"{folder.name},,,,,,,,{remark}", flush=True)
            continue
        report = json.loads(proof.stdout)
        status |= report["verdict"] == "refuted"
        tangent = ""
        if report["events"] > 0 and len(report["final"]) <= FEW:
            check = run(carom, "check", scene, "--events", str(report["events"]), "--audits", "1", "--horizon", "100000", "--json")
            if check.stdout:
                growth = (json.loads(check.stdout)["horizon"] or {}).get("digits_per_collision")
                tangent = "" if growth is None else f"{growth:.3f}"
        beside = report["against_double"] or {}
        mark = lambda m: str(m["event"]) if m else "-"
        print(f"{folder.name},{report['events']},{report['digits']},{report['digits_per_event']:.3f},{tangent},"
              f"{mark(beside.get('off'))},{mark(beside.get('different'))},{report['seconds']:.2f},{remark}", flush=True)
    return status


sys.exit(main())
