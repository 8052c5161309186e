"""The figures of a results folder, by what its study has written."""

import json
from pathlib import Path

from . import error_curves, two_radii


def pages(folder, norm, palette):
    """{name of the file: function that draws it}. A folder without a summary is a SystemExit."""
    folder = Path(folder)
    path, study = folder / "summary.json", folder.resolve().name
    try:
        summary = json.loads(path.read_text(encoding="utf-8"))
        if "detail" in summary:
            return two_radii.pages(folder, study, summary, palette)
        return error_curves.pages(study, summary, norm)
    except OSError as failure:
        raise SystemExit(f"figures: {path}: {failure.strerror}") from None
    except (ValueError, KeyError, TypeError):
        raise SystemExit(f"figures: {path}: not the summary of a study") from None
