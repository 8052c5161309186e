"""How pages look, and how they are saved: the same bytes from the same numbers."""

import io
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

plt.rcdefaults()  # not what the user's own matplotlibrc says
plt.rcParams.update(
    {
        "font.family": "STIXGeneral",
        "mathtext.fontset": "stix",
        "font.size": 9,
        "axes.titlesize": 10,
        "axes.labelsize": 9,
        "legend.fontsize": 8,
        "xtick.labelsize": 8,
        "ytick.labelsize": 8,
        "axes.linewidth": 0.6,
        "xtick.major.width": 0.6,
        "ytick.major.width": 0.6,
        "xtick.minor.width": 0.4,
        "ytick.minor.width": 0.4,
        "xtick.direction": "in",
        "ytick.direction": "in",
        "legend.frameon": False,
        "savefig.dpi": 300,
        "pdf.fonttype": 42,
        "svg.fonttype": "path",
        "svg.hashsalt": "gridstep",
    }
)

# What would differ from run to run is left out of each format.
_FORMATS = {"pdf": {"CreationDate": None}, "svg": {"Date": None}, "png": {"Software": None}}


def paths(folder, name):
    return [folder / f"{name}.{kind}" for kind in _FORMATS]


def save(figure, folder, name):
    """As PDF, SVG and PNG; each file appears whole or not at all."""
    for (kind, metadata), path in zip(_FORMATS.items(), paths(folder, name)):
        content = io.BytesIO()
        figure.savefig(content, format=kind, metadata=metadata, bbox_inches="tight", pad_inches=0.04)
        unfinished = path.with_name(f".{path.name}.{os.getpid()}.tmp")
        unfinished.write_bytes(content.getvalue())
        os.replace(unfinished, path)
    plt.close(figure)
