"""PULSE in a session: what a pulse moves, in closed form, and what ends it."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable

import numpy as np
import pytest

from aftdeck.errors import CommandError
from aftdeck.station.core.pulses import ANGLE, DISTANCE, MOST
from aftdeck.station.messages import from_page
from aftdeck.station.messages.frame import Frame
from aftdeck.station.session.session import Session
from aftdeck.tuples import Vec3
from tests.loaded import scenario
from tests.station.flying import Flown, flying, shown, steps

NONE: Vec3 = (0.0, 0.0, 0.0)
LONG = 400
"""Steps in which a pulse comes to rest, also with the heaviest built-in payload."""


def along(axis: int, sign: float = 1.0) -> Vec3:
    x, y, z = (sign if k == axis else 0.0 for k in range(3))
    return x, y, z


def pulse(
    session: Session, translation: Vec3 = NONE, rotation: Vec3 = NONE, drive: float = 0.0, orbiter: Vec3 = NONE
) -> None:
    session.accept(from_page.Pulse(0, translation, rotation, drive, 0.0, orbiter))
    steps(session, 1)


def enter(session: Session, mode: str, rate: str = "vernier", *, hold: bool = False) -> Frame:
    session.accept(from_page.EnterMode(0, mode))
    session.accept(from_page.SelectRate(0, "coarse" if rate == "coarse" else "vernier"))
    session.accept(from_page.PositionHold(0, hold))
    frame = steps(session, 10)
    assert frame.mode == mode
    return frame


def point(frame: Frame) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    """Return the point of resolution in L: the payload's centre in ORB LD, which has no offset here, else the tip."""
    assert frame.payload is not None or frame.mode != "ORB LD"
    return np.array(frame.payload[0] if frame.payload is not None and frame.mode == "ORB LD" else frame.position)


@pytest.mark.parametrize("hold", [False, True])
@pytest.mark.parametrize("rate", ["coarse", "vernier"])
@pytest.mark.parametrize(
    ("name", "mode"),
    [("first-flight", "ORB UNL"), ("first-flight", "END EFF"), ("srms-berth", "ORB LD"), ("concept-1972", "ORB UNL")],
)
def test_pulse_moves_the_point_by_its_distance(name: str, mode: str, rate: str, hold: bool) -> None:
    with flying(made=scenario(name)) as session:
        before = enter(session, mode, rate, hold=hold)
        pulse(session, along(0))
        after = steps(session, LONG)
        assert np.linalg.norm(point(after) - point(before)) == pytest.approx(DISTANCE, rel=1e-3)
        assert not any((*after.translation, *after.rotation))


@pytest.mark.parametrize("mode", ["SINGLE", "DIRECT"])
def test_pulse_turns_the_selected_joint_by_its_angle(mode: str) -> None:
    with flying() as session:
        before = enter(session, mode)
        pulse(session, drive=-1.0)
        after = steps(session, LONG)
        turned = np.subtract(after.angles, before.angles)
        assert turned[before.joint] == pytest.approx(-ANGLE, rel=1e-3)
        assert np.abs(np.delete(turned, before.joint)).max() < 1e-9


def test_pulse_turns_the_end_effector_by_its_angle_about_its_place() -> None:
    with flying() as session:
        before = enter(session, "END EFF")
        pulse(session, rotation=along(2))
        after = steps(session, LONG)
        turn = np.array(after.orientation) @ np.array(before.orientation).T
        assert math.sqrt(max(3.0 - float(np.trace(turn)), 0.0)) == pytest.approx(ANGLE, rel=1e-2)  # 2 - 2 cos = angle²
        assert np.allclose(before.position, after.position, atol=1e-5)


def test_pulses_add_up_and_opposite_ones_cancel() -> None:
    with flying() as session:
        before = enter(session, "ORB UNL")
        for sign in (1.0, 1.0, -1.0, 1.0, 1.0):
            pulse(session, along(1, sign))
        after = steps(session, 2 * LONG)
        assert np.linalg.norm(point(after) - point(before)) == pytest.approx(3 * DISTANCE, rel=1e-3)


