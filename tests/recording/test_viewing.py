"""Channels in Foxglove's schemas."""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial.transform import RigidTransform, Rotation

from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.frame import Frame
from aftdeck.station.conversion.frame_of import Displays
from aftdeck.station.conversion.welcome_of import welcome_of
from tests.recording.flights import NOTE, Decoded, read, record_random_sticks

ROUNDING = 1e-4
"""Greatest error of a pose that is composed of the rounded poses of several links [m, rad]."""

SCHEMAS = {
    "/tf": "foxglove.FrameTransforms",
    "/tf_static": "foxglove.FrameTransforms",
    "/scene": "foxglove.SceneUpdate",
    "/joints": "foxglove.JointStates",
    "/joints/commanded": "foxglove.JointStates",
    "/tip": "foxglove.PoseInFrame",
    "/log": "foxglove.Log",
}


CONCEPT = """title = "the concept arm with a payload, none of them drawn"
arm = "concept-1972"

[initial]
joints = ["20 deg", "60 deg", "-100 deg", "5 deg", "-30 deg", "10 deg"]

[payload]
mass = "15000 lb"
position = [0, 0, 1.5]
"""


class RecordedRun(NamedTuple):
    scenario: str
    frames: list[Frame]
    topics: dict[str, list[Decoded]]


