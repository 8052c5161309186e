#!/usr/bin/env python3
"""Makes the quick figures with the built program: files that open, the same bytes again, and the numbers that they show.

    scripts/figures_test.py PATH_OF_GRIDSTEP [unittest options]     exits with 77 where matplotlib is missing
"""

import json
import os
import subprocess
import sys
import tempfile
import types
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

try:
    import matplotlib
    import numpy as np
except ImportError as missing:
    # Debian's modules belong to Debian's Python, which need not be the first in the path.
    debian = "/usr/bin/python3"
    if os.path.realpath(sys.executable) != os.path.realpath(debian) and os.path.exists(debian):
        os.execv(debian, [debian, *sys.argv])
    print(f"skipped: {missing}")
    sys.exit(77)

from gridstep_figures import blobby_cube, colours, flower_curvature, kernel_masks, page, program, results
from gridstep_figures.surface import Surface
from gridstep_figures.view import View

SCRIPT = Path(__file__).resolve().parent / "figures"
PROGRAM = None
STUDY = {
    "name": "small",
    "sweeps": [
        {
            "shapes": ["ellipse:a=6,b=3", "flower:radius=6,amplitude=2,petals=5"],
            "estimators": ["ii", "mdca"],
            "radii": [{"k": 2}],
            "schedule": {"from": 0.5, "to": 0.05, "steps": 5},
            "shifts": 3,
        }
    ],
}


def context(palette="paper"):
    return types.SimpleNamespace(gridstep=program.Gridstep(PROGRAM), map=palette, volume=None)


def lines(axes):
    return {line.get_gid(): line for line in axes.get_lines()}


class InFolder(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="gridstep_figures_")
        self.addCleanup(temporary.cleanup)
        self.addCleanup(matplotlib.pyplot.close, "all")
        self.folder = Path(temporary.name)

    def figures(self, *arguments):
        command = [sys.executable, SCRIPT, "--program", PROGRAM, *map(str, arguments)]
        return subprocess.run(command, cwd=self.folder, capture_output=True, text=True)

    def study(self):
        (self.folder / "small.json").write_text(json.dumps(STUDY))
        subprocess.run([PROGRAM, "study", "small.json", "--out", "small"], cwd=self.folder, check=True, capture_output=True)
        return self.folder / "small"

    def volume(self):
        """An ellipsoid that leaves the middle of its box."""
        z, y, x = np.indices((24, 20, 22))
        inside = ((x - 10) / 10) ** 2 + ((y - 10) / 9) ** 2 + ((z - 13) / 9) ** 2 <= 1
        path = self.folder / "ball.vol"
        path.write_bytes(b"X: 22\nY: 20\nZ: 24\nVersion: 2\n.\n" + inside.astype(np.uint8).tobytes())
        return path


