"""Exceptions of Aftdeck, one class per cause. A message states the given value, the allowed values and the place."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from aftdeck.encodable import encodable


class AftdeckError(Exception):
    """Base of every error that Aftdeck raises for a caller's mistake or an impossible request."""

    def __str__(self) -> str:
        """Return the message; it may name a file, and goes to pages and into files."""
        return encodable(super().__str__())


class InputError(AftdeckError, ValueError):
    """An argument of the wrong shape, kind or range."""


class ArmError(AftdeckError):
    """An arm file that cannot be read, or that does not describe an arm with a closed form."""


class LimitError(AftdeckError):
    """A joint angle outside its hard limits.

    Attributes:
        joint: name of the joint.
        angle: given angle [rad].
        allowed: minimum and maximum angle [rad].
    """

    def __init__(self, message: str, joint: str, angle: float, allowed: tuple[float, float]) -> None:
        super().__init__(message)
        self.joint, self.angle, self.allowed = joint, angle, allowed


class SingularityError(AftdeckError):
    """An arm at a singularity, where some motions of the tip require unbounded joint rates.

    Attributes:
        singularity: ``shoulder``, ``elbow`` or ``wrist``.
        distance: signed normalised distance from the singularity, in [-1, 1].
    """

    def __init__(self, message: str, singularity: str, distance: float) -> None:
        super().__init__(message)
        self.singularity, self.distance = singularity, distance


class UnreachableError(AftdeckError):
    """A pose that the arm cannot reach.

    Attributes:
        excess: distance beyond the reach [m], or angle beyond a joint limit [rad].
        joint: joint whose limit is exceeded on the nearest branch; None if the pose is out of reach.
    """

    def __init__(self, message: str, excess: float, joint: str | None = None) -> None:
        super().__init__(message)
        self.excess, self.joint = excess, joint


class ScenarioError(AftdeckError):
    """A scenario, worksite or arm file with errors, all reported at once.

    Attributes:
        problems: one sentence for each problem, location first (``file.toml:12: phase[1].rate: ...``).
    """

    def __init__(self, problems: Sequence[str]) -> None:
        self.problems = tuple(map(_readable, problems))
        super().__init__("\n".join(self.problems))


_LONGEST_PROBLEM = 2_000
"""Greatest length of a problem's sentence [characters]; what a file repeats more often is cut off."""


def _readable(sentence: str) -> str:
    """Return a sentence as one line that a terminal prints without effect on other lines."""
    line = sentence if sentence.isprintable() else "".join(x if x.isprintable() else repr(x)[1:-1] for x in sentence)
    return line if len(line) <= _LONGEST_PROBLEM else f"{line[:_LONGEST_PROBLEM]}…"


class CommandError(AftdeckError):
    """An operator's command that is rejected in the present state; the run continues unchanged."""


class SimulationError(AftdeckError):
    """A failure of the simulation: the arm's state contains a number that is not finite. The message gives the time."""


RecordingFault = Literal[
    "other",
    "unreadable",
    "foreign",
    "empty",
    "damaged",
    "rewritten",
    "newer layout",
    "older layout",
    "exists",
    "unwritable",
]
"""Cause of a `RecordingError`.

``foreign``: the file is not a recording. ``empty``: the recording contains no control step. ``rewritten``: the file is
valid, but another program left out, moved or added messages.
"""


class RecordingError(AftdeckError):
    """A recording file that cannot be written, read or re-simulated; the message names the file and the cause.

    Attributes:
        fault: cause of the error.
    """

    def __init__(self, message: str, fault: RecordingFault = "other") -> None:
        super().__init__(message)
        self.fault = fault