@pytest.fixture(scope="module", params=["loaded", "concept"])
def recorded(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> RecordedRun:
    folder: Path = tmp_path_factory.mktemp("viewing")
    path, name = folder / "run.mcap", str(request.param)
    if name == "concept":
        name = str(folder / "concept.toml")
        Path(name).write_text(CONCEPT)
    return RecordedRun(name, record_random_sticks(name, path, 203), read(path))


def stamp(content: dict[str, Any]) -> int:
    time = content["timestamp"]
    return int(time["seconds"] * 1_000_000_000 + time["nanos"])


def transform(position: dict[str, float], turn: dict[str, float]) -> RigidTransform:
    rotation = Rotation.from_quat([turn[k] for k in "xyzw"])
    return RigidTransform.from_components(np.array([position[k] for k in "xyz"]), rotation)


def tree(*messages: Decoded) -> dict[str, tuple[str, RigidTransform]]:
    return {
        t["child_frame_id"]: (t["parent_frame_id"], transform(t["translation"], t["rotation"]))
        for message in messages
        for t in message.content["transforms"]
    }


def in_root(frames: dict[str, tuple[str, RigidTransform]], name: str) -> RigidTransform:
    pose = RigidTransform.identity()
    while name in frames:
        name, own = frames[name]
        pose = own * pose
    assert name == "scene"
    return pose


def drawn_frames(recorded: RecordedRun) -> list[tuple[Frame, int]]:
    return [(frame, i) for i, frame in enumerate(recorded.frames[::5])]


def test_channels_have_foxgloves_schemas(recorded: RecordedRun) -> None:
    for topic, schema in SCHEMAS.items():
        assert {(m.schema, m.encoding) for m in recorded.topics[topic]} == {(schema, "protobuf")}


def test_moving_quantities_are_sent_ten_times_a_second(recorded: RecordedRun) -> None:
    for topic in ("/tf", "/joints", "/joints/commanded", "/tip"):
        assert len(recorded.topics[topic]) == 41
    assert len(recorded.topics["/tf_static"]) == len(recorded.topics["/scene"]) == 1


def test_times_are_those_of_the_frames(recorded: RecordedRun) -> None:
    began = recorded.topics["/opening"][0].time_ns
    for topic in ("/joints", "/tip", "/joints/commanded"):
        for (frame, _), message in zip(drawn_frames(recorded), recorded.topics[topic], strict=True):
            assert message.time_ns == began + round(frame.time_s * 1e9)
            assert stamp(message.content) == message.time_ns
    for message in recorded.topics["/tf"]:
        assert {stamp(t) for t in message.content["transforms"]} == {message.time_ns}


def test_joints_are_the_frames_joints(recorded: RecordedRun) -> None:
    names = list(load_scenario(recorded.scenario).arm.joints)
    for (frame, _), measured, commanded in zip(
        drawn_frames(recorded), recorded.topics["/joints"], recorded.topics["/joints/commanded"], strict=True
    ):
        for message, angles, rates in (
            (measured, frame.angles, frame.rates),
            (commanded, frame.angles_commanded, frame.rates_commanded),
        ):
            joints = message.content["joints"]
            assert [joint["name"] for joint in joints] == names
            assert [joint["position"] for joint in joints] == pytest.approx(angles, abs=ROUNDING)
            assert [joint["velocity"] for joint in joints] == pytest.approx(rates, abs=ROUNDING)


def same(pose: RigidTransform, seven: NDArray[np.float64]) -> None:
    assert pose.translation == pytest.approx(seven[:3], abs=ROUNDING)
    turned = pose.rotation * Rotation.from_quat(seven[[4, 5, 6, 3]]).inv()
    assert turned.magnitude() == pytest.approx(0.0, abs=ROUNDING)


def test_every_body_has_the_pose_that_the_page_draws(recorded: RecordedRun) -> None:
    displays = Displays(load_scenario(recorded.scenario))
    names = [body.name for body in welcome_of(load_scenario(recorded.scenario), demo=False).bodies]
    assert ("payload" in names) == (recorded.scenario == "loaded")  # in concept.toml the payload has no shape
    for (frame, _), message in zip(drawn_frames(recorded), recorded.topics["/tf"], strict=True):
        frames = tree(recorded.topics["/tf_static"][0], message)
        assert set(frames) == {*names, "payload", "L", "tip"}
        assert frame.payload is not None
        held = (in_root(frames, "L").inv() * in_root(frames, "payload")).as_matrix()
        assert held[:3, 3] == pytest.approx(frame.payload[0], abs=ROUNDING)
        assert held[:3, :3] == pytest.approx(np.array(frame.payload[1]), abs=ROUNDING)
        poses = np.array(displays.frame(frame, -1).display.poses).reshape(-1, 7)
        for name, seven in zip(names, poses, strict=True):
            same(in_root(frames, name), seven)


def test_tip_is_sent_as_a_pose_in_L_and_as_a_coordinate_frame(recorded: RecordedRun) -> None:
    for (frame, i), message in zip(drawn_frames(recorded), recorded.topics["/tip"], strict=True):
        assert message.content["frame_id"] == "L"
        shown = message.content["pose"]
        pose = transform(shown["position"], shown["orientation"])
        assert pose.translation == pytest.approx(frame.position, abs=ROUNDING)
        assert pose.rotation.as_matrix() == pytest.approx(np.array(frame.orientation), abs=ROUNDING)
        frames = tree(recorded.topics["/tf_static"][0], recorded.topics["/tf"][i])
        offset = (in_root(frames, "L") * pose).inv() * in_root(frames, "tip")
        assert offset.as_exp_coords() == pytest.approx(np.zeros(6), abs=ROUNDING)


def test_log_has_every_event_and_note(recorded: RecordedRun) -> None:
    levels = {"info": 2, "caution": 3, "warning": 4}
    lines = [
        (
            m.content["level"],
            m.content["name"],
            m.content["message"],
            m.time_ns - recorded.topics["/opening"][0].time_ns,
        )
        for m in recorded.topics["/log"]
    ]
    events = [
        (levels[e.level], e.kind, e.text, round(frame.time_s * 1e9)) for frame in recorded.frames for e in frame.events
    ]
    note = (3, "hand", NOTE, round(recorded.frames[-1].time_s * 1e9))
    assert events
    assert lines == [*events, note]


def test_scene_has_every_body_in_a_coordinate_frame_that_is_sent(recorded: RecordedRun) -> None:
    (message,) = recorded.topics["/scene"]
    entities = message.content["entities"]
    frames = tree(recorded.topics["/tf_static"][0], recorded.topics["/tf"][0])
    assert all(entity["frame_id"] == entity["id"] and entity["frame_locked"] for entity in entities)
    named = {entity["frame_id"] for entity in entities}
    assert named <= set(frames) - {"L", "tip"} and set(frames) - named <= {"L", "tip", "payload"}
    assert ("payload" in named) == (recorded.scenario == "loaded")
