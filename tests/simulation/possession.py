"""What has to hold of payloads in every flight: each is there once, moves as what has it moves, and never jumps."""

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
"""[m], and of the axes' components [1]."""
CARRIAGE, LATCHES = 7.0, 30.0
"""How long the Shuttle's take from end to end [s]."""
PULLED, TURNED = 0.2, 0.5
"""More than a pin in the snares is ever off its seat [m], and turned, axes' components summed [1]."""


def posed(cargo: Cargo) -> tuple[Array, Array]:
    """A cargo's centre [m] and axes, in L."""
    return np.array(cargo.position), np.array(cargo.orientation)


def in_hand(frame: Frame, cargo: Cargo) -> tuple[Array, Array]:
    """A cargo's centre [m] and axes in system 7."""
    hand, (centre, axes) = np.array(frame.orientation), posed(cargo)
    return hand.T @ (centre - frame.position), hand.T @ axes


def in_space(frame: Frame, cargo: Cargo) -> tuple[Array, Array]:
    """A cargo's centre [m] and axes in what does not move with the orbiter."""
    centre, axes = posed(cargo)
    return centre + frame.work.orbiter, axes


def in_place(scenario: Scenario, frame: Frame, cargo: Cargo) -> tuple[Array, Array]:
    """A fixed cargo's centre [m] and axes against what it is fixed to."""
    (seat,) = (seat for seat in scenario.worksite.seats if seat.name == cargo.seat)
    return in_space(frame, cargo) if seat.frame == "space" else posed(cargo)


def moved(one: tuple[Array, Array], other: tuple[Array, Array]) -> tuple[float, float]:
    """How far apart two poses are [m], and how much they are turned [1]."""
    return float(np.linalg.norm(one[0] - other[0])), float(np.abs(one[1] - other[1]).max())


def check_possession(scenario: Scenario, frames: list[Frame]) -> None:
    """Every frame by itself, and every step by who had the payload before it."""
    names = [cargo.name for cargo in scenario.cargo]
    for frame in frames:
        check_frame(names, frame)
    for before, now in in_turn(frames):
        for was, is_now in zip(before.work.cargo, now.work.cargo, strict=True):
            check_step(scenario, before, now, was, is_now)


def check_frame(names: list[str], frame: Frame) -> None:
    """Each payload is there once; one at most is held, by the hand that says so; no seat holds two."""
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
    """A step's motion of a payload is that of what had it at the step's beginning."""
    period, where = scenario.control_period, f"{now.time_s} s: {was} to {is_now}"
    if was.seat:
        reach = 2.0 * period / LATCHES * PULLED
        way, turn = moved(in_place(scenario, before, was), in_place(scenario, now, _fixed_as(was, is_now)))
        assert way <= (reach if drawn(scenario, was) else EXACT) and turn <= max(reach, EXACT), where
        if not drawn(scenario, was):
            assert turn <= EXACT, where
    elif was.held:
        carriage = before.work.hand.carriage is not None
        way, turn = moved(in_hand(before, was), in_hand(now, is_now))
        share = 2.0 * period / CARRIAGE if carriage else 0.0
        assert way <= EXACT + share * PULLED and turn <= EXACT + share * TURNED, where
    else:
        (here, _), (there, _) = in_space(before, was), in_space(now, is_now)
        velocity = np.array(is_now.velocity) + np.subtract(now.work.orbiter, before.work.orbiter) / period
        assert there == pytest.approx(here + velocity * period, abs=EXACT), where


def drawn(scenario: Scenario, cargo: Cargo) -> bool:
    """Whether the seat that a cargo is in has latches that draw it in."""
    return any(seat.latch == "command" for seat in scenario.worksite.seats if seat.name == cargo.seat)


def _fixed_as(was: Cargo, is_now: Cargo) -> Cargo:
    """A cargo as it is, against the seat that it was in."""
    return Cargo(is_now.name, is_now.position, is_now.orientation, is_now.velocity, is_now.held, was.seat)
