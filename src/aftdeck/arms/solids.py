"""Solids of an arm: its collision bodies, in the frames that carry them."""

from __future__ import annotations

from aftdeck.arms.covers import hexahedra
from aftdeck.arms.geometry import frozen
from aftdeck.arms.load import ArmModel
from aftdeck.bodies.solid import Solid


def solids_of(model: ArmModel) -> tuple[Solid, ...]:
    """Return an arm's solids in the order of its file; their vertices are read-only.

    `bodies.cover` states how far a cover extends beyond the round part that it covers.
    """
    bodies = model.source.bodies
    return tuple(Solid(body.part, body.frame, frozen(v)) for body in bodies for v in hexahedra(body, body.part))
