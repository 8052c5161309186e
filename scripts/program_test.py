#!/usr/bin/env python3
"""Runs the built program as a user does: wrong input, the CSV of estimates, studies and their interruption.

    scripts/program_test.py PATH_OF_GRIDSTEP [unittest options]
"""

import base64
import csv
import io
import json
import math
import os
import re
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import zlib
from pathlib import Path

PROGRAM = None

STUDY = {
    "name": "small",
    "sweeps": [
        {
            "shapes": ["disk:radius=5", "ellipse:a=6,b=3"],
            "estimators": ["ii"],
            "evaluations": ["masks", "full"],
            "radii": [{"k": 2}],
            "schedule": {"from": 1, "to": 0.1, "steps": 5},
            "shifts": 2,
        }
    ],
}


def run(*arguments, folder=None, **keywords):
    return subprocess.run(
        [PROGRAM, *map(str, arguments)], cwd=folder, capture_output=True, text=True, timeout=60, **keywords
    )


class InFolder(unittest.TestCase):
    """Each test runs in an empty folder of its own."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="gridstep_")
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def files(self):
        return sorted(str(p.relative_to(self.folder)) for p in self.folder.rglob("*"))

    def run_here(self, *arguments, **keywords):
        return run(*arguments, folder=self.folder, **keywords)

    def must_work(self, *arguments, **keywords):
        result = self.run_here(*arguments, **keywords)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result

    def must_fail(self, arguments, *named, **keywords):
        """One line on standard error that holds every text of `named`, and no trace in the folder."""
        before = self.files()
        result = self.run_here(*arguments, **keywords)
        self.assertNotEqual(result.returncode, 0)
        self.assertGreater(result.returncode, 0, "killed by a signal")
        self.assertEqual(result.stdout, "")
        self.assertTrue(result.stderr.startswith("gridstep: "), result.stderr)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        self.assertTrue(result.stderr.endswith("\n"))
        for text in named:
            self.assertIn(text, result.stderr)
        self.assertEqual(self.files(), before, "something was left behind")
        return result

    def write_study(self, study, name="small.json"):
        path = self.folder / name
        path.write_text(study if isinstance(study, str) else json.dumps(study))
        return path


class WrongInput(InFolder):
    def test_commands(self):
        for arguments, named in [
            ((), ["list, study, estimate, convert or report"]),
            (("frobnicate",), ["unknown command 'frobnicate'", "study"]),
            (("--frobnicate",), ["--frobnicate"]),
            (("list", "colours"), ["colours", "shapes"]),
            (("study",), ["study"]),
            (("study", "nosuch"), ["unknown study 'nosuch'", "paper-2d"]),
            (("study", "paper-2d", "--quick", "--full"), ["--quick", "--full"]),
            (("study", "paper-2d", "--threads", "0"), ["--threads", "0"]),
            (("study", "paper-2d", "--seed", "-1"), ["--seed", "-1"]),
            (("study", "paper-2d", "--seed", "x"), ["--seed", "x"]),
        ]:
            with self.subTest(arguments=arguments):
                self.must_fail(arguments, *named)

    def test_estimate(self):
        good = {"--shape": "disk:radius=5", "--h": "0.5", "--estimator": "ii", "--k": "3", "--csv": "out.csv"}
        cases = [
            ({"--shape": "dsik"}, ["unknown shape 'dsik'", "disk"]),
            ({"--shape": "disk:diameter=3"}, ["'disk'", "'diameter'", "radius"]),
            ({"--shape": "disk:radius=-3"}, ["radius", "-3"]),
            ({"--shape": "disk:radius=inf"}, ["radius", "inf"]),
            ({"--shape": "disk:radius=nan"}, ["radius", "nan"]),
            ({"--shape": "disk:radius=3x"}, ["radius", "3x"]),
            ({"--shape": "disk:radius=1,radius=2"}, ["radius", "twice"]),
            ({"--shape": "disk:radius="}, ["radius"]),
            ({"--shape": None}, ["--shape", "--image", "--volume"]),
            ({"--shape": "disk:radius=0.01,cx=0.25,cy=0.25"}, ["disk:radius=0.01", "h = 0.5", "coarser"]),
            ({"--shape": "disk:cx=1e30"}, ["disk:cx=1e30", "h = 0.5"]),
            ({"--shape": "polynomial:formula=x^2+y^2-"}, ["polynomial", "x^2+y^2-", "character 9"]),
            ({"--shape": "polynomial:formula=w"}, ["polynomial", "'w'"]),
            ({"--shape": "polynomial:formula=x^2+y^2+z^2+1"}, ["polynomial", "x^2+y^2+z^2+1"]),
            ({"--shape": "polynomial:formula=x"}, ["polynomial 'x'", "bound"]),
            ({"--shape": "polynomial:formula=x^2+y^2-1"}, ["polynomial", "x^2+y^2-1"]),
            ({"--estimator": "iii"}, ["unknown estimator 'iii'", "ii-covariance"]),
            ({"--estimator": "ii-covariance"}, ["ii-covariance", "2D"]),
            ({"--estimator": None}, ["--estimator"]),
            ({"--h": "-1"}, ["--h", "-1"]),
            ({"--h": "0"}, ["--h", "0"]),
            ({"--h": "nan"}, ["--h", "nan"]),
            ({"--h": "inf"}, ["--h", "inf"]),
            ({"--h": "abc"}, ["--h", "abc"]),
            ({"--h": "0.5x"}, ["--h", "0.5x"]),
            ({"--h": None}, ["--h"]),
            ({"--h": "1e-7"}, ["disk:radius=5", "1e-07", "memory"]),
            ({"--h": "1e-300"}, ["disk:radius=5", "1e-300"]),
            ({"--k": "0"}, ["--k", "0"]),
            ({"--k": "-2"}, ["--k", "-2"]),
            ({"--k": "nan"}, ["--k", "nan"]),
            ({"--k": "0.1"}, ["R/h", "h = 0.5"]),
            ({"--k": None}, ["'ii'", "--radius", "--k"]),
            ({"--image": "disk.pgm"}, ["--image", "--shape"]),
            ({"--volume": "disk.vol"}, ["--volume", "--shape"]),
            ({"--threshold": "0,3"}, ["--threshold", "--shape"]),
            ({"--size": "1,1,1"}, ["--size", "--volume"]),
            ({"--quantity": "mean"}, ["--quantity mean", "'ii'", "kappa"]),
            ({"--quantity": "mean", "--estimator": None}, ["--quantity mean", "2D"]),
            ({"--out": "out.ply"}, ["out.ply", ".csv, .npy"]),
            ({"--out": "missing/out.npy"}, ["missing/out.npy"]),
            ({"--estimator": "bc"}, ["--k", "'bc'", "no radius"]),
            ({"--estimator": "ii,mdac"}, ["unknown estimator 'mdac'"]),
            ({"--k": None, "--radius": "0.4"}, ["R/h = 0.8", "R = 0.4", "h = 0.5"]),
            ({"--k": None, "--radius": "inf"}, ["--radius", "inf"]),
            ({"--k": None, "--radius": "1e9"}, ["memory"]),
            ({"--k": None, "--radius": "2", "--alpha": "0.4"}, ["--alpha", "--k"]),
            ({"--radius": "2"}, ["--radius", "--k"]),
            ({"--alpha": "1"}, ["--alpha", "1"]),
            ({"--alpha": "-0.1"}, ["--alpha", "-0.1"]),
            ({"--alpha": "nan"}, ["--alpha", "nan"]),
            ({"--noise": "1"}, ["--noise", "1"]),
            ({"--noise": "-0.5"}, ["--noise", "-0.5"]),
            ({"--noise": "nan"}, ["--noise", "nan"]),
            ({"--shift": "0.1"}, ["--shift", "1", "2D"]),
            ({"--shift": "0.1,nan"}, ["--shift", "nan"]),
            ({"--shift": "0.1,b"}, ["--shift", "b"]),
            ({"--shift": "1e300,0"}, ["disk:radius=5"]),
            ({"--evaluation": "fast"}, ["unknown evaluation 'fast'", "masks"]),
            ({"--centre": "pointel"}, ["'pointel'", "surfel"]),
            ({"--threads": "0"}, ["--threads", "0"]),
            ({"--threads": "-1"}, ["--threads", "-1"]),
            ({"--seed": "-1"}, ["--seed", "-1"]),
            ({"--csv": "missing/out.csv"}, ["missing/out.csv"]),
            ({"--csv": "."}, [".", "directory"]),
            ({"--csv": "/dev/full"}, ["/dev/full", "No space left"]),
        ]
        for change, named in cases:
            with self.subTest(change=change):
                options = {**good, **change}
                arguments = [part for pair in options.items() if pair[1] is not None for part in pair]
                self.must_fail(["estimate", *arguments], *named)
        self.must_work("estimate", *[part for pair in good.items() for part in pair])  # else cases prove nothing
        self.assertEqual(self.files(), ["out.csv"])

    def test_study_files(self):
        def changed(**sweep):
            return {**STUDY, "sweeps": [{**STUDY["sweeps"][0], **sweep}]}

        for study, named in [
            ("", ["small.json"]),
            ('{"name": "a",\n "sweeps": [}', ["small.json", "line 2"]),
            ('{"name": "a", "name": "b"}', ["'name'", "twice"]),
            ("[1]", ["[1]", "object"]),
            ({**STUDY, "sweep": 1}, ["unknown key 'sweep'"]),
            ({**STUDY, "seed": -1}, ["seed = -1"]),
            (changed(shapes=["dsik"]), ["sweeps[0]", "'dsik'"]),
            (changed(shapes=[]), ["sweeps[0]", "shapes = []"]),
            (changed(estimators=["iii"]), ["sweeps[0]", "'iii'"]),
            (changed(radii=[{"k": -1}]), ["sweeps[0].radii[0]", "k = -1"]),
            (changed(radii=[{"k": 0.1}]), ["R/h", "h = 1", "k = 0.1", "alpha = 0.333"]),
            (changed(shifts=0), ["sweeps[0]", "shifts = 0"]),
            (changed(schedule={"values": [1, 1e-7]}), ["disk:radius=5", "1e-07", "memory"]),
            (changed(shapes=["disk:radius=0.001"]), ["disk:radius=0.001", "h = 1", "coarser"]),
        ]:
            with self.subTest(study=study):
                path = self.write_study(study)
                self.must_fail(["study", path, "--out", "out"], *named)

    def test_study_options(self):
        self.write_study(STUDY)
        self.must_fail(["study", "small.json", "--full"], "--full", "small.json")
        self.must_fail(["study", "missing.json"], "missing.json")
        (self.folder / "file").write_text("")
        self.must_fail(["study", "small.json", "--out", "file/below"], "--out", "file/below")
        self.must_fail(["study", "small.json", "--out", "file"], "file")

    def test_standard_output_that_is_full(self):
        with open("/dev/full", "w") as full:
            result = subprocess.run([PROGRAM, "list"], stdout=full, stderr=subprocess.PIPE, text=True)
        self.assertGreater(result.returncode, 0)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)


class Help(unittest.TestCase):
    def test_every_command_has_an_example(self):
        for command in ([], ["list"], ["study"], ["estimate"], ["convert"], ["report"]):
            with self.subTest(command=command):
                result = run(*command, "--help")
                self.assertEqual(result.returncode, 0)
                self.assertEqual(result.stderr, "")
                self.assertRegex(result.stdout, r"Examples?:\n  gridstep ")

    def test_version(self):
        self.assertRegex(run("--version").stdout, r"^gridstep \d+\.\d+\.\d+ \(.+\)\n$")

    def test_list(self):
        everything = json.loads(run("list", "--json").stdout)
        self.assertEqual(list(everything), ["shapes", "estimators", "studies"])
        text = run("list").stdout
        for kind, entries in everything.items():
            self.assertEqual(json.loads(run("list", kind, "--json").stdout), {kind: entries})
            for entry in entries:
                self.assertIn(f"  {entry['name']} ", text)


def neighbours(a, b):
    """Linels share a pointel: in Khalimsky coordinates, the even corners next to their open direction."""

    def pointels(x, y):
        return {(x - 1, y), (x + 1, y)} if x % 2 else {(x, y - 1), (x, y + 1)}

    return bool(pointels(*a) & pointels(*b))


class Image(InFolder):
    RING = "P2\n# a ring of 3 x 3 pixels and a dot\n6 5\n200\n" + "\n".join(
        ["9 9 9 9 9 9", "9 50 50 50 9 9", "9 50 9 50 9 60", "9 50 50 50 9 9", "9 9 9 9 9 9"]
    )

    def image(self, text, name="ring.pgm"):
        (self.folder / name).write_bytes(text if isinstance(text, bytes) else text.encode())
        return name

    def contours(self, *arguments):
        self.must_work("estimate", "--image", *arguments, "--csv", "out.csv")
        return list(csv.DictReader(io.StringIO((self.folder / "out.csv").read_text())))

    def test_every_estimator_on_every_contour(self):
        table = self.contours(self.image(self.RING), "--threshold", "50,60", "--radius", "1.5")
        counts = [sum(row["component"] == str(c) for row in table) for c in range(3)]
        self.assertEqual(counts, [12, 4, 4])
        estimators = json.loads(run("list", "estimators", "--json").stdout)["estimators"]
        flat = [e["name"] for e in estimators if e["quantities_2d"]]
        for name in flat:
            self.assertTrue(any(column.startswith(name + ".") for column in table[0]), name)
        for row in table:
            for name in row:
                self.assertTrue(math.isfinite(float(row[name])), name)
        # The dot is at the right border, in the middle row: x = 5, y = 2.
        cells = {(int(r["kx"]), int(r["ky"])) for r in table}
        for cell in [(12, 5), (10, 5), (11, 4), (11, 6)]:
            self.assertIn(cell, cells)

    def test_radius_is_five_pixels_unless_given(self):
        ring = self.image(self.RING)
        default = self.contours(ring, "--threshold", "50,60", "--h", "0.5")
        self.assertEqual(default, self.contours(ring, "--threshold", "50,60", "--h", "0.5", "--radius", "2.5"))
        self.assertNotEqual(default, self.contours(ring, "--threshold", "50,60", "--h", "0.5", "--radius", "2"))

    def test_bitmap(self):
        table = self.contours(self.image("P1\n3 3\n0 0 0\n0 1 0\n0 0 0\n", "dot.pbm"), "--estimator", "bc", "--h", "0.5")
        self.assertEqual(len(table), 4)
        self.assertEqual({abs(float(r["x"]) - 0.5) + abs(float(r["y"]) - 0.5) for r in table}, {0.25})

    def test_wrong_input(self):
        ring = self.image(self.RING)
        cut = self.image(self.RING[:60], "cut.pgm")
        text = self.image("hello", "text.pgm")
        empty = self.image("P1\n2 2\n0 0 0 0\n", "empty.pbm")
        for arguments, named in [
            ([ring], [ring, "from 9 to 60", "--threshold"]),
            ([ring, "--threshold", "100,200"], [ring, "100", "200"]),
            ([ring, "--threshold", "60,50"], ["--threshold", "60", "50"]),
            ([ring, "--threshold", "7"], ["--threshold", "7"]),
            ([cut, "--threshold", "50,60"], [cut]),
            ([text, "--threshold", "50,60"], [text]),
            (["none.pgm", "--threshold", "1,2"], ["none.pgm", "not found"]),
            ([empty], [empty]),
            ([ring, "--threshold", "50,60", "--estimator", "bc", "--radius", "2"], ["'bc'", "no radius"]),
            ([ring, "--threshold", "50,60", "--estimator", "ii-covariance", "--radius", "2"], ["ii-covariance", "2D"]),
            ([ring, "--threshold", "50,60", "--radius", "0.5"], ["R/h = 0.5"]),
            ([ring, "--threshold", "50,60", "--h", "-1"], ["--h", "-1"]),
            ([ring, "--threshold", "50,60", "--shift", "0.1,0.2"], ["--shift"]),
            ([ring, "--threshold", "50,60", "--csv", "missing/out.csv"], ["missing/out.csv"]),
        ]:
            with self.subTest(arguments=arguments):
                self.must_fail(["estimate", "--image", *arguments], *named)


class WithVolume(InFolder):
    """A ball of radius 6 and a single voxel, 16 x 15 x 14."""

    SIZE = (16, 15, 14)

    def voxels(self):
        inside = lambda x, y, z: (x - 7) ** 2 + (y - 7) ** 2 + (z - 7) ** 2 <= 36 or (x, y, z) == (15, 14, 13)
        return bytes(inside(x, y, z) for z in range(14) for y in range(15) for x in range(16))

    def header(self, more=""):
        return "".join(f"{axis}: {size}\n" for axis, size in zip("XYZ", self.SIZE)) + more + ".\n"

    def file(self, content, name="ball.vol"):
        (self.folder / name).write_bytes(content)
        return name

    def ball(self):
        return self.file(self.header("Version: 3\n").encode() + zlib.compress(self.voxels()))

    def estimate(self, *arguments):
        result = self.must_work("estimate", "--volume", *arguments, "--csv", "out.csv")
        return result.stdout, list(csv.DictReader(io.StringIO((self.folder / "out.csv").read_text())))


class Volume(WithVolume):
    def test_every_component(self):
        text, table = self.estimate(self.ball(), "--radius", "3", "--quantity", "mean")
        self.assertIn("components 2", text)
        self.assertEqual(list(table[0]), ["kx", "ky", "kz", "x", "y", "z", "component", "mean"])
        self.assertEqual([row["component"] for row in table], ["0"] * (len(table) - 6) + ["1"] * 6)
        # The ball is the same set as that of the shape, far enough from the single voxel.
        sphere = ("estimate", "--shape", "sphere:radius=6,cx=7,cy=7,cz=7", "--h", "1", "--radius", "3", "--quantity", "mean")
        self.must_work(*sphere, "--csv", "sphere.csv")
        shape = list(csv.DictReader(io.StringIO((self.folder / "sphere.csv").read_text())))
        of = lambda rows: {(r["kx"], r["ky"], r["kz"]): r["mean"] for r in rows}
        self.assertEqual(of(table[:-6]), of(shape))

    def test_mean_alone_is_nearly_that_of_all(self):
        ball = self.ball()
        _, alone = self.estimate(ball, "--radius", "5", "--estimator", "ii-ho1", "--quantity", "mean")
        _, everything = self.estimate(ball, "--radius", "5", "--estimator", "ii-ho1")
        self.assertEqual(list(alone[0])[7:], ["mean"])
        self.assertIn("k1", everything[0])
        for one, other in zip(alone, everything, strict=True):
            # They differ by the distance of the surfel from the boundary times the square of (k1 - k2) / 2.
            half = (float(other["k1"]) - float(other["k2"])) / 2
            self.assertAlmostEqual(float(one["mean"]), float(other["mean"]), delta=2.5 * half**2 + 1e-9)

    def test_quantity_picks_the_estimator(self):
        ball = self.ball()
        for quantity, columns in [("gaussian", ["gaussian"]), ("normal", ["normal_x", "normal_y", "normal_z"])]:
            text, table = self.estimate(ball, "--radius", "3", "--quantity", quantity)
            self.assertIn("ii-covariance", text)
            self.assertEqual(list(table[0])[7:], columns)
        _, everything = self.estimate(ball)
        _, five = self.estimate(ball, "--radius", "5", "--estimator", "ii-covariance")
        self.assertEqual(everything, five)

    def test_evaluations_have_equal_sums(self):
        ball = self.ball()
        tables = [
            self.estimate(ball, "--radius", "4.5", "--raw", "--evaluation", evaluation)[1]
            for evaluation in ("full", "masks", "bricks")
        ]
        self.assertEqual(tables[0], tables[1])
        self.assertEqual(tables[0], tables[2])

    def test_spacing_is_the_unit(self):
        x, y, z = self.SIZE
        nrrd = (
            f"NRRD0004\ntype: uint8\ndimension: 3\nsizes: {x} {y} {z}\nencoding: raw\nspacings: 0.5 0.5 0.5\n\n"
        ).encode() + self.voxels()
        spaced = self.file(nrrd, "ball.nrrd")
        _, table = self.estimate(spaced, "--radius", "1.5", "--quantity", "mean")
        _, voxels = self.estimate(spaced, "--radius", "3", "--h", "1", "--quantity", "mean")
        _, plain = self.estimate(self.ball(), "--radius", "3", "--quantity", "mean")
        self.assertEqual(voxels, plain)
        for row, other in zip(table, plain):
            self.assertEqual(float(row["x"]), 0.5 * float(other["x"]))
            self.assertAlmostEqual(float(row["mean"]), 2 * float(other["mean"]), places=12)

    def test_all_files_or_none(self):
        ball = self.ball()
        outs = ["out.ply", "out.vtp", "out.obj", "out.npy", "more.csv"]
        arguments = [part for out in outs for part in ("--out", out)]
        self.must_work("estimate", "--volume", ball, "--radius", "3", *arguments)
        self.assertEqual(self.files(), sorted([ball, *outs]))
        for out in outs:
            (self.folder / out).unlink()
        self.must_fail(["estimate", "--volume", ball, "--radius", "3", *arguments, "--out", "missing/a.ply"], "missing")
        self.must_fail(["estimate", "--volume", ball, "--radius", "3", *arguments, "--csv", "/dev/full"], "/dev/full")

    def test_raw(self):
        raw = self.file(b"".join(bytes([0, v]) for v in self.voxels()), "ball.raw")
        _, table = self.estimate(raw, "--size", "16,15,14", "--type", "int16-be", "--radius", "3")
        self.assertEqual(table, self.estimate(self.ball(), "--radius", "3")[1])
        size = ["--size", "16,15,14"]
        for arguments, named in [
            ([raw], [raw, "--size"]),
            ([raw, *size], [raw, "3360", "6720"]),
            ([raw, "--size", "16,15,15", "--type", "int16"], [raw, "truncated", "7200", "6720"]),
            ([raw, "--size", "16,15"], ["--size = 16,15"]),
            ([raw, "--size", "16,15,x"], ["--size"]),
            ([raw, "--size", "16,15,-14"], [raw, "-14"]),
            ([raw, "--type", "int16"], ["--type", "--size"]),
            ([raw, *size, "--type", "short"], ["'short'", "int16"]),
            ([self.ball(), *size], ["ball.vol", "--size"]),
        ]:
            with self.subTest(arguments=arguments):
                self.must_fail(["estimate", "--volume", *arguments, "--radius", "3"], *named)

    def test_wrong_input(self):
        ball = self.ball()
        content = (self.folder / ball).read_bytes()
        grey = self.file(self.header("Version: 2\n").encode() + bytes(i % 200 for i in range(16 * 15 * 14)), "grey.vol")
        empty = self.file(self.header("Version: 2\n").encode() + bytes(16 * 15 * 14), "empty.vol")
        cut = self.file(content[:-9], "cut.vol")
        huge = self.file(b"X: 10000\nY: 10000\nZ: 10000\nVersion: 2\n.\n" + bytes(1000), "huge.vol")
        bomb = self.file(b"X: 2\nY: 2\nZ: 2\nVersion: 3\n.\n" + zlib.compress(bytes(1 << 28)), "bomb.vol")
        line = self.file(b"two\nlines\n", "two\nlines.vol")
        for arguments, named in [
            (["none.vol"], ["none.vol", "not found"]),
            (["."], [".vol, .longvol"]),
            (["ball.png"], ["ball.png", ".nii.gz"]),
            ([grey], [grey, "from 0 to 199", "--threshold"]),
            ([grey, "--threshold", "200,255"], [grey, "200", "255"]),
            ([grey, "--threshold", "9,3"], ["--threshold", "9", "3"]),
            ([grey, "--threshold", "nan,3"], ["--threshold", "nan"]),
            ([grey, "--threshold", "9"], ["--threshold", "9"]),
            ([empty], [empty, "no voxel"]),
            ([cut], [cut, "zlib"]),
            ([huge], [huge, "1000000000000 bytes", "1000"]),
            ([bomb], [bomb, "more than the voxels"]),
            ([line], ["two lines.vol", "'two'"]),
            ([ball, "--radius", "0.5"], ["R/h = 0.5"]),
            ([ball, "--radius", "1e9"], ["memory"]),
            ([ball, "--h", "-1"], ["--h", "-1"]),
            ([ball, "--estimator", "mdca"], ["'mdca'", "3D"]),
            ([ball, "--quantity", "kappa"], ["kappa", "3D"]),
            ([ball, "--shift", "0.1,0.2,0.3"], ["--shift"]),
            ([ball, "--out", "out.stl"], ["out.stl", ".ply, .vtp, .obj"]),
        ]:
            with self.subTest(arguments=arguments):
                self.must_fail(["estimate", "--volume", *arguments], *named)

    def test_convert(self):
        ball = self.ball()
        self.must_work("convert", ball, "ball.nrrd")
        self.must_work("convert", "ball.nrrd", "back.vol")
        plain = (self.folder / "back.vol").read_bytes()
        self.assertTrue(plain.endswith(b"Version: 2\n.\n" + self.voxels()))
        self.must_work("convert", "--threshold", "0,0", ball, "none.longvol")
        long = (self.folder / "none.longvol").read_bytes().split(b"\n.\n", 1)[1]
        self.assertEqual(long, b"".join(bytes([1 - v, 0, 0, 0, 0, 0, 0, 0]) for v in self.voxels()))
        wide = self.file(b"NRRD0001\ntype: short\ndimension: 3\nsizes: 1 1 1\nencoding: raw\nendian: big\n\n\1\0", "a.nrrd")
        for arguments, named in [
            ([wide, "a.vol"], ["a.nrrd", "256", "uint8"]),
            ([wide, "a.png"], ["a.png", ".vti"]),
            ([wide, "a.nii"], ["a.nii", ".vti"]),
            (["none.vol", "a.vol"], ["none.vol", "not found"]),
            ([wide, "missing/a.vti"], ["missing/a.vti"]),
            ([wide], ["out"]),
        ]:
            with self.subTest(arguments=arguments):
                self.must_fail(["convert", *arguments], *named)

    def test_samples(self):
        """The volume of the paper, where a copy of DGtal's samples is at hand."""
        al = Path(os.environ.get("GRIDSTEP_SAMPLES", "samples")) / "Al.100.vol"
        if not al.is_file():
            self.skipTest(f"no {al}; GRIDSTEP_SAMPLES names the folder")
        text, table = self.estimate(al, "--radius", "7", "--quantity", "gaussian", "--evaluation", "bricks")
        self.assertIn("100 x 100 x 100 voxels of uint8, 70413 in [1, 1]", text)
        for evaluation in ("full", "masks"):
            other = self.estimate(al, "--radius", "7", "--quantity", "gaussian", "--evaluation", evaluation)[1]
            self.assertEqual(table, other)


