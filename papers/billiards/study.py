"""What the scripts of this study share: `carom` as a function, folders for its files, tables, bounds."""
import csv
import json
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).parent
EXAMPLES = HERE.parent.parent / "examples"
LONG = "--long" in sys.argv
CAROM = next((a for a in sys.argv[1:] if not a.startswith("--")), "carom")

_folder = tempfile.TemporaryDirectory(prefix="carom-billiards-")
_good = True


def carom(command, scene, *settings, out=None, **options):
    """The JSON object of `carom COMMAND`; `scene` is a path or the text of a scene, options are those of the command line."""
    path = scene
    if "\n" in str(scene):
        path = pathlib.Path(_folder.name) / "scene.toml"
        path.write_text(scene)
    line = [CAROM, command, str(path), "--json"] + (["--out", str(out)] if out else [])
    for name, value in options.items():
        line += [f"--{name}"] + ([] if value is True else [str(value)])
    for setting in settings:
        line += ["--set", setting]
    done = subprocess.run(line, capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{' '.join(line)}\nended with status {done.returncode}: {done.stderr}")
    return json.loads(done.stdout)


def run(scene, *settings, **options):
    return carom("run", scene, *settings, **options)


def folder(name):
    """An empty folder that is gone at the end."""
    path = pathlib.Path(_folder.name) / name
    shutil.rmtree(path, ignore_errors=True)
    path.mkdir()
    return path


def rows(path):
    """The rows of a table that carom wrote, as dictionaries of text."""
    with open(path, newline="") as file:
        yield from csv.DictReader(line for line in file if not line.startswith("#"))


def head(*names):
    print("| " + " | ".join(names) + " |\n|" + "---|" * len(names), flush=True)


def row(*cells):
    print("| " + " | ".join(map(str, cells)) + " |", flush=True)


def mean(values):
    """Mean and standard error."""
    n = len(values)
    middle = math.fsum(values) / n
    return middle, math.sqrt(math.fsum((v - middle) ** 2 for v in values) / (n * (n - 1))) if n > 1 else math.nan


def within(what, value, known, bound, error=None):
    """Whether value is within the bound of known, and within 4 standard errors where there are."""
    global _good
    off = abs(value - known)
    good = off <= bound and (error is None or off <= 4 * error)
    if not good:
        print(f"\nBROKEN: {what} is {value}{'' if error is None else f' +- {error}'}, known {known}, bound {bound}", flush=True)
        _good = False
    return good


def end():
    sys.exit(0 if _good else 1)
