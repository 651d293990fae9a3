"""The way out of the contacts that inhibit the arm: the stick, the joint or the telescope that leads out of them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.simulation.ahead import frames_after
from aftdeck.simulation.flight import Flight
from aftdeck.simulation.log import spoken
from aftdeck.simulation.restrain import AHEAD, kept_apart
from aftdeck.simulation.state import State
from aftdeck.simulation.ways_out import STICKS, entered, steering_of
from aftdeck.steering.mode import MODES
from aftdeck.steering.way_out import DIRECTIONS, stick_rates
from aftdeck.worksite.restrain import leads_out, ways_out

LOOK_EVERY = 10
"""Steps between two searches."""
SLOWLY = 0.02
"""Share of its full rate at which a way is tried [1]: about as fast as the arm sets out from rest."""


class _Way(NamedTuple):
    """A motion that the operator can command.

    Attributes:
        name: how, for people.
        rates: (6,) of the joints [rad/s].
        telescope: its drive, -1 to 1.
    """

    name: str
    rates: Array
    telescope: float


def way_out_of_contact(flight: Flight, state: State) -> None:
    """Look for the motion that takes the arm out of what it touches fastest, and say how it is commanded.

    It is looked for now and then, and told for as long as the arm is inhibited: `advice`, empty where there is none.
    """
    things = state.site
    if things.advice and state.tick % LOOK_EVERY:
        return
    for ways, sliding in ((_sticks(state), True), (_joints(flight, state), False)):
        apart = kept_apart(flight, state, sliding=sliding)
        first = _afters(flight, state, ways, SLOWLY)
        won = ways_out(things.watch, *apart, first)
        if not won.max() > 0.0:
            ahead = [_afters(flight, state, ways, SLOWLY * steps) for steps in AHEAD]
            won = leads_out(things.watch, *apart, first, ahead)
        if won.max() > 0.0:
            things.advice = f"way out: {ways[int(won.argmax())].name}"
            return
    things.advice = ""


def _afters(flight: Flight, state: State, ways: list[_Way], steps: float) -> Array:
    """(k, F, 12) where everything is after some steps of each way."""
    return np.array([frames_after(flight, state, steps * way.rates, steps * way.telescope) for way in ways])


def _sticks(state: State) -> list[_Way]:
    """Each stick by itself, in the present mode or in ORB UNL where that takes none."""
    rates = np.zeros((DIRECTIONS, 6))
    stick_rates(*steering_of(state), rates)
    return [_Way(f"{entered(state)}{name}", own, 0.0) for name, own in zip(STICKS, rates, strict=True)]


def _joints(flight: Flight, state: State) -> list[_Way]:
    """Each joint by itself, and the telescope of an arm that has one."""
    arm, position = flight.scenario.arm, state.panel.mode
    mode = position if MODES[position].kind == "single" else "SINGLE"
    found = []
    for joint, name in enumerate(arm.joints):
        for sign, sense in ((1.0, "+"), (-1.0, "−")):
            rates = np.zeros(6)
            rates[joint] = sign * arm.rate_limits[joint]
            found.append(_Way(f"{mode} {spoken(name)} {sense}", rates, 0.0))
    if flight.telescope.rate:
        found += [_Way("telescope longer", np.zeros(6), 1.0), _Way("telescope shorter", np.zeros(6), -1.0)]
    return found
