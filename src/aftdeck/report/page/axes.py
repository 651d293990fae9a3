"""Axes of a chart, into which lines, areas and texts are drawn, as SVG.

Lengths are in points, as the chart's size. The page scales a chart to the width of its column.
"""

from __future__ import annotations

import html
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.report.page.document import Chart
from aftdeck.report.page.ticks import ticks

INCH = 72.0
"""An inch [pt]."""
_FONTS = "'DejaVu Sans', 'Bitstream Vera Sans', 'Lucida Grande', Verdana, Geneva, Arial, Helvetica, sans-serif"
_FRAME, _GRID, _TICKS, _INK = "#8a929a", "#e3e7ea", "#4a525a", "#22282e"
"""Colours of the axes' lines, of the grid, of ticks with their numbers, and of titles."""
_FONT, _TICK, _GAP = 9.0, 3.5, 3.5
"""Size of the font, length of a tick, and gap between a tick and its number."""
_RISE, _BELOW = 0.38, 0.76
"""Baseline of a text in the middle of its height, and of one below a point, as parts of its size."""
_ROOM_X, _ROOM_Y = 3.0 * _FONT, 2.0 * _FONT
"""Room that a number needs along each axis."""
_TITLE = 6.0
"""Distance of a title's baseline from the axes [pt]."""
_MARGIN = 0.05
"""Part of the range of the values that an axis is longer at each end."""
_EM = 0.62
"""Mean width of a character, as a part of the font's size."""


class Margins(NamedTuple):
    """Space for texts around the axes [in]."""

    left: float
    bottom: float
    right: float
    top: float


class Span(NamedTuple):
    """Range of an axis; `first` is at the left or at the bottom, and may be the greater value."""

    first: float
    last: float


class Entry(NamedTuple):
    """Line in a legend.

    Attributes:
        text: what the line shows.
        colour: its colour.
        width: its width.
    """

    text: str
    colour: str
    width: float


def span_of(values: Sequence[float]) -> Span:
    """Return the range of an axis that shows these values, with a margin."""
    low, high = min(values), max(values)
    if high - low <= 1e-12 * max(abs(low), abs(high)):
        low, high = (low - _MARGIN * abs(low), high + _MARGIN * abs(high)) if low else (-_MARGIN, _MARGIN)
    margin = _MARGIN * (high - low)
    return Span(low - margin, high + margin)