class Estimate(InFolder):
    FLAT = ("estimate", "--shape", "ellipse:a=6,b=3", "--h", "0.25", "--k", "2", "--estimator", "ii")
    SOLID = ("estimate", "--shape", "ellipsoid:a=3,b=4,c=5", "--h", "0.5", "--radius", "1.5")

    def rows(self, *arguments):
        result = self.must_work(*arguments, "--csv", "out.csv")
        text = (self.folder / "out.csv").read_text()
        table = list(csv.DictReader(io.StringIO(text)))
        count = int(re.search(r"surfels (\d+)", result.stdout).group(1))
        self.assertEqual(len(table), count)
        for row in table:
            self.assertNotIn(None, row.values())
            self.assertNotIn(None, row)
        return text.split("\n")[0], table

    def check_cells(self, table, axes, h):
        seen = set()
        for row in table:
            cell = tuple(int(row["k" + axis]) for axis in axes)
            self.assertEqual(sum(c % 2 == 0 for c in cell), 1, cell)
            for c, axis in zip(cell, axes):
                self.assertAlmostEqual(float(row[axis]), h * (c - 1) / 2, places=12)
            seen.add(cell)
        self.assertEqual(len(seen), len(table), "a surfel twice")

    def test_columns_in_2d(self):
        header, table = self.rows(*self.FLAT)
        self.assertEqual(header, "kx,ky,x,y,kappa,true_kappa,error")
        self.check_cells(table, "xy", 0.25)
        for row in table:
            self.assertAlmostEqual(float(row["error"]), float(row["kappa"]) - float(row["true_kappa"]), places=12)
            self.assertTrue(3 / 36 - 1e-9 <= float(row["true_kappa"]) <= 6 / 9 + 1e-9)
        header, table = self.rows(*self.FLAT, "--raw")
        self.assertEqual(header, "kx,ky,x,y,kappa,sum,true_kappa,error")
        for row in table:  # kappa = 3 pi/(2 R) - 3 A/R^3, A = h^2 sum, R = 2 h^(1/3)
            R = 2 * 0.25 ** (1 / 3)
            kappa = 3 * 3.141592653589793 / (2 * R) - 3 * 0.25**2 * float(row["sum"]) / R**3
            self.assertAlmostEqual(float(row["kappa"]), kappa, places=10)

    def test_contours_are_walked(self):
        cells = [(int(row["kx"]), int(row["ky"])) for row in self.rows(*self.FLAT)[1]]
        for before, after in zip(cells, cells[1:] + cells[:1]):
            self.assertTrue(neighbours(before, after), (before, after))
        # The shape on the left: the area inside the walk is positive.
        twice = sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(cells, cells[1:] + cells[:1]))
        self.assertGreater(twice, 0)

    def test_columns_in_3d(self):
        header, table = self.rows(*self.SOLID, "--estimator", "ii", "--raw")
        self.assertEqual(header, "kx,ky,kz,x,y,z,mean,sum,true_mean,error")
        self.check_cells(table, "xyz", 0.5)
        header, table = self.rows(*self.SOLID, "--estimator", "ii-covariance", "--raw")
        vectors = [f"{v}_{axis}" for v in ("normal", "dir1", "dir2") for axis in "xyz"]
        names = header.split(",")
        self.assertEqual(names[:6], ["kx", "ky", "kz", "x", "y", "z"])
        quantities = names[6 : names.index("sum")]
        for name in ["mean", "gaussian", "k1", "k2", *vectors]:
            self.assertIn(name, quantities)
        raw = ["sum", "cov_xx", "cov_xy", "cov_xz", "cov_yy", "cov_yz", "cov_zz"]
        truth = ["true_" + name for name in quantities]
        at = 6 + len(quantities)
        self.assertEqual(names[at : at + 7], raw)
        self.assertEqual(names[at + 7 : at + 7 + len(truth)], truth)
        errors = names[at + 7 + len(truth) :]
        self.assertEqual(errors[0], "error")
        self.assertTrue(all(name.startswith("error_") for name in errors[1:]))
        self.check_cells(table, "xyz", 0.5)
        for row in table:
            for name in errors[1:]:
                quantity = name.removeprefix("error_")
                if quantity == "normal":
                    pairs = [(float(row["normal_" + k]), float(row["true_normal_" + k])) for k in "xyz"]
                    cosine = max(-1, min(1, sum(a * b for a, b in pairs)))
                    self.assertAlmostEqual(float(row[name]), math.acos(cosine), places=6)
                    continue
                difference = float(row[quantity]) - float(row["true_" + quantity])
                self.assertAlmostEqual(float(row[name]), difference, places=10)

    def test_values_at_pointels(self):
        contour = ("estimate", "--shape", "ellipse:a=6,b=3", "--h", "0.25", "--estimator")
        header, table = self.rows(*contour, "mdss-length")
        self.assertEqual(header, "kx,ky,px,py,x,y,kappa,true_kappa,error")
        self.check_cells(table, "xy", 0.25)
        for row, after in zip(table, table[1:] + table[:1]):
            start, end = (int(row["px"]), int(row["py"])), (int(after["px"]), int(after["py"]))
            middle = (int(row["kx"]), int(row["ky"]))
            self.assertEqual(tuple(a + b for a, b in zip(start, end)), tuple(2 * m for m in middle))
        at_linels = self.rows(*contour, "bc")[1]
        self.assertNotEqual([r["true_kappa"] for r in table], [r["true_kappa"] for r in at_linels])

    def test_several_estimators(self):
        one = ("estimate", "--shape", "ellipse:a=6,b=3", "--h", "0.25", "--k", "2", "--estimator")
        header, table = self.rows(*one, "ii,mst")
        columns = ["ii.kappa", "ii.true_kappa", "ii.error", "mst.tangent_x", "mst.tangent_y"]
        columns += ["mst.true_tangent_x", "mst.true_tangent_y", "mst.error"]
        self.assertEqual(header, "kx,ky,x,y," + ",".join(columns))
        alone = self.rows(*one, "ii")[1]
        self.assertEqual([r["ii.kappa"] for r in table], [r["kappa"] for r in alone])
        for row in table:
            a, b = (math.atan2(float(row[p + "tangent_y"]), float(row[p + "tangent_x"])) for p in ("mst.", "mst.true_"))
            angle = abs(math.remainder(a - b, 2 * math.pi))
            self.assertAlmostEqual(float(row["mst.error"]), angle, places=6)

    def test_surfels_at_edges_have_no_truth(self):
        _, table = self.rows(
            *("estimate", "--shape", "square", "--h", "0.25", "--estimator", "ii", "--k", "2")
        )
        self.assertTrue(any(row["true_kappa"] == "" for row in table))
        for row in table:
            self.assertEqual(row["true_kappa"] == "", row["error"] == "")
            self.assertNotEqual(row["kappa"], "")

    def test_evaluations_and_threads_agree(self):
        for base in (self.FLAT, (*self.SOLID, "--estimator", "ii-covariance")):
            texts = set()
            for evaluation in ("full", "masks", "bricks"):
                for threads in (1, 2):
                    options = ("--evaluation", evaluation, "--threads", threads, "--raw", "--csv", "out.csv")
                    self.must_work(*base, *options)
                    texts.add((self.folder / "out.csv").read_text())
            self.assertEqual(len(texts), 1)

    def test_instruction_sets_agree(self):
        unknown = {**os.environ, "GRIDSTEP_TARGET": "mmx"}
        line = self.must_fail([*self.SOLID, "--estimator", "ii"], "GRIDSTEP_TARGET", "'mmx'", env=unknown).stderr
        targets = line.split("runs: ")[1].strip().split(", ")
        self.assertEqual(targets[-1], "plain")
        texts = set()
        for target in targets:
            chosen = {**os.environ, "GRIDSTEP_TARGET": target}
            self.must_work(*self.SOLID, "--estimator", "ii-covariance", "--raw", "--csv", "out.csv", env=chosen)
            texts.add((self.folder / "out.csv").read_text())
        self.assertEqual(len(texts), 1)

    def test_csv_on_standard_output(self):
        self.must_work(*self.FLAT, "--csv", "out.csv")
        for name in ("-", "/dev/stdout"):
            result = self.must_work(*self.FLAT, "--csv", name)
            self.assertEqual(result.stdout, (self.folder / "out.csv").read_text(), "nothing but the CSV")
            self.assertIn("surfels", result.stderr)

    def test_json(self):
        result = self.must_work(*self.FLAT[:-1], "ii,mdca", "--csv", "out.csv", "--json")
        self.assertEqual(result.stderr, "")
        told = json.loads(result.stdout)
        header, *rows = csv.reader(io.StringIO((self.folder / "out.csv").read_text()))
        self.assertEqual([told["surfels"], told["h"], told["components"]], [len(rows), 0.25, 1])
        self.assertAlmostEqual(told["digital_radius"], told["radius"] / 0.25)
        self.assertEqual([e["estimator"] for e in told["estimates"]], ["ii", "mdca"])
        for estimate in told["estimates"]:
            name = estimate["estimator"]
            errors = [abs(float(row[header.index(f"{name}.error")])) for row in rows]
            self.assertEqual(estimate["errors"]["kappa"]["sup"], max(errors))
            values = [float(row[header.index(f"{name}.kappa")]) for row in rows]
            self.assertEqual(estimate["ranges"]["kappa"], [min(values), max(values)])
            self.assertEqual("work" in estimate, name == "ii", "no kernel, no work")
        self.assertGreater(told["estimates"][0]["work"]["kernel_size"], 0)
        for output in ("-", "/dev/stdout"):
            self.must_fail([*self.FLAT, "--json", "--csv", output], "--json", f"--csv {output}", "standard output")

    def test_a_failure_keeps_the_file_of_before(self):
        (self.folder / "out.csv").write_text("precious")
        self.must_fail([*self.FLAT, "--shift", "nan,0", "--csv", "out.csv"], "nan")
        self.assertEqual((self.folder / "out.csv").read_text(), "precious")

    def test_noise_comes_from_the_seed(self):
        texts = []
        for seed in (1, 1, 2):
            self.must_work(*self.FLAT, "--noise", "0.3", "--seed", seed, "--csv", "out.csv")
            texts.append((self.folder / "out.csv").read_text())
        self.assertEqual(texts[0], texts[1])
        self.assertNotEqual(texts[0], texts[2])