def test_pulse_of_the_orbiter_moves_it_by_its_distance() -> None:
    with flying(made=scenario("free-flyer")) as session:
        before = np.array(shown(session).work.orbiter)
        pulse(session, orbiter=along(0))
        assert np.linalg.norm(np.array(steps(session, LONG).work.orbiter) - before) == pytest.approx(DISTANCE, rel=0.05)


@pytest.mark.parametrize(
    "end",
    [
        lambda session: session.accept(from_page.Stop(0)),
        lambda session: session.accept(from_page.EnterMode(0, "END EFF")),
        lambda session: session.set_unattended(),
        lambda session: session.desk.hand_over("given"),
        lambda session: session.accept(from_page.Restart(0)),
    ],
    ids=["stop", "mode", "unattended", "hand over", "restart"],
)
def test_what_takes_the_sticks_away_ends_all_pulses(end: Callable[[Flown], None]) -> None:
    with flying() as session:
        enter(session, "ORB UNL")
        pulse(session, along(0))
        assert any(steps(session, 3).translation)
        end(session)
        assert not any(steps(session, 2).translation)
        assert not any(steps(session, 100).translation)


def test_deflected_stick_ends_pulses_of_other_axes() -> None:
    with flying() as session:
        enter(session, "ORB UNL")
        pulse(session, along(0))
        session.accept(from_page.Sticks(1, (0.0, 0.5, 0.0), NONE, 0.0))
        assert steps(session, 1).translation == (0.0, 0.5, 0.0)
        session.accept(from_page.Sticks(2, NONE, NONE, 0.0))
        assert not any(steps(session, 1).translation)


def test_silent_page_leaves_no_stick_deflected_after_its_pulse() -> None:
    with flying() as session:
        enter(session, "ORB UNL")
        pulse(session, along(0))
        session.now += 60.0
        assert not any(steps(session, LONG).translation)


@pytest.mark.parametrize("mode", ["OPR CMD", "MASTER"])
def test_pulse_is_refused_where_the_sticks_do_not_act(mode: str) -> None:
    with flying() as session:
        enter(session, mode)
        pulse(session, along(0))
        assert [event.kind for event in session.log.since(0)][-1] == "refused"
        assert not any(steps(session, 5).translation)


def test_rate_hold_keeps_its_rates_and_refuses_a_pulse() -> None:
    with flying() as session:
        enter(session, "ORB UNL")
        session.accept(from_page.Sticks(1, (0.5, 0.0, 0.0), NONE, 0.0))
        session.accept(from_page.RateHold(0))
        steps(session, 2)
        session.accept(from_page.Sticks(2, NONE, NONE, 0.0))
        pulse(session, along(1))
        assert [event.kind for event in session.log.since(0)][-1] == "refused"


def test_pulses_that_wait_are_limited() -> None:
    with flying() as session:
        enter(session, "ORB UNL")
        for _ in range(MOST + 2):
            pulse(session, along(0))
        refused = [event for event in session.log.since(0) if event.kind == "refused"]
        assert 1 <= len(refused) <= 2


@pytest.mark.parametrize("part", [0.5, 2.0, math.nan])
def test_pulse_of_another_size_is_rejected(part: float) -> None:
    with flying() as session, pytest.raises(CommandError):
        session.accept(from_page.Pulse(0, (part, 0.0, 0.0), NONE, 0.0, 0.0, NONE))


def test_pulse_through_a_command_delay_has_the_same_distance() -> None:
    with flying(made=dataclasses.replace(scenario(), delay=25)) as session:
        before = steps(session, 60)
        pulse(session, along(2))
        assert np.linalg.norm(point(steps(session, LONG)) - point(before)) == pytest.approx(DISTANCE, rel=1e-3)
