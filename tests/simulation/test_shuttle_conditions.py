"""The snares capture a payload, and latches fix it, exactly if conditions hold that are computed independently."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

import aftdeck
from aftdeck import Inputs
from tests.simulation.concept import vec3
from tests.simulation.flights import flown, random_inputs, srms
from tests.simulation.payload_invariants import check_possession
from tests.simulation.shuttle_rules import envelope, latching
from tests.steering.flying import fly

ROUNDING = 1e-9
"""Smallest compared margin [m], [rad]; the two computations may round a smaller margin differently."""
seeds = st.integers(0, 2**32 - 1)


@settings(max_examples=6)
@given(seeds, st.floats(0.0, 1.0))
def test_snares_capture_pin_exactly_inside_the_envelope(seed: int, spread: float) -> None:
    rng = np.random.default_rng(seed)
    x, y, above = spread * rng.uniform(-3.5, 3.5, 3) + [0.0, 0.0, 2.0]
    made = srms(float(above), float(x), float(y), vec3(spread * rng.uniform(-11.0, 11.0, 3)))
    sim = aftdeck.Simulation(made)
    frames = flown(sim, [Inputs(effector="close", rate="vernier"), *random_inputs(rng, 130, 0.3, switches=0.0)])
    closed = next(frame for frame in frames if "CLOSE" in frame.work.hand.flags)
    margins = envelope(closed, made.arm.model.end_effector_roll)
    if np.abs(margins).min() > ROUNDING:
        assert closed.work.cargo[0].held == bool((margins > 0.0).all())
    assert not any(frame.work.cargo[0].held for frame in frames[: frames.index(closed)])
    (kind,) = (event.kind for event in closed.events if event.kind in ("captured", "missed"))
    assert (kind == "captured") == closed.work.cargo[0].held
    check_possession(made, frames)


@settings(max_examples=8)
@given(seeds, st.floats(0.0, 1.0))
def test_latches_fix_payload_exactly_if_trunnions_are_ready(seed: int, spread: float) -> None:
    rng = np.random.default_rng(seed)
    x, y, above = spread * rng.uniform(-1.5, 1.5, 3) + [0.0, 0.0, 1.0]
    turned = vec3(spread * rng.uniform(-1.2, 1.2, 3))
    made = srms(float(above), float(x), float(y), turned, held=True)
    sim = aftdeck.Simulation(made)
    margins = latching(sim.step(Inputs()))
    frame = sim.step(Inputs(latch="latch"))
    if np.abs(margins).min() > ROUNDING:
        assert (frame.work.cargo[0].seat == "bay") == bool((margins > 0.0).all())
    rejected = any(event.kind == "refused" for event in frame.events)
    assert rejected != (frame.work.cargo[0].seat == "bay")


def test_latching_and_unlatching_take_their_time() -> None:
    sim = aftdeck.Simulation(srms(0.5, 0.5, -0.3, held=True, head="control_period = 0.08"))
    frames = fly(sim, 31.0, Inputs(latch="latch")) + fly(sim, 31.0, Inputs(latch="unlatch"))
    times = {event.kind: event.time_s for frame in frames for event in frame.events}
    assert times["latched"] - times["latch"] in (29.92, 30.0)
    begun = next(frame.time_s for before, frame in pairwise(frames) if before.time_s >= 31.0 - 1e-9)
    assert abs(times["unlatched"] - begun - 30.0) < 0.17
    fixed = [frame.work.cargo[0].seat == "bay" for frame in frames]
    assert fixed == sorted(fixed, reverse=True) and not fixed[-1]
