"""Control periods of many rows, with the sticks of the arm and nothing else."""

from __future__ import annotations

from aftdeck.arrays import Array, Flags, Indices, Mask
from aftdeck.law import law
from aftdeck.lent import lend
from aftdeck.simulation.period.attach import press
from aftdeck.simulation.period.period import JUDGED, periods
from aftdeck.simulation.row.now import Flat, lent, motion_of
from aftdeck.simulation.row.scalars import MADE, TELESCOPE, WORKS
from aftdeck.simulation.row.world import world_of
from aftdeck.steering.layout import DRIVE, JOINT, LAW, STICKS
from aftdeck.worksite.capture.effector import BEGINS

Constants = tuple[Array, Indices, Mask]
"""`row.constants.Packed`."""
Rows = tuple[Array, Indices, Mask]
"""Rows of n states: arrays (n, size) of float64, int64 and uint8."""


@law
def row_of(constants: Constants, rows: Rows, i: int) -> Flat:
    """Return the constants of the run and row i."""
    numbers, indices, marks = rows
    return lent((constants[0], constants[1], constants[2], numbers[i], indices[i], marks[i]))


@law
def advance_all(
    constants: Constants,
    rows: Rows,
    rules: Array,
    rates: Indices,
    links: Array,
    orders: Array,
    sticks: Array,
    switches: Array,
    going: Flags,
    most: Indices,
    made: Indices,
    reached: Indices,
) -> None:
    """Make control steps of many rows in manual modes, each until something happens that Python has to handle.

    Args:
        constants: constants of the run.
        rows: rows of n states.
        rules: (n, 2, k) rules of each row's mode, with the rate setting coarse and vernier.
        rates: (n,) rate setting: 0 coarse, 1 vernier.
        links: (n, m) the arm's links with its shoulder at the present height.
        orders: (n, 2) law of each row's mode, and selected joint.
        sticks: (n, 6) rotation, then translation.
        switches: (n,) switch of the end effector that is pressed: 1 close, -1 open; 0 for none.
        going: (n,) whether a row takes part.
        most: (n,) greatest number of steps.
        made: (n,) output: the number that were made; 0 for the other rows.
        reached: (n,) output: how far the last step has come (`period.advance`); the other rows keep their numbers.
    """
    for i in range(len(going)):
        made[i] = 0
        if not going[i]:
            continue
        flat, own = row_of(constants, rows, i), lend(rules[i, rates[i]])
        now = motion_of(flat)
        for k in range(6):
            now.command[STICKS + k] = sticks[i, k] + 0.0  # -0.0 becomes 0.0
        now.command[LAW], now.command[JOINT] = orders[i, 0], orders[i, 1]
        now.command[DRIVE] = now.scalars[TELESCOPE] = 0.0
        before = now.snare.copy()
        begins = switches[i] != 0.0 and press(world_of(flat), now, switches[i])
        reached[i] = periods(flat, own, own, lend(links[i]), own, True, most[i])
        made[i] = int(now.scalars[MADE])
        if begins and reached[i] <= JUDGED and made[i] == 1:  # Python begins the sequence
            now.snare[:] = before
            now.scalars[WORKS] = BEGINS
