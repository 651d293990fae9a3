"""Numbers of an exported flight: flown again, they give the recorded flight, bit for bit."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise, repeat
from pathlib import Path

import msgspec
import numpy as np
import pytest

from aftdeck.errors import InputError, RecordingError
from aftdeck.export.about import read_about, read_episode, write_about, write_episode
from aftdeck.export.flight import read_flight
from aftdeck.export.pictures import Painter, names_of, usual_cameras
from aftdeck.export.plan import plan
from aftdeck.export.replay import fly, fly_episode, replays
from aftdeck.export.samples import samples
from aftdeck.export.state import StateReader, in_state
from aftdeck.export.written import about_of, episode_of, new_folder, numbers_of
from aftdeck.recording.codec import encode
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import Input
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.inputs import Inputs
from tests.export.runs import STEPS, busy, by_hand, by_script_then_hand
from tests.recording.flown import bay, record_steps, rewritten

RUNS = [by_hand, by_script_then_hand]


@pytest.fixture
def run(tmp_path: Path) -> Path:
    return by_hand(tmp_path / "run.mcap")


@pytest.mark.parametrize("made", RUNS)
@pytest.mark.parametrize("fps", [50.0, 10.0, 12.5])
def test_inputs_of_a_dataset_give_the_recorded_flight(made: Callable[[Path], Path], fps: float, tmp_path: Path) -> None:
    flight = read_flight(made(tmp_path / "run.mcap"))
    assert flight.frames_sha256 == flight.recording.frames_sha256 != ""
    chosen = plan([flight], fps=fps)
    numbers = numbers_of(flight, chosen)
    episode = episode_of(flight, chosen, numbers, success=False)
    assert episode.inputs_equal and episode.inputs_apart_m < 1e-8
    assert len(numbers.action) == episode.samples == -(-STEPS // chosen.per_sample)


def test_dataset_flies_without_its_recording(run: Path, tmp_path: Path) -> None:
    flight = read_flight(run)
    chosen = plan([flight])
    numbers = numbers_of(flight, chosen)
    folder = tmp_path / "about"
    write_about(folder, about_of(chosen))
    write_episode(folder, 0, episode_of(flight, chosen, numbers, success=False), flight.recording.opening)
    run.unlink()
    inputs = numbers.inputs.reshape(len(numbers.inputs), -1)
    assert replays(folder, 0, inputs)
    assert read_about(folder) == about_of(chosen)
    assert read_episode(folder, 0)[1] == flight.recording.opening
    changed = inputs.copy()
    changed[2, 0] = np.nextafter(changed[2, 0], 2.0)
    assert not replays(folder, 0, changed), "one bit of one stick"
    assert fly_episode(folder, 0, numbers.action, "action").tips.shape == (STEPS, 3)
    with pytest.raises(InputError, match="got shape"):
        fly_episode(folder, 0, inputs[:, :3])
    with pytest.raises(InputError, match="episode-000001"):
        fly_episode(folder, 1, inputs)


def test_action_and_inputs_of_the_same_shape_are_not_confused(run: Path, tmp_path: Path) -> None:
    flight = read_flight(run)
    names = plan([flight]).inputs
    chosen = plan([flight], fps=50.0, columns=names[::-1])
    numbers = numbers_of(flight, chosen)
    write_about(tmp_path / "about", about_of(chosen))
    episode = episode_of(flight, chosen, numbers, success=False)
    write_episode(tmp_path / "about", 0, episode, flight.recording.opening)
    assert replays(tmp_path / "about", 0, numbers.inputs.reshape(STEPS, -1))
    assert replays(tmp_path / "about", 0, numbers.action, "action")


def test_recording_that_grows_meanwhile_gives_the_samples_of_what_was_read(run: Path) -> None:
    flight = read_flight(run)
    part = replace(flight, inputs=flight.inputs[:12], tips=flight.tips[:12], records=flight.records[:12])
    found = list(samples(part, 5, None))
    assert [sample.done for sample in found] == [False, False, True]
    assert len(numbers_of(part, plan([part])).action) == len(found)


def test_folder_of_another_process_is_not_touched(tmp_path: Path) -> None:
    folder = tmp_path / "set-v0"
    with pytest.raises(InputError, match="exists already"), new_folder(folder) as made:
        made.mkdir()
        folder.mkdir()
        (folder / "theirs").touch()
    assert [path.name for path in tmp_path.iterdir()] == ["set-v0"] and (folder / "theirs").exists()


def test_actions_that_float32_holds_give_the_recorded_flight(tmp_path: Path) -> None:
    steady = (Inputs(translation=(0.5, -0.25, 0.0), rate="coarse" if k == 0 else None) for k in range(30))
    record_steps(tmp_path / "run.mcap", bay(), steady, 30)
    flight = read_flight(tmp_path / "run.mcap")
    chosen = plan([flight])
    episode = episode_of(flight, chosen, numbers_of(flight, chosen), success=False)
    assert episode.action_equal and episode.action_apart_m is not None and episode.action_apart_m < 1e-8


def test_action_of_a_sample_has_its_last_sticks_and_every_switch(run: Path) -> None:
    flight = read_flight(run)
    encoding, actions = flight.encoding, flight.actions(5)
    columns = dict(zip(encoding.names, actions.T, strict=True))
    assert columns["rate"].tolist() == [-1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    assert columns["mode"][0] > 0.0 and columns["mode"][5] > 0.0
    last = [step.translation for step in _inputs(run)][4::5]
    assert actions[:6, :3].tolist() == [list(sticks) for sticks in last]


def _inputs(run: Path) -> list[Input]:
    return [message for message in Recording(run).messages() if isinstance(message, Input)]


def test_samples_see_what_was_before_and_after(run: Path) -> None:
    flight = read_flight(run)
    frames = [frame for _, frame in Recording(run).steps()]
    found = list(samples(flight, 5, None))
    assert [sample.done for sample in found] == [False] * 6 + [True]
    tip = StateReader(flight.scenario).names.index("tip_x")
    then = [sample.then.state[tip : tip + 3].tolist() for sample in found]
    recorded = [np.array(frames[min(k, STEPS) - 1].position, np.float32).tolist() for k in range(5, STEPS + 5, 5)]
    assert then == recorded
    for sample, following in pairwise(found):
        assert sample.then is following.seen


def test_state_has_a_name_for_each_number(run: Path) -> None:
    flight = read_flight(run)
    names = StateReader(flight.scenario).names
    assert len(set(names)) == len(names) == next(samples(flight, 5, None)).seen.state.size
    assert {name for reading in in_state() for name in names if name.startswith(reading.state)} == set(names)


def test_completed_script_is_a_success_once(tmp_path: Path) -> None:
    made = bay('[[phase]]\nmode = "ORB UNL"\nduration = 0.4\ntranslation = [0.5, 0, 0]\n', "short")
    record_steps(tmp_path / "run.mcap", made, iter([None] * 20), 20, "completed")
    found = list(samples(read_flight(tmp_path / "run.mcap"), 5, None))
    assert [sample.success for sample in found] == [False, False, False, True]
    assert [sample.reward for sample in found] == [0.0, 0.0, 0.0, 1.0]


def test_task_that_is_complete_before_the_end_is_rewarded_once(tmp_path: Path) -> None:
    made = bay('[[step]]\ntitle = "Move"\ntext = "Move."\ndone = { moved = "0.02 m" }\n')
    record_steps(tmp_path / "run.mcap", made, repeat(Inputs(translation=(1.0, 0.0, 0.0))), 60)
    found = list(samples(read_flight(tmp_path / "run.mcap"), 5, None))
    success, rewards = [sample.success for sample in found], [sample.reward for sample in found]
    assert success == sorted(success) and 1 < sum(success) < len(found) == 12
    assert rewards == [float(k == success.index(True)) for k in range(12)]


def test_pictures_are_drawn_from_the_frames(tmp_path: Path) -> None:
    above = load_scenario("first-flight")
    record_steps(tmp_path / "run.mcap", above, busy(), STEPS)
    flight = read_flight(tmp_path / "run.mcap")
    cameras = names_of(usual_cameras(flight))
    assert len(cameras) == 2
    found = list(samples(flight, 10, Painter(flight.scenario, cameras, (64, 48))))
    for sample in found:
        assert {name: (one.shape, one.dtype) for name, one in sample.seen.pictures.items()} == dict.fromkeys(
            cameras, ((48, 64, 3), np.dtype(np.uint8))
        )
        assert all(one.any() for one in sample.seen.pictures.values())
    first, last = found[0].seen.pictures, found[-1].then.pictures
    assert any((first[name] != last[name]).any() for name in cameras), "the arm has moved"


def test_names_of_pictures_have_letters_digits_and_underscores() -> None:
    assert names_of(["AFT P", "A"]) == {"aft_p": "AFT P", "a": "A"}
    with pytest.raises(InputError, match="different cameras"):
        names_of(["AFT P", "aft-p"])


@pytest.mark.parametrize("fps", [0.0, -1.0, 7.0, 100.0, float("nan"), float("inf")])
def test_rate_that_does_not_divide_the_control_rate_is_rejected(fps: float, run: Path) -> None:
    with pytest.raises(InputError, match="expected 50, the control rate, divided by a whole number"):
        plan([read_flight(run)], fps=fps)


def test_missing_camera_is_rejected_with_those_that_exist(run: Path) -> None:
    flight = read_flight(run)
    with pytest.raises(InputError, match=r"no camera 'Q'; it has .*WR"):
        Painter(flight.scenario, names_of(["Q"]), (64, 48))


@pytest.mark.parametrize("size", [(8, 48), (64, 5000)])
def test_size_beyond_the_limits_is_rejected(size: tuple[int, int], run: Path) -> None:
    with pytest.raises(InputError, match="each from 16 to 2048"):
        Painter(read_flight(run).scenario, {}, size)


def test_runs_of_different_arms_are_rejected(run: Path, tmp_path: Path) -> None:
    other = load_scenario("concept-1972")
    record_steps(tmp_path / "concept.mcap", other, iter([Inputs()] * 3), 3)
    with pytest.raises(InputError, match=r"concept\.mcap: .*angle_shoulder_heading.* instead of angle_shoulder_yaw"):
        plan([read_flight(run), read_flight(tmp_path / "concept.mcap")])


def test_recording_without_a_step_or_that_is_damaged_is_rejected(run: Path, tmp_path: Path) -> None:
    empty = tmp_path / "empty.mcap"
    record_steps(empty, bay(), iter(()), 0)
    with pytest.raises(RecordingError, match="nothing to export"):
        read_flight(empty)
    text = run.read_bytes()
    (tmp_path / "damaged.mcap").write_bytes(text[:2000] + b"\xff" * 50 + text[2050:])
    with pytest.raises(RecordingError, match="damaged"):
        read_flight(tmp_path / "damaged.mcap")


def test_recording_of_another_version_tells_how_far_its_flight_is_apart(run: Path, tmp_path: Path) -> None:
    first = next(frame for _, frame in Recording(run).steps())
    other = msgspec.structs.replace(first, sha256="0" * len(first.sha256))  # what other laws would have computed
    rewritten(run, tmp_path / "other.mcap", {"/frames": encode(other)})
    flight = read_flight(tmp_path / "other.mcap")
    chosen = plan([flight])
    episode = episode_of(flight, chosen, numbers_of(flight, chosen), success=False)
    assert not episode.inputs_equal and episode.frames_sha256 == ""
    assert episode.inputs_apart_m < 1e-6


def test_too_few_rows_are_rejected(run: Path) -> None:
    flight = read_flight(run)
    with pytest.raises(InputError, match="expected 33"):
        fly(flight.scenario, 0, flight.inputs[:-1], flight.steps, 1)
