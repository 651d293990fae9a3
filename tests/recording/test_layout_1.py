"""Recordings of layout 1 (Aftdeck 0.1) can be read and verified."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import msgspec
import pytest
from mcap.records import Channel
from mcap.records import Message as McapMessage
from mcap.stream_reader import StreamReader

from aftdeck.errors import RecordingError
from aftdeck.recording.format_1 import FramesOf1
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import FrameRecord
from aftdeck.recording.replay import verify
from aftdeck.simulation.frame import Frame, WayOut
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.motion.ways_out import by_joint, by_stick
from aftdeck.simulation.run import Simulation
from aftdeck.worksite.watch.alarm import level_of
from tests.each import each
from tests.recording.flown import rewritten

FILES = [
    Path(__file__).parent / "layout_1" / f"{name}.mcap" for name in ("concept-1972-script", "loaded", "srms-deploy")
]
BY_MODE_2 = {"concept-1972-script", "srms-deploy"}
"""Files with motions in mode 2, whose law has changed since: the tip may be a millimetre from its recorded position."""


def raw_frames(path: Path) -> list[dict[str, Any]]:
    """Return the frames in a file without conversion."""
    topics, found = {}, []
    with path.open("rb") as file:
        for record in StreamReader(file).records:
            if isinstance(record, Channel):
                topics[record.id] = record.topic
            elif isinstance(record, McapMessage) and topics[record.channel_id] == "/frames":
                found.append(msgspec.json.decode(record.data))
    return found


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_file_of_layout_1_verifies_by_its_values(path: Path) -> None:
    now: list[Frame] = []
    verdict = verify(path, stepped=lambda sim: now.append(sim.look()))
    assert not verdict.whole and not verdict.same_laws and verdict.frames > 200 and verdict.changes == ()
    assert verdict.equal or path.stem in BY_MODE_2
    for (_, before), after in zip(Recording(path).steps(), now, strict=True):
        assert after.position == pytest.approx(before.position, abs=1e-3)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_numbers_are_converted_unchanged(path: Path) -> None:
    for old, (_, frame) in zip(raw_frames(path), Recording(path).steps(), strict=True):
        assert list(frame.angles) == old["angles_rad"] and list(frame.position) == old["tip_m"]
        assert list(frame.resolution) == old["point_m"] and frame.wall_s == old["wall_s"]
        assert (frame.check.text if frame.check else "") == old["check"]
        assert [angle for view in frame.views for angle in view] == old["views"]
        assert (list(frame.payload.position) if frame.payload else None) == old["payload_m"]
        near = frame.work.nearest
        assert (near and near.clearance) == (old["work"]["nearest"] and old["work"]["nearest"]["clearance_m"])
        assert frame.work.hand.spacing == old["work"]["hand"]["spacing_m"]


def test_fields_missing_in_the_first_files_are_derived() -> None:
    path = next(path for path in FILES if path.stem == "srms-deploy")
    old, now, level = (
        FramesOf1(Recording(path).opening.joints, lambda: (0.5, 0.15)),
        [frame for _, frame in Recording(path).steps()],
        "info",
    )
    for written, frame in zip(raw_frames(path), now, strict=True):
        del written["work"]["clearance_level"], written["attached"], written["wrist_pitch"], written["times"]
        converted = old.frame(written)
        near = frame.work.nearest
        if near is not None:
            level = level_of(near.clearance, 0.5, 0.15, level)  # type: ignore[arg-type]
        assert converted["work"]["clearance_level"] == level and converted["attached"] == frame.attached
        assert converted["wrist_pitch"] is None


def test_file_is_read_without_loading_its_scenario_if_possible(tmp_path: Path) -> None:
    source = FILES[1]
    opening = Recording(source).opening
    other = msgspec.structs.replace(opening, scenario_text=f"gravity = 9.81\n{opening.scenario_text}")
    rewritten(source, tmp_path / "old.mcap", {"/opening": msgspec.json.encode(other)})
    frames = [frame for _, frame in Recording(source).steps()]
    assert [frame for _, frame in Recording(tmp_path / "old.mcap").steps()] == frames
    written = raw_frames(source)[0]
    del written["work"]["clearance_level"]
    rewritten(tmp_path / "old.mcap", tmp_path / "older.mcap", {"/frames": msgspec.json.encode(written)})
    with pytest.raises(RecordingError, match=r"older\.mcap: .*gravity"):
        list(Recording(tmp_path / "older.mcap").steps())


@pytest.mark.slow
@pytest.mark.parametrize("position", ["", "ORB UNL"])
@each("direction", range(12))
def test_escape_by_stick_is_read_from_its_text(direction: int, position: str) -> None:
    sim = Simulation("first-flight")
    sim.step(Inputs(mode="ORB UNL" if position == "" else "OPR CMD"))
    escape = by_stick(sim._state, "contact", direction)
    assert read(escape) == escape and escape.position == position


@pytest.mark.slow
@each("joint", range(6))
def test_escape_by_joint_or_telescope_is_read_from_its_text(joint: int) -> None:
    sim = Simulation("concept-1972")
    for sign in (-1, 1):
        escape = by_joint(sim._flight, "SINGLE", "contact", joint, sign)
        assert read(escape, sim.scenario.arm.joints) == escape
    for text, sign in (("telescope longer", 1), ("telescope shorter", -1)):
        escape = WayOut("contact", text, "telescope", 0, sign)
        assert read(escape) == escape


def read(escape: WayOut, joints: tuple[str, ...] = ()) -> WayOut:
    """Write an escape direction into a frame of layout 1, as one of the inhibit reasons; return it as converted."""
    recording = Recording(FILES[0])
    written = raw_frames(FILES[0])[0]
    written["work"]["inhibits"] = ["palm touches bar", f"way out: {escape.text}"]
    frame = FramesOf1(joints or recording.opening.joints, lambda: (0.5, 0.15)).frame(written)
    assert frame["work"]["inhibits"] == ["palm touches bar"]
    return msgspec.convert(frame["ways_out"][-1], WayOut)


@pytest.mark.parametrize(
    ("field", "value"),
    [("goal", "there"), ("check", 7), ("views", 3), ("tip_rotation", [0.0, 0.0, 0.0, 0.0]), ("work", {})],
)
def test_invalid_frame_is_damage(tmp_path: Path, field: str, value: object) -> None:
    source = FILES[1]
    rewritten(source, tmp_path / "odd.mcap", {"/frames": msgspec.json.encode({**raw_frames(source)[0], field: value})})
    with pytest.raises(RecordingError, match="/frames") as caught:
        list(Recording(tmp_path / "odd.mcap").messages())
    assert caught.value.fault == "damaged"


def test_layout_2_is_written() -> None:
    assert {"angles", "position", "orientation", "payload"} <= set(FrameRecord.__struct_fields__)
