"""Berthing: the guides in closed form, the ready-to-latch conditions, the latches' times, and retention."""

from __future__ import annotations

from math import radians, tan

import msgspec
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from aftdeck.arrays import Array
from aftdeck.bodies.pose import HERE, row_of
from aftdeck.errors import InputError
from aftdeck.frames import Pose, rotation_x, rotation_y, rotation_z
from aftdeck.units import INCH
from aftdeck.worksite.berths.berthing import (
    OFFSET,
    BerthTolerances,
    Guide,
    in_guides,
    offsets,
    prepare,
    ready_to_latch,
    retained,
    switches,
)
from aftdeck.worksite.berths.latches import Latches, advance
from aftdeck.worksite.conditions import Condition, all_hold, condition_text, failing, rejection_text
from aftdeck.worksite.log_line import LogLine

TOLERANCES = BerthTolerances(0.05, radians(1.0))
HEIGHT, HALF_ANGLE, THROAT, PLAY = 24.0 * INCH, radians(17.0), 0.02, 0.05
PORT = Guide("forward port", (1.0, -2.386, 0.36), (0.0, 0.0, 1.0), (1.0, 0.0, 0.0), HALF_ANGLE, HEIGHT, THROAT, PLAY)
STARBOARD = msgspec.structs.replace(PORT, name="aft starboard", seat=(4.0, 2.386, 0.36))
KEEL = msgspec.structs.replace(PORT, name="keel", seat=(2.0, 0.0, -2.41), along=(0.0, 1.0, 0.0))
GUIDES = prepare([PORT, STARBOARD, KEEL])
TRUNNIONS = np.array([PORT.seat, STARBOARD.seat, KEEL.seat]) - np.array([2.5, 0.0, 0.0])
"""Positions of the trunnions in the payload's frame; the centre of the stowed payload is at x = 2.5 m."""
STOWED = Pose(np.array([2.5, 0.0, 0.0]), np.eye(3))


def payload(offset: tuple[float, float, float] = (0.0, 0.0, 0.0), turn: Array | None = None) -> tuple[Array, Array]:
    """Return the trunnions' offsets from their seats, and the payload's pose relative to its stowed pose."""
    left = Pose(np.array(offset), np.eye(3) if turn is None else turn)
    at, found = row_of(Pose(STOWED.position + left.position, left.rotation)), np.empty((len(TRUNNIONS), OFFSET))
    offsets(np.array(HERE), at, TRUNNIONS, GUIDES.seats, GUIDES.axes, found)
    return found, row_of(left)


def ready(offset: tuple[float, float, float] = (0.0, 0.0, 0.0), turn: Array | None = None) -> tuple[Condition, ...]:
    trunnions, left = payload(offset, turn)
    return ready_to_latch(trunnions, left, GUIDES, TOLERANCES)


# --- guides


@settings(deadline=None)
@given(st.floats(-0.2, 0.8), st.floats(-0.4, 0.4), st.floats(-0.1, 0.1))
def test_trunnion_is_in_its_guide_within_the_v_and_the_play(up: float, along: float, across: float) -> None:
    trunnions, _ = payload((along, across, up))
    found = in_guides(trunnions, GUIDES)
    in_v = 0.0 <= up <= HEIGHT and abs(across) <= PLAY and abs(along) <= THROAT + max(up, 0.0) * tan(HALF_ANGLE)
    keel = 0.0 <= up <= HEIGHT and abs(along) <= PLAY and abs(across) <= THROAT + max(up, 0.0) * tan(HALF_ANGLE)
    edge = min(abs(condition.margin) for condition in found)
    if edge > 1e-12:
        assert [condition.holds for condition in found] == [in_v, in_v, keel]


def test_guide_reports_its_tightest_condition() -> None:
    trunnions, _ = payload((0.15, 0.0, 0.1))
    forward, _, keel = failing(in_guides(trunnions, GUIDES))
    room = THROAT + 0.1 * tan(HALF_ANGLE)
    assert forward.name == "forward port trunnion in guide" and keel.name == "keel trunnion in guide"
    assert (forward.value, forward.limit) == pytest.approx((0.15, room))
    assert (keel.value, keel.limit) == pytest.approx((-0.15, -PLAY))
    assert condition_text(forward, "SI") == (
        f"forward port trunnion 150 mm from its guide's middle, at most {room * 1e3:.3g} mm allowed"
    )
    below, _ = payload((0.0, 0.0, -0.01))
    lowest = in_guides(below, GUIDES)[0]
    assert not lowest.holds and (lowest.value, lowest.limit) == pytest.approx((-0.01, 0.0))


def test_guide_with_oblique_directions_is_rejected() -> None:
    with pytest.raises(InputError, match="guide 'keel'"):
        prepare([PORT, msgspec.structs.replace(KEEL, along=(0.0, 0.9, 0.1))])


# --- ready to latch


@settings(deadline=None)
@given(st.tuples(*[st.floats(-0.06, 0.06)] * 3), st.floats(-0.02, 0.02), st.sampled_from("xyz"))
def test_payload_is_ready_within_distance_and_angle_tolerances(
    offset: tuple[float, float, float], angle: float, axis: str
) -> None:
    turn = {"x": rotation_x, "y": rotation_y, "z": rotation_z}[axis](angle)
    off = [float(np.linalg.norm(turn @ t + offset - t)) for t in TRUNNIONS]
    expected = max(off) <= 0.05 and abs(angle) <= radians(1.0)
    if min(abs(max(off) - 0.05), abs(abs(angle) - radians(1.0))) > 1e-9:
        assert all_hold(ready(offset, turn)) == expected
        trunnions, _ = payload(offset, turn)
        assert switches(trunnions, GUIDES, TOLERANCES) == tuple((d <= 0.05, d <= 0.05) for d in off)


