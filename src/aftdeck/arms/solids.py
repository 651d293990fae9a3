"""Solids of an arm: its collision bodies, in the frames that carry them."""

from __future__ import annotations

from aftdeck.arms.blocks import blocks_of
from aftdeck.arms.covers import corners, hexahedra
from aftdeck.arms.geometry import frozen
from aftdeck.arms.load import ArmModel
from aftdeck.arms.model import HeadingArmFile
from aftdeck.bodies.solid import Solid


def solids_of(model: ArmModel) -> tuple[Solid, ...]:
    """Return an arm's solids, from the foot to the tip; their vertices are read-only.

    The concept arm's solids are the boxes of `arms.blocks`. For the family of the Shuttle's arm, the solids are the
    covers that the arm's file lists. `bodies.cover` states how far a cover extends beyond the round part that it
    covers. If the file lists no covers, the arm has no solids.
    """
    file = model.source
    if isinstance(file, HeadingArmFile):
        return tuple(
            Solid(block.part, block.frame, frozen(corners(block.low, block.high, block.axes)))
            for block in blocks_of(file, model.linkage.frames)
        )
    return tuple(Solid(body.part, body.frame, frozen(v)) for body in file.bodies for v in hexahedra(body, body.part))
