"""Charts of a study's report."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from aftdeck.report.catalogue import METRICS
from aftdeck.report.intervals import Interval, mean_interval
from aftdeck.report.page.document import COLOURS, Chart
from aftdeck.report.table import Row
from aftdeck.simulation.readings.quantity import UNITS
from aftdeck.study.charts import chart
from aftdeck.study.factor import Factor
from aftdeck.study.statistics import Group, groups, numbers, success_rate

_LONG = 12
"""Length of a label above which labels are written in a slope [characters]."""
_MOST_TICKS = 8
"""Greatest number of levels that are all written on the axis."""
_FLAT = 1e-3
"""Range of an axis, as a share of its values, below which the differences are not worth a picture."""
_MOST_LINES = 8
"""Greatest number of lines in one chart."""


def title_of(column: str) -> str:
    """Return the name of a result for people, with its unit."""
    metric = next((metric for metric in METRICS if metric.column == column), None)
    if metric is None:
        return {"final_error_m": "Final error [m]", "final_angle_rad": "Final angle [rad]"}.get(column, column)
    unit = UNITS[metric.quantity]
    return f"{metric.title} [{unit}]" if unit else metric.title


def response_chart(factor: Factor, rows: Sequence[Row], column: str, by: Factor | None = None) -> Chart:
    """Return a chart of a response against a factor: means with intervals, and the cases if the values are drawn.

    Args:
        factor: factor on the axis.
        rows: cases without an error.
        column: the response.
        by: factor with one line for each of its levels; None: one line for all cases.
    """
    lines = [("", rows)] if by is None else [(group.label, group.rows) for group in groups(by, rows)][:_MOST_LINES]

    def draw(axes: Any) -> None:
        present = groups(factor, rows)
        order = [group.label for group in present]
        for number, (label, own) in enumerate(lines):
            colour = COLOURS[number % len(COLOURS)]
            if factor.span is not None:
                shown = [row for row in own if row[column] is not None]
                axes.plot(
                    [row[factor.column] for row in shown],
                    [row[column] for row in shown],
                    ".",
                    color=colour,
                    alpha=0.35,
                    markersize=4,
                )
            found = [
                (group, mean_interval(values))
                for group in groups(factor, own)
                if (values := numbers(group.rows, column))
            ]
            _bars(axes, found, order, colour, label, (number - (len(lines) - 1) / 2.0) * 0.08)
        axes.set_ylabel(title_of(column))
        axes.ticklabel_format(axis="y", useOffset=False)
        _not_flat(axes)
        _finish(axes, factor, present, legend=by.name if by is not None else "")

    what = f"{title_of(column)} against {factor.name}" + (f" by {by.name}" if by is not None else "")
    return chart(draw, what)


def success_chart(factor: Factor, rows: Sequence[Row]) -> Chart:
    """Return a chart of the success rate against a factor, with Wilson's intervals; errors count as failures."""

    def draw(axes: Any) -> None:
        found = [(group, success_rate(group.rows)) for group in groups(factor, rows)]
        order = [group.label for group, _ in found]
        _bars(axes, found, order, COLOURS[2], "", 0.0)
        axes.set_ylim(-0.04, 1.04)
        axes.set_yticks([0.0, 0.25, 0.5, 0.75, 1.0], ["0 %", "25 %", "50 %", "75 %", "100 %"])
        axes.set_ylabel("Success rate")
        _finish(axes, factor, [group for group, _ in found])

    return chart(draw, f"Success rate against {factor.name}")


def _bars(
    axes: Any,
    found: Sequence[tuple[Group, Interval]],
    order: Sequence[str],
    colour: str,
    label: str,
    shift: float,
) -> None:
    """Draw means with intervals; a line joins them if the factor has numbers."""
    numeric = all(group.at is not None for group, _ in found)
    at = [group.at if numeric else order.index(group.label) + shift for group, _ in found]
    values = [interval.value for _, interval in found]
    below = [max(0.0, interval.value - interval.low) for _, interval in found]
    above = [max(0.0, interval.high - interval.value) for _, interval in found]
    style = "o-" if numeric else "o"
    axes.errorbar(
        at, values, (below, above), fmt=style, color=colour, markersize=5, linewidth=1.4, capsize=3, label=label
    )


def _finish(axes: Any, factor: Factor, present: Sequence[Group], legend: str = "") -> None:
    """Label the factor's axis: the levels that have a case, or the usual ticks."""
    unit = factor.span.unit if factor.span is not None else ""
    axes.set_xlabel(f"{factor.column}" + (f" [{unit}]" if unit and unit not in factor.column else ""))
    if factor.span is not None and factor.span.log:
        axes.set_xscale("log")
    order, at = [group.label for group in present], [group.at for group in present]
    if factor.levels and None in at:
        slope = max(map(len, order)) > _LONG or len(order) > _MOST_LINES
        axes.set_xticks(range(len(order)), order, rotation=30 if slope else 0, ha="right" if slope else "center")
        axes.set_xlim(-0.5, len(order) - 0.5)
    elif factor.levels and len(order) <= _MOST_TICKS:
        axes.set_xticks(at, order)
    if legend:
        axes.legend(title=legend, fontsize=8, title_fontsize=8, loc="upper left", bbox_to_anchor=(1.01, 1.0))


def _not_flat(axes: Any) -> None:
    """Widen an axis that would magnify differences of no importance."""
    low, high = axes.get_ylim()
    middle = (low + high) / 2.0
    least = _FLAT * abs(middle)
    if high - low < least:
        axes.set_ylim(middle - 20.0 * least, middle + 20.0 * least)
