"""From values to colours: as in the paper, or by maps whose lightness tells the order."""

import numpy as np
from matplotlib import colormaps
from matplotlib.cm import ScalarMappable
from matplotlib.colors import LinearSegmentedColormap, Normalize, TwoSlopeNorm

# The highest value is yellow, the lowest blue, red between; where the sign matters, zero is black.
_MAPS = {
    "paper": {
        False: LinearSegmentedColormap.from_list("paper", ["#1020e0", "#e01010", "#ffee20"]),
        True: LinearSegmentedColormap.from_list(
            "paper_signed", [(0, "#2a3cff"), (0.5, "#000000"), (0.76, "#e01010"), (1, "#ffee20")]
        ),
    },
    "perceptual": {False: colormaps["viridis"], True: colormaps["coolwarm"]},
}
NAMES = tuple(_MAPS)

# Curves in one panel, for all kinds of colour vision (Okabe & Ito).
CURVES = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000")


class scale:
    """The colours that span the values but for 1 % at either end, as on the report page; signed ones meet at zero."""

    def __init__(self, name, values, signed):
        low, high = np.percentile(values, [1, 99])
        if not low < high:
            low, high = low - (abs(low) or 1) / 2, high + (abs(high) or 1) / 2
        if signed:
            most = max(abs(low), abs(high))
            norm = TwoSlopeNorm(0, min(low, -most / 1e3), max(high, most / 1e3))
        else:
            norm = Normalize(low, high)
        self._mappable = ScalarMappable(norm, _MAPS[name][signed])

    def colours(self, values):
        return self._mappable.to_rgba(values)

    def bar(self, figure, axes, label):
        """Below the axes."""
        bar = figure.colorbar(
            self._mappable, ax=axes, orientation="horizontal", shrink=0.75, aspect=28, pad=0.02, extend="both"
        )
        bar.set_label(label)
        bar.outline.set_linewidth(0.5)
        low, high = self._mappable.norm.vmin, self._mappable.norm.vmax
        if isinstance(self._mappable.norm, TwoSlopeNorm):
            # Each half of the bar has its own scale: its end and its middle, and zero where they meet.
            bar.set_ticks([low, low / 2, 0, high / 2, high])
            bar.ax.set_xticklabels([f"{t:.2g}".replace("-", "\u2212") for t in bar.get_ticks()])