class Files(InFolder):
    def check_files(self, folder):
        for path in sorted(folder.iterdir()):
            with self.subTest(file=path.name):
                content = path.read_bytes()
                if path.suffix == ".pdf":
                    self.assertTrue(content.startswith(b"%PDF-") and content.rstrip().endswith(b"%%EOF"))
                elif path.suffix == ".svg":
                    self.assertGreater(len(list(ElementTree.fromstring(content).iter())), 50)
                else:
                    picture = matplotlib.image.imread(path)
                    self.assertGreater(len(np.unique(picture.reshape(-1, picture.shape[2]), axis=0)), 20, "blank")

    def test_the_same_bytes_again(self):
        self.study()
        detail = ("study", "level-of-detail", "--volume", self.volume(), "--radii", "4,2", "--out", "ball")
        subprocess.run([PROGRAM, *detail], cwd=self.folder, check=True, capture_output=True)
        what = ("kernel-masks", "flower-curvature", "small", "ball")
        names = ["kernel-masks", "flower-curvature", "error-curves-small-kappa-sup", "level-of-detail-ball"]
        for out in ("a", "b"):
            result = self.figures(*what, "--out", out)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            written = sorted(f"{name}.{kind}" for name in names for kind in ("pdf", "svg", "png"))
            self.assertEqual(sorted(p.name for p in (self.folder / out).iterdir()), written)
            self.assertEqual(result.stdout.count("written: "), len(written))
        for name in written:
            self.assertEqual((self.folder / "a" / name).read_bytes(), (self.folder / "b" / name).read_bytes(), name)
        self.check_files(self.folder / "a")

    def test_the_other_colours(self):
        self.assertEqual(self.figures("kernel-masks", "--out", "a").returncode, 0)
        self.assertEqual(self.figures("kernel-masks", "--out", "b", "--map", "perceptual").returncode, 0)
        self.check_files(self.folder / "b")
        a, b = (self.folder / out / "kernel-masks.png" for out in "ab")
        self.assertNotEqual(a.read_bytes(), b.read_bytes())

    def test_wrong_input(self):
        (self.folder / "empty").mkdir()
        (self.folder / "other").mkdir()
        (self.folder / "other/summary.json").write_text("[]")
        (self.folder / "file").write_text("")
        twice = self.study(), self.folder / "deep/small"
        twice[1].mkdir(parents=True)
        (twice[1] / "summary.json").write_bytes((twice[0] / "summary.json").read_bytes())
        for arguments, named in [
            (["kernal"], ["'kernal'", "kernel-masks"]),
            (["empty"], ["empty/summary.json", "No such file"]),
            (["other"], ["other/summary.json", "not the summary"]),
            (["two-radii", "--volume", "none.vol"], ["none.vol", "not found"]),
            (["kernel-masks", "--program", "none"], ["none", "--program"]),
            (["kernel-masks", "--out", "file"], ["file", "File exists"]),
            ([*twice], ["error-curves-small-kappa-sup twice"]),
        ]:
            with self.subTest(arguments=arguments):
                before = sorted(self.folder.rglob("*"))
                result = self.figures(*arguments)
                self.assertEqual(result.returncode, 1)
                self.assertTrue(result.stderr.startswith("figures: "), result.stderr)
                self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
                for text in named:
                    self.assertIn(text, result.stderr)
                self.assertEqual(sorted(self.folder.rglob("*")), before)

    def test_help(self):
        text = self.figures("--help").stdout
        self.assertIn("examples:\n  scripts/figures ", text)
        for name in ("kernel-masks", "flower-curvature", "blobby-cube", "two-radii"):
            self.assertIn(name, text)


class Numbers(InFolder):
    def test_error_curves_are_those_of_the_summary(self):
        folder = self.study()
        summary = json.loads((folder / "summary.json").read_text())
        for norm in ("sup", "rms", "mean"):
            ((name, draw),) = results.pages(folder, norm, "paper").items()
            self.assertEqual(name, f"error-curves-small-kappa-{norm}")
            panels = draw().axes
            series = [s for s in summary["convergence"] if s["norm"] == norm]
            self.assertEqual(len(series), 4)
            for s in series:
                (axes,) = [a for a in panels if s["shape"].startswith(a.get_title())]
                shown = lines(axes)
                h = np.array([level["h"] for level in s["levels"]])
                means, fit = shown[f"means {s['estimator']}"], shown[f"fit {s['estimator']}"]
                np.testing.assert_array_equal(means.get_xdata(), h)
                np.testing.assert_allclose(means.get_ydata(), [np.mean(l["errors"]) for l in s["levels"]], rtol=1e-14)
                np.testing.assert_allclose(fit.get_ydata(), s["constant"] * h ** s["slope"], rtol=1e-14)
                self.assertIn(f"{s['slope']:.3f}".replace("-", "\u2212"), means.get_label())
                bands = [tuple(np.sort(np.unique(b.get_paths()[0].vertices[:, 1]))) for b in axes.collections]
                ends = [end(l["errors"]) for l in s["levels"] for end in (min, max)]
                self.assertTrue(any(np.allclose((b[0], b[-1]), (min(ends), max(ends)), rtol=1e-14) for b in bands))
            reference = lines(panels[0])["reference 0.333"]
            x, y = reference.get_xdata(), reference.get_ydata()
            self.assertAlmostEqual(np.log(y[0] / y[-1]) / np.log(x[0] / x[-1]), 1 / 3, places=12)

    def test_masks_turn_the_ball_into_the_one_beside_it(self):
        ball = kernel_masks.ball(4.5)
        self.assertEqual(len(ball), 69)  # Gauss's circle problem
        for step in kernel_masks.STEPS:
            gained, lost = kernel_masks.masks(4.5, step)
            self.assertEqual((ball - lost) | gained, {(x + step[0], y + step[1]) for x, y in ball})
            self.assertEqual(len(gained), len(lost))

    def test_masks_that_are_not_the_program_s_are_not_drawn(self):
        kernel_masks.check(context())
        true_ball = kernel_masks.ball
        self.addCleanup(setattr, kernel_masks, "ball", true_ball)
        kernel_masks.ball = lambda radius: true_ball(radius) | {(int(radius) + 1, 0)}
        with self.assertRaises(SystemExit):
            kernel_masks.check(context())

    def test_arc_positions_end_at_the_length_of_the_contour(self):
        disk = ("--shape", "disk:radius=5", "--h", 0.02, "--estimator", "ii,lambda-mst", "--k", 3)
        _, table = context().gridstep.contour(*disk)
        s = flower_curvature.arc_positions(table, 0.02)
        self.assertTrue(np.all(np.diff(s) > 0))
        self.assertAlmostEqual(s[-1], 2 * np.pi * 5, delta=0.05)


