"""Runs the program and reads what it wrote."""

import json
import subprocess
import tempfile
from pathlib import Path

import numpy as np

from .surface import read_ply


class Gridstep:
    """The program at a path."""

    def __init__(self, path):
        self.path = path

    def __call__(self, *words):
        """What it prints with --json. A failure is a SystemExit with the program's own line."""
        command = [str(self.path), *map(str, words), "--json"]
        try:
            return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
        except FileNotFoundError:
            raise SystemExit(f"figures: {self.path}: no such program; --program names it") from None
        except subprocess.CalledProcessError as failure:
            raise SystemExit(f"figures: {failure.stderr.strip()}") from None

    def contour(self, *words):
        """(summary, table): of the linels of a contour in its order, a NumPy array with a field a column."""
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "contour.npy"
            return self("estimate", *words, "--out", file), np.load(file)

    def surface(self, *words):
        """(summary, Surface)"""
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "surface.ply"
            return self("estimate", *words, "--out", file), read_ply(file)
