"""The snare end effector: its envelope, the times and order of its sequences, and its log lines."""

from __future__ import annotations

import re
from math import pi, radians

import msgspec
import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from aftdeck.bodies.placed import rows_of
from aftdeck.bodies.pose import row_of
from aftdeck.frames import Pose, endori
from aftdeck.tuples import Rows, Vec3
from aftdeck.units import INCH
from aftdeck.worksite.capture.grapple import CaptureEnvelope, in_envelope
from aftdeck.worksite.capture.snare import Flags, Snare, SnareCommand, SnareTimes, advance, flags
from aftdeck.worksite.conditions import Condition, all_hold, failing
from aftdeck.worksite.draw_in import remaining
from aftdeck.worksite.log_line import LogLine

ENVELOPE = CaptureEnvelope(4.0 * INCH, -0.001, 4.0 * INCH, radians(10.0), radians(10.0), radians(10.0))
TIMES = SnareTimes(2.5, 7.0, 4.0)
AUTO, MAN, OFF = SnareCommand("AUTO"), SnareCommand("MAN"), SnareCommand("OFF")
Fixture = tuple[Vec3, Rows]


def near(position: Vec3 = (0.05, 0.0, 0.0), turn: NDArray[np.float64] | None = None) -> Fixture:
    return position, rows_of(np.eye(3) if turn is None else turn)


INSIDE = in_envelope(near(), ENVELOPE.packed)
BESIDE = in_envelope(near((0.05, 5.2 * INCH, 0.0)), ENVELOPE.packed)


def fly(
    snare: Snare,
    command: SnareCommand,
    seconds: float,
    dt: float = 0.02,
    conditions: tuple[Condition, ...] = (),
) -> tuple[Snare, list[LogLine]]:
    """Return the state and the log lines after steps of dt, with the trigger pressed in the first step."""
    lines: list[LogLine] = []
    for k in range(round(seconds / dt)):
        pressed = command if k == 0 else msgspec.structs.replace(command, trigger="")
        snare, more = advance(snare, TIMES, pressed, dt, conditions, "ft-in")
        lines += more
    return snare, lines


def capture(command: SnareCommand) -> SnareCommand:
    return msgspec.structs.replace(command, trigger="capture")


def release(command: SnareCommand) -> SnareCommand:
    return msgspec.structs.replace(command, trigger="release")


RIGID_PIN = fly(Snare(), capture(AUTO), 14.0, conditions=INSIDE)[0]


# --- the envelope


@pytest.mark.parametrize(
    ("name", "inside", "outside"),
    [
        ("pin off axis", near((0.05, 0.0, 3.999 * INCH)), near((0.05, 0.0, 4.001 * INCH))),
        ("pin depth", near((3.999 * INCH, 0.0, 0.0)), near((4.001 * INCH, 0.0, 0.0))),
        ("pin depth", near((0.0, 0.0, 0.0)), near((-0.002, 0.0, 0.0))),
        ("roll", near(turn=endori(radians(9.99), 0, 0)), near(turn=endori(radians(10.01), 0, 0))),
        ("pitch", near(turn=endori(0, radians(-9.99), 0)), near(turn=endori(0, radians(-10.01), 0))),
        ("yaw", near(turn=endori(0, 0, radians(9.99))), near(turn=endori(0, 0, radians(10.01)))),
    ],
)
def test_capture_envelope_ends_at_its_limits(name: str, inside: Fixture, outside: Fixture) -> None:
    assert all_hold(in_envelope(inside, ENVELOPE.packed))
    assert [condition.name for condition in failing(in_envelope(outside, ENVELOPE.packed))] == [name]


# --- the sequences


