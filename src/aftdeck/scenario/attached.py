"""Payloads that the script attaches to the end effector, phase by phase: the report's PA, T_78 and r_87."""

from __future__ import annotations

from aftdeck.files import Where
from aftdeck.kinematics.payload import HeldPayload
from aftdeck.scenario.payload import attached_payload
from aftdeck.scenario.problems import Problems
from aftdeck.scenario.schema import Phase


class Grasp:
    """The payloads that the scenario itself attaches to the end effector, collected phase by phase.

    Attributes:
        payloads: payloads collected so far, in the order of the file.
        held: number, from 1, of the payload that is attached at present; 0 for none.
    """

    def __init__(self, payload: HeldPayload | None, *, takes_others: bool) -> None:
        self.payloads = [] if payload is None else [payload]
        self.held = len(self.payloads)
        self._takes_others = takes_others

    @property
    def loaded(self) -> bool:
        """Whether the end effector can hold a payload: one is attached, or the worksite's payloads are present."""
        return self.held > 0 or self._takes_others

    @property
    def mass(self) -> float:
        """Mass of the attached payload [kg]; 0 for none. The worksite's payloads do not count."""
        return self.payloads[self.held - 1].mass if self.held else 0.0

    def attach(self, problems: Problems, phase: Phase, where: Where) -> int | None:
        """Attach or detach a payload as a phase demands.

        Return the number of the attached payload, from 1; 0 if the payload was detached; None if nothing changes.

        Args:
            problems: collects the problems found.
            phase: the decoded phase.
            where: the phase's place in the file.
        """
        if phase.payload is None and not phase.detached:
            return None
        field = (*where, "detached" if phase.payload is None else "payload")
        current = self.payloads[self.held - 1] if self.held else None
        if phase.payload is not None and phase.detached:
            problems.add(field, "give either payload or detached, not both")
        elif self._takes_others:
            problems.add(
                field,
                "is allowed only without [[cargo]]; the end effector captures and releases the payloads of [[cargo]]",
            )
        elif current is not None and (current.shapes or current.solids):
            problems.add(
                field,
                "the attached payload has a shape or a body, so it stays attached; only payloads of the worksite can "
                "be released",
            )
        elif phase.detached and current is None:
            problems.add(field, "no payload is attached")
        elif phase.payload is None:
            self.held = 0
            return self.held
        elif (payload := attached_payload(problems, phase.payload, field)) is not None:
            self.payloads.append(payload)
            self.held = len(self.payloads)
            return self.held
        return None
