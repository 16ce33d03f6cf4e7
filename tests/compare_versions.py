#!/usr/bin/env python3
"""Runs two builds of myoloop on the same experiments and compares every number that they write.

usage: tests/compare_versions.py BEFORE AFTER [--task simulate|calibrate|diagnose] [--data FOLDER] [--numbers]
                                 [EXPERIMENT...]

Without EXPERIMENT: the bundled examples, and the experiments of FOLDER/experiments (default: MYOLOOP_DATA or
../shared).
One row per experiment: the largest relative difference of any number in any JSON or CSV file, 0 where all bits agree.
Times, versions and the call itself are left out. Exit status 1 where files or texts differ or a difference exceeds the
limit of the task: 0 (simulate), 1e-9 (calibrate), 1e-6 (diagnose). --numbers: sentences, which a change of words
touches, are left out; names and verdicts, which are single words, are compared.
"""
import argparse
import csv
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
LIMIT = {"simulate": 0.0, "calibrate": 1e-9, "diagnose": 1e-6}
LEFT_OUT = {"version", "command", "seconds", "wall_s", "cpu_s", "setup_s", "forward_s", "backward_s", "fit_s",
            "solve_s", "run_s", "numerical_error_s", "peak_memory_bytes", "cost", "memory_bytes", "seconds_per_step",
            "real_time_factor"}


def leaves(value, path=()):
    if isinstance(value, dict):
        for key, item in value.items():
            if key not in LEFT_OUT and not key.endswith("seconds") and not key.startswith("wall"):
                yield from leaves(item, path + (key,))
    elif isinstance(value, list):
        for i, item in enumerate(value):
            yield from leaves(item, path + (i,))
    else:
        yield path, value


def values_of(path):
    if path.suffix == ".json":
        return dict(leaves(json.loads(path.read_text())))
    rows = csv.reader(path.open())
    return {(i, j): cell for i, row in enumerate(rows) for j, cell in enumerate(row)}


def number(value):
    if isinstance(value, bool):
        return None
    try:
        return float(value)
    except (TypeError, ValueError):
        return None


def difference(a, b):
    x, y = number(a), number(b)
    if x is None or y is None:
        return 0.0 if a == b else math.inf
    if x == y or (math.isnan(x) and math.isnan(y)):
        return 0.0
    return abs(x - y) / max(abs(x), abs(y), 1e-12)


def is_sentence(value):
    return isinstance(value, str) and " " in value.strip()


def results(folder):
    """Files of results. The cache of fits is left out: its keys hold all digits of the values."""
    return {p.relative_to(folder) for p in folder.rglob("*")
            if p.suffix in (".json", ".csv") and p.name != "diagnose_fits.json"}


def compare(before, after, numbers_only):
    worst, where = 0.0, ""
    names, others = results(before), results(after)
    if names != others:
        return math.inf, f"files differ: {sorted(map(str, names ^ others))[:3]}"
    for name in sorted(names):
        a, b = values_of(before / name), values_of(after / name)
        if a.keys() != b.keys():
            return math.inf, f"{name}: keys differ: {sorted(map(str, a.keys() ^ b.keys()))[:3]}"
        for key in a:
            if numbers_only and is_sentence(a[key]) and is_sentence(b[key]):
                continue
            d = difference(a[key], b[key])
            if d > worst:
                worst, where = d, f"{name} {'.'.join(map(str, key))}: {a[key]} {b[key]}"
    return worst, where


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("before")
    parser.add_argument("after")
    parser.add_argument("--task", choices=LIMIT, default="simulate")
    parser.add_argument("--data", default=os.environ.get("MYOLOOP_DATA", str(ROOT.parent / "shared")))
    parser.add_argument("--numbers", action="store_true")
    parser.add_argument("experiment", nargs="*")
    call = parser.parse_intermixed_args()
    folders = [pathlib.Path(e) for e in call.experiment] or sorted(
        p.parent for base in (ROOT / "assets/examples", pathlib.Path(call.data) / "experiments")
        for p in base.glob("*/experiment.toml"))
    failed = False
    for folder in folders:
        with tempfile.TemporaryDirectory() as scratch:
            statuses, outs = [], []
            for side, program in (("before", call.before), ("after", call.after)):
                out = pathlib.Path(scratch) / side
                run = subprocess.run([program, call.task, str(folder), "--out", str(out), "--quiet"],
                                     capture_output=True, text=True, check=False)
                statuses.append(run.returncode)
                outs.append(out)
            if statuses != [0, 0]:
                worst, where = math.inf, f"exit status {statuses[0]} and {statuses[1]}"
            else:
                worst, where = compare(*outs, call.numbers)
        bad = worst > LIMIT[call.task]
        failed |= bad
        print(f"{call.task:10} {folder.name:32} {worst:9.2g} {'DIFFERS ' + where if bad else ''}", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
