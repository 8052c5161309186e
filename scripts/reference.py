#!/usr/bin/env python3
"""Reviewed output of the quick studies, in results/reference/.

  scripts/reference.py check [--program build/gridstep] [STUDY ...]   run them anew and compare
  scripts/reference.py update [--program build/gridstep] [STUDY ...]  run them anew and store: review the diff

A row is one estimator at one h: counts are summed over the shifts, errors averaged. Integers (surfels, cells visited,
restarts, ...) must be equal; errors agree within 1e-12 relative, which leaves room for another mathematics library and
none for another formula. Timings are not compared.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
REFERENCE = ROOT / "results" / "reference"
STUDIES = ["paper-2d", "paper-3d", "radius-exponent", "noise", "compare-2d"]
TOLERANCE = 1e-12
KEY = ["shape", "noise", "h", "estimator", "evaluation", "k", "alpha"]
COUNTS = ["surfels", "singular", "far", "components"]
WORK = ["evaluations", "cells_visited", "restarts", "kernel_size"]
NORMS = ["sup", "rms", "mean"]


def run(program, study):
    """The records of a new run, reduced to what is compared."""
    with tempfile.TemporaryDirectory() as folder:
        command = [program, "study", study, "--quick", "--out", folder]
        done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        if done.returncode != 0:
            sys.exit(f"{' '.join(command)} failed:\n{done.stderr}")
        lines = (pathlib.Path(folder) / "records.jsonl").read_text().splitlines()
    return rows_of([json.loads(line) for line in lines[1:]])


def rows_of(records):
    by_key = {}
    for record in records:
        by_key.setdefault(json.dumps([record[k] for k in KEY]), []).append(record)
    return [row(json.loads(key), shifts) for key, shifts in by_key.items()]


def row(key, shifts):
    quantities = {quantity: None for record in shifts for quantity in record["errors"]}  # a set that keeps its order
    errors = {}
    for quantity in quantities:
        norms = [record["errors"][quantity] for record in shifts if quantity in record["errors"]]
        errors[quantity] = [sum(n[name] for n in norms) / len(norms) for name in NORMS]
    counts = [sum(record[c] for record in shifts) for c in COUNTS]
    counts += [sum(record["work"][w] for record in shifts) for w in WORK]
    return {"key": key, "shifts": len(shifts), "counts": counts, "errors": errors}


def store(study, rows):
    head = json.dumps({"schema": 2, "study": study, "key": KEY, "counts": COUNTS + WORK, "norms": NORMS})
    lines = ",\n".join(json.dumps(r) for r in rows)
    (REFERENCE / f"{study}.json").write_text(f'{head[:-1]}, "rows": [\n{lines}\n]}}\n')


def differences(stored, new):
    """One line for each thing that differs."""
    if len(stored) != len(new):
        yield f"{len(new)} rows, the reference has {len(stored)}"
        return
    for old, now in zip(stored, new):
        if old["key"] != now["key"]:
            yield f"{now['key']}: the reference has {old['key']} here"
        for name, a, b in zip(["shifts"] + COUNTS + WORK, [old["shifts"]] + old["counts"], [now["shifts"]] + now["counts"]):
            if a != b:
                yield f"{now['key']}: {name} = {b}, the reference has {a}"
        if old["errors"].keys() != now["errors"].keys():
            yield f"{now['key']}: quantities {list(now['errors'])}, the reference has {list(old['errors'])}"
            continue
        for quantity, norms in old["errors"].items():
            for norm, a, b in zip(NORMS, norms, now["errors"][quantity]):
                if abs(a - b) > TOLERANCE * max(abs(a), abs(b)):
                    yield f"{now['key']}: {norm} error of {quantity} = {b!r}, the reference has {a!r}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("action", choices=["check", "update"])
    parser.add_argument("studies", nargs="*", metavar="STUDY", help=f"of {', '.join(STUDIES)} (default: all)")
    parser.add_argument("--program", default=str(ROOT / "build" / "gridstep"))
    options = parser.parse_args()
    failed = False
    for study in options.studies or STUDIES:
        if study not in STUDIES:
            parser.error(f"no reference for study '{study}'")
        rows = run(options.program, study)
        if options.action == "update":
            store(study, rows)
            print(f"{study}: {len(rows)} rows stored")
            continue
        found = list(differences(json.loads((REFERENCE / f"{study}.json").read_text())["rows"], rows))
        print(f"{study}: {len(rows)} rows, {len(found)} differences")
        for line in found[:20]:
            print("  " + line)
        failed = failed or bool(found)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
