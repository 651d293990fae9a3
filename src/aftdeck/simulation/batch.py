"""Simulations of one scenario whose rows lie side by side, so that one compiled call moves all of them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from aftdeck.arrays import Array, Flags, Indices
from aftdeck.errors import InputError
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.parts.shown import write_effector
from aftdeck.simulation.parts.worksite_state import DRIVES, Switch
from aftdeck.simulation.period.many import Constants, advance_all
from aftdeck.simulation.period.period import UNCHANGED
from aftdeck.simulation.row.row import Row, new_arrays
from aftdeck.simulation.run import Simulation
from aftdeck.simulation.state import State
from aftdeck.simulation.step import make_row_current
from aftdeck.steering.mode import MODES
from aftdeck.steering.rules import SETTINGS

_SWITCHES: dict[float, Switch] = {drive: switch for switch, drive in DRIVES.items()}
STICKS = 6
"""Number of the sticks' axes."""


class Batch:
    """Simulations on the kinematic plant that an operator flies with the sticks of the arm, many in one call.

    A row with nothing to do but the motion stays in compiled code for as long as this lasts; its simulation then lags
    behind. `catch_up` takes its state over, which `hold` does for rows in which something happens.

    Args:
        first: the first simulation; the others are its twins.
        count: number of simulations.

    Attributes:
        simulations: the simulations, n.
        rows: rows of their states.
        rates: (n,) rate setting in force: its number in `SETTINGS`.
        switches: (n,) position of the end effector's switch: 1 close, 0 stop, -1 open.

    Raises:
        InputError: the plant has masses, or the scenario plans changes in flight, which would change the constants.
    """

    def __init__(self, first: Simulation, count: int) -> None:
        if first.scenario.changes_at:
            raise InputError(
                f"scenario: {first.scenario.name!r} plans changes in flight ([[event]]), which no batch can make; use "
                "make_vec(..., vectorization_mode='async') or 'sync'"
            )
        if first.scenario.plant != "kinematic":
            raise InputError(f"plant: got {first.scenario.plant!r}, expected 'kinematic'")
        self.simulations = [first, *(first.twin() for _ in range(count - 1))]
        state = first.parts[1]
        self.rows = new_arrays(state.row.tables, count)
        self.rates, self._behind, self._made, self._reached = (np.zeros(count, np.int64) for _ in range(4))
        self._own: list[Row | None] = [None] * count
        self._going, self._sticks = np.zeros(count, np.bool_), np.zeros((count, STICKS))
        self.switches, self._pressed, self._orders = np.zeros(count), np.zeros(count), np.zeros((count, 2))
        self._rules = np.zeros((count, len(SETTINGS), len(state.rules)))
        self._links = np.zeros((count, len(state.arm.model.links)))

    def __getstate__(self) -> dict[str, object]:
        """Return the fields for `copy` and `pickle`: the rows are left out, and the states are saved."""
        for i in range(len(self.simulations)):
            self.catch_up(i)
        fields = {name: value for name, value in vars(self).items() if name not in ("simulations", "rows", "_own")}
        return fields | {"_first": self.simulations[0], "_saved": [sim.save() for sim in self.simulations]}

    def __setstate__(self, fields: dict[str, Any]) -> None:
        """Set the fields from those of another batch, and make rows with its states."""
        first, saved = fields.pop("_first"), fields.pop("_saved")
        vars(self).update(fields)
        self.simulations = [first, *(first.twin() for _ in saved[1:])]
        self.rows, self._own = new_arrays(first.parts[1].row.tables, len(saved)), [None] * len(saved)
        for i, (sim, state) in enumerate(zip(self.simulations, saved, strict=True)):
            sim.restore(state)
            self.place(i)

    @property
    def constants(self) -> Constants:
        """Constants of the run, as compiled code takes them."""
        return tuple(self.simulations[0].parts[0].packed)  # type: ignore[return-value]

    def place(self, i: int) -> None:
        """Take a simulation that has been restarted, and has made a step, into the batch."""
        state = self.simulations[i].parts[1]
        if state.row is not self._own[i]:
            numbers, indices, marks = self.rows
            state.move_row((numbers[i], indices[i], marks[i]))
            self._own[i] = state.row
        self._behind[i] = 0
        self._look(i)

    def hold(
        self,
        sticks: Array,
        rates: Indices,
        switches: Array,
        steps: int,
        skipped: Flags,
        inputs: Callable[[int], Inputs],
    ) -> list[int]:
        """Make control periods with the same inputs in all simulations, as `Simulation.hold` does in each.

        Args:
            sticks: (n, 6) rotation, then translation, in [-1, 1].
            rates: (n,) rate setting that is wanted: its number in `SETTINGS`.
            switches: (n,) switch of the end effector that is pressed: 1 close, -1 open; 0 for none.
            steps: number of control periods.
            skipped: (n,) whether a simulation makes no steps.
            inputs: returns the inputs of a simulation.

        Returns:
            The simulations of which Python code has made at least a part; the others lag behind.

        Raises:
            InputError: as for `Simulation.hold`.
            SimulationError: the same.
        """
        left, changed = np.where(skipped, 0, steps), set[int]()
        moves = ~skipped
        self._sticks[moves], self._pressed[moves] = sticks[moves], switches[moves]
        going = self._going & moves
        np.copyto(self.rates, rates, where=going)
        np.copyto(self.switches, switches, where=going & (switches != 0.0))
        while (moving := self._going & (left > 0)).any():
            advance_all(
                self.constants, self.rows, self._rules, self.rates, self._links, self._orders, self._sticks,
                self._pressed, moving, left, self._made, self._reached,
            )  # fmt: skip
            self._behind += self._made
            left -= self._made
            ended: list[int] = np.flatnonzero(moving & (self._reached != UNCHANGED)).tolist()
            for i in ended:
                self._take_over(i, self.simulations[i].checked(inputs(i)), int(self._reached[i]))
                self._look(i)
            changed.update(ended)
        for i in np.flatnonzero(left).tolist():
            self._by_python(i, inputs(i), left)
            changed.add(i)
        return sorted(changed)

    def _by_python(self, i: int, inputs: Inputs, left: Indices) -> None:
        """Make the control periods that are left of a simulation that has not to catch up."""
        self.simulations[i].hold(inputs, int(left[i]))
        left[i] = 0
        self._look(i)

    def catch_up(self, i: int) -> None:
        """Let a simulation take over the control periods that compiled code has made in its row."""
        if self._behind[i]:
            roll, pitch, yaw, x, y, z = (self._sticks[i] + 0.0).tolist()
            effector = _SWITCHES[self._pressed[i]] if self._pressed[i] else None
            self._take_over(i, Inputs(translation=(x, y, z), rotation=(roll, pitch, yaw), effector=effector), UNCHANGED)

    def _take_over(self, i: int, inputs: Inputs, reached: int) -> None:
        sim = self.simulations[i]
        state = sim.parts[1]
        state.panel.rate, state.worksite.switch = SETTINGS[self.rates[i]], _SWITCHES[self.switches[i]]
        sim.take_over(inputs, int(self._behind[i]), reached)
        self._behind[i] = 0

    def _look(self, i: int) -> None:
        """Find out whether compiled code can go on in a row, and with which rules."""
        flight, state = self.simulations[i].parts
        panel = state.panel
        write_effector(state)
        self.switches[i] = DRIVES[state.worksite.switch]
        self.rates[i], self._going[i] = SETTINGS.index(panel.rate), takes_sticks(flight, state)
        if self._going[i]:
            for rules, rate in zip(self._rules[i], SETTINGS, strict=True):
                rules[:] = state.carried.rules[panel.mode, rate, panel.flown]
            self._links[i], self._orders[i] = state.arm.model.links, (panel.flown, panel.joint)


def takes_sticks(flight: Flight, state: State) -> bool:
    """Return whether the next steps of a state with only the sticks of the arm need nothing but compiled code."""
    panel = state.panel
    return (
        MODES[panel.mode].kind == "manual"
        and panel.rate_hold_sticks is None
        and not (state.by_script or state.script.attached or state.delayed_inputs)
        and make_row_current(flight, state)
    )