def test_failed_switch_prevents_ready_to_latch() -> None:
    trunnions, left = payload()
    found = ready_to_latch(trunnions, left, GUIDES, TOLERANCES, frozenset({"keel B"}))
    (failed,) = failing(found)
    assert failed.name == "keel latch ready" and (failed.value, failed.limit) == (1.0, 2.0)
    assert "keel latch: switch B" in rejection_text("LATCH", found, "SI")
    assert switches(trunnions, GUIDES, TOLERANCES, frozenset({"keel B"})) == ((True, True), (True, True), (True, False))


@settings(deadline=None)
@given(st.floats(0.0, 0.1), st.floats(0.0, 0.03))
def test_payload_released_near_its_stowed_pose_is_retained(distance: float, angle: float) -> None:
    left = Pose(np.array([0.0, 0.6 * distance, -0.8 * distance]), rotation_y(angle))
    found = retained(row_of(left), TOLERANCES)
    if min(abs(distance - 0.05), abs(angle - radians(1.0))) > 1e-9:
        assert all_hold(found) == (distance <= 0.05 and angle <= radians(1.0))


# --- latches


def fly(
    latches: Latches, command: str, seconds: float, dt: float = 0.02, conditions: tuple[Condition, ...] = ()
) -> tuple[Latches, list[LogLine]]:
    lines: list[LogLine] = []
    for k in range(round(seconds / dt)):
        latches, more = advance(latches, 30.0, command if k == 0 else "", dt, conditions, "SI")  # type: ignore[arg-type]
        lines += more
    return latches, lines


@pytest.mark.parametrize("dt", [0.001, 0.02, 0.7, 100.0])
def test_latching_takes_30_s_with_any_step(dt: float) -> None:
    latches, seated = Latches(), ready()
    for command, kind in (("latch", "latched"), ("unlatch", "unlatched")):
        elapsed = 0.0
        lines: tuple[LogLine, ...] = ()
        pressed = command
        while not lines:
            latches, lines = advance(latches, 30.0, pressed, dt, seated, "SI")  # type: ignore[arg-type]
            pressed, elapsed = "", elapsed + dt
        assert [line.kind for line in lines] == [kind]
        assert 30.0 - 1e-6 <= elapsed < 30.0 + dt + 1e-6
    assert latches == Latches()


def test_closing_latches_align_the_payload_and_hold_it_until_open() -> None:
    half, _ = fly(Latches(), "latch", 15.0, conditions=ready((0.03, 0.0, 0.0)))
    assert half.hold and half.misaligned == pytest.approx(0.5)
    back, _ = fly(half, "unlatch", 10.0)
    assert back.hold and back.closed == pytest.approx(1.0 / 6.0) and back.misaligned == half.misaligned
    shut, _ = fly(back, "latch", 30.0)  # a held payload needs no new ready-to-latch test
    assert shut.closed == 1.0 and shut.misaligned == 0.0
    opened, lines = fly(shut, "unlatch", 29.9)
    assert opened.hold and not lines
    opened, lines = fly(opened, "", 0.2)
    assert opened == Latches() and [line.kind for line in lines] == ["unlatched"]


@pytest.mark.parametrize(
    ("latches", "command", "conditions", "text"),
    [
        (
            Latches(),
            "latch",
            ready((0.0, 0.0, 0.08)),
            "LATCH refused: forward port trunnion 80 mm from its seat, at most 50 mm allowed; aft starboard trunnion "
            "80 mm from its seat, at most 50 mm allowed; keel trunnion 80 mm from its seat, at most 50 mm allowed",
        ),
        (Latches(), "latch", (), "LATCH refused: no payload is at the latches"),
        (Latches(1.0, 1.0), "latch", ready(), "LATCH refused: the latches are already closed"),
        (Latches(), "unlatch", ready(), "UNLATCH refused: the latches are already released"),
    ],
)
def test_rejected_latch_command_logs_the_reason(
    latches: Latches, command: str, conditions: tuple[Condition, ...], text: str
) -> None:
    after, lines = fly(latches, command, 0.02, conditions=conditions)
    assert after == latches
    assert [line.text for line in lines] == [text]


@settings(deadline=None)
@given(st.lists(st.tuples(st.sampled_from(["", "latch", "unlatch"]), st.floats(0.0, 40.0), st.booleans()), max_size=20))
def test_latches_start_to_close_only_on_a_ready_payload(steps: list[tuple[str, float, bool]]) -> None:
    latches = Latches()
    for command, dt, near in steps:
        conditions = ready() if near else ready((0.0, 0.0, 0.08))
        after, lines = advance(latches, 30.0, command, dt, conditions, "SI")  # type: ignore[arg-type]
        if after.hold and not latches.hold:
            assert command == "latch" or latches.motion == "latch"
            assert near or latches.motion == "latch"
        assert 0.0 <= after.closed <= 1.0 and abs(after.closed - latches.closed) <= dt / 30.0 + 1e-8
        assert ("latched" in [line.kind for line in lines]) == (after.closed == 1.0 > latches.closed)
        latches = msgspec.json.decode(msgspec.json.encode(after), type=Latches)
        assert latches == after
