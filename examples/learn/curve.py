"""Curve of a training as an SVG file."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import matplotlib as mpl

mpl.use("svg")
from matplotlib import pyplot as plt


def draw(path: Path, points: Sequence[tuple[float, float]], across: str, up: str, line: float | None = None) -> None:
    """Draw a curve.

    Args:
        path: SVG file to write.
        points: pairs (across, up).
        across: title of the horizontal axis.
        up: title of the vertical axis.
        line: value that a dashed line marks.
    """
    mpl.rcParams["svg.hashsalt"] = "aftdeck"  # the same file for the same points
    figure, axes = plt.subplots(figsize=(6.4, 3.2), layout="constrained")
    axes.plot(*zip(*points, strict=True), color="#1f6feb", marker="o", markersize=3)
    if line is not None:
        axes.axhline(line, color="#888888", linestyle="--", linewidth=1)
    axes.set_xlabel(across)
    axes.set_ylabel(up)
    axes.grid(alpha=0.3)
    axes.set_ylim(bottom=0.0)
    figure.savefig(path, metadata={"Date": None})