@pytest.mark.parametrize("dt", [0.001, 0.02, 0.037, 0.2, 3.0, 20.0])
def test_capture_and_release_durations_do_not_depend_on_the_step(dt: float) -> None:
    marks = {"captured": 2.5, "rigid": 13.5}
    snare, time = Snare(), 0.0
    for trigger, ends in (("capture", marks), ("release", {"released": 13.5})):
        times: dict[str, float] = {}
        time, command = 0.0, SnareCommand("AUTO", trigger=trigger)  # type: ignore[arg-type]
        while snare.motion or command.trigger:
            snare, lines = advance(snare, TIMES, command, dt, INSIDE, "ft-in")
            command, time = AUTO, time + dt
            times |= {line.kind: time for line in lines}
        assert times.keys() == ends.keys()
        for kind, end in ends.items():
            assert end - 1e-6 <= times[kind] < end + dt + 1e-6
    assert snare == Snare(met=True)


@settings(deadline=None, max_examples=60)
@given(st.floats(0.0, 14.0), st.integers(1, 400), st.sampled_from(["capture", "release"]))
def test_positions_of_snares_and_carriage_depend_only_on_time(time: float, steps: int, trigger: str) -> None:
    start = Snare() if trigger == "capture" else RIGID_PIN
    once = advance(start, TIMES, SnareCommand("AUTO", trigger=trigger), time, INSIDE, "ft-in").snare  # type: ignore[arg-type]
    many = advance(start, TIMES, SnareCommand("AUTO", trigger=trigger), 0.0, INSIDE, "ft-in").snare  # type: ignore[arg-type]
    for _ in range(steps):
        many = advance(many, TIMES, AUTO, time / steps, INSIDE, "ft-in").snare
    if trigger == "capture":
        ring, carriage, tension = (np.clip((time - a) / (b - a), 0, 1) for a, b in ((0, 2.5), (2.5, 9.5), (9.5, 13.5)))
    else:
        tension, carriage, ring = (
            np.clip((b - time) / (b - a), 0, 1) for a, b in ((0, 4.0), (4.0, 11.0), (11.0, 13.5))
        )
    for snare in (once, many):
        assert (snare.ring, snare.carriage, snare.tension) == pytest.approx((ring, carriage, tension), abs=1e-8)


def test_flags_follow_the_capture_sequence() -> None:
    assert flags(Snare()) == Flags(False, True, False, True, False, True)
    closing = fly(Snare(), capture(AUTO), 1.0, conditions=INSIDE)[0]
    assert flags(closing) == Flags(False, True, False, False, False, True)
    retracting = fly(Snare(), capture(AUTO), 5.0, conditions=INSIDE)[0]
    assert flags(retracting) == Flags(True, False, True, False, False, True)
    assert flags(RIGID_PIN) == Flags(True, False, True, False, True, False)
    derigidizing = fly(RIGID_PIN, release(AUTO), 2.0)[0]
    assert flags(derigidizing) == Flags(True, False, True, False, False, False)


def test_pin_stays_captured_until_the_snares_are_open() -> None:
    almost, lines = fly(RIGID_PIN, release(AUTO), 13.4)
    assert almost.captured and not lines
    free, lines = fly(almost, AUTO, 0.2)
    assert not free.captured
    assert [line.kind for line in lines] == ["released"]


def test_snares_that_miss_the_pin_log_it_and_stop() -> None:
    snare, lines = fly(Snare(), capture(AUTO), 20.0, conditions=BESIDE)
    (missed,) = lines
    assert missed.kind == "missed" and re.search(r"pin 5\.2 in .* 4 in", missed.text)
    assert flags(snare) == Flags(False, True, True, False, False, True)
    again, lines = fly(snare, capture(AUTO), 1.0, conditions=INSIDE)
    assert [line.kind for line in lines] == ["refused"]
    assert re.search("CAPTURE .*without the pin.*RELEASE", lines[0].text)
    opened, _ = fly(again, release(AUTO), 3.0)
    assert flags(opened) == flags(Snare())
    assert fly(opened, capture(AUTO), 3.0, conditions=INSIDE)[0].captured


