"""Output of the commands: JSON, tables, summaries.

The commands print only by these functions and those of `aftdeck.lines`, because texts may come from a stranger's file.
"""

from __future__ import annotations

import math
import shutil
import sys
import textwrap
from typing import TYPE_CHECKING, Any

from aftdeck.encodable import encodable
from aftdeck.lines import print_line, visible

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from aftdeck.simulation.summary import Summary


def print_summary(s: Summary, slides: Sequence[bool]) -> None:
    """Print a run's summary as readable text; `slides`: for each joint, whether it slides."""
    from aftdeck.arms.by_joint import shown

    ended = {"completed": "completed", "time": "ended by its duration", "fault": "ENDED IN A FAULT"}[s.ended]
    print_line(f"{s.scenario}: {ended} after {s.time_s:.2f} s" + (f", in phase {s.phase!r}" if s.phase else ""))
    joints = [shown(q, slid, ".3f") for q, slid in zip(s.joints_rad, slides, strict=True)]
    if not any(slides):
        joints = [*(joint.removesuffix(" deg") for joint in joints), "deg"]
    print_line("  joints     " + "  ".join(joints))
    print_line("  tip in L   " + "  ".join(f"{x:.4f}" for x in s.tip.position_m) + "  m")
    if s.position_error_m is not None and s.rotation_error_rad is not None:
        print_line(f"  error      {s.position_error_m * 1e3:.4f} mm, {math.degrees(s.rotation_error_rad):.5f} deg")
    if s.true_position_error_m is not None and s.true_rotation_error_rad is not None:
        angle = math.degrees(s.true_rotation_error_rad)
        print_line(
            f"  true error {s.true_position_error_m * 1e3:.4f} mm, {angle:.5f} deg; the one above is by the encoders"
        )
    print_line(f"  joint rate at most {100.0 * s.worst_rate_ratio:.1f} % of its limit")
    if s.min_clearance_m is not None:
        print_line(f"  clearance  at least {100.0 * s.min_clearance_m:.1f} cm")
    for event in s.events:
        print_line(f"  {event.time_s:9.2f} s  {event.text}")
    print_line(f"  frames     sha256 {s.frames_sha256}")


def print_cautions(cautions: Iterable[str]) -> None:
    """Print the cautions of a scenario on standard error; the scenario can still be run."""
    for caution in cautions:
        print_line(f"caution: {caution}", sys.stderr)


def print_json(value: object, indent: int | None = None) -> None:
    """Print JSON in plain ASCII, which every terminal and pipe transmits unchanged."""
    import json

    import msgspec

    print(json.dumps(_encodable(msgspec.to_builtins(value)), indent=indent).replace("\x7f", "\\u007f"))


def _encodable(value: Any) -> Any:
    """Return a value of JSON in which each text can be encoded; a path may contain bytes that are not UTF-8."""
    if isinstance(value, dict):
        return {encodable(name): _encodable(item) for name, item in value.items()}
    if isinstance(value, list | tuple):
        return [_encodable(item) for item in value]
    return encodable(value) if isinstance(value, str) else value


_LEAST_ROOM = 24
"""Minimum width of a table's last column [characters]."""
_INDENT = 4
"""Indentation of a last column that is printed below its row [characters]."""


def print_table(rows: Sequence[Mapping[str, object]], columns: tuple[str, ...], as_json: bool) -> None:
    """Print rows as JSON, or as a table whose last column is wrapped between words at the terminal's width.

    If the other columns are too wide, the last column is printed below each row.
    """
    if as_json:
        print_json(rows)
        return
    cells = [columns] + [tuple(visible(str(row[column])) for column in columns) for row in rows]
    widths = [max(len(row[i]) for row in cells) for i in range(len(columns))]
    numeric = [all(isinstance(row[column], int | float) for row in rows) for column in columns]
    before = sum(widths[:-1]) + 2 * (len(columns) - 1)
    width = shutil.get_terminal_size().columns
    below = width - before < _LEAST_ROOM
    before = _INDENT if below else before
    for row in cells:
        start = "  ".join(
            f"{cell:>{width}}" if right else f"{cell:<{width}}"
            for cell, width, right in zip(row[:-1], widths, numeric, strict=False)
        )
        lines = textwrap.wrap(row[-1], max(width - before, _LEAST_ROOM)) or [""]
        if below:
            print_line(start.rstrip())
        else:
            print_line(f"{start}  {lines.pop(0)}")
        for line in lines:
            print_line(" " * before + line)
