"""Conversion of recorded inputs to another control period."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import msgspec

from aftdeck.recording.records import Input

_SWITCHES = tuple(
    field.name for field in msgspec.structs.fields(Input) if field.default is None and field.name != "camera"
)
"""Fields that are None in every step that does not set them: switches, keyed-in targets, angles of the master arm.

`camera` is left out: a camera drive acts as long as it is deflected, as a stick does.
"""
SAME_TIME = 1e-9
"""Times that differ by less than this value count as equal [s]."""


def resampled(inputs: Iterator[Input], old: float, new: float) -> Iterator[Input]:
    """Yield the inputs of each step at the new control period.

    An old step belongs to the first new step that ends after the old step begins. A new step has the latest stick
    deflections of its old steps, and every switch that was set in them. Together the new steps last at least as long as
    the old steps.

    Args:
        inputs: inputs of every step at the old control period.
        old: old control period [s].
        new: new control period [s].
    """
    record = next(inputs, None)
    last = Input(tick=0)
    tick = 0
    while record is not None or (tick * new < last.tick * old - SAME_TIME):
        tick += 1
        since: list[Input] = []
        while record is not None and (record.tick - 1) * old < tick * new - SAME_TIME:
            since.append(record)
            record = next(inputs, None)
        step_inputs = merged(since, last, tick)
        last = since[-1] if since else last
        yield step_inputs


def merged(since: Sequence[Input], before: Input, tick: int) -> Input:
    """Return the inputs of one new step, merged from `since`: the inputs since the previous new step.

    If `since` is empty, the sticks stay as in `before`, and no switch is set.
    """
    if len(since) == 1:
        return msgspec.structs.replace(since[0], tick=tick)
    latest = since[-1] if since else before
    changes: dict[str, object] = {
        name: next((value for record in reversed(since) if (value := getattr(record, name)) is not None), None)
        for name in _SWITCHES
    }
    stopped = max((i for i, record in enumerate(since) if record.stop), default=0)
    changes["stop"] = any(record.stop for record in since)
    changes["proceed"] = any(record.proceed for record in since[stopped:])  # STOP acts before PROCEED in a step
    changes["changes"] = {key: value for record in since for key, value in record.changes.items()}
    changes["rate_hold"] = sum(record.rate_hold for record in since) % 2 == 1
    return msgspec.structs.replace(latest, tick=tick, **changes)
