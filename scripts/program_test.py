#!/usr/bin/env python3
"""Tests of the program as a user meets it. Usage: program_test.py PROGRAM [unittest arguments]"""

import csv
import io
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = ""
DISK = {"name": "disk", "sweeps": [{"shapes": ["disk"], "estimators": ["ii"], "radii": [{"k": 3}],
                                    "schedule": {"from": 0.5, "to": 0.1, "steps": 6}, "shifts": 3}]}


def run(*arguments, **options):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=120, **options)


def estimate(shape="ellipse", h="1", estimator="ii", *more):
    radius = [] if "--radius" in more or "--k" in more else ["--k", "3"]
    return ["estimate", "--shape", shape, "--h", h, "--estimator", estimator, *radius, *more]


def numbers(folder):
    """The records of a run without their timings."""
    records = [json.loads(line) for line in (folder / "records.jsonl").read_text().splitlines()[1:]]
    for record in records:
        del record["seconds"]
    return records


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, content):
        path = self.folder / name
        path.write_text(content if isinstance(content, str) else json.dumps(content))
        return str(path)


class BadInput(InFolder):
    def refused(self, arguments, *named):
        before = sorted(self.folder.rglob("*"))
        done = run(*arguments, cwd=self.folder)
        with self.subTest(arguments=arguments):
            self.assertNotEqual(done.returncode, 0)
            self.assertEqual(done.stdout, "")
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            for part in named:
                self.assertIn(part, done.stderr)
            self.assertEqual(sorted(self.folder.rglob("*")), before, "left something behind")

    def test_names(self):
        self.refused(["frobnicate"], "'frobnicate'", "estimate")
        self.refused(estimate("blob"), "'blob'", "ellipse")
        self.refused(estimate("ellipse:q=3"), "'q'", "angle")
        self.refused(estimate("ellipse:a=-3"), "a = -3")
        self.refused(estimate("flower:amplitude=30"), "amplitude=30", "radius=20")
        self.refused(estimate("ellipse", "1", "iii"), "'iii'", "ii-covariance")
        self.refused(estimate("ellipse", "1", "ii-covariance"), "ii-covariance", "2D")
        self.refused(estimate("ellipse", "1", "ii", "--evaluation", "fast"), "'fast'", "masks")
        self.refused(["study", "paper-4d"], "'paper-4d'", "paper-2d")
        self.refused(["list", "shapez"], "shapez")

    def test_grid_step_and_radius(self):
        for h in ["-1", "0", "nan", "inf"]:
            self.refused(estimate(h=h), "--h", h)
        self.refused(estimate(h="abc"), "--h", "abc")
        self.refused(["estimate", "--shape", "ellipse", "--estimator", "ii", "--k", "3"], "--h")
        self.refused(["estimate", "--shape", "ellipse", "--h", "1", "--estimator", "ii"], "--radius", "--k")
        self.refused(estimate("ellipse", "1", "ii", "--radius", "0.5"), "R/h = 0.5")
        self.refused(estimate("ellipse", "1", "ii", "--radius", "nan"), "--radius", "nan")
        self.refused(estimate("ellipse", "1", "ii", "--k", "2", "--alpha", "nan"), "--alpha", "nan")
        self.refused(estimate("ellipse", "1", "ii", "--shift", "1,2,3"), "--shift", "3")
        self.refused(estimate("ellipse", "1", "ii", "--noise", "1"), "--noise", "1")

    def test_shapes_that_cannot_be_digitized(self):
        self.refused(estimate("disk:radius=0.1,cx=0.5"), "disk:radius=0.1", "h = 1")
        self.refused(estimate("sphere", "1e-5"), "sphere", "1e-05", "GiB")
        self.refused(estimate("polynomial:x^2+y^"), "x^2+y^", "character")
        self.refused(estimate("polynomial:x^2+y^2+z^2+1"), "x^2+y^2+z^2+1", "never negative")
        self.refused(estimate("polynomial:x^2-1"), "x^2-1", "unbounded")
        self.refused(estimate("polynomial:x^2+y^2+z^2-4,bound=1"), "x^2+y^2+z^2-4", "half side 1")

    def test_files(self):
        self.refused(["study", self.write("bad.json", '{"name": "x",')], "bad.json", "line 1")
        self.refused(["study", self.write("unknown.json", {**DISK, "foo": 1})], "unknown.json", "'foo'")
        self.refused(["study", self.write("twice.json", '{"name": "x", "name": "y"}')], "twice.json", "name")
        self.refused(["study", self.write("sized.json", DISK), "--full"], "sized.json", "--full")
        self.refused(["study", "paper-2d", "--out", self.write("file", "") + "/out"], "file/out")
        self.refused(estimate("ellipse", "1", "ii", "--csv", "missing/a.csv"), "missing/a.csv", "No such file")
        self.refused(estimate("ellipse", "1", "ii", "--csv", "/dev/full"), "/dev/full", "No space left")

    def test_full_disk_leaves_no_partial_file(self):
        # A limit on the size of files stands in for a full disk.
        arguments = estimate("ellipse", "0.05", "ii", "--csv", "a.csv")
        limited = f"ulimit -f 8; trap '' XFSZ; exec {PROGRAM} {' '.join(arguments)}"
        done = subprocess.run(["bash", "-c", limited], capture_output=True, text=True, cwd=self.folder, timeout=60)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("a.csv", done.stderr)
        self.assertEqual(list(self.folder.iterdir()), [])


