"""Greatest difference of two frames in metres and in radians, over all lengths and angles that a frame records."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from functools import cache
from typing import Any, get_args, get_origin, get_type_hints

import msgspec
from msgspec.structs import replace

from aftdeck.recording.hints import apart as without_meta
from aftdeck.recording.hints import is_object, names, without_none
from aftdeck.recording.records import FrameRecord
from aftdeck.tuples import Rows

_Distances = tuple[float, float]
"""Greatest difference [m], and greatest difference [rad]; infinite if only one of the frames has a value."""
_Measure = Callable[[Any, Any], _Distances]
_NOTHING, _EVERYTHING = (0.0, 0.0), (math.inf, math.inf)


ROUNDING_M, ROUNDING_RAD = 1e-9, 4e-9
"""Errors of a difference because both values are rounded to nine decimals: of a length [m], and of an angle [rad].

Each component of an attitude's quaternion is rounded by at most 5e-10. The quaternion is therefore rounded by at most
1e-9, and its angle by at most 2e-9 rad.
"""


TOLERANCE_M, TOLERANCE_RAD = 0.01, 1e-3
"""Tolerance for a run with masses that another environment repeats: of a length [m], and of an angle [rad] (assumed).

MuJoCo's last digits depend on the processor and on its build. The encoders' steps turn them into 1e-4 rad, and friction
and contacts amplify them.
"""


class Apart(msgspec.Struct, frozen=True):
    """Bounds of the differences between two runs, over all recorded lengths and angles.

    The bounds include the rounding of the recorded values.
    """

    metres: float | None
    """Bound of the difference of any length or position [m]; None if only one run has a value of some field."""
    radians: float | None
    """Bound of the difference of any angle, or of the angle between two attitudes [rad]; None as for `metres`."""
    tick: int
    """Number of the first step that differs."""
    time_s: float
    """Simulated time of this step."""


def within_tolerance(found: Apart | None) -> bool:
    """Return whether two runs are nowhere further apart than the tolerance for another environment."""
    if found is None:
        return True
    if found.metres is None or found.radians is None:
        return False
    return found.metres <= TOLERANCE_M and found.radians <= TOLERANCE_RAD


def further(found: Apart | None, before: FrameRecord, after: FrameRecord) -> Apart:
    """Return `found` with the differences of two more frames of the same step."""
    lengths, angles = _of_object(FrameRecord)(before, after)
    before_now = found or Apart(0.0, 0.0, before.tick, before.time_s)
    return replace(
        before_now,
        metres=_greater(before_now.metres, lengths + ROUNDING_M),
        radians=_greater(before_now.radians, angles + ROUNDING_RAD),
    )


def _greater(found: float | None, value: float) -> float | None:
    return None if found is None or not math.isfinite(value) else max(found, value)


@cache
def _of_object(kind: type, unit: str = "") -> _Measure:
    """Return the measure of a struct or a named tuple; `unit` applies to fields that do not declare their own."""
    hints = get_type_hints(kind, include_extras=True)
    measures = [(name, own) for name in names(kind) if (own := _of(hints[name], unit)) is not None]
    return lambda a, b: _greatest(own(getattr(a, name), getattr(b, name)) for name, own in measures)


def _of(hint: Any, unit: str) -> _Measure | None:
    """Return the measure of values of a type in a unit; None if they contain no length and no angle."""
    hint, meta = without_meta(hint)
    if meta is not None and meta.extra:
        unit = meta.extra.get("unit") or unit
    if (kind := without_none(hint)) is not hint:
        inner = _of(kind, unit)
        return None if inner is None else lambda a, b: _present(inner, a, b)
    if hint == Rows:
        return _turn
    if hint is float:
        return {"m": _length, "rad": _angle}.get(unit)
    if get_origin(hint) is tuple:
        item = _of(get_args(hint)[0], unit)
        return None if item is None else lambda a, b: _items(item, a, b)
    if is_object(hint):
        return _of_object(hint, unit)
    return None


def _length(a: float, b: float) -> _Distances:
    return abs(a - b), 0.0


def _angle(a: float, b: float) -> _Distances:
    return 0.0, abs(a - b)


def _turn(a: Rows, b: Rows) -> _Distances:
    """Return the angle between two attitudes, from the distance of their matrices: |A - B| = sqrt(8) sin(angle / 2)."""
    differences = [x - y for row, other in zip(a, b, strict=True) for x, y in zip(row, other, strict=True)]
    distance = math.hypot(*differences)
    return 0.0, 2.0 * math.asin(min(distance / math.sqrt(8.0), 1.0))


def _present(inner: _Measure, a: Any, b: Any) -> _Distances:
    if a is None or b is None:
        return _NOTHING if a is b else _EVERYTHING
    return inner(a, b)


def _items(item: _Measure, a: Any, b: Any) -> _Distances:
    return _greatest(map(item, a, b)) if len(a) == len(b) else _EVERYTHING


def _greatest(found: Iterable[_Distances]) -> _Distances:
    lengths, angles = 0.0, 0.0
    for length, angle in found:
        lengths, angles = max(lengths, length), max(angles, angle)
    return lengths, angles
