"""Block that the scene program sends to the VCU in each control step (Figure 22), as words of 24 bits.

The order is the report's: x components of all L vectors, then of all P vectors; the same for y and z; the instructions
of the priority output table; the moving vertices of the telescope, and those of the prong. Legible: five L and five P
vectors, D at scale B11 with feet, PCX at B3, vertices at B16. Assumed: the vectors' order (that of TABLE IV, with our
two systems at the end), three P vectors in each system (PC, PL, PE), B3 for all of them, B11 for L vectors, the layout
of an instruction (fields as in Figure 15) and a word 0 after the last one.
"""

from __future__ import annotations

from typing import NamedTuple

from aftdeck.arrays import Array
from aftdeck.errors import InputError
from aftdeck.historical.frame_words import BITS, fixed
from aftdeck.mainprior.fixed import PRONG
from aftdeck.mainprior.routine import Priority
from aftdeck.mainprior.shapes import TELESCOPE
from aftdeck.mainprior.tables import CODES
from aftdeck.mainprior.trace import Aspect, Instruction, Select
from aftdeck.mainprior.vectors import DISPLAY
from aftdeck.units import FOOT

L_SCALE, P_SCALE, VERTEX_SCALE = 11, 3, 16
"""Scales of L vectors [ft], P vectors [half the width of the picture] and vertices [ft]."""
NEW_L = 1 << (BITS - 1 - 6)
"""Bit 6 of an instruction: the L vector is selected."""
_CODE_AT = BITS - 1 - 5
"""Number of bits to the right of the L vector select code, bits 3 to 5."""
_ADDRESS = (1 << 15) - 1
"""Address field, bits 9 to 23; for an aspect test, the number of the cluster."""


class VcuBlock(NamedTuple):
    """Block for the VCU.

    Attributes:
        vectors: for each axis, the L vectors of all systems and then their PC, PL and PE.
        program: the priority output table, and a word 0.
        telescope: z of the upper vertices of the telescope, in R.
        prong: y of the eight vertices of the prong, in system 2.
        unsaid: names of vectors that are too long for their scale; their words are 0.
    """

    vectors: tuple[int, ...]
    program: tuple[int, ...]
    telescope: tuple[int, ...]
    prong: tuple[int, ...]
    unsaid: tuple[str, ...]


def block_of(found: Priority) -> VcuBlock:
    """Return the block for a frame. The vectors of a system that does not exist are 0."""
    rows: dict[str, tuple[int, int, int]] = {}
    unsaid = []
    for system in CODES:
        eye, display = found.vectors.eye.get(system), found.vectors.display.get(system)
        vectors: dict[str, tuple[Array | None, int, float]] = {system: (eye, L_SCALE, FOOT)}
        for k, name in enumerate(DISPLAY):
            vectors[name + system[1:]] = (None if display is None else display[k], P_SCALE, 1.0)
        for name, (vector, scale, unit) in vectors.items():
            try:
                x, y, z = (0, 0, 0) if vector is None else (fixed(v / unit, scale, name) for v in vector.tolist())
            except InputError:
                unsaid.append(name)
                x, y, z = 0, 0, 0
            rows[name] = x, y, z
    names = [*CODES, *(kind + system[1:] for kind in DISPLAY for system in CODES)]
    heights = sorted(found.stage.bodies[TELESCOPE].points[:, 2].tolist())
    tube = heights[: len(heights) // 2]  # the upper vertices, because Z is down
    finger = found.stage.systems["L2"].within(found.stage.bodies[PRONG].points)[:, 1]
    return VcuBlock(
        tuple(rows[name][axis] for axis in range(3) for name in names),
        (*map(instruction_word, found.table), 0),
        tuple(fixed(z / FOOT, VERTEX_SCALE, "z of the telescope") for z in tube),
        tuple(fixed(y / FOOT, VERTEX_SCALE, "y of the prong") for y in finger.tolist()),
        tuple(unsaid),
    )


def instruction_word(instruction: Instruction) -> int:
    """Return an instruction of the priority output table as a word."""
    if isinstance(instruction, Select):
        return NEW_L | CODES[instruction.system] << _CODE_AT
    return instruction.cluster


def instruction_of(word: int) -> Instruction:
    """Return the instruction of a word."""
    if word & NEW_L:
        return Select(next(system for system, code in CODES.items() if code == word >> _CODE_AT & 0b111))
    return Aspect(word & _ADDRESS)
