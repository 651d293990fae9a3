"""What the script attaches to the end effector, phase by phase: the report's PA, T_78 and r_87."""

from __future__ import annotations

from aftdeck.files import Where
from aftdeck.kinematics.payload import Payload
from aftdeck.scenario.model import Attached
from aftdeck.scenario.payload import attached_payload
from aftdeck.scenario.problems import Problems
from aftdeck.scenario.schema import Phase


def attachment(
    problems: Problems, phase: Phase, before: Payload | None, cargo: bool, where: Where
) -> tuple[Attached | None, Payload | None]:
    """Return what a phase attaches, None where it leaves all as it is, and what is in the grasp then.

    Args:
        problems: gathers what is wrong.
        phase: as decoded.
        before: what is in the grasp until then, but for payloads of the worksite.
        cargo: whether the worksite has payloads, which the hand takes and lets go itself.
        where: its place in the file.
    """
    if phase.payload is None and not phase.detached:
        return None, before
    there = (*where, "detached" if phase.payload is None else "payload")
    if phase.payload is not None and phase.detached:
        problems.wrong(there, "give either payload or detached, not both")
    elif cargo:
        problems.wrong(there, "is for a grasp without a worksite's payloads: the hand takes and lets those go itself")
    elif before is not None and (before.shapes or before.solids):
        problems.wrong(there, "cannot change a payload with a shape or a body; payloads of the worksite can be let go")
    elif phase.detached and before is None:
        problems.wrong(there, "there is nothing in the grasp")
    else:
        payload = None if phase.payload is None else attached_payload(problems, phase.payload, there)
        return Attached(payload), payload
    return None, before
