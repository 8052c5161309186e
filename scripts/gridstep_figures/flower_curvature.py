"""Curvature along the flower, estimate and truth against the arc position, at two grid steps."""

import matplotlib.pyplot as plt
import numpy as np

from . import colours

NAME = "flower-curvature"
SUMMARY = "curvature along a flower, estimate and truth against the arc position, at two grid steps"
SHAPE = "flower:radius=20,amplitude=7,petals=6"
STEPS = (0.5, 0.02)
SHOWN = 1 / 3  # of the contour: two of six petals


def arc_positions(table, h):
    """Of the middles of linels along their contour: a linel is as long as its projection on the estimated tangent."""
    tangents = np.column_stack([table["lambda-mst.tangent_x"], table["lambda-mst.tangent_y"]])
    along = np.column_stack([table["kx"] % 2, table["ky"] % 2])  # the open direction of a linel is the odd one
    lengths = h * np.abs(np.sum(tangents * along, axis=1))
    return np.cumsum(lengths) - lengths / 2


def draw(context):
    figure = plt.figure(figsize=(6.8, 2.9), layout="constrained")
    left, right = figure.subfigures(1, 2, width_ratios=(1, 2.25))
    contour, curve = left.subplots(), right.subplots()
    for h, colour, size in zip(STEPS, colours.CURVES[1::-1], (2.6, 0)):
        _, table = context.gridstep.contour(
            *("--shape", SHAPE, "--h", h, "--estimator", "ii,lambda-mst", "--k", 5)
        )
        contour_table = table = np.roll(table, -int(np.argmax(table["x"])))  # from the rightmost linel on
        s = arc_positions(table, h)
        end = SHOWN * s[-1]
        table, s = table[s <= end], s[s <= end]
        style = {"marker": "o", "markersize": size, "linewidth": 0.6} if size else {"linewidth": 0.9}
        curve.plot(s, table["ii.kappa"], color=colour, label=f"estimate, $h = {h:g}$", **style)
    curve.plot(s, table["ii.true_kappa"], color="black", linewidth=0.8, linestyle=(0, (5, 2)), label="truth", zorder=3)
    curve.axhline(0, color="#999999", linewidth=0.5, zorder=0)
    curve.set_xlim(0, end)
    curve.set_xlabel("arc position $s$")
    curve.set_ylabel(r"curvature $\kappa$")
    curve.legend(loc="lower center", ncols=3, bbox_to_anchor=(0.5, 1))

    kappa = contour_table["ii.kappa"]
    scale = colours.scale(context.map, kappa, signed=False)
    contour.scatter(contour_table["x"], contour_table["y"], c=scale.colours(kappa), s=3, linewidths=0, rasterized=True)
    start = contour_table[0]
    contour.annotate(
        "", xy=(start["x"] + 2, start["y"] + 7), xytext=(start["x"] + 2, start["y"] - 1),
        arrowprops={"arrowstyle": "->", "linewidth": 0.7},
    )
    contour.text(start["x"] + 3, start["y"] + 3, "$s$", va="center")
    contour.set_aspect("equal")
    contour.axis("off")
    scale.bar(left, contour, rf"estimate of $\kappa$, $h = {STEPS[-1]:g}$")
    return figure
