"""Charts of a run: timeline, strips, and the path from above and from the side."""

from __future__ import annotations

import itertools
from collections.abc import Iterator

import numpy as np

from aftdeck.arrays import Array
from aftdeck.report.curves import Lane, Strip
from aftdeck.report.page.axes import Axes, Entry, Margins, Span, span_of
from aftdeck.report.page.document import COLOURS, Chart
from aftdeck.report.page.gather import Gathered
from aftdeck.report.words import axis_of
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.visual.scene import VisualScene

_LEVELS = {"caution": "#f0b840", "warning": "#d9534f"}
_PLAIN = ("#dde5eb", "#c8d3dc")
"""Colours of stretches by their level; those without an alarm have two in turn."""
_LABEL_PART = 0.006
"""Part of the timeline's width that a character of a label needs."""
_TIMELINE_MARGINS = Margins(0.75, 0.45, 0.1, 0.05)
_STRIP_MARGINS = Margins(0.5, 0.28, 0.1, 0.25)
_VIEW_MARGINS = Margins(0.6, 0.45, 0.1, 0.1)
_FIXED, _MOVING = "#eef1f3", "#d3dce3"
"""Colours of bodies that are fixed to the orbiter or to space, and of others."""
_STILL = ("orbiter", "space")


def timeline(run: Gathered) -> Chart:
    """Return the lanes of a run over time, with its key moments as lines."""
    lanes, end = [lane for lane in run.lanes if any(one.label for one in lane.stretches)], run.recording.time_s
    size = (10.8, 0.6 + 0.34 * max(1, len(lanes)))
    axes = Axes(size, _TIMELINE_MARGINS, Span(0.0, end), Span(len(lanes) - 0.4, -0.6))
    axes.number_x()
    for row, lane in enumerate(lanes):
        _lane(axes, row, lane)
    for moment in run.moments:
        axes.upright(moment.frame.time_s, "#22282e")
    axes.frame()
    for row, lane in enumerate(lanes):
        axes.name_y(float(axes.down(row)), lane.name)
        for one in lane.stretches:
            if one.end_s - one.start_s > _LABEL_PART * end * len(one.label) > 0.0:
                axes.label(one.start_s + 0.003 * end, float(axes.down(row)), one.label, 7.5)
    axes.title_x("time [s]")
    return axes.chart(f"Timeline of {run.title}")


def _lane(axes: Axes, row: int, lane: Lane) -> None:
    plain = itertools.cycle(_PLAIN)
    for one in lane.stretches:
        if one.label:
            x, y = (one.start_s, one.end_s), (row - 0.38, row + 0.38)
            corners = np.array([(x[0], y[0]), (x[1], y[0]), (x[1], y[1]), (x[0], y[1])])
            axes.area(corners, next(plain) if one.level == "info" else _LEVELS[one.level])


def strips(run: Gathered, *, shown: bool) -> Iterator[Chart]:
    """Yield the strips of a run: those that the replay shows at first, or the others; those without values not."""
    for strip in run.strips:
        values = [value for curve in strip.curves for value in curve.values if value is not None]
        if strip.shown == shown and values and (strip.low != strip.high or shown):
            yield _strip(strip, run.recording.time_s)


def _strip(strip: Strip, end: float) -> Chart:
    unit, factor = axis_of(strip.quantity)
    curves = [(curve, np.array(curve.values, dtype=float) * factor) for curve in strip.curves]
    bounds = ((strip.limit, COLOURS[5]), (strip.caution, "#d99a1c"), (strip.warning, COLOURS[4]))
    levels = [(value * factor, colour) for value, colour in bounds if value is not None]
    known = [float(end(values)) for _, values in curves if len(values) for end in (np.nanmin, np.nanmax)]
    axes = Axes((5.4, 1.7), _STRIP_MARGINS, Span(0.0, end), _range(known, [value for value, _ in levels]))
    axes.number_x()
    power = axes.number_y()
    entries = []
    for curve, values in sorted(curves, key=lambda one: one[0].role == "actual"):
        actual = curve.role == "actual"
        entries.append(Entry(curve.role, COLOURS[0] if actual else COLOURS[1], 1.1 if actual else 0.9))
        if len(values):
            axes.line(np.array(curve.times_s), values, entries[-1].colour, entries[-1].width)
    for value, colour in levels:
        axes.level(value, colour)
    axes.frame()
    unit = " ".join(filter(None, (power, unit)))
    axes.title(f"{strip.name} [{unit}]" if unit else strip.name)
    if len(entries) > 1:
        axes.legend(entries, 7.5, side_by_side=True, margin=0.0)
    return axes.chart(strip.name)


def _range(known: list[float], levels: list[float]) -> Span:
    """Return the range of a strip's values; a level counts only if it is outside."""
    found = span_of(known)
    for level in levels:
        known.append(level)
        if not found.first <= level <= found.last:
            found = span_of(known)
    return found


def views(run: Gathered) -> Iterator[Chart]:
    """Yield the path of the tip and of the held payload from above and from the side, over the bodies at the end."""
    faces = list(_faces(run.scenario, run.moments[-1].frame))
    held = run.held[~np.isnan(run.held).any(axis=1)]
    paths = np.concatenate([run.tip, held])
    low, high = paths.min(axis=0) - 3.0, paths.max(axis=0) + 3.0
    for name, down, title in (("from above", 1, "y, to starboard [m]"), ("from the side", 2, "z, up [m]")):
        x = Span(high[0], low[0])  # forward is at the right
        y = Span(high[down], low[down]) if down == 1 else Span(low[down], high[down])
        axes = Axes((5.4, 4.2), _VIEW_MARGINS, x, y, equal=True)
        axes.number_x()
        axes.number_y()
        for corners, colour in faces:
            axes.area(corners[:, [0, down]], colour, "#b6c0c8")
        entries = [Entry("tip", COLOURS[0], 1.1)]
        axes.line(run.tip[:, 0], run.tip[:, down], COLOURS[0], 1.1)
        if len(held):
            axes.line(run.held[:, 0], run.held[:, down], COLOURS[1], 1.1)
            entries.append(Entry("held payload", COLOURS[1], 1.1))
        axes.circle(run.tip[0, 0], run.tip[0, down], COLOURS[0])
        axes.square(run.tip[-1, 0], run.tip[-1, down], COLOURS[0])
        axes.frame()
        axes.title_x("x, aft [m]")
        axes.title_y(title)
        axes.legend(entries, 8.0, side_by_side=False, margin=0.5)
        caption = f"Path {name}; circle: start, square: end. Bodies at the end."
        yield axes.chart(f"Path {name}", caption)


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
