"""Row of the state: its arrays that compiled code changes, as parts of three flat arrays."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.bodies.pair import PAIR
from aftdeck.bodies.pose import POSE
from aftdeck.flat import block, line, table_of
from aftdeck.kinematics.observe import SEEN
from aftdeck.law import law
from aftdeck.lent import lend, lend_block
from aftdeck.simulation.row.scalars import FLOATING, SCALARS
from aftdeck.steering.layout import COMMAND, REPORT, STATE
from aftdeck.worksite.capture.snare import SNARE
from aftdeck.worksite.watch.found import FOUND
from aftdeck.worksite.watch.groups import SOLID, Layout
from aftdeck.worksite.watch.measured import Measured


class Flat(NamedTuple):
    """Constants of a run and a row of its state, as compiled code takes them: flat arrays.

    Attributes:
        fixed_numbers: constants of the run (`world.Packed`): float64.
        fixed_indices: int64.
        fixed_marks: uint8.
        numbers: the state's row (`row.Row`): float64.
        indices: int64.
        marks: uint8.
    """

    fixed_numbers: Array
    fixed_indices: Indices
    fixed_marks: Mask
    numbers: Array
    indices: Indices
    marks: Mask


Arrays = tuple[Array, Indices, Mask, Array, Indices, Mask]
"""The arrays of a `Flat`, as Python passes them to a law: a call with a named tuple takes a microsecond more."""


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
    snare: Array
    carrier: Indices


class Watch(NamedTuple):
    """Clearances and contacts; each has the name that its array has in `Measured`, `ClearanceMonitor` or `Contacts`.

    `frames_touching` is `Contacts.count`.
    """

    at: Array
    placed: Array
    bound: Array
    moved: Array
    moved_then: Array
    beyond: Array
    pair_bound: Array
    memory: Array
    found: Array
    likely: Indices
    moves: Indices
    placed_after: Indices
    listed: Indices
    near: Mask
    reviewed: Mask
    active: Mask
    counts: Mask
    monitored_before: Mask
    frames_touching: Mask
    essential: Mask
    arm: Mask
    permitted: Mask


class Limits(NamedTuple):
    """Limits of the joints and singularities of a step; n joints, s singularities.

    A *cause* is a singularity that is near, or a joint past a limit: all singularities, then all joints.

    Attributes:
        zones: (n,) zone of each joint (`simulation.frame`).
        singular: (s,) 1 for singularities that are near.
        advice: (s + n,) stick direction that was shown last for each cause; -1 for none.
        ways: (s + n, 3) way out of each cause (`period.ways`).
    """

    zones: Indices
    singular: Indices
    advice: Indices
    ways: Indices


NUMBERS = (
    "scalars", "angles", "rates", "commanded", "base", "orbiter", "orbiter_velocity", "poses_in_carrier", "frames",
    "before", "flights", "steering", "command", "report", "observed", "at", "placed", "bound", "moved", "moved_then",
    "beyond", "pair_bound", "memory", "found", "snare",
)  # fmt: skip
"""Parts of the row's float64, in their order."""
INDICES = ("carrier", "likely", "moves", "placed_after", "listed", "zones", "singular", "advice", "ways")
"""Parts of its int64."""
MARKS = (
    "near", "reviewed", "active", "counts", "monitored_before", "frames_touching", "essential", "arm", "permitted",
)  # fmt: skip
"""Parts of its uint8."""


FIXED, ROW, TABLES = 0, 3, 6
"""Number of the first table of the constants and of the row, and the number of tables: of float64, int64 and uint8."""


class Tables(NamedTuple):
    """Tables of the row's flat arrays."""

    numbers: Indices
    indices: Indices
    marks: Indices