class Rendering(InFolder):
    def test_what_is_in_front_is_seen(self):
        """Three cubes in a corner, the nearest one red: no pixel of it is hidden by the others."""
        view = View(towards=(1, 2, 3), up=(0, 0, 1))
        faces = []
        for cube in [(1, 0, 0), (0, 0, 0), (0, 1, 0)]:
            for axis in range(3):
                u, v = np.eye(3)[(axis + 1) % 3], np.eye(3)[(axis + 2) % 3]
                corner = np.array(cube) + np.eye(3)[axis]
                faces.append([corner, corner + u, corner + u + v, corner + v])
        corners = np.array(faces, float)
        normals = np.tile(view.light, (9, 1))
        surface = Surface(corners, dict(zip(("normal_x", "normal_y", "normal_z"), normals.T)))
        tones = np.tile([0.0, 0.0, 1.0, 1.0], (9, 1))
        tones[6:] = [1, 0, 0, 1]  # the last cube hides the x-face of none and the y-face of the second
        axes = matplotlib.pyplot.figure().subplots()
        view.draw(axes, surface, tones)
        image = axes.get_images()[0]
        picture, (left, right, low, high) = image.get_array(), image.get_extent()
        for face in corners[6:]:
            x, y = view.flat(face.mean(axis=0))
            row = int((high - y) / (high - low) * picture.shape[0])
            column = int((x - left) / (right - left) * picture.shape[1])
            red, _, blue, _ = picture[row, column].astype(int)
            self.assertGreater(red, blue + 100)

    def test_directions_lie_on_the_surface_in_sight(self):
        cylinder = ("--shape", "cylinder:radius=3,height=8", "--h", 0.5, "--estimator", "ii-covariance", "--radius", 2)
        _, surface = context().gridstep.surface(*cylinder)
        axes = matplotlib.pyplot.figure().subplots()
        View(towards=(1, -1, 0.3), up=(0, 0, 1)).draw_directions(axes, surface, "dir2", spacing=1)
        segments = np.array(axes.collections[0].get_segments())
        self.assertGreater(len(segments), 20)
        # Along the axis, which is upright on the page, but for the caps and their rims.
        along = segments[:, 1] - segments[:, 0]
        upright = np.abs(along[:, 1]) > 5 * np.abs(along[:, 0])
        self.assertGreater(np.mean(upright), 0.5)

    def test_colours_of_the_paper(self):
        values = np.linspace(-1, 3, 1001)
        signed = colours.scale("paper", values, signed=True).colours(np.array([-1.0, 0, 3]))
        plain = colours.scale("paper", values, signed=False).colours(np.array([-1.0, 1, 3]))
        blue, black, yellow = signed[:, :3]
        self.assertTrue(blue[2] > 0.9 > 0.3 > max(blue[:2]))
        self.assertLess(max(black), 0.01)
        self.assertTrue(min(yellow[:2]) > 0.9 > 0.2 > yellow[2])
        self.assertTrue(plain[0, 2] > 0.8 and plain[1, 0] > 0.8 and max(plain[1, 1:3]) < 0.2 and min(plain[2, :2]) > 0.9)

    def test_a_constant_has_colours_too(self):
        for signed in (False, True):
            for value in (0.0, 2.0, -3.0):
                tones = colours.scale("paper", np.full(9, value), signed).colours(np.full(9, value))
                self.assertTrue(np.isfinite(tones).all())

    def test_the_blobby_cube(self):
        self.addCleanup(setattr, blobby_cube, "SHAPE", blobby_cube.SHAPE)
        blobby_cube.SHAPE = ("--shape", "blobby-cube", "--h", 0.1, "--estimator", "ii-covariance", "--radius", 0.3)
        page.save(blobby_cube.draw(context()), self.folder, "cube")
        self.assertGreater((self.folder / "cube.png").stat().st_size, 50_000)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
