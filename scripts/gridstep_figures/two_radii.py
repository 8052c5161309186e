"""Gaussian curvature of a surface at two radii: what a small kernel resolves, a large one smooths.

The paper's Fig. 3 shows Al.100.vol at R = 14 and R = 7: --volume Al.100.vol. Without a volume, a shape of ours.
"""

import matplotlib.pyplot as plt

from . import colours
from .surface import read_ply
from .view import View

NAME = "two-radii"
SUMMARY = "Gaussian curvature of --volume FILE at R = 14 and 7 voxels, or of Goursat's surface"
VOXELS = (14, 7)
SHAPE, RADII = ("--shape", "goursat", "--h", 0.25), (3.5, 1.75)


def draw(context):
    what, radii = (("--volume", context.volume, "--h", 1), VOXELS) if context.volume else (SHAPE, RADII)
    words = (*what, "--estimator", "ii-covariance", "--radius")
    return side_by_side(context.map, [(R, context.gridstep.surface(*words, R)[1]) for R in radii])


def side_by_side(palette, surfaces):
    """Of (radius, surface)."""
    view = View(towards=(1, -1.6, 0.8), up=(0, 0, 1))
    count = len(surfaces)
    figure, panels = plt.subplots(1, count, figsize=(3.2 * count, 4.2), squeeze=False, layout="constrained")
    for axes, (R, surface) in zip(panels.flat, surfaces):
        gaussian = surface.values["gaussian"]
        scale = colours.scale(palette, gaussian, signed=True)
        view.draw(axes, surface, scale.colours(gaussian))
        axes.set_title(f"$R = {R:g}$")
        scale.bar(figure, axes, "Gaussian curvature $K$")
    return figure


def pages(folder, study, summary, palette):
    """The same from what the study level-of-detail left in its folder."""

    def draw_levels():
        levels = summary["detail"]["levels"]
        return side_by_side(palette, [(level["radius"], read_ply(folder / level["surfaces"][1])) for level in levels])

    return {f"level-of-detail-{study}": draw_levels}
