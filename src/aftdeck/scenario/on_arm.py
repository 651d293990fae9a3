"""An arm with what a worksite mounts on it: the housings of the worksite's cameras on the arm's frames."""

from __future__ import annotations

from aftdeck.arms.load import ArmModel
from aftdeck.arms.shapes import shapes_of
from aftdeck.arms.solids import solids_of
from aftdeck.bodies.solid import Solid
from aftdeck.shapes import Shape
from aftdeck.worksite.model import Worksite


def arm_solids(model: ArmModel, worksite: Worksite) -> tuple[Solid, ...]:
    """Return the solids in the frames of an arm, from the foot to the tip; those of the worksite come last."""
    mounted = (own.solids for frame, own in worksite.mounted.items() if frame in model.frames)
    return (*solids_of(model), *(solid for own in mounted for solid in own))


def arm_shapes(model: ArmModel, worksite: Worksite) -> dict[str, tuple[Shape, ...]]:
    """Return the shapes that draw an arm by their frames, in the order from the foot to the tip."""
    mounted = {frame: own.shapes for frame, own in worksite.mounted.items()}
    return {frame: (*shapes, *mounted.get(frame, ())) for frame, shapes in shapes_of(model).bodies.items()}
