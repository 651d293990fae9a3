"""Parts of a flexible arm that bend: its base and its booms."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arms.load import ArmModel
from aftdeck.arms.masses import masses_of
from aftdeck.arrays import Array


class Flexure(NamedTuple):
    """Part that bends; the gearboxes are not among them, because the encoders measure their windup.

    Attributes:
        part: name of the part, such as ``upper_boom``.
        frame: index of the frame that carries the part, in `ArmModel.frames`.
        end: (3,) place of the part's end in this frame, as long as the part is straight [m].
    """

    part: str
    frame: int
    end: Array


def flexures_of(model: ArmModel) -> tuple[Flexure, ...]:
    """Return the parts of an arm that bend on the plant ``flexible``, from the base to the wrist.

    The base is a flexure of no length: it lets the whole arm turn about L's origin.

    Raises:
        ArmError: the arm's file lacks a table of the masses.
    """
    booms = tuple(Flexure(boom.name, model.frames.index(boom.frame), boom.end) for boom in masses_of(model).booms)
    return (Flexure("base", 0, np.zeros(3)), *booms)
