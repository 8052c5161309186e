"""A digital surface with values, as the program writes it in PLY."""

from dataclasses import dataclass

import numpy as np


@dataclass
class Surface:
    corners: np.ndarray  # surfels x 4 x 3, counterclockwise seen from outside
    values: dict  # by column: an array over the surfels

    def vectors(self, name):
        return np.column_stack([self.values[f"{name}_{axis}"] for axis in "xyz"])

    @property
    def centres(self):
        return self.corners.mean(axis=1)

    @property
    def outwards(self):
        """The unit normals of the squares themselves."""
        sides = np.cross(self.corners[:, 1] - self.corners[:, 0], self.corners[:, 2] - self.corners[:, 1])
        return sides / np.linalg.norm(sides, axis=1, keepdims=True)

    @property
    def step(self):
        return np.linalg.norm(self.corners[0, 1] - self.corners[0, 0])


def read_ply(path):
    with open(path, encoding="ascii") as file:
        counts, columns = {}, []
        for line in iter(file.readline, "end_header\n"):
            words = line.split()
            if words[0] == "element":
                counts[words[1]] = int(words[2])
            elif words[0] == "property" and "face" in counts and words[1] != "list":
                columns.append(words[2])
        vertices = np.loadtxt(file, max_rows=counts["vertex"], ndmin=2)
        faces = np.loadtxt(file, max_rows=counts["face"], ndmin=2)
    return Surface(vertices[faces[:, 1:5].astype(int)], dict(zip(columns, faces[:, 5:].T)))
