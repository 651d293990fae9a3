"""State that a learner sees: numbers that an operator's page shows, in one vector, from a frame."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from aftdeck.errors import InputError
from aftdeck.export.columns import MODE_NUMBERS
from aftdeck.frames import quaternion_of_rows
from aftdeck.scenario.model import Scenario
from aftdeck.scene.stick_axes import StickAxes
from aftdeck.simulation.frame import Frame
from aftdeck.task.along_sticks import seen_along
from aftdeck.task.readings import clearance_share, conditions_share, effector_switch
from aftdeck.task.remaining import Remaining

Floats32 = NDArray[np.float32]


class Shown(NamedTuple):
    """Group of numbers of the state.

    Attributes:
        name: name of the group.
        parts: what distinguishes the names of its numbers; empty for a single number, None for the arm's joints.
        unit: unit.
        definition: what it is.
    """

    name: str
    parts: tuple[str, ...] | None
    unit: str
    definition: str


_XYZ = ("x", "y", "z")
GROUPS = (
    Shown("angle", None, "rad", "Joint angles, measured."),
    Shown("rate", None, "rad/s", "Joint rates, measured."),
    Shown("tip", _XYZ, "m", "Position of the tip, in L."),
    Shown("attitude", ("w", *_XYZ), "", "Attitude of the tip in L, as a quaternion with w not negative."),
    Shown("velocity", _XYZ, "m/s", "Velocity of the point of resolution along the sticks' axes."),
    Shown("turning", _XYZ, "rad/s", "Angular velocity about the sticks' axes."),
    Shown("to_go", _XYZ, "m", "Distance to go along the sticks' axes; 0 if there is no place to move to."),
    Shown("rotation_to_go", _XYZ, "rad", "Rotation to go about the sticks' axes: unit axis times angle."),
    Shown("clearance", (), "", "Minimum clearance c of the monitored pairs, as c / (c + 1 ft); 1 without a pair."),
    Shown("arm_inhibit", (), "", "1 while a contact inhibits the arm."),
    Shown("conditions", (), "", "Share of the conditions of capture or docking that hold; 0 without one."),
    Shown("held", (), "", "1 while the end effector holds a payload."),
    Shown("opening", (), "", "Opening of the snares or of the prong, 0 closed to 1 open."),
    Shown("effector", (), "", "End effector switch: 1 close, 0 stop, -1 open."),
    Shown("mode", (), "", "Mode, numbered as in the column `mode` of an action."),
    Shown("coarse", (), "", "Rate setting: 1 coarse, -1 vernier."),
    Shown("brakes", (), "", "1 while BRAKES are on."),
)
"""Groups of the state, in their order."""


class StateReader:
    """Reader of the state from the frames of one scenario.

    Attributes:
        names: name of each number.
    """

    def __init__(self, scenario: Scenario) -> None:
        self._sticks = StickAxes(scenario)
        parts = [(group.name, scenario.arm.joints if group.parts is None else group.parts) for group in GROUPS]
        self.names = tuple(
            name for group, own in parts for name in ([f"{group}_{part}" for part in own] if own else [group])
        )

    def of(self, frame: Frame, left: Remaining | None) -> Floats32:
        """Return the state (numbers,).

        Args:
            frame: the frame.
            left: remaining motion; None if there is no place to move to.
        """
        seen = seen_along(frame, left, self._sticks.in_l(frame))
        values = [
            *frame.angles,
            *frame.rates,
            *frame.position,
            *quaternion_of_rows(frame.orientation),
            *seen.velocity,
            *seen.turning,
            *seen.to_go,
            *seen.rotation_to_go,
            clearance_share(frame),
            float(frame.work.arm_inhibit),
            conditions_share(frame),
            float(frame.payload is not None),
            frame.work.hand.opening,
            effector_switch(frame),
            float(MODE_NUMBERS.get(frame.mode, 0)),
            1.0 if frame.rate == "coarse" else -1.0,
            float(frame.brakes),
        ]
        return np.array(values, dtype=np.float32)


def same_names(what: str, ours: tuple[str, ...], first: tuple[str, ...], where: str, there: str) -> None:
    """Check that two runs have the same names of something.

    Raises:
        InputError: they differ; the message states which names only one of the runs has.
    """
    if ours == first:
        return
    more, less = [name for name in ours if name not in first], [name for name in first if name not in ours]
    raise InputError(
        f"{where}: {what} differ from those of {there}: {', '.join(more) or 'none'} instead of "
        f"{', '.join(less) or 'none'}; export runs of different arms into different folders"
    )
