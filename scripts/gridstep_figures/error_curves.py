"""Error against the grid step, from the summary.json of a study: one panel a shape, one curve a way to estimate.

Bands span the shifts, markers are their means; dashed lines are the fits, dotted ones what a theorem gives.
"""

import math
from functools import partial

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import LogLocator, NullFormatter

from . import colours

NAME = "error-curves"
MARKERS = "os^Dv<>"
PANELS_A_ROW = 3
QUANTITIES = {"kappa": r"$\kappa$", "mean": "$H$", "gaussian": "$K$", "k1": r"$\kappa_1$", "k2": r"$\kappa_2$"}


def way(series, of_page):
    """What tells a series from the others of its panel: the same on all panels."""
    parts = [series["estimator"]]
    for key, text in (("k", "k={:.3g}"), ("alpha", r"\alpha={:.3g}"), ("noise", r"\beta={:.3g}")):
        if series[key] is not None and len({s[key] for s in of_page if s[key] is not None}) > 1:
            parts.append(f"${text.format(series[key])}$")
    return ", ".join(parts)


def slope_text(series):
    if not _is_number(series["slope"]):
        return "no slope"
    text = f"{series['slope']:.3f}"
    if series["interval"] and all(map(_is_number, series["interval"])):
        text += " [{:.3f}, {:.3f}]".format(*series["interval"])
    return text.replace("-", "\u2212")


def _is_number(value):
    return isinstance(value, (int, float)) and math.isfinite(value)


def drawn(series):
    """(h, means, least, largest) by level; a level without any error has no place on a logarithmic axis."""
    levels = [(l["h"], np.mean(l["errors"]), min(l["errors"]), max(l["errors"])) for l in series["levels"]]
    return np.array([(h, mean, least or mean, most) for h, mean, least, most in levels if mean > 0]).reshape(-1, 4).T


def panel(axes, fellows, ways):
    """`ways`: of the whole page, in the order of their colours."""
    references = {}
    for series in fellows:
        number = ways.index(way(series, fellows))
        ink = colours.CURVES[number % len(colours.CURVES)]
        h, means, least, most = drawn(series)
        if not h.size:
            continue
        axes.fill_between(h, least, most, color=ink, alpha=0.18, linewidth=0)
        axes.plot(
            h, means, color=ink, linewidth=0.9, marker=MARKERS[number % len(MARKERS)], markersize=3,
            label=f"{ways[number]}: {slope_text(series)}", gid=f"means {ways[number]}",
        )
        if series["constant"]:
            fit = series["constant"] * h ** series["slope"]
            axes.plot(h, fit, color=ink, linewidth=0.8, linestyle="--", gid=f"fit {ways[number]}")
        p = series["expected"]
        if p is not None:
            references.setdefault(p, (h, []))[1].append(np.min(least / h**p))
    for p, (h, constants) in references.items():
        line = 0.72 * min(constants) * h**p
        axes.plot(h, line, color="#555555", linewidth=0.9, linestyle=":", gid=f"reference {p:.3f}")
        power = "1/3" if abs(p - 1 / 3) < 1e-9 else f"{p:.3g}"
        axes.annotate(
            f"$h^{{{power}}}$", xy=(h.min(), line.min()), xytext=(7, 1), textcoords="offset points", va="top",
            color="#555555",
        )  # fmt: skip
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.margins(y=0.08)
    for axis, (low, high) in ((axes.xaxis, axes.get_xlim()), (axes.yaxis, axes.get_ylim())):
        axis.set_minor_formatter(NullFormatter())
        if high < 50 * low:  # too few powers of ten
            axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
            axis.set_major_formatter(lambda value, _: f"{value:g}")
    axes.set_xlabel("$h$", labelpad=0)
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.16), handlelength=1.6, title="slope [95 % interval]")


def panels_of(series):
    """One a shape; and one a noise level, where there are several estimators to compare."""
    several = len({s["estimator"] for s in series}) > 1
    panels = {}
    for s in series:
        panels.setdefault((s["shape"], s["noise"] if several else None), []).append(s)
    return panels


def draw(series):
    """Of series that have quantity and norm in common."""
    panels = panels_of(series)
    ways = list(dict.fromkeys(way(s, fellows) for fellows in panels.values() for s in fellows))
    columns = min(PANELS_A_ROW, len(panels))
    rows = -(-len(panels) // columns)
    height = 2.75 + 0.165 * max(map(len, panels.values()))
    figure, grid = plt.subplots(
        rows, columns, figsize=(2.6 * columns, rows * height), squeeze=False, layout="constrained"
    )
    for axes, ((shape, noise), fellows) in zip(grid.flat, panels.items()):
        name = shape.split(":")[0]
        panel(axes, fellows, ways)
        title = name if sum(n == noise and s.startswith(f"{name}:") for s, n in panels) <= 1 else shape
        axes.set_title(rf"{title}, noise $\beta = {noise:g}$" if noise else title, pad=4)
    for axes in grid.flat[len(panels) :]:
        axes.axis("off")
    quantity = QUANTITIES.get(series[0]["quantity"], series[0]["quantity"])
    for row in grid:
        row[0].set_ylabel(f"{series[0]['norm']} error of {quantity}")
    return figure


def pages(study, summary, norm):
    """{name of the file: function that draws it}, one for each quantity of a study."""
    series = [s for s in summary["convergence"] if s["norm"] == norm]
    return {
        f"{NAME}-{study}-{quantity}-{norm}": partial(draw, [s for s in series if s["quantity"] == quantity])
        for quantity in dict.fromkeys(s["quantity"] for s in series)
    }
