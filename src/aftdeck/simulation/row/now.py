"""Row of the state: its arrays that compiled code changes, as parts of three flat arrays."""

from __future__ import annotations

from typing import NamedTuple

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.bodies.pair import PAIR
from aftdeck.bodies.pose import POSE
from aftdeck.flat import block, line, table_of
from aftdeck.kinematics.observe import SEEN
from aftdeck.law import law
from aftdeck.simulation.row.scalars import FLOATING, SCALARS
from aftdeck.steering.layout import COMMAND, REPORT, STATE
from aftdeck.worksite.watch.found import FOUND
from aftdeck.worksite.watch.groups import SOLID, Layout


class Motion(NamedTuple):
    """Joints, bodies, frames and steering; each has the name of the state's array that it is."""

    scalars: Array
    angles: Array
    rates: Array
    commanded: Array
    base: Array
    orbiter: Array
    orbiter_velocity: Array
    poses_in_carrier: Array
    frames: Array
    before: Array
    flights: Array
    steering: Array
    command: Array
    report: Array
    observed: Array
    carrier: Indices


class Watch(NamedTuple):
    """Clearances and contacts; each has the name of the array of `ClearanceMonitor` or `Contacts` that it is.

    `frames_touching` is `Contacts.count`.
    """

    at: Array
    placed: Array
    bound: Array
    memory: Array
    found: Array
    likely: Indices
    near: Mask
    active: Mask
    counts: Mask
    monitored_before: Mask
    frames_touching: Mask
    essential: Mask
    arm: Mask
    permitted: Mask


NUMBERS = (
    "scalars", "angles", "rates", "commanded", "base", "orbiter", "orbiter_velocity", "poses_in_carrier", "frames",
    "before", "flights", "steering", "command", "report", "observed", "at", "placed", "bound", "memory", "found",
)  # fmt: skip
"""Parts of the row's float64, in their order."""
INDICES = ("carrier", "likely")
"""Parts of its int64."""
MARKS = ("near", "active", "counts", "monitored_before", "frames_touching", "essential", "arm", "permitted")
"""Parts of its uint8."""


class Tables(NamedTuple):
    """Tables of the row's flat arrays."""

    numbers: Indices
    indices: Indices
    marks: Indices


def tables_of(layout: Layout, joints: int, singularities: int, payloads: int) -> Tables:
    """Return the tables of the rows of runs with these solids, and these numbers of joints and others."""
    frames, groups = (len(layout.frames), POSE), (len(layout.groups),)
    shapes = {
        "scalars": (SCALARS,), "angles": (joints,), "rates": (joints,), "commanded": (joints,), "base": (POSE,),
        "orbiter": (3,), "orbiter_velocity": (3,), "poses_in_carrier": (payloads, POSE), "frames": frames,
        "before": frames, "flights": (payloads, FLOATING), "steering": (STATE,), "command": (COMMAND,),
        "report": (REPORT,), "observed": (SEEN + singularities,), "at": frames,
        "placed": (len(layout.solids), SOLID), "bound": groups, "memory": (len(layout.pairs), PAIR),
        "found": (*groups, FOUND), "carrier": (payloads,), "likely": groups,
    }  # fmt: skip
    return Tables(*(table_of(shapes.get(name, groups) for name in names) for names in (NUMBERS, INDICES, MARKS)))


@law
def motion_of(numbers: Array, indices: Indices, tables: Tables) -> Motion:
    """Return the joints, bodies and frames of a row."""
    own = tables.numbers
    return Motion(
        line(numbers, own, 0), line(numbers, own, 1), line(numbers, own, 2), line(numbers, own, 3),
        line(numbers, own, 4), line(numbers, own, 5), line(numbers, own, 6), block(numbers, own, 7),
        block(numbers, own, 8), block(numbers, own, 9), block(numbers, own, 10), line(numbers, own, 11),
        line(numbers, own, 12), line(numbers, own, 13), line(numbers, own, 14), line(indices, tables.indices, 0),
    )  # fmt: skip


@law
def watch_of(numbers: Array, indices: Indices, marks: Mask, tables: Tables) -> Watch:
    """Return the clearances and contacts of a row."""
    own, flags = tables.numbers, tables.marks
    return Watch(
        block(numbers, own, 15), block(numbers, own, 16), line(numbers, own, 17), block(numbers, own, 18),
        block(numbers, own, 19), line(indices, tables.indices, 1), line(marks, flags, 0), line(marks, flags, 1),
        line(marks, flags, 2), line(marks, flags, 3), line(marks, flags, 4), line(marks, flags, 5),
        line(marks, flags, 6), line(marks, flags, 7),
    )  # fmt: skip
