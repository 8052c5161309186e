"""A digital surface seen from far away."""

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.figure import Figure

PIXELS = 1200  # of the longer side of a picture


class View:
    """An orthographic projection: `towards` points from the surface to the eye, `up` upwards on the page."""

    def __init__(self, towards, up):
        self.depth = np.asarray(towards, float) / np.linalg.norm(towards)
        right = np.cross(up, self.depth)
        self.right = right / np.linalg.norm(right)
        self.up = np.cross(self.depth, self.right)
        light = self.depth + 0.7 * self.up - 0.5 * self.right
        self.light = light / np.linalg.norm(light)
        self.halfway = (self.light + self.depth) / np.linalg.norm(self.light + self.depth)

    def flat(self, points):
        return np.stack([points @ self.right, points @ self.up], axis=-1)

    def draw(self, axes, surface, colours):
        """The squares in their colours (RGB or RGBA), shaded by the estimated normals.

        Drawn from back to front by the depth of the spels behind them. That is exact: of two unit cubes of a grid,
        one that hides the other in a direction v is behind it in no coordinate along v, so its depth is greater.
        """
        front = np.flatnonzero(surface.outwards @ self.depth > 1e-9)
        spels = surface.centres[front] - surface.step / 2 * surface.outwards[front]
        front = front[np.argsort(spels @ self.depth, kind="stable")]
        # A little of the squares' own normals keeps the steps of the grid visible.
        normals = 0.85 * surface.vectors("normal")[front] + 0.15 * surface.outwards[front]
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        shade = 0.42 + 0.58 * np.clip(normals @ self.light, 0, 1)
        gleam = 0.22 * np.clip(normals @ self.halfway, 0, 1) ** 12  # shows the relief also where the colour is black
        shaded = np.clip(colours[front, :3] * shade[:, None] + gleam[:, None], 0, 1)
        squares = self.flat(surface.corners[front])
        margin = 0.02 * np.ptp(squares, axis=(0, 1)).max()
        low, high = squares.min(axis=(0, 1)) - margin, squares.max(axis=(0, 1)) + margin
        extent = (low[0], high[0], low[1], high[1])
        axes.imshow(_picture(squares, shaded, extent), extent=extent, interpolation="bilinear")
        axes.axis("off")

    def draw_directions(self, axes, surface, name, spacing, colour="black"):
        """Short lines along a direction field, one in each cell of a coarse grid on the surface in sight."""
        directions, centres = surface.vectors(name), surface.centres
        visible = np.flatnonzero(surface.vectors("normal") @ self.depth > 0.15)
        cells = np.floor(centres[visible] / spacing).astype(int)
        offset = np.linalg.norm(centres[visible] - (cells + 0.5) * spacing, axis=1)
        order = np.lexsort((offset, *cells.T))
        _, first = np.unique(cells[order], axis=0, return_index=True)
        chosen = visible[order[np.sort(first)]]
        chosen = chosen[~self._hidden(surface, chosen)]
        # Lifted a little, and as long as a cell of the coarse grid is wide.
        middles, halves = centres[chosen], 0.42 * spacing * directions[chosen]
        lines = LineCollection(
            self.flat(np.stack([middles - halves, middles + halves], axis=1)),
            colors=colour, linewidths=0.7, capstyle="round",
        )
        axes.add_collection(lines)

    def _hidden(self, surface, chosen):
        """Whether something is in front of these surfels, by more than a few steps."""
        step = surface.step
        pixels = lambda points: np.round(self.flat(points) / step).astype(int)
        depths = surface.centres @ self.depth
        nearest = {}
        for pixel, depth in zip(map(tuple, pixels(surface.centres)), depths):
            nearest[pixel] = max(depth, nearest.get(pixel, -np.inf))
        return np.array([nearest[tuple(p)] > depths[i] + 4 * step for p, i in zip(pixels(surface.centres[chosen]), chosen)])


def _picture(squares, colours, extent):
    """Of polygons, drawn once for all file formats; tens of thousands would make a vector file that few can open."""
    width, height = extent[1] - extent[0], extent[3] - extent[2]
    figure = Figure(figsize=(PIXELS * min(1, width / height), PIXELS * min(1, height / width)), dpi=1)
    canvas = FigureCanvasAgg(figure)
    axes = figure.add_axes((0, 0, 1, 1))
    axes.set(xlim=extent[:2], ylim=extent[2:])
    axes.axis("off")
    figure.patch.set_alpha(0)
    # Edges in the colour of the face close the seams between neighbours.
    axes.add_collection(PolyCollection(squares, facecolors=colours, edgecolors=colours, linewidths=72 * 0.6))
    canvas.draw()
    return np.asarray(canvas.buffer_rgba())
