#!/usr/bin/env python3
"""Compares `sfw evaluate` with ../shared/tools/score.py, a second hand's account of many metrics.

usage: evaluate_agrees_with_score.py SFW

Maps each recording with the given program, scores the map with both and prints a line per common
figure: ours, theirs. score.py ranks equal probabilities in whatever order the sort leaves them, so
its AUC is compared with ties counting half; what it says itself stands in brackets.
Exit status: 0 all within 0.01, 1 not, 77 the recordings or a Python package are missing.
SFW_SHARED names the folder of the recordings if it is not ../shared.
"""

import importlib.util
import json
import os
import pathlib
import subprocess
import sys
import tempfile

SKIPPED = 77
TOLERANCE = 0.01
RECORDINGS = [
    ("turtlebot_home_a", "two_routers.csv"),
    ("turtlebot_home_a", "one_router.csv"),
    ("ble_flat", "survey.csv"),
]
# The name here of each figure of score.py that both give.
FREE = {
    "P": "free_precision",
    "R": "free_recall",
    "IoU": "free_iou",
    "beyond_m2": "beyond_m2",
    "beyond_P": "beyond_precision",
}
WALL = {
    "wallP": "wall_precision_2",
    "wallR": "wall_recall_2",
    "wallF1": "wall_f1_2",
    "occ_in_free": "wall_in_free",
    "leak": "all_walls_called_free",
}

# Runs a script in which argsort(argsort(x)) gives tied values their mean rank: so does this
# replacement of argsort, which leaves mean ranks as they are when applied to them again.
WITH_MEAN_RANKS = """
import runpy, sys
import numpy

def mean_ranks(values):
    _, inverse, counts = numpy.unique(values, return_inverse=True, return_counts=True)
    return (numpy.cumsum(counts) - (counts + 1) / 2)[inverse]

numpy.argsort = mean_ranks
del sys.argv[0]
runpy.run_path(sys.argv[0])
"""


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(SKIPPED)


def require_packages():
    for package in ("numpy", "scipy", "PIL", "yaml"):
        if importlib.util.find_spec(package) is None:
            skip(f"the Python package {package} is missing")


def require_shared():
    root = pathlib.Path(__file__).resolve().parent.parent.parent
    shared = pathlib.Path(os.environ.get("SFW_SHARED", root.parent / "shared"))
    recordings = shared / "data" / "recordings"
    needed = [shared / "tools" / "score.py"]
    needed += [recordings / folder / readings for folder, readings in RECORDINGS]
    for path in needed:
        if not path.exists():
            skip(f"{path} is missing; SFW_SHARED may name the folder")
    return shared


def run(*command):
    result = subprocess.run([str(part) for part in command], stdout=subprocess.PIPE, text=True)
    if result.returncode != 0:
        sys.exit(f"failed with status {result.returncode}: {' '.join(map(str, command))}")
    return result.stdout


def figure_pairs(ours, theirs):
    """Yields (name, our value, their value) of each common figure."""
    yield "free_m2", ours["free_m2"], theirs["free_m2"]
    for side, names in (("map", {**FREE, **WALL}), ("path_only", FREE)):
        for their_name, our_name in names.items():
            yield f"{side} {our_name}", ours[side][our_name], theirs[side][their_name]


def agree(ours, theirs):
    if ours is None or theirs is None:
        return ours is theirs
    return abs(ours - theirs) <= TOLERANCE


def text(value):
    return "none" if value is None else f"{value:.4f}"


def show(name, ours, theirs, note=""):
    """Prints a figure; returns whether the two agree."""
    same = agree(ours, theirs)
    verdict = "ok" if same else "DIFFERS"
    print(f"  {name:28} {text(ours):>9} {text(theirs):>9}  {verdict}{note}")
    return same


def compare(program, shared, folder, readings):
    """Prints the metrics of one recording; returns how many differ."""
    recording = shared / "data" / "recordings" / folder
    path, truth = recording / readings, recording / "truth.yaml"
    with tempfile.TemporaryDirectory() as output:
        recorded = ["--readings", path, "--access-points", recording / "access_points.yaml"]
        run(program, "map", *recorded, "--output", output)
        made = pathlib.Path(output)
        compared = ["--map", made / "map.yaml", "--truth", truth, "--readings", path]
        ours = json.loads(run(program, "evaluate", *compared, "--json"))
        score = [shared / "tools" / "score.py", *compared, "--prob", made / "probability.yaml"]
        theirs = json.loads(run(sys.executable, *score))
        halved = json.loads(run(sys.executable, "-c", WITH_MEAN_RANKS, *score))
    print(f"{folder}/{readings}")
    differing = sum(not show(*pair) for pair in figure_pairs(ours, theirs))
    note = f"  ({text(theirs.get('auc'))})"
    return differing + (not show("map auc", ours["map"]["auc"], halved.get("auc"), note))


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    require_packages()
    shared = require_shared()
    differing = sum(compare(sys.argv[1], shared, *recording) for recording in RECORDINGS)
    print(f"{differing} metrics differ by more than {TOLERANCE}")
    sys.exit(1 if differing else 0)


main()