def test_snares_that_close_far_from_any_fixture_log_it() -> None:
    (missed,) = fly(Snare(), capture(AUTO), 3.0)[1]
    assert missed.kind == "missed" and "no grapple fixture" in missed.text


def test_pin_that_leaves_while_the_snares_close_is_missed() -> None:
    snare, _ = fly(Snare(), capture(AUTO), 1.0, conditions=INSIDE)
    snare, lines = fly(snare, AUTO, 2.0, conditions=BESIDE)
    assert not snare.captured
    assert lines[0].kind == "missed" and re.search(r"left the envelope.*pin 5\.2 in", lines[0].text)


def test_pin_that_enters_while_the_snares_close_is_captured() -> None:
    snare, _ = fly(Snare(), capture(AUTO), 2.0, conditions=BESIDE)
    assert fly(snare, AUTO, 1.0, conditions=INSIDE)[0].captured


def test_man_mode_trigger_moves_only_the_snares() -> None:
    snare, lines = fly(Snare(), capture(MAN), 20.0, conditions=INSIDE)
    assert [line.kind for line in lines] == ["captured"]
    assert (snare.ring, snare.carriage, snare.tension) == (1.0, 0.0, 0.0)
    part, _ = fly(snare, SnareCommand("MAN", contr="RIGID"), 3.5)
    assert part.carriage == pytest.approx(0.5)
    rest, _ = fly(part, MAN, 5.0)
    assert rest == part
    rigid, lines = fly(rest, SnareCommand("MAN", contr="RIGID"), 7.6)
    assert flags(rigid).RIGID and [line.kind for line in lines] == ["rigid"]
    _, lines = fly(rigid, release(MAN), 1.0)
    assert [line.kind for line in lines] == ["refused"]
    assert re.search("RELEASE .*MAN CONTR DERIGID", lines[0].text)
    loose, _ = fly(rigid, SnareCommand("MAN", contr="DERIGID"), 11.1)
    assert flags(loose).EXTEND and flags(loose).DERIGID and loose.captured
    free, _ = fly(loose, release(MAN), 2.6)
    assert flags(free) == flags(Snare())


def test_off_stops_all_motion_and_rejects_the_trigger() -> None:
    part, _ = fly(Snare(), capture(AUTO), 5.0, conditions=INSIDE)
    stopped, _ = fly(part, OFF, 5.0)
    assert (stopped.carriage, stopped.motion) == (part.carriage, "")
    assert fly(stopped, AUTO, 5.0)[0] == stopped
    refused, lines = fly(stopped, release(OFF), 1.0)
    assert refused == stopped
    assert lines[0].kind == "refused" and re.search("RELEASE .*END EFFECTOR MODE is OFF", lines[0].text)
    # A second CAPTURE completes the sequence.
    assert flags(fly(stopped, capture(AUTO), 12.0)[0]).RIGID


def test_release_while_closing_opens_the_snares() -> None:
    closing, _ = fly(Snare(), capture(AUTO), 1.0, conditions=INSIDE)
    opened, lines = fly(closing, release(AUTO), 1.02)
    assert flags(opened) == flags(Snare()) and not lines


def test_release_when_open_and_capture_when_captured_are_rejected() -> None:
    for snare, command, pattern in (
        (Snare(), release(AUTO), "RELEASE .*already open"),
        (RIGID_PIN, capture(AUTO), "CAPTURE .*already captured"),
    ):
        after, (line,) = fly(snare, command, 0.02)
        assert after == snare
        assert line.kind == "refused" and re.search(pattern, line.text)


def test_snares_do_not_close_with_the_carriage_retracted() -> None:
    retracted, _ = fly(Snare(), SnareCommand("MAN", contr="RIGID"), 3.0)
    snare, lines = fly(retracted, capture(AUTO), 3.0, conditions=INSIDE)
    assert snare.ring == 0.0 and lines[0].kind == "refused" and re.search("CAPTURE .*carriage", lines[0].text)
    assert flags(fly(snare, release(AUTO), 12.0)[0]) == flags(Snare())


