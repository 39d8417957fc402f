"""What the scripts of this study share: `carom compare` as a function, tables, CSV files."""
import csv
import json
import math
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).parent
QUICK = "--quick" in sys.argv
CAROM = next((a for a in sys.argv[1:] if not a.startswith("--")), "carom")
ENGINES = ("box2d", "box2d:continuous", "chipmunk", "bullet", "bullet:continuous")


def is_engine(name):
    return name.split(":")[0] in ("box2d", "chipmunk", "bullet")


def name(row):
    return row["engine"] or row["method"]


def call(arguments):
    """Exit status, standard output and standard error of carom."""
    done = subprocess.run([CAROM, *map(str, arguments)], capture_output=True, text=True)
    return done.returncode, done.stdout, done.stderr


def compare(scene, steps, names, *settings, until=None, out=None):
    """The JSON object of one comparison; `scene` is a path or the text of a scene."""
    methods = ",".join(n for n in names if not is_engine(n))
    engines = ",".join(n for n in names if is_engine(n))
    path = HERE / scene if "\n" not in str(scene) else write(scene)
    command = ["compare", path, "--json", "--dt", ",".join(map(repr, steps))]
    command += ["--method", methods] if methods else []
    command += ["--engine", engines] if engines else []
    command += ["--until", repr(until)] if until is not None else []
    command += ["--out", out] if out else []
    for setting in settings:
        command += ["--set", setting]
    status, text, error = call(command)
    if status:
        sys.exit(f"carom {' '.join(map(str, command))}\nended with status {status}: {error}")
    return json.loads(text)


def write(text):
    path = HERE / "out" / (pathlib.Path(sys.argv[0]).stem + ".toml")
    path.parent.mkdir(exist_ok=True)
    path.write_text(text)
    return path


def built(names):
    """Those of the names that this carom has; engines are built in where their packages were found."""
    known = {}
    for n in names:
        engine = n.split(":")[0]
        if is_engine(n) and engine not in known:
            known[engine] = call(["compare", HERE / "drop.toml", "--dt", "0.1", "--until", "0.1", "--engine", engine])[0] == 0
    return [n for n in names if known.get(n.split(":")[0], True)]


def save(file, head, rows):
    """Beside the scripts, or under out/ if --quick."""
    path = HERE / "out" / file if QUICK else HERE / file
    path.parent.mkdir(exist_ok=True)
    with open(path, "w", newline="") as table:
        out = csv.writer(table, lineterminator="\n")
        out.writerow(head)
        out.writerows(rows)


def table(head, rows):
    print("| " + " | ".join(head) + " |")
    print("|" + "---|" * len(head))
    for row in rows:
        print("| " + " | ".join(map(str, row)) + " |")
    print(flush=True)


def number(x, digits=2):
    return "-" if x is None or math.isnan(x) else f"{x:.{digits}g}"


def off(measured, p, n):
    """Whether a measured share is more than 3 standard errors from p; shares that are 0 or 1 must be met exactly."""
    return abs(measured - p) > 3 * math.sqrt(max(0.0, p * (1 - p)) / n)


def phased_steps(distance, speed, length, n, dice):
    """n steps of about `length`, each chosen so that contact, `distance` away, falls on a random phase of a step.

    speed dt = distance / (N + u), u uniform in (0, 1): the contact is u of a step after the N-th one. `distance` must be
    (N + 1/2) length; lengths then differ from `length` by at most 1/(2 N).
    """
    whole = round(distance / length - 0.5)
    return [distance / speed / (whole + dice.random()) for _ in range(n)]
