"""Capture by the snares and latching: nothing is taken in a frame in which its conditions, computed anew, fail."""

from __future__ import annotations

import functools
import math
from itertools import pairwise

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

import aftdeck
from aftdeck import Inputs
from aftdeck.arrays import Array
from aftdeck.simulation.frame import Frame
from tests.simulation.concept import vec3
from tests.simulation.flights import anything, flown, log_of, srms
from tests.simulation.possession import check_possession
from tests.steering.flying import fly

INCH = 0.0254
ROUNDING = 1e-9
"""Conditions that hold or fail by less are not told apart [m], [rad]."""
FIXTURE = np.array([-1.0, 0.0, 2.26])
"""Of the payload's grapple fixture, in its axes [m]."""
FIXTURE_AXES = np.array([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]])
"""Turned by 90 deg of pitch: its axis 1 looks into the payload."""
RADIAL, DEPTH, ANGLE = 4.0 * INCH, 4.0 * INCH, math.radians(10.0)
"""The capture envelope."""
TRUNNIONS = INCH * np.array([
    *([x, y, 14.05] for x in (-82.595, 82.595) for y in (-93.925, 93.925)),
    [0.0, 0.0, -94.975],
])  # fmt: skip
KEEL = 4
SEATED, STOWED = 0.05, math.radians(1.0)
"""How near each trunnion has to be [m], and how little the payload may be turned [rad]."""
HEIGHT, HALF_ANGLE, THROAT, PLAY = 0.51, math.radians(17.0), 0.044, 0.025
"""Of a V-guide."""
seeds = st.integers(0, 2**32 - 1)


@functools.cache
def stowed() -> tuple[Array, Array]:
    """The payload's place in the bay [m] and its axes, in L: as it lies there when nothing has happened."""
    (payload,) = aftdeck.Simulation("srms-deploy").step(Inputs()).work.cargo
    return np.array(payload.position), np.array(payload.orientation)


def envelope(frame: Frame, roll: float) -> Array:
    """(7,) by how much each condition of capture holds [m], [rad]."""
    (payload,) = frame.work.cargo
    s, c = math.sin(roll), math.cos(roll)
    effector = np.array(frame.orientation) @ [[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]]
    axes = np.array(payload.orientation)
    out, y, z = effector.T @ (np.array(payload.position) + axes @ FIXTURE - frame.position)
    turn = effector.T @ axes @ FIXTURE_AXES
    pitch = math.asin(-turn[2, 0])
    yaw, turned = math.atan2(turn[1, 0], turn[0, 0]), math.atan2(turn[2, 1], turn[2, 2])
    return np.array([
        RADIAL - math.hypot(y, z), out, DEPTH - out, ANGLE - abs(pitch), ANGLE - abs(yaw), ANGLE - abs(turned),
    ])  # fmt: skip


def latching(frame: Frame) -> Array:
    """By how much each condition of latching holds [m], [rad]: guides, seats, attitude."""
    (payload,) = frame.work.cargo
    place, scene = stowed()
    turn = scene.T @ payload.orientation
    off = (TRUNNIONS @ turn.T + scene.T @ (payload.position - place)) - TRUNNIONS
    margins = [SEATED - np.linalg.norm(one) for one in off]
    for k, (x, y, z) in enumerate(off):
        along, across = (y, x) if k == KEEL else (x, y)
        room = THROAT + max(z, 0.0) * math.tan(HALF_ANGLE)
        margins += [z, HEIGHT - z, room - abs(along), PLAY - abs(across)]
    angle = math.acos(min(1.0, max(-1.0, (np.trace(turn) - 1.0) / 2.0)))
    return np.array([*margins, STOWED - angle])


@settings(max_examples=6)
@given(seeds, st.floats(0.0, 1.0))
def test_the_snares_hold_a_pin_just_where_it_is_in_the_envelope_when_they_close(seed: int, spread: float) -> None:
    rng = np.random.default_rng(seed)
    x, y, above = spread * rng.uniform(-3.5, 3.5, 3) + [0.0, 0.0, 2.0]
    made = srms(float(above), float(x), float(y), vec3(spread * rng.uniform(-11.0, 11.0, 3)))
    sim = aftdeck.Simulation(made)
    frames = flown(sim, [Inputs(effector="close", rate="vernier"), *anything(rng, 130, 0.3, switches=0.0)])
    closed = next(frame for frame in frames if "CLOSE" in frame.work.hand.flags)
    margins = envelope(closed, made.arm.model.end_effector_roll)
    if np.abs(margins).min() > ROUNDING:
        assert closed.work.cargo[0].held == bool((margins > 0.0).all())
    assert not any(frame.work.cargo[0].held for frame in frames[: frames.index(closed)])
    told = [text for text in log_of([closed]) if text.startswith(("CAPTURE: pin", "snares closed empty: "))]
    assert len(told) == 1 and told[0].startswith("CAPTURE") == closed.work.cargo[0].held
    check_possession(made, frames)


@settings(max_examples=8)
@given(seeds, st.floats(0.0, 1.0))
def test_the_latches_take_a_payload_just_where_every_trunnion_is_ready(seed: int, spread: float) -> None:
    rng = np.random.default_rng(seed)
    x, y, above = spread * rng.uniform(-1.5, 1.5, 3) + [0.0, 0.0, 1.0]
    turned = vec3(spread * rng.uniform(-1.2, 1.2, 3))
    made = srms(float(above), float(x), float(y), turned, held=True)
    sim = aftdeck.Simulation(made)
    margins = latching(sim.step(Inputs()))
    frame = sim.step(Inputs(latch="latch"))
    if np.abs(margins).min() > ROUNDING:
        assert (frame.work.cargo[0].seat == "bay") == bool((margins > 0.0).all())
    refused = [text for text in log_of([frame]) if text.startswith("LATCH refused: ")]
    assert bool(refused) != (frame.work.cargo[0].seat == "bay")


def test_latched_and_unlatched_are_told_when_the_latches_have_run_their_time_and_not_before() -> None:
    sim = aftdeck.Simulation(srms(0.5, 0.5, -0.3, held=True, head="control_period = 0.08"))
    frames = fly(sim, 31.0, Inputs(latch="latch")) + fly(sim, 31.0, Inputs(latch="unlatch"))
    times = {event.text: event.time_s for frame in frames for event in frame.events}
    assert times["latched"] - times["latches of the Payload bay latches closing"] in (29.92, 30.0)
    begun = next(frame.time_s for before, frame in pairwise(frames) if before.time_s >= 31.0 - 1e-9)
    assert abs(times["latches released"] - begun - 30.0) < 0.17
    fixed = [frame.work.cargo[0].seat == "bay" for frame in frames]
    assert fixed == sorted(fixed, reverse=True) and not fixed[-1]