class Estimate(InFolder):
    def rows(self, *arguments):
        path = self.folder / "out.csv"
        done = run(*arguments, "--csv", str(path))
        self.assertEqual(done.returncode, 0, done.stderr)
        return list(csv.DictReader(io.StringIO(path.read_text())))

    def test_columns(self):
        plane = ["kx", "ky", "x", "y", "kappa", "sum", "true_kappa", "error"]
        self.assertEqual(list(self.rows(*estimate("ellipse", "0.5", "ii", "--raw"))[0]), plane)
        space = ["kx", "ky", "kz", "x", "y", "z", "mean", "true_mean", "error"]
        self.assertEqual(list(self.rows(*estimate("sphere", "1"))[0]), space)
        row = self.rows(*estimate("torus", "0.5", "ii-covariance", "--k", "2", "--raw"))[0]
        quantities = ["mean", "gaussian", "k1", "k2"] + [v + "_" + c for v in ("normal", "dir1", "dir2") for c in "xyz"]
        raw = ["sum"] + ["cov_" + c for c in ("xx", "xy", "xz", "yy", "yz", "zz")]
        errors = ["error", "error_gaussian", "error_k1", "error_k2"]
        self.assertEqual(list(row), space[:6] + quantities + raw + ["true_" + q for q in quantities] + errors)
        self.assertAlmostEqual(float(row["mean"]) - float(row["true_mean"]), float(row["error"]), 12)

    def test_surfels(self):
        rows = self.rows(*estimate("ellipse", "0.5", "ii", "--shift", "0.1,0.2"))
        cells = [(int(r["kx"]), int(r["ky"])) for r in rows]
        self.assertEqual(len(set(cells)), len(cells))
        for (kx, ky), row in zip(cells, rows):
            self.assertEqual((kx + ky) % 2, 1)
            self.assertEqual((float(row["x"]), float(row["y"])), (0.25 * (kx - 1), 0.25 * (ky - 1)))
        for (ax, ay), (bx, by) in zip(cells, cells[1:] + cells[:1]):  # along the contour: the next one shares a pointel
            self.assertLessEqual(abs(ax - bx) + abs(ay - by), 2)

    def test_no_number_at_a_corner(self):
        rows = self.rows(*estimate("square", "1"))
        self.assertTrue(any(r["true_kappa"] == "" and r["error"] == "" for r in rows))
        self.assertTrue(all(float(r["kappa"]) == float(r["kappa"]) for r in rows))

    def test_same_file_for_every_evaluation_and_number_of_threads(self):
        contents = set()
        for options in (["--evaluation", "full"], ["--evaluation", "masks"], ["--threads", "1"], ["--threads", "2"]):
            done = run(*estimate("goursat", "1", "ii-covariance", "--raw", *options), "--csv", "-")
            self.assertEqual(done.returncode, 0)
            contents.add(done.stdout)
        self.assertEqual(len(contents), 1)


class Study(InFolder):
    def test_outputs(self):
        study = self.write("disk.json", DISK)
        out = self.folder / "out"
        done = run("study", study, "--out", str(out), "--csv", "--latex")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("verdict", done.stdout)
        names = {path.name for path in out.iterdir()}
        self.assertEqual(names, {"records.jsonl", "summary.json", "convergence.csv", "convergence.tex", "cost.csv",
                                 "cost.tex"})
        head = json.loads((out / "records.jsonl").read_text().splitlines()[0])
        self.assertEqual(head["study"]["name"], "disk")
        for key in ("commit", "dirty", "compiler", "flags", "cpu"):
            self.assertIn(key, head["provenance"])
        self.assertEqual(len(numbers(out)), 18)
        summary = json.loads((out / "summary.json").read_text())
        self.assertEqual([c["norm"] for c in summary["convergence"]], ["sup", "rms", "mean"])

    def test_killed_and_resumed(self):
        long = json.loads(json.dumps(DISK))
        long["sweeps"][0]["schedule"] = {"from": 0.5, "to": 0.005, "steps": 12}
        study = self.write("long.json", long)
        whole, killed = self.folder / "whole", self.folder / "killed"
        self.assertEqual(run("study", study, "--out", str(whole)).returncode, 0)
        process = subprocess.Popen([PROGRAM, "study", study, "--out", str(killed)], stderr=subprocess.DEVNULL)
        journal = killed / "journal.jsonl"
        while not (journal.exists() and journal.read_text().count("\n") > 5) and process.poll() is None:
            time.sleep(0.005)
        process.send_signal(signal.SIGKILL)
        process.wait()
        self.assertFalse((killed / "records.jsonl").exists())
        done = run("study", study, "--out", str(killed))
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("--resume", done.stderr)
        done = run("study", study, "--out", str(killed), "--resume")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(numbers(killed), numbers(whole))
        self.assertFalse(journal.exists())


class Help(unittest.TestCase):
    def test_every_command_has_help_with_an_example(self):
        for command in ([], ["list"], ["study"], ["estimate"]):
            done = run(*command, "--help")
            self.assertEqual(done.returncode, 0)
            self.assertIn("gridstep " + " ".join(command), done.stdout)
            self.assertIn("Example", done.stdout)

    def test_list_as_json(self):
        everything = json.loads(run("list", "--json").stdout)
        self.assertEqual(set(everything), {"shapes", "estimators", "studies"})
        self.assertIn("goursat", [shape["name"] for shape in everything["shapes"]])
        self.assertEqual(set(json.loads(run("list", "shapes", "--json").stdout)), {"shapes"})


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
