"""Charts of a run: timeline, strips, and the path from above and from the side."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from aftdeck.arrays import Array
from aftdeck.extra import needed
from aftdeck.report.curves import Lane, Strip
from aftdeck.report.page.document import Chart
from aftdeck.report.page.gather import Gathered
from aftdeck.report.page.svg import COLOURS, chart
from aftdeck.report.words import axis_of
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.visual.scene import VisualScene

_LEVELS = {"caution": "#f0b840", "warning": "#d9534f"}
_PLAIN = ("#dde5eb", "#c8d3dc")
"""Colours of stretches by their level; those without an alarm have two in turn."""
_LABEL_PART = 0.006
"""Part of the timeline's width that a character of a label needs."""
_TIMELINE_MARGINS = (0.75, 0.45, 0.1, 0.05)
_STRIP_MARGINS = (0.5, 0.28, 0.1, 0.25)
_VIEW_MARGINS = (0.6, 0.45, 0.1, 0.1)
"""Space for texts at the left, bottom, right and top [in]."""
_FIXED, _MOVING = "#eef1f3", "#d3dce3"
"""Colours of bodies that are fixed to the orbiter or to space, and of others."""
_STILL = ("orbiter", "space")


def timeline(run: Gathered) -> Chart:
    """Return the lanes of a run over time, with its key moments as lines."""
    lanes, end = [lane for lane in run.lanes if any(one.label for one in lane.stretches)], run.recording.time_s

    def draw(axes: Any) -> None:
        for row, lane in enumerate(lanes):
            _lane(axes, row, lane, end)
        for moment in run.moments:
            axes.axvline(moment.frame.time_s, color="#22282e", linewidth=0.6, alpha=0.5)
        axes.set_yticks(range(len(lanes)), [lane.name for lane in lanes])
        axes.set_ylim(len(lanes) - 0.4, -0.6)
        axes.set_xlim(0.0, end)
        axes.set_xlabel("time [s]")
        axes.grid(visible=False, axis="y")

    size = (10.8, 0.6 + 0.34 * max(1, len(lanes)))
    return chart(draw, f"Timeline of {run.title}", size, _TIMELINE_MARGINS)


def _lane(axes: Any, row: int, lane: Lane, end: float) -> None:
    shown = [one for one in lane.stretches if one.label]
    plain = itertools.cycle(_PLAIN)
    axes.broken_barh(
        [(one.start_s, one.end_s - one.start_s) for one in shown],
        (row - 0.38, 0.76),
        facecolors=[next(plain) if one.level == "info" else _LEVELS[one.level] for one in shown],
    )
    for one in shown:
        if one.end_s - one.start_s > _LABEL_PART * end * len(one.label):
            axes.text(one.start_s + 0.003 * end, row, one.label, va="center", fontsize=7.5, clip_on=True)


def strips(run: Gathered, *, shown: bool) -> Iterator[Chart]:
    """Yield the strips of a run: those that the replay shows at first, or the others; those without values not."""
    for strip in run.strips:
        values = [value for curve in strip.curves for value in curve.values if value is not None]
        if strip.shown == shown and values and (strip.low != strip.high or shown):
            yield _strip(strip, run.recording.time_s)


def _strip(strip: Strip, end: float) -> Chart:
    unit, factor = axis_of(strip.quantity)

    def draw(axes: Any) -> None:
        for curve in sorted(strip.curves, key=lambda curve: curve.role == "actual"):
            values = [math.nan if value is None else value * factor for value in curve.values]
            actual = curve.role == "actual"
            axes.plot(
                curve.times_s,
                values,
                color=COLOURS[0] if actual else COLOURS[1],
                linewidth=1.1 if actual else 0.9,
                label=curve.role,
            )
        for value, colour in ((strip.limit, COLOURS[5]), (strip.caution, "#d99a1c"), (strip.warning, COLOURS[4])):
            if value is not None:
                axes.axhline(value * factor, color=colour, linewidth=0.9, linestyle="--")
        axes.set_xlim(0.0, end)
        axes.set_title(f"{strip.name} [{unit}]" if unit else strip.name, fontsize=9.5, loc="left")
        if len(strip.curves) > 1:
            axes.legend(fontsize=7.5, loc="upper right", ncols=2, borderaxespad=0.0)

    return chart(draw, strip.name, (5.4, 1.7), _STRIP_MARGINS)


def views(run: Gathered) -> Iterator[Chart]:
    """Yield the path of the tip and of the held payload from above and from the side, over the bodies at the end."""
    faces, colours = zip(*_faces(run.scenario, run.moments[-1].frame), strict=True)
    kind = needed("matplotlib.collections").PolyCollection
    for name, down, title in (("from above", 1, "y, to starboard [m]"), ("from the side", 2, "z, up [m]")):

        def draw(axes: Any, down: int = down, title: str = title) -> None:
            flat = [corners[:, [0, down]] for corners in faces]
            axes.add_collection(kind(flat, facecolors=colours, edgecolors="#b6c0c8", linewidths=0.3))
            axes.plot(run.tip[:, 0], run.tip[:, down], color=COLOURS[0], linewidth=1.1, label="tip")
            if not np.isnan(run.held).all():
                axes.plot(run.held[:, 0], run.held[:, down], color=COLOURS[1], linewidth=1.1, label="held payload")
            axes.plot(*run.tip[0, [0, down]], "o", color=COLOURS[0], markersize=4)
            axes.plot(*run.tip[-1, [0, down]], "s", color=COLOURS[0], markersize=4)
            paths = np.concatenate([run.tip, run.held[~np.isnan(run.held).any(axis=1)]])
            low, high = paths.min(axis=0) - 3.0, paths.max(axis=0) + 3.0
            axes.set_xlim(high[0], low[0])  # forward is at the right
            axes.set_ylim((high[down], low[down]) if down == 1 else (low[down], high[down]))
            axes.set_aspect("equal", adjustable="box")
            axes.set_xlabel("x, aft [m]")
            axes.set_ylabel(title)
            axes.legend(fontsize=8, loc="upper right")

        drawn = chart(draw, f"Path {name}", (5.4, 4.2), _VIEW_MARGINS)
        yield drawn._replace(caption=f"Path {name}; circle: start, square: end. Bodies at the end.")


def _faces(scenario: Scenario, frame: Frame) -> Iterator[tuple[Array, str]]:
    """Yield the corners of each face in the scene, and its colour; faces of bodies that move come last."""
    scene = VisualScene(scenario)
    poses, absent = scene.frames_at(frame), scene.absent(frame)
    bodies = [one for one in zip(scene.clusters.clusters, scene.clusters.frame.tolist(), strict=True)]
    for cluster, number in sorted(bodies, key=lambda one: one[0].frame not in _STILL):
        if cluster.part not in absent:
            corners = cluster.body.points @ poses[number, 3:].reshape(3, 3).T + poses[number, :3]
            colour = _FIXED if cluster.frame in _STILL else _MOVING
            yield from ((corners[list(loop)], colour) for loop in cluster.body.loops)
