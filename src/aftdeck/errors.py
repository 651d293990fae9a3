"""What can be wrong, one class a cause. Messages are sentences: what was given, what is allowed, where."""

from __future__ import annotations

from collections.abc import Sequence


class AftdeckError(Exception):
    """Base of every error that Aftdeck raises for a caller's mistake or an impossible request."""


class InputError(AftdeckError, ValueError):
    """An argument of the wrong shape, kind or range."""


class ArmError(AftdeckError):
    """An arm file that cannot be read or that describes no arm of a known family."""


class LimitError(AftdeckError):
    """A joint angle outside its hard limits.

    Attributes:
        joint: name of the joint.
        angle: what was given [rad].
        allowed: least and greatest angle [rad].
    """

    def __init__(self, message: str, joint: str, angle: float, allowed: tuple[float, float]) -> None:
        super().__init__(message)
        self.joint, self.angle, self.allowed = joint, angle, allowed


class SingularityError(AftdeckError):
    """The arm stands at a singularity, where a commanded tip motion has no bounded joint rates.

    Attributes:
        singularity: ``shoulder``, ``elbow`` or ``wrist``.
        distance: the normalised distance found, in [-1, 1].
    """

    def __init__(self, message: str, singularity: str, distance: float) -> None:
        super().__init__(message)
        self.singularity, self.distance = singularity, distance


class UnreachableError(AftdeckError):
    """A pose that the arm cannot take.

    Attributes:
        excess: by how much: metres beyond the reach, or radians beyond a joint limit.
        joint: the joint whose limit is passed on the branch that comes nearest; None where reach is short.
    """

    def __init__(self, message: str, excess: float, joint: str | None = None) -> None:
        super().__init__(message)
        self.excess, self.joint = excess, joint


class ScenarioError(AftdeckError):
    """A scenario, worksite or arm file with errors, all of them at once.

    Attributes:
        problems: one sentence each, beginning with its place (``file.toml:12: phase[1].rate: ...``).
    """

    def __init__(self, problems: Sequence[str]) -> None:
        super().__init__("\n".join(problems))
        self.problems = tuple(problems)


class CommandError(AftdeckError):
    """An operator's command that cannot be taken in the present state; the flight goes on unchanged."""


class SimulationError(AftdeckError):
    """The simulation itself broke down (a number is not finite); carries the time and the cause."""


class RecordingError(AftdeckError):
    """A session file that cannot be written, read or understood; says which and why."""
