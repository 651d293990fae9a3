"""Charts of a study, drawn by matplotlib."""

from __future__ import annotations

import functools
import io
import os
import re
from collections.abc import Callable
from typing import Any

from aftdeck.extra import needed
from aftdeck.folders import user_folder, usual_folder
from aftdeck.report.page.document import Chart

_STYLE = {
    "font.family": "sans-serif",
    "font.size": 9.0,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.edgecolor": "#8a929a",
    "axes.labelcolor": "#22282e",
    "xtick.color": "#4a525a",
    "ytick.color": "#4a525a",
    "axes.grid": True,
    "grid.color": "#e3e7ea",
    "axes.axisbelow": True,
    "svg.fonttype": "none",
    "legend.frameon": False,
    "path.simplify": True,
}


@functools.cache
def _give_a_folder() -> None:
    """Give matplotlib a folder if the user's cannot be written; it prints lines if it has to find one itself."""
    folder = user_folder("cache")
    if folder is not None and folder != usual_folder("cache"):
        os.environ.setdefault("MPLCONFIGDIR", str(folder / "matplotlib"))


def chart(
    draw: Callable[[Any], None],
    what: str,
    size: tuple[float, float] = (4.6, 3.1),
    margins: tuple[float, float, float, float] | None = None,
) -> Chart:
    """Return a drawing; equal drawings give equal texts.

    Args:
        draw: function that draws into matplotlib's axes.
        what: what the drawing shows, for a reader who cannot see it.
        size: width and height [in].
        margins: space for texts at the left, bottom, right and top [in]; None to measure the texts, which takes time.

    Raises:
        InputError: matplotlib is not installed.
    """
    _give_a_folder()
    matplotlib: Any = needed("matplotlib")
    figure_kind: Any = needed("matplotlib.figure").Figure
    out = io.StringIO()
    with matplotlib.rc_context({**_STYLE, "svg.hashsalt": what}):
        figure = figure_kind(figsize=size, layout="constrained" if margins is None else None)
        if margins is not None:
            left, bottom, right, top = margins
            wide, high = size
            figure.subplots_adjust(left / wide, bottom / high, 1.0 - right / wide, 1.0 - top / high)
        draw(figure.add_subplot())
        figure.savefig(out, format="svg", transparent=True, metadata={"Date": None, "Creator": None})
    _, _, text = out.getvalue().partition("<svg ")
    for part in ("metadata", "style"):  # the page's own style has what matplotlib's says
        text = re.sub(f"<{part}.*?</{part}>", "", text, flags=re.DOTALL)
    return Chart(text, what)