@lru_cache(maxsize=8)
def tables_of(layout: Layout, joints: int, singularities: int, payloads: int) -> Tables:
    """Return the tables of the rows of runs with these solids, and these numbers of joints and others."""
    frames, groups = (len(layout.frames), POSE), (len(layout.groups),)
    shapes = {
        "scalars": (SCALARS,), "angles": (joints,), "rates": (joints,), "commanded": (joints,), "base": (POSE,),
        "orbiter": (3,), "orbiter_velocity": (3,), "poses_in_carrier": (payloads, POSE), "frames": frames,
        "before": frames, "flights": (payloads, FLOATING), "steering": (STATE,), "command": (COMMAND,),
        "report": (REPORT,), "observed": (SEEN + singularities,), "at": frames,
        "placed": (len(layout.solids), SOLID), "bound": groups, "moved": (len(layout.frames),),
        "moved_then": (len(layout.frames),), "beyond": (3,), "pair_bound": (len(layout.pairs),),
        "memory": (len(layout.pairs), PAIR), "found": (*groups, FOUND), "snare": (SNARE,), "carrier": (payloads,),
        "likely": groups, "moves": (len(layout.frames),), "placed_after": (len(layout.solids),),
        "listed": (len(layout.groups) + 1,), "reviewed": (2 * len(layout.groups),),
        "zones": (joints,), "singular": (singularities,), "advice": (singularities + joints,),
        "ways": (singularities + joints, 3),
    }  # fmt: skip
    return Tables(*(table_of(shapes.get(name, groups) for name in names) for names in (NUMBERS, INDICES, MARKS)))


@law
def lent(arrays: Arrays) -> Flat:
    """Return the flat arrays without counts of references: they have to live until the calling law returns."""
    a, b, c, d, e, f = arrays
    return Flat(lend(a), lend(b), lend(c), lend(d), lend(e), lend(f))


@law
def table(fixed_indices: Indices, which: int) -> Indices:
    """Return one of the tables in the constants' indices, which begin with the tables' places (`world.packed`)."""
    begin = fixed_indices[which]
    return lend_block(fixed_indices, begin, (fixed_indices[which + 1] - begin) // 3, 3)


@law
def motion_of(flat: Flat) -> Motion:
    """Return the joints, bodies and frames of a row."""
    numbers, own, whole = flat.numbers, table(flat.fixed_indices, ROW), table(flat.fixed_indices, ROW + 1)
    return Motion(
        line(numbers, own, 0), line(numbers, own, 1), line(numbers, own, 2), line(numbers, own, 3),
        line(numbers, own, 4), line(numbers, own, 5), line(numbers, own, 6), block(numbers, own, 7),
        block(numbers, own, 8), block(numbers, own, 9), block(numbers, own, 10), line(numbers, own, 11),
        line(numbers, own, 12), line(numbers, own, 13), line(numbers, own, 14), line(numbers, own, 24),
        line(flat.indices, whole, 0),
    )  # fmt: skip


@law
def watch_of(flat: Flat) -> Watch:
    """Return the clearances and contacts of a row."""
    numbers, own, whole = flat.numbers, table(flat.fixed_indices, ROW), table(flat.fixed_indices, ROW + 1)
    marks, flags = flat.marks, table(flat.fixed_indices, ROW + 2)
    return Watch(
        block(numbers, own, 15), block(numbers, own, 16), line(numbers, own, 17), line(numbers, own, 18),
        line(numbers, own, 19), line(numbers, own, 20), line(numbers, own, 21), block(numbers, own, 22),
        block(numbers, own, 23), line(flat.indices, whole, 1), line(flat.indices, whole, 2),
        line(flat.indices, whole, 3), line(flat.indices, whole, 4), line(marks, flags, 0), line(marks, flags, 1),
        line(marks, flags, 2), line(marks, flags, 3), line(marks, flags, 4), line(marks, flags, 5),
        line(marks, flags, 6), line(marks, flags, 7), line(marks, flags, 8),
    )  # fmt: skip


@law
def monitor_of(watch: Watch) -> Measured:
    """Return the arrays of the clearance monitor."""
    return Measured(
        watch.at, watch.placed, watch.bound, watch.moved, watch.moved_then, watch.beyond, watch.pair_bound,
        watch.memory, watch.found, watch.likely, watch.moves, watch.placed_after, watch.listed, watch.near,
        watch.reviewed,
    )  # fmt: skip


@law
def limits_of(flat: Flat) -> Limits:
    """Return the limits of a row."""
    indices, whole = flat.indices, table(flat.fixed_indices, ROW + 1)
    return Limits(line(indices, whole, 5), line(indices, whole, 6), line(indices, whole, 7), block(indices, whole, 8))