COMMANDS = st.builds(
    SnareCommand,
    st.sampled_from(["AUTO", "OFF", "MAN"]),
    st.sampled_from(["", "", "capture", "release"]),
    st.sampled_from(["RIGID", "OFF", "DERIGID"]),
)


@settings(deadline=None, max_examples=150)
@given(st.lists(st.tuples(COMMANDS, st.floats(0.0, 5.0), st.booleans()), max_size=30))
def test_only_the_snares_capture_or_release_a_pin_in_any_switch_order(
    steps: list[tuple[SnareCommand, float, bool]],
) -> None:
    snare = Snare()
    for command, dt, inside in steps:
        after, lines = advance(snare, TIMES, command, dt, INSIDE if inside else BESIDE, "ft-in")
        if after.captured and not snare.captured:
            assert inside and after.ring == 1.0 and "captured" in [line.kind for line in lines]
        if snare.captured and not after.captured:
            retracts_after = command.mode == "MAN" and command.contr == "RIGID"
            assert after.ring == 0.0 and (retracts_after or after.carriage == after.tension == 0.0)
        for part in (after.ring, after.carriage, after.tension):
            assert 0.0 <= part <= 1.0
        assert after.tension == 0.0 or after.carriage == 1.0
        assert snare.drawn <= after.drawn or not after.captured
        assert not after.captured or after.ring > 0.0
        if command.mode == "OFF":
            assert (after.ring, after.carriage, after.tension) == (snare.ring, snare.carriage, snare.tension)
        snare = msgspec.json.decode(msgspec.json.encode(after), type=Snare)  # a saved state is the encoded struct
        assert snare == after
    # From any state, RELEASE in AUTO frees the pin and makes the snares ready again.
    assert flags(fly(fly(snare, release(AUTO), 14.0)[0], AUTO, 0.02)[0]) == flags(Snare())


# --- alignment of the pin

OFFSETS = st.tuples(*[st.floats(-1.0, 1.0)] * 3).map(np.array)
TURNS = st.tuples(*[st.floats(-1.8, 1.8)] * 3).map(np.array)
"""Rotation vectors of less than half a turn [rad]."""


@settings(deadline=None)
@given(OFFSETS, TURNS, st.floats(0.0, 1.0))
@example(np.ones(3), np.array([pi, 0.0, 0.0]), 0.5)
@example(np.ones(3), np.array([0.0, pi, 0.0]), 0.5)
@example(np.ones(3), np.array([0.0, 0.0, pi]), 0.5)
@example(np.ones(3), np.zeros(3), 0.5)
def test_misalignment_shrinks_along_its_offset_and_about_its_axis(
    offset: NDArray[np.float64], vector: NDArray[np.float64], fraction: float
) -> None:
    found = np.empty(12)
    remaining(row_of(Pose(offset, Rotation.from_rotvec(vector).as_matrix())), fraction, found)
    assert found[:3] == pytest.approx(offset * fraction)
    assert found[3:].reshape(3, 3) == pytest.approx(Rotation.from_rotvec(vector * fraction).as_matrix(), abs=1e-12)


def test_pin_alignment_is_kept_when_the_carriage_extends() -> None:
    captured, _ = fly(Snare(), capture(MAN), 3.0, conditions=INSIDE)
    assert captured.misaligned == 1.0
    half, _ = fly(captured, SnareCommand("MAN", contr="RIGID"), 3.5)
    assert half.misaligned == pytest.approx(0.5)
    out, _ = fly(half, SnareCommand("MAN", contr="DERIGID"), 4.0)
    assert (out.carriage, out.misaligned) == (0.0, half.misaligned)
    assert RIGID_PIN.misaligned == 0.0
