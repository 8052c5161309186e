"""The full kernel and its displacement masks, as in the paper's Fig. 2.

When the kernel moves by one step to a neighbour, a sum over it gains the points of R+ and loses those of R-: the two
differences of the ball before and after. The masks of the program are as large; otherwise nothing is drawn.
"""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PatchCollection
from matplotlib.patches import Rectangle

NAME = "kernel-masks"
SUMMARY = "a digital disk and the masks R+ and R- of its eight displacements"
RADIUS = 9
STEPS = [(x, y) for y in (1, 0, -1) for x in (-1, 0, 1)]
COLOURS = {
    "paper": {"kernel": "#c8c8c8", "gained": "#f4c20d", "lost": "#1f3fd8"},
    "perceptual": {"kernel": "#c8c8c8", "gained": "#e69f00", "lost": "#0072b2"},
}


def ball(radius):
    """The lattice points within the radius of the origin, as a set of pairs."""
    r = int(radius)
    return {(x, y) for x in range(-r, r + 1) for y in range(-r, r + 1) if x * x + y * y <= radius * radius}


def masks(radius, step):
    """(R+, R-)"""
    before = ball(radius)
    after = {(x + step[0], y + step[1]) for x, y in before}
    return after - before, before - after


def check(context):
    """The program's kernel of this radius and its masks have as many cells as those drawn here."""
    answer = context.gridstep(
        *("estimate", "--shape", "disk:radius=20", "--h", 1, "--estimator", "ii"),
        *("--radius", RADIUS, "--evaluation", "masks"),
    )
    work = answer["estimates"][0]["work"]
    sizes = sorted(len(masks(RADIUS, step)[0]) for step in STEPS if step != (0, 0))
    if work["kernel_size"] != len(ball(RADIUS)) or sorted(work["mask_sizes"]) != sizes:
        raise SystemExit(f"figures: {NAME}: the program's kernel or masks are not those of a digital disk")


def cells(axes, points, colour):
    squares = [Rectangle((x - 0.5, y - 0.5), 1, 1) for x, y in sorted(points)]
    axes.add_collection(PatchCollection(squares, facecolor=colour, edgecolor="white", linewidth=0.35))


def frame(axes):
    r = RADIUS + 2
    axes.set_xlim(-r, r)
    axes.set_ylim(-r - 2, r)
    axes.set_aspect("equal")
    axes.axis("off")


def draw(context):
    check(context)
    tones = COLOURS[context.map]
    figure = plt.figure(figsize=(6.8, 3.9), layout="constrained")
    left, right = figure.subfigures(1, 2, width_ratios=(1.0, 1.35))

    axes = left.subplots()
    cells(axes, ball(RADIUS), tones["kernel"])
    circle = np.linspace(0, 2 * np.pi, 400)
    axes.plot(RADIUS * np.cos(circle), RADIUS * np.sin(circle), color="black", linewidth=0.8)
    axes.plot([0, RADIUS], [0, 0], color="black", linewidth=0.8)
    axes.plot(0, 0, "o", color="black", markersize=2.5)
    axes.text(RADIUS / 2, 0.5, "$R/h$", ha="center")
    frame(axes)
    axes.set_title(f"full kernel: {len(ball(RADIUS))} points", y=-0.04)

    for axes, step in zip(right.subplots(3, 3).flat, STEPS):
        frame(axes)
        if step == (0, 0):
            cells(axes, ball(RADIUS), tones["kernel"])
            continue
        gained, lost = masks(RADIUS, step)
        axes.plot(RADIUS * np.cos(circle), RADIUS * np.sin(circle), color="#b0b0b0", linewidth=0.5)
        cells(axes, gained, tones["gained"])
        cells(axes, lost, tones["lost"])
        axes.annotate(
            "", xy=(2.2 * step[0], 2.2 * step[1]), xytext=(-2.2 * step[0], -2.2 * step[1]),
            arrowprops={"arrowstyle": "-|>", "linewidth": 0.7, "color": "black", "mutation_scale": 7},
        )
        axes.text(0, -RADIUS - 4.2, f"$+{len(gained)}$  $-{len(lost)}$", ha="center", fontsize=7)
    handles = [Rectangle((0, 0), 1, 1, facecolor=tones[kind]) for kind in ("gained", "lost")]
    left.legend(handles, ["$R^+$: gained", "$R^-$: lost"], loc="lower center", ncols=2)
    return figure
