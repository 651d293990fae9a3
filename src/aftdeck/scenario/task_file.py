"""Types of the steps of the operator's task in a scenario file (`[[step]]`)."""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from aftdeck.arms.constant import Text
from aftdeck.bounds import Bounds
from aftdeck.units import Angle, Length

Use = Literal[
    "-X",
    "+X",
    "-Y",
    "+Y",
    "-Z",
    "+Z",
    "-roll",
    "+roll",
    "-pitch",
    "+pitch",
    "-yaw",
    "+yaw",
    "-telescope",
    "+telescope",
    "-pan",
    "+pan",
    "-tilt",
    "+tilt",
    "-zoom",
    "+zoom",
    "stop",
    "rate",
    "rate hold",
    "pulse",
    "close",
    "open",
    "latch",
    "brakes",
    "safing",
    "position hold",
    "mode -",
    "mode +",
    "enter",
    "proceed",
    "joint -",
    "joint +",
    "fly orbiter",
    "acknowledge",
    "announce",
    "plane",
    "bending",
    "otherMonitor",
    "cameraStep -",
    "cameraStep +",
    "split",
    "matrix",
    "offered pair",
    "slow camera",
    "light",
    "mute",
    "lock exposure",
    "control page",
    "console",
    "leave",
    "camera 1",
    "camera 2",
    "camera 3",
    "camera 4",
    "camera 5",
    "camera 6",
    "camera 7",
    "camera 8",
    "camera 9",
    "camera 10",
]
"""Functions of keys, buttons and axes that a step can name; the page has them in ``web/src/input/uses/``."""
DeskGroup = Literal[
    "thc", "rhc", "mode", "target", "joints", "clearance", "conditions", "effector", "limits", "singularity"
]
"""Groups of the desk that a step can point at."""
StickAxis = Literal["X", "Y", "Z"]
"""Axis of the THC."""
PointNumber = Annotated[int, Bounds(1, 1000, "points are counted from 1, and a sequence has some tens")]
Share = Annotated[float, Bounds(0.0, 1.0, "1 is the whole limit")]


class _Part(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A table of a scenario file; unknown fields are rejected."""


class StateSpec(_Part, frozen=True):
    """State of a run. Every field that is given has to hold.

    `looked`: since the step began, the operator has put another camera on a monitor. `moved` and `turned`: since the
    step began, the tip has moved or turned at least this far. `within` and `within_angle`: the tip is at most this far
    from the step's target, and turned from it by at most this angle; with the step's `joint`, only the angle counts,
    or only the length if it slides. A
    step without a target uses the target of the automatic mode. `above`: the tip is at least this far from its pose at
    the target's payload, or the held payload from its pose in the target's berth, measured along the way out like
    `above` of a target. `sticks_released`: no stick is deflected; `at_rest`: and
    the tip is at rest. `orbiter_at_rest`: the orbiter does not translate.

    `held`: the end effector holds a payload. `fixed`: the payload is fixed to a berth; `berth`: to the berth of this
    name. `ready`: all conditions on the panel hold. `holds` names conditions that hold; `share` is the part of each
    limit within which they have to hold. `flag` is lit at the end effector. `switch` is the position of its switch.
    `moves`: a mechanism moves: latches, snares, carriage, prong or telescope.

    `mode`, `rate`, `sequence` and `point` are those of the panel. `singular`: a singularity is nearer than the arm's
    threshold. `alarm`: CLEARANCE shows a warning.
    """

    looked: bool | None = None
    moved: Length | None = None
    turned: Angle | None = None
    within: Length | None = None
    within_angle: Angle | None = None
    above: Length | None = None
    sticks_released: bool | None = None
    at_rest: bool | None = None
    orbiter_at_rest: bool | None = None
    held: bool | None = None
    fixed: bool | None = None
    berth: Text | None = None
    ready: bool | None = None
    holds: tuple[Text, ...] = ()
    share: Share = 1.0
    flag: Text | None = None
    switch: Literal["stop", "close", "open"] | None = None
    moves: bool | None = None
    mode: Text | None = None
    rate: Literal["coarse", "vernier"] | None = None
    sequence: Literal["idle", "checking", "ready", "in progress"] | None = None
    point: PointNumber | None = None
    singular: bool | None = None
    alarm: bool | None = None


class HintSpec(_Part, frozen=True):
    """Text of a step for a certain state: it is shown in place of the step's text while `when` holds.

    Of several hints whose state holds, the first is shown. `uses` replaces the step's `uses`.
    """

    when: StateSpec
    text: Text
    uses: tuple[Text, ...] | None = None