def records_of(path):
    """Head and records, without what differs from run to run."""
    head, *records = map(json.loads, path.read_text().splitlines())
    for record in records:
        del record["seconds"]
    return head, records


def has_page():
    """Whether the program was built with Node, and so with the page report.html."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "small.json").write_text(json.dumps(STUDY))
        return "written: out/report.html" in run("study", "small.json", "--out", "out", folder=folder).stdout


def page_data(path):
    """The data in a page, and the elements of its surfaces."""
    elements = re.findall(r'<script type="application/json" id="(.+?)">(.+?)</script>', path.read_text())
    return {name: json.loads(data) for name, data in elements}


class Study(InFolder):
    def results(self):
        return sorted(["records.jsonl", "summary.json"] + ["report.html"] * has_page())

    def test_outputs(self):
        self.write_study(STUDY)
        result = self.must_work("study", "small.json", "--out", "a/b", "--csv", "--latex")
        tables = ["best-radius", "convergence", "cost", "equal-error", "fallbacks", "isotropy", "noise", "work-precision"]
        names = sorted([f"{t}.{e}" for t in tables for e in ("csv", "tex")] + self.results())
        self.assertEqual(sorted(os.listdir(self.folder / "a/b")), names, "and no journal")
        head, records = records_of(self.folder / "a/b/records.jsonl")
        self.assertEqual(len(records), 2 * 5 * 2 * 2)
        self.assertEqual(head["study"], STUDY)
        self.assertEqual(head["seed"], 1)
        text = (self.folder / "a/b/summary.json").read_text()

        def refuse(constant):
            self.fail(f"{constant} is no JSON")

        summary = json.loads(text, parse_constant=refuse)
        self.assertEqual(summary["study"], STUDY)
        for key in ("commit", "compiler", "flags", "cpu"):
            self.assertIn(key, json.dumps(summary["provenance"]))
        self.assertEqual(len(summary["convergence"]), 2 * 3)
        self.assertEqual(len(summary["cost"]), 2 * 2)
        with open(self.folder / "a/b/convergence.csv", newline="") as file:
            self.assertEqual(len(list(csv.reader(file))), 1 + 2 * 3)
        self.assertIn(r"\toprule", (self.folder / "a/b/convergence.tex").read_text())
        self.assertIn("written: a/b/records.jsonl", result.stdout)
        self.assertEqual(result.stdout.count("report.html"), 1, "that it is written, or that it is not")
        self.assertNotIn("Fallbacks", result.stdout, "as no estimator here has any")
        self.assertIn("100%", result.stderr)

    def test_fallbacks_are_told(self):
        sweep = {
            "shapes": ["torus:major=6,minor=2"],
            "estimators": ["ii-ho1-guarded"],
            "schedule": {"values": [0.5]},
            "shifts": 1,
        }
        self.write_study({"name": "small", "sweeps": [sweep]})
        result = self.must_work("study", "small.json", "--out", "a", "--csv")
        work = records_of(self.folder / "a/records.jsonl")[1][0]["work"]
        self.assertGreater(work["fallbacks"], 0)
        self.assertRegex(result.stdout, rf"Fallbacks[^$]*0\.5: {work['fallbacks']} of \d+")
        self.assertIn(f"0.5: {work['fallbacks']} of", (self.folder / "a/fallbacks.csv").read_text())
        summary = json.loads((self.folder / "a/summary.json").read_text())
        self.assertEqual(summary["cost"][0]["steps"][0]["fallbacks"], work["fallbacks"])

    def test_json(self):
        self.write_study(STUDY)
        result = self.must_work("study", "small.json", "--out", "a", "--json")
        self.assertEqual(json.loads(result.stdout), json.loads((self.folder / "a/summary.json").read_text()))
        self.assertIn("100%", result.stderr)

    def test_the_default_folder_and_the_seed(self):
        self.write_study(STUDY)
        self.must_work("study", "small.json", "--seed", 5, "--threads", 1)
        folder = self.folder / "results/raw/small"
        self.assertEqual(sorted(os.listdir(folder)), self.results())
        head, records = records_of(folder / "records.jsonl")
        self.assertEqual(head["seed"], 5)
        self.assertEqual(head["study"]["seed"], 5, "the study that gives these numbers again")
        self.must_work("study", "small.json", "--out", "other", "--threads", 2)
        self.assertNotEqual(records_of(self.folder / "other/records.jsonl")[1], records)
        self.write_study(head["study"])
        self.must_work("study", "small.json", "--out", "again", "--threads", 2)
        self.assertEqual(records_of(self.folder / "again/records.jsonl")[1], records)

    def test_a_killed_study_goes_on(self):
        study = json.loads(json.dumps(STUDY))
        study["sweeps"][0]["schedule"] = {"from": 0.2, "to": 0.02, "steps": 6}
        self.write_study(study)
        self.must_work("study", "small.json", "--out", "whole")
        _, expected = records_of(self.folder / "whole/records.jsonl")

        journal = self.folder / "killed/journal.jsonl"
        command = [PROGRAM, "study", "small.json", "--out", "killed"]
        process = subprocess.Popen(
            command, cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
        deadline = time.monotonic() + 30
        while time.monotonic() < deadline and process.poll() is None:
            if journal.exists() and journal.read_bytes().count(b"\n") >= 4:
                process.send_signal(signal.SIGKILL)
                break
            time.sleep(0.001)
        process.wait()
        self.assertEqual(process.returncode, -signal.SIGKILL, "finished before it could be killed")
        self.assertEqual(os.listdir(self.folder / "killed"), ["journal.jsonl"])

        unfinished = journal.read_bytes()
        self.must_fail(["study", "small.json", "--out", "killed"], str(Path("killed/journal.jsonl")), "--resume")
        self.must_fail(
            ["study", "small.json", "--out", "killed", "--resume", "--seed", "9"],
            str(Path("killed/journal.jsonl")),
            "not the journal of this study",
        )
        self.assertEqual(journal.read_bytes(), unfinished)

        self.must_work("study", "small.json", "--out", "killed", "--resume")
        self.assertEqual(sorted(os.listdir(self.folder / "killed")), self.results())
        self.assertEqual(records_of(self.folder / "killed/records.jsonl")[1], expected)


class LevelOfDetail(WithVolume):
    """One surface at several radii: of the ball, or of a shape."""

    def setUp(self):
        super().setUp()
        self.ball()
        self.study = ("study", "level-of-detail", "--volume", "ball.vol", "--out", "out")

    def test_files_and_table(self):
        result = self.must_work(*self.study, "--radii", "4,2.5", "--csv", "--latex")
        surfaces = ["radius-2.5.ply", "radius-2.5.vtp", "radius-4.ply", "radius-4.vtp"]
        names = ["detail.csv", "detail.tex", *surfaces, *["report.html"] * has_page(), "summary.json"]
        self.assertEqual(sorted(os.listdir(self.folder / "out")), names)
        summary = json.loads((self.folder / "out/summary.json").read_text())
        detail = summary["detail"]
        self.assertEqual(summary["study"]["detail"], {"volume": "ball.vol", "digital_radii": [4, 2.5], "estimator": "ii-covariance"})
        self.assertEqual([level["digital_radius"] for level in detail["levels"]], [4, 2.5])
        for level in detail["levels"]:
            # The values are those of gridstep estimate, and so are their quantiles.
            _, table = self.estimate("ball.vol", "--radius", level["radius"], "--out", "one.ply")
            self.assertEqual((self.folder / "out" / level["surfaces"][1]).read_bytes(), (self.folder / "one.ply").read_bytes())
            self.assertEqual(detail["surfels"], len(table))
            self.assertEqual(list(level["quantities"]), ["mean", "gaussian", "k1", "k2"])
            for quantity, spread in level["quantities"].items():
                values = sorted(float(row[quantity]) for row in table)
                self.assertEqual([spread["quantiles"][0], spread["quantiles"][-1]], [values[0], values[-1]])
                self.assertAlmostEqual(spread["mean"], sum(values) / len(values), places=12)
                middle = (len(values) - 1) / 2
                median = (values[math.floor(middle)] + values[math.ceil(middle)]) / 2
                self.assertAlmostEqual(spread["quantiles"][spread["probabilities"].index(0.5)], median, places=14)
        with open(self.folder / "out/detail.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([(r["quantity"], r["R/h"]) for r in rows][:3], [("mean", "4"), ("mean", "2.5"), ("gaussian", "4")])
        self.assertIn("written: out/radius-2.5.vtp", result.stdout)
        self.assertEqual(result.stdout.count("report.html"), 1, "that it is written, or that it is not")
        again = self.must_work(*self.study, "--radii", "4,2.5", "--json").stdout
        self.assertEqual(json.loads(again), json.loads((self.folder / "out/summary.json").read_text()))

    def test_report(self):
        self.must_work(*self.study, "--radii", "4,2.5")
        summary = json.loads((self.folder / "out/summary.json").read_text())
        page = self.folder / "out/report.html"
        if not page.exists():
            self.must_fail(["report", "out"], "report.html", "without Node")
            self.skipTest("built without Node")
        of_study = page.read_bytes()
        page.unlink()
        (self.folder / "ball.vol").unlink()
        self.assertEqual(self.must_work("report", "out").stdout, "written: out/report.html\n")
        self.assertEqual(page.read_bytes(), of_study, "from the files in the folder alone")
        data = page_data(page)
        (study,) = data["report-data"]["studies"]
        self.assertEqual(study["detail"], summary["detail"])
        (surface,) = study["surfaces"]
        self.assertEqual(surface["surfels"], summary["detail"]["surfels"])
        self.assertEqual([e["digital_radius"] for e in surface["estimators"]], [4, 2.5])
        self.assertEqual(data["surface-0"]["truth"], {})
        for of_radius, level in zip(data["surface-0"]["estimates"], summary["detail"]["levels"]):
            for quantity, text in of_radius.items():
                values = sorted(struct.unpack(f"<{surface['surfels']}f", base64.b64decode(text)))
                spread = level["quantities"][quantity]
                for shown, exact in [(values[0], spread["quantiles"][0]), (values[-1], spread["quantiles"][-1])]:
                    self.assertAlmostEqual(shown, exact, delta=1e-6 * abs(exact))

        self.write_study(STUDY)
        self.must_work("study", "small.json", "--out", "curves")
        self.must_work("report", "curves", "out", "--out", "both.html")
        both = page_data(self.folder / "both.html")["report-data"]["studies"]
        self.assertEqual(["detail" in study for study in both], [False, True])

    def test_a_surface_that_is_not_that_of_its_summary_is_left_out(self):
        self.must_work(*self.study, "--radii", "4,2.5")
        if not (self.folder / "out/report.html").exists():
            self.skipTest("built without Node")
        ply, summary = self.folder / "out/radius-4.ply", self.folder / "out/summary.json"
        whole, told = ply.read_text(), summary.read_text()
        for path, text, reason in [
            (ply, whole[: len(whole) // 2], "truncated"),
            (ply, whole.replace("element vertex ", "element vertex x"), "line 3"),
            (ply, whole.replace("property double mean", "property double kappa"), "values of 3 quantities"),
            (ply, re.sub(r"(?m)^(4 \d+ \d+ \d+ \d+ 0) \S+", r"\1 7", whole, count=1), "the values of mean"),
            (summary, re.sub(r'"surfels": \d+', '"surfels": 200001', told), "200001 surfels, more than the 200000"),
        ]:
            with self.subTest(reason=reason):
                before = path.read_text()
                self.assertNotEqual(text, before)
                path.write_text(text)
                said = self.must_work("report", "out").stdout
                path.write_text(before)
                self.assertEqual(said.splitlines()[0], "written: out/report.html")
                self.assertIn(reason, said.splitlines()[1])
                (study,) = page_data(self.folder / "out/report.html")["report-data"]["studies"]
                self.assertEqual(study["surfaces"], [])
                self.assertIn(reason, study["surfaces_left_out"][0])
        ply.unlink()
        self.assertIn("radius-4.ply: not found", self.must_work("report", "out").stdout)

    def test_a_wrong_summary_is_refused(self):
        self.must_work(*self.study, "--radii", "4,2.5")
        path = self.folder / "out/summary.json"
        told = path.read_text()
        for change, named in [
            (lambda d: d.pop("input"), ["out/summary.json", "detail", "'input' is missing"]),
            (lambda d: d.update(levels=[]), ["detail", "levels"]),
            (lambda d: d["levels"][1].update(radius="wide"), ["levels[1]", 'radius = "wide"']),
            (lambda d: d["levels"][1]["quantities"].pop("mean"), ["levels[1]", "quantities"]),
            (lambda d: d["levels"][0]["quantities"]["mean"]["quantiles"].pop(), ["levels[0]", "mean", "quantiles"]),
        ]:
            with self.subTest(named=named):
                summary = json.loads(told)
                change(summary["detail"])
                path.write_text(json.dumps(summary))
                self.must_fail(["report", "out"], *named)

    def test_a_file_and_a_shape(self):
        path = self.write_study({"name": "mine", "detail": {"shape": "sphere:radius=3", "h": 0.5, "digital_radii": [3]}})
        self.must_work("study", path, "--out", "out")
        summary = json.loads((self.folder / "out/summary.json").read_text())
        self.assertEqual(summary["detail"]["levels"][0]["radius"], 1.5)
        self.must_work("study", path, "--volume", "ball.vol", "--threshold", "1,1", "--out", "out")
        summary = json.loads((self.folder / "out/summary.json").read_text())
        self.assertEqual(summary["study"]["detail"], {"volume": "ball.vol", "threshold": [1, 1], "digital_radii": [3]})

    def test_wrong_input(self):
        grey = self.file(self.header("Version: 2\n").encode() + bytes(i % 200 for i in range(16 * 15 * 14)), "grey.vol")
        small = self.write_study(STUDY)
        for arguments, named in [
            (["level-of-detail", "--volume", "none.vol"], ["none.vol", "not found"]),
            (["level-of-detail", "--volume", grey], [grey, "--threshold"]),
            (["level-of-detail", "--volume", "ball.vol", "--threshold", "9,3"], ["threshold = [9.0,3.0]"]),
            (["level-of-detail", "--volume", "ball.vol", "--threshold", "9,12"], ["ball.vol", "9", "12"]),
            (["level-of-detail", "--volume", "ball.vol", "--radii", "7,7"], ["digital_radii = [7.0,7.0]"]),
            (["level-of-detail", "--volume", "ball.vol", "--radii", "0.5"], ["digital_radii = [0.5]"]),
            (["level-of-detail", "--volume", "ball.vol", "--radii", "7,x"], ["--radii", "x"]),
            (["level-of-detail", "--volume", "ball.vol", "--radii", "1e9"], ["ball.vol", "memory"]),
            (["level-of-detail", "--threshold", "1,2"], ["level-of-detail", "threshold"]),
            (["level-of-detail", "--seed", "3"], ["level-of-detail", "seed"]),
            (["level-of-detail", "--resume"], ["--resume"]),
            (["noise", "--volume", "ball.vol"], ["--volume", "noise"]),
            ([small, "--radii", "3"], ["--radii", "small.json"]),
        ]:
            with self.subTest(arguments=arguments):
                self.must_fail(["study", *arguments, "--out", "out"], *named)


class Report(InFolder):
    """Of a study's folder; the page itself is tested by scripts/report."""

    SOLID = {
        "name": "solid",
        "sweeps": [
            {
                "shapes": ["sphere:radius=3"],
                "estimators": ["ii-covariance"],
                "radii": [{"k": 2}],
                "schedule": {"values": [1, 0.5]},
                "shifts": 1,
            }
        ],
    }

    def setUp(self):
        super().setUp()
        self.write_study(self.SOLID)
        self.must_work("study", "small.json", "--out", "a")

    def page(self, path):
        return page_data(self.folder / path)

    def test_what_is_in_it(self):
        if not (self.folder / "a/report.html").exists():
            self.must_fail(["report", "a"], "report.html", "without Node")
            self.skipTest("built without Node")
        of_study = (self.folder / "a/report.html").read_bytes()
        (self.folder / "a/report.html").unlink()
        self.assertIn("written: a/report.html", self.must_work("report", "a").stdout)
        self.assertEqual((self.folder / "a/report.html").read_bytes(), of_study, "from the files alone")
        summary = json.loads((self.folder / "a/summary.json").read_text())
        page = self.page("a/report.html")
        (study,) = page["report-data"]["studies"]
        for key in summary:
            self.assertEqual(study[key], summary[key])
        self.assertEqual([s["h"] for s in study["surfaces"]], [0.5])
        self.assertEqual(study["surfaces_left_out"], [])
        self.assertEqual(list(page), ["report-data", "surface-0"])

        self.must_work("study", "small.json", "--seed", 2, "--out", "b")
        self.must_work("report", "a", "b", "--out", "both.html")
        both = self.page("both.html")["report-data"]["studies"]
        self.assertEqual([s["folder"] for s in both], ["a", "b"])
        self.assertEqual([s["seed"] for s in both], [1, 2])

    def test_a_surface_that_is_not_found_again_is_left_out(self):
        if not (self.folder / "a/report.html").exists():
            self.skipTest("built without Node")
        records = (self.folder / "a/records.jsonl").read_text()
        for old, new, reason in [
            (r'"h":0.5', '"h":0.51', "surfels"),
            (r'"mean":{"sup":', '"mean":{"sup":1', "the rms error of mean"),
            (r'"shape":"sphere', '"shape":"spere', "unknown shape 'spere'"),
            (r'"k":2.0', '"k":0.1', "R/h"),
            (r'"offset":\[', '"offset":[0,', "4 numbers"),
            (r'"h":0.5', '"h":1e-6', "memory"),
            (r'"h":0.5', '"h":-1', "h = -1"),
        ]:
            with self.subTest(reason=reason):
                changed = re.sub(old, new, records)
                self.assertNotEqual(changed, records)
                (self.folder / "a/records.jsonl").write_text(changed)
                self.must_work("report", "a")
                (study,) = self.page("a/report.html")["report-data"]["studies"]
                self.assertEqual(len(study["surfaces_left_out"]), 1)
                self.assertIn(reason, study["surfaces_left_out"][0])

    def test_wrong_input(self):
        def changed(change):
            summary = json.loads((self.folder / "a/summary.json").read_text())
            change(summary)
            return json.dumps(summary)

        files = {name: (self.folder / "a" / name).read_text() for name in ("summary.json", "records.jsonl")}
        lines = files["records.jsonl"].splitlines()
        for name, text, named in [
            ("summary.json", "", ["a/summary.json"]),
            ("summary.json", files["summary.json"][:-9], ["a/summary.json", "line"]),
            ("summary.json", "[]", ["a/summary.json", "object"]),
            ("summary.json", changed(lambda s: s.update(schema=2)), ["a/summary.json", "schema = 2"]),
            ("summary.json", changed(lambda s: s.pop("cost")), ["a/summary.json", "'cost' is missing"]),
            (
                "summary.json",
                changed(lambda s: s["convergence"][1].update(slope="steep")),
                ["a/summary.json", "convergence[1]", 'slope = "steep"'],
            ),
            (
                "summary.json",
                changed(lambda s: s["convergence"][0].update(interval=[1])),
                ["a/summary.json", "convergence[0]", "interval = [1]"],
            ),
            ("summary.json", changed(lambda s: s.update(study={"name": "other"})), ["not of the same run"]),
            ("records.jsonl", "", ["a/records.jsonl"]),
            ("records.jsonl", lines[0] + "\n" + lines[1][:-5], ["a/records.jsonl", "line 2 is no JSON"]),
            ("records.jsonl", lines[0] + "\n{}", ["a/records.jsonl", "line 2", "'shape'"]),
        ]:
            with self.subTest(named=named):
                (self.folder / "a" / name).write_text(text)
                self.must_fail(["report", "a"], *named)
                (self.folder / "a" / name).write_text(files[name])
        self.must_fail(["report"], "folders")
        self.must_fail(["report", "none"], "none/summary.json", "No such file")
        if has_page():
            self.must_fail(["report", "a", "--out", "missing/page.html"], "missing/page.html")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
