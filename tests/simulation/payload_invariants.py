"""Invariants of payloads in every run: each exists once, moves with its carrier, and never jumps."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest

from aftdeck.arrays import Array
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.worksite.report import Cargo
from tests.simulation.flights import in_turn

EXACT = 1e-9
"""Tolerance of positions [m] and of axes' components [1]."""
CARRIAGE, LATCHES = 7.0, 30.0
"""Travel times of the Shuttle's carriage and latches, from end to end [s]."""
PULLED, TURNED = 0.2, 0.5
"""Upper bounds for a pin in the snares: distance from its seat [m], and change of its axes' components [1]."""


def posed(cargo: Cargo) -> tuple[Array, Array]:
    """Return a payload's centre [m] and axes, in L."""
    return np.array(cargo.position), np.array(cargo.orientation)


def in_frame_7(frame: Frame, cargo: Cargo) -> tuple[Array, Array]:
    """Return a payload's centre [m] and axes in frame 7."""
    tip, (centre, axes) = np.array(frame.orientation), posed(cargo)
    return tip.T @ (centre - frame.position), tip.T @ axes


def in_space(frame: Frame, cargo: Cargo) -> tuple[Array, Array]:
    """Return a payload's centre [m] and axes in space, which does not move with the orbiter."""
    centre, axes = posed(cargo)
    return centre + frame.work.orbiter, axes


def at_berth(scenario: Scenario, frame: Frame, cargo: Cargo) -> tuple[Array, Array]:
    """Return a fixed payload's centre [m] and axes relative to its berth."""
    (seat,) = (seat for seat in scenario.worksite.berths if seat.name == cargo.seat)
    return in_space(frame, cargo) if seat.frame == "space" else posed(cargo)


def moved(one: tuple[Array, Array], other: tuple[Array, Array]) -> tuple[float, float]:
    """Return the distance between two poses [m], and the greatest difference of their axes' components [1]."""
    return float(np.linalg.norm(one[0] - other[0])), float(np.abs(one[1] - other[1]).max())


def check_possession(scenario: Scenario, frames: list[Frame]) -> None:
    """Check every frame, and the motion of each payload in every step."""
    names = [cargo.name for cargo in scenario.payloads]
    for frame in frames:
        check_frame(names, frame)
    for before, now in in_turn(frames):
        for was, is_now in zip(before.work.cargo, now.work.cargo, strict=True):
            check_step(scenario, before, now, was, is_now)


def check_frame(names: list[str], frame: Frame) -> None:
    """Check that each payload exists once, that at most one is held, and that no berth contains two.

    The frame must report the held payload, and no other.
    """
    work = frame.work
    assert [cargo.name for cargo in work.cargo] == names
    held = [cargo for cargo in work.cargo if cargo.held]
    assert len(held) <= 1
    assert ("CAPTURE" in work.hand.flags) == bool(held)
    assert (frame.payload is not None) == bool(held)
    if frame.payload is not None:
        shown = np.array(frame.payload[0]), np.array(frame.payload[1])
        assert moved(shown, posed(held[0])) == pytest.approx((0.0, 0.0), abs=EXACT)
    assert all(a.seat != b.seat or not a.seat for a, b in combinations(work.cargo, 2))
    if frame.mode in ("ORB LD", "PL"):
        assert held
    for cargo in work.cargo:
        axes = np.array(cargo.orientation)
        assert axes.T @ axes == pytest.approx(np.eye(3), abs=EXACT)


def check_step(scenario: Scenario, before: Frame, now: Frame, was: Cargo, is_now: Cargo) -> None:
    """Check that the motion of a payload in a step is that of its carrier at the beginning of the step."""
    period, where = scenario.control_period, f"{now.time_s} s: {was} to {is_now}"
    if was.seat:
        reach = 2.0 * period / LATCHES * PULLED
        shift, turn = moved(at_berth(scenario, before, was), at_berth(scenario, now, _fixed_as(was, is_now)))
        assert shift <= (reach if drawn(scenario, was) else EXACT) and turn <= max(reach, EXACT), where
        if not drawn(scenario, was):
            assert turn <= EXACT, where
    elif was.held:
        carriage = before.work.hand.carriage is not None
        shift, turn = moved(in_frame_7(before, was), in_frame_7(now, is_now))
        share = 2.0 * period / CARRIAGE if carriage else 0.0
        assert shift <= EXACT + share * PULLED and turn <= EXACT + share * TURNED, where
    else:
        (here, _), (there, _) = in_space(before, was), in_space(now, is_now)
        velocity = np.array(is_now.velocity) + np.subtract(now.work.orbiter, before.work.orbiter) / period
        assert there == pytest.approx(here + velocity * period, abs=EXACT), where


def drawn(scenario: Scenario, cargo: Cargo) -> bool:
    """Return whether the berth of a payload has latches that draw it in."""
    return any(seat.closes == "on command" for seat in scenario.worksite.berths if seat.name == cargo.seat)


def _fixed_as(was: Cargo, is_now: Cargo) -> Cargo:
    """Return a payload with its present pose and its previous berth."""
    return Cargo(is_now.name, is_now.position, is_now.orientation, is_now.velocity, is_now.held, was.seat)
