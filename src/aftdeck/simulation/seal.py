"""The seal of a state: a digest by which two flights, or a flight and its replay, are found equal or not."""

from __future__ import annotations

from hashlib import sha256

import msgspec

from aftdeck.simulation.state import State

_encode = msgspec.msgpack.Encoder().encode


def seal(state: State) -> bytes:
    """SHA-256 over what a frame tells of, to the last digit: where everything is, what is commanded, what happened."""
    things, plant = state.site, state.plant
    words = (
        state.tick,
        state.by_script,
        state.phase,
        state.panel,
        plant.stand.position,
        things.prong.position,
        things.switch,
        things.effector_mode,
        things.rigid,
        things.snare,
        things.task,
        things.nearest,
        things.advice,
        [thing.seat for thing in things.cargo],
        state.cameras.views,
        state.events,
    )
    numbers = (
        plant.angles,
        plant.rates,
        plant.commanded,
        state.steering,
        state.command,
        state.report,
        things.frames,
        things.orbiter,
        things.orbiter_velocity,
        things.watch.found[things.nearest : things.nearest + 1],
    )
    digest = sha256(_encode(words))
    for array in numbers:
        digest.update(array.data)
    return digest.digest()
