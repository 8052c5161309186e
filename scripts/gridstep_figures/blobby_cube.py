"""Curvatures and principal directions on the blobby cube, estimated at every surfel."""

import matplotlib.pyplot as plt

from . import colours
from .view import View

NAME = "blobby-cube"
SUMMARY = "mean and Gaussian curvature and both principal directions on the blobby cube"
SHAPE = ("--shape", "blobby-cube", "--h", 0.018, "--estimator", "ii-covariance", "--radius", 0.27)


def draw(context):
    _, surface = context.gridstep.surface(*SHAPE)
    view = View(towards=(1, -1.7, 0.9), up=(0, 0, 1))
    figure, panels = plt.subplots(2, 2, figsize=(6.2, 7), layout="constrained")
    for axes, (name, label, signed) in zip(
        panels.flat,
        [
            ("mean", "mean curvature $H$", False),
            ("gaussian", "Gaussian curvature $K$", True),
            ("k1", r"direction of the larger curvature $\kappa_1$", False),
            ("k2", r"direction of the smaller curvature $\kappa_2$", False),
        ],
    ):
        values = surface.values[name]
        scale = colours.scale(context.map, values, signed)
        tones = scale.colours(values)
        if name in ("k1", "k2"):
            # Pale, for the lines on it to be seen.
            tones = 0.55 * tones + 0.45
        view.draw(axes, surface, tones)
        if name in ("k1", "k2"):
            view.draw_directions(axes, surface, "dir1" if name == "k1" else "dir2", spacing=0.1)
        scale.bar(figure, axes, label)
    return figure