class Axes:
    """Axes of a chart. What is drawn later covers what was drawn before."""

    def __init__(self, size: tuple[float, float], margins: Margins, x: Span, y: Span, *, equal: bool = False) -> None:
        """Make empty axes.

        Args:
            size: width and height of the chart [in].
            margins: space around the axes.
            x: range of the horizontal axis.
            y: range of the vertical axis.
            equal: whether both axes have the same scale; the axes are then in the middle of their space.
        """
        self._size = wide, high = size[0] * INCH, size[1] * INCH
        left, right = margins.left * INCH, wide - margins.right * INCH
        top, bottom = margins.top * INCH, high - margins.bottom * INCH
        if equal:
            scale = min((right - left) / abs(x.last - x.first), (bottom - top) / abs(y.last - y.first))
            out_x = 0.5 * (right - left - scale * abs(x.last - x.first))
            out_y = 0.5 * (bottom - top - scale * abs(y.last - y.first))
            left, right, top, bottom = left + out_x, right - out_x, top + out_y, bottom - out_y
        self.left, self.right, self.top, self.bottom = left, right, top, bottom
        self._x, self._y = x, y
        self._clip = "clip-" + "-".join(f"{edge:g}" for edge in (left, top, right, bottom))
        self._parts: list[str] = []

    def across(self, values: Array | float) -> Array:
        """Return the horizontal places of values [pt]."""
        return self.left + (np.asarray(values) - self._x.first) * (
            (self.right - self.left) / (self._x.last - self._x.first)
        )

    def down(self, values: Array | float) -> Array:
        """Return the vertical places of values, downwards [pt]."""
        return self.bottom - (np.asarray(values) - self._y.first) * (
            (self.bottom - self.top) / (self._y.last - self._y.first)
        )

    def number_x(self) -> str:
        """Draw grid lines and numbers of the horizontal axis; return their power of ten (`Ticks.power`)."""
        found = ticks(min(self._x), max(self._x), (self.right - self.left) / _ROOM_X)
        for x, text in zip(self.across(np.array(found.values)).tolist(), found.texts, strict=True):
            self._draw(f"M{x:.2f} {self.bottom:.2f}V{self.top:.2f}", f'stroke="{_GRID}"')
            self._draw(f"M{x:.2f} {self.bottom:.2f}v{_TICK}", f'stroke="{_TICKS}"')
            self._write(x, self.bottom + _TICK + _GAP + _BELOW * _FONT, text, "middle", _TICKS)
        return found.power

    def number_y(self) -> str:
        """Draw grid lines and numbers of the vertical axis; return their power of ten (`Ticks.power`)."""
        found = ticks(min(self._y), max(self._y), (self.bottom - self.top) / _ROOM_Y)
        for y, text in zip(self.down(np.array(found.values)).tolist(), found.texts, strict=True):
            self._draw(f"M{self.left:.2f} {y:.2f}H{self.right:.2f}", f'stroke="{_GRID}"')
            self.name_y(y, text)
        return found.power

    def name_y(self, y: float, text: str) -> None:
        """Draw a tick and a text at the vertical axis, at a place [pt]."""
        self._draw(f"M{self.left:.2f} {y:.2f}h-{_TICK}", f'stroke="{_TICKS}"')
        self._write(self.left - _TICK - _GAP, y + _RISE * _FONT, text, "end", _TICKS)

    def frame(self) -> None:
        """Draw the lines of both axes."""
        path = f"M{self.left:.2f} {self.top:.2f}V{self.bottom:.2f}H{self.right:.2f}"
        self._draw(path, f'stroke="{_FRAME}" stroke-linejoin="miter"')

    def title(self, text: str) -> None:
        """Write a title above the axes."""
        self._write(self.left, self.top - _TITLE, text, "start", "#000", 9.5)

    def title_x(self, text: str) -> None:
        """Write what the horizontal axis shows."""
        self._write(0.5 * (self.left + self.right), self.bottom + 26.84, text, "middle", _INK)

    def title_y(self, text: str) -> None:
        """Write what the vertical axis shows, upwards."""
        x, y = self.left - 26.4, 0.5 * (self.top + self.bottom)
        self._write(x, y, text, "middle", _INK, more=f' transform="rotate(-90 {x:.2f} {y:.2f})"')

    def line(self, x: Array, y: Array, colour: str, width: float) -> None:
        """Draw a line; NaN interrupts it."""
        points = np.column_stack([self.across(x), self.down(y)])
        gaps = np.isnan(points.sum(axis=1))
        pieces = np.split(points, np.flatnonzero(np.diff(gaps)) + 1)[bool(gaps[0]) :: 2]
        path = "".join(f"M{_points(piece)}" for piece in pieces)
        self._draw(path, f'stroke="{colour}" stroke-width="{width}" stroke-linecap="square"', clipped=True)

    def level(self, y: float, colour: str) -> None:
        """Draw a dashed line across the axes."""
        path = f"M{self.left:.2f} {float(self.down(y)):.2f}H{self.right:.2f}"
        self._draw(path, f'stroke="{colour}" stroke-width="0.9" stroke-dasharray="3.33 1.44"', clipped=True)

    def upright(self, x: float, colour: str) -> None:
        """Draw a thin line from the bottom to the top of the axes."""
        path = f"M{float(self.across(x)):.2f} {self.bottom:.2f}V{self.top:.2f}"
        self._draw(path, f'stroke="{colour}" stroke-width="0.6" stroke-opacity="0.5"', clipped=True)

    def area(self, corners: Array, fill: str, edge: str = "") -> None:
        """Fill a polygon with these corners (n, 2); `edge` is the colour of its thin outline, empty for none."""
        path = f"M{_points(np.column_stack([self.across(corners[:, 0]), self.down(corners[:, 1])]))}z"
        outline = f' stroke="{edge}" stroke-width="0.3"' if edge else ' stroke="none"'
        self._draw(path, f'fill="{fill}"{outline}', clipped=True)

    def circle(self, x: float, y: float, colour: str) -> None:
        """Draw a small filled circle."""
        place = f'cx="{float(self.across(x)):.2f}" cy="{float(self.down(y)):.2f}"'
        self._parts.append(f'<circle {place} r="2.5" fill="{colour}" stroke="none"/>')

    def square(self, x: float, y: float, colour: str) -> None:
        """Draw a small filled square."""
        place = f'x="{float(self.across(x)) - 2.5:.2f}" y="{float(self.down(y)) - 2.5:.2f}"'
        self._parts.append(f'<rect {place} width="5" height="5" fill="{colour}" stroke="none"/>')

    def label(self, x: float, y: float, text: str, size: float) -> None:
        """Write a text that begins at a value of the horizontal axis, in the middle of its height [pt]."""
        self._write(float(self.across(x)), y + 0.26 * size, text, "start", "#000", size)

    def legend(self, entries: Sequence[Entry], size: float, *, side_by_side: bool, margin: float) -> None:
        """Draw a legend: side by side in the title's row, or below each other in the axes' upper right corner.

        Args:
            entries: the lines that it names.
            size: size of the font [pt].
            side_by_side: whether the entries stand in the title's row, where no line crosses them.
            margin: distance from the corner, in sizes of the font.
        """
        widths = [_EM * size * len(entry.text) for entry in entries]
        right = self.right - (margin + 0.4) * size
        for k, entry in enumerate(entries):
            if side_by_side:
                x, y = right - sum(widths[k:]) - 4.8 * size * (len(entries) - k - 1), self.top - _TITLE - 0.35 * size
            else:
                x, y = right - max(widths), self.top + (margin + 0.81 + 1.5 * k) * size
            line = f'stroke="{entry.colour}" stroke-width="{entry.width}"'
            self._draw(f"M{x - 2.8 * size:.2f} {y:.2f}h{2.0 * size:.2f}", line)
            self._write(x, y + 0.35 * size, entry.text, "start", "#000", size)

    def chart(self, what: str, caption: str = "") -> Chart:
        """Return the chart; `what` says what it shows, for a reader who cannot see it."""
        wide, high = self._size
        area = f'x="{self.left:.2f}" y="{self.top:.2f}" width="{self.right - self.left:.2f}"'
        clip = f'<clipPath id="{self._clip}"><rect {area} height="{self.bottom - self.top:.2f}"/></clipPath>'
        body = "\n".join(self._parts)
        head = f'width="{wide:.2f}pt" height="{high:.2f}pt" viewBox="0 0 {wide:.2f} {high:.2f}"'
        style = f'fill="none" stroke-width="0.8" font-size="{_FONT}" font-family="{_FONTS}"'
        return Chart(f"{head} {style}>\n{clip}\n{body}\n</svg>", what, caption)

    def _draw(self, path: str, style: str, *, clipped: bool = False) -> None:
        clip = f' clip-path="url(#{self._clip})"' if clipped else ""
        self._parts.append(f'<path {style}{clip} d="{path}"/>')

    def _write(
        self, x: float, y: float, text: str, anchor: str, colour: str, size: float = _FONT, more: str = ""
    ) -> None:
        font = "" if size == _FONT else f' font-size="{size}"'
        place = f'x="{x:.2f}" y="{y:.2f}" text-anchor="{anchor}" fill="{colour}"'
        self._parts.append(f"<text {place}{font}{more}>{html.escape(text)}</text>")


def _points(points: Array) -> str:
    """Return places (n, 2) as the points of a path; what is less than a hundredth of a point away is left out."""
    rounded = np.rint(points * 100.0)
    kept = np.ones(len(rounded), dtype=bool)
    kept[1:] = (rounded[1:] != rounded[:-1]).any(axis=1)
    return " ".join([f"{x:g} {y:g}" for x, y in (rounded[kept] / 100.0).tolist()])
