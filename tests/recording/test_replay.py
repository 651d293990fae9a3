"""Verification and re-run of recordings."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import hypothesis.strategies as st
import msgspec
import pytest
from hypothesis import HealthCheck, given, settings

import aftdeck
from aftdeck.errors import InputError, RecordingError, ScenarioError
from aftdeck.plant.multibody.plant import MultibodyPlant
from aftdeck.plant.state import PlantState
from aftdeck.recording import replay
from aftdeck.recording.changed import rerun
from aftdeck.recording.codec import encode
from aftdeck.recording.environment import environment
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import Closing, FrameRecord, Input, Opening
from aftdeck.recording.replay import verify
from aftdeck.recording.run import record
from aftdeck.scenario.load import parse_scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.summary import Summary
from tests.each import each, seeds
from tests.recording.flown import bay, messages, record_random_run, record_steps, rewritten
from tests.scenario.missions import SCRIPTED, VERY_LONG

QUICK = ("uncradle", "sequence")
SCRIPT = """seed = 4
[[phase]]
name = "shoulder"
mode = "SINGLE"
joint = "shoulder_pitch"
joint_at = "80 deg"

[[phase]]
name = "forward"
mode = "ORB UNL"
translation = [0.6, 0, 0.2]
duration = "2 s"
"""
"""Script of a few seconds."""
PUSH = Inputs((0.5, -0.2, 0.1), (0.0, 0.3, 0.0))


@pytest.fixture(scope="module")
def run_file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("run") / "script.mcap"
    record(bay(extra=SCRIPT, name="script"), path)
    return path


@pytest.fixture(scope="module")
def manual_file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("hand") / "hand.mcap"
    record_steps(path, bay(), itertools.repeat(PUSH), 200)
    return path


def check_equal(name: str, path: Path) -> None:
    summary = record(name, path).summary
    verdict = verify(path)
    assert verdict.equal and verdict.different == 0 and verdict.first is None and not verdict.cut
    assert verdict.time_s == summary.time_s
    closing = messages(path)[-1]
    assert isinstance(closing, Closing)
    assert (closing.ended, closing.frames_sha256) == (summary.ended, summary.frames_sha256)
    assert msgspec.json.decode(closing.summary, type=Summary) == summary


@pytest.mark.parametrize("name", QUICK)
def test_scripted_run_verifies(name: str, tmp_path: Path) -> None:
    check_equal(name, tmp_path / "run.mcap")


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize("name", [name for name in SCRIPTED if name not in (*QUICK, VERY_LONG)])
def test_each_of_the_slow_scripted_runs_verifies(name: str, tmp_path: Path) -> None:
    check_equal(name, tmp_path / "run.mcap")


def check_random_run(path: Path, seed: int, steps: int, extra: str = "") -> None:
    path.unlink(missing_ok=True)
    flown = record_random_run(path, seed, steps, extra)
    verdict = verify(path)
    assert verdict.equal and verdict.frames == steps
    recorded_inputs = [(m.tick, m.translation) for m in messages(path) if isinstance(m, Input)]
    assert recorded_inputs == [(k, i.translation) for k, (i, _) in enumerate(flown, 1) if i is not None]


_hypothesis = settings(
    max_examples=5, suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow]
)


@_hypothesis
@given(
    st.integers(0, 2**32), st.sampled_from(["", "command_delay = 0.3\n", 'soft_stops = "as-flown"\nstrict = true\n'])
)
def test_run_with_random_inputs_verifies(tmp_path: Path, seed: int, extra: str) -> None:
    check_random_run(tmp_path / "random.mcap", seed, 150, extra)


@pytest.mark.slow
@each("seed", seeds(2, 40))
def test_long_run_with_random_inputs_verifies(tmp_path: Path, seed: int) -> None:
    check_random_run(tmp_path / f"{seed}.mcap", seed, 2000)


def test_demonstration_with_change_to_manual_control_verifies(tmp_path: Path) -> None:
    path = tmp_path / "taken.mcap"
    script: Iterator[Inputs | None] = itertools.chain(itertools.repeat(None, 100), itertools.repeat(PUSH))
    record_steps(path, aftdeck.load_scenario("first-flight"), script, 200)
    assert verify(path).equal
    assert [m.by for m in messages(path) if isinstance(m, FrameRecord)] == ["script"] * 100 + ["hand"] * 100


def test_run_with_another_seed_verifies(tmp_path: Path) -> None:
    path = tmp_path / "seeded.mcap"
    record(bay(extra=SCRIPT), path, seed=77)
    assert Recording(path).opening.seed == 77
    assert verify(path).equal


def with_changed_frame(source: Path, out: Path) -> FrameRecord:
    """Write a copy of a recording with a changed first frame, and return this frame."""
    first = next(m for m in messages(source) if isinstance(m, FrameRecord))
    angles = (first.angles[0] + 1e-3, *first.angles[1:])
    wrong = msgspec.structs.replace(first, angles=angles, sha256="0" * 16)
    rewritten(source, out, {"/frames": encode(wrong)})
    return wrong


def test_changed_frame_is_found_with_its_fields(manual_file: Path, tmp_path: Path) -> None:
    wrong = with_changed_frame(manual_file, tmp_path / "wrong.mcap")
    verdict = verify(tmp_path / "wrong.mcap")
    assert (verdict.equal, verdict.different, verdict.frames) == (False, 1, 200)
    assert verdict.first is not None and verdict.first.tick == wrong.tick == 1
    assert [change.field for change in verdict.first.fields] == ["angles[0]"]


def test_changed_inputs_are_found_in_their_step(manual_file: Path, tmp_path: Path) -> None:
    other = encode(Input(tick=1, translation=(-0.5, -0.2, 0.1)))
    rewritten(manual_file, tmp_path / "wrong.mcap", {"/inputs": other})
    verdict = verify(tmp_path / "wrong.mcap")
    assert not verdict.equal and verdict.first is not None
    assert verdict.first.tick == 1
    assert "translation[0]" in {change.field for change in verdict.first.fields}


def test_changed_digest_of_all_frames_is_found(manual_file: Path, tmp_path: Path) -> None:
    closing = messages(manual_file)[-1]
    assert isinstance(closing, Closing)
    other = msgspec.json.encode(msgspec.structs.replace(closing, frames_sha256="0" * 64))
    rewritten(manual_file, tmp_path / "wrong.mcap", {"/closing": other})
    verdict = verify(tmp_path / "wrong.mcap")
    assert (verdict.equal, verdict.different) == (False, 0)


def with_header(source: Path, out: Path, **changes: object) -> None:
    """Write a copy of a recording with these changes of the header."""
    start = msgspec.structs.replace(Recording(source).opening, **changes)
    rewritten(source, out, {"/opening": msgspec.json.encode(start)}, rechained=True)


def test_file_of_another_version_is_verified_and_named(manual_file: Path, tmp_path: Path) -> None:
    with_header(manual_file, tmp_path / "old.mcap", version="0.0.1", machine="another", environment=None)
    verdict = verify(tmp_path / "old.mcap")
    assert verdict.equal
    assert (verdict.recorded_by, verdict.version) == ("0.0.1", aftdeck.__version__)
    assert not verdict.same_machine


def test_file_with_digests_of_other_fields_is_compared_by_values(manual_file: Path, tmp_path: Path) -> None:
    with_header(manual_file, tmp_path / "old.mcap", version="0.0.1", digests="")
    verdict = verify(tmp_path / "old.mcap")
    assert verdict.equal and not verdict.whole and verify(manual_file).whole
    first = next(message for message in messages(manual_file) if isinstance(message, FrameRecord))
    forged = msgspec.structs.replace(first, position=(9.0, 9.0, 9.0))
    rewritten(tmp_path / "old.mcap", tmp_path / "forged.mcap", {"/frames": encode(forged)}, rechained=True)
    verdict = verify(tmp_path / "forged.mcap")
    assert (verdict.equal, verdict.different) == (False, 1) and verdict.first is not None
    assert [change.field for change in verdict.first.fields] == [f"position[{axis}]" for axis in range(3)]


@pytest.mark.parametrize(
    ("version", "changes", "equal"),
    [
        pytest.param("0.0.1", {"text": "worded differently"}, True, id="wording of another version"),
        pytest.param("0.0.1", {"kind": "forged"}, False, id="kind"),
        pytest.param("0.0.1", {"level": "warning"}, False, id="level"),
        pytest.param(aftdeck.__version__, {"text": "worded differently"}, False, id="wording of this version"),
    ],
)
def test_log_lines_of_another_version_may_differ_in_wording_alone(
    tmp_path: Path, version: str, changes: dict[str, str], equal: bool
) -> None:
    record_steps(tmp_path / "new.mcap", bay(), iter([Inputs(mode="END EFF"), Inputs()]), 2)
    with_header(tmp_path / "new.mcap", tmp_path / "old.mcap", version=version, digests="")
    first = next(message for message in messages(tmp_path / "new.mcap") if isinstance(message, FrameRecord))
    assert first.events
    lines = tuple(msgspec.structs.replace(line, **changes) for line in first.events)
    forged = msgspec.structs.replace(first, events=lines)
    rewritten(tmp_path / "old.mcap", tmp_path / "forged.mcap", {"/frames": encode(forged)}, rechained=True)
    assert verify(tmp_path / "forged.mcap").equal is equal


def test_unloadable_file_of_another_version_is_reported(manual_file: Path, tmp_path: Path) -> None:
    text = Recording(manual_file).opening.scenario_text
    with_header(manual_file, tmp_path / "new.mcap", version="9.0.0", scenario_text=f"gravity = 9.81\n{text}")
    with pytest.raises(RecordingError, match=r"Aftdeck 9\.0\.0 .*gravity"):
        verify(tmp_path / "new.mcap")


def test_damage_in_a_file_of_another_version_is_damage(manual_file: Path, tmp_path: Path) -> None:
    with_header(manual_file, tmp_path / "old.mcap", version="0.0.1")
    whole = bytearray((tmp_path / "old.mcap").read_bytes())
    whole[len(whole) // 2] ^= 16
    (tmp_path / "old.mcap").write_bytes(whole)
    with pytest.raises(RecordingError, match=r"^[^:]*old\.mcap: .* [0-9.]+ s: ") as caught:
        verify(tmp_path / "old.mcap")
    assert caught.value.fault == "damaged"


def test_progress_increases_to_at_most_1(run_file: Path) -> None:
    shares: list[float] = []
    assert verify(run_file, shares.append).equal
    assert shares == sorted(shares) and 0.0 < shares[0] <= shares[-1] <= 1.0


# --- re-run with changes -------------------------------------------------------------------------------


def test_rerun_with_equal_values_has_no_difference(manual_file: Path) -> None:
    outcome = rerun(manual_file, ("rate=coarse", "control_period=0.02", "arm=srms"))
    assert outcome.first is None and outcome.events == () and outcome.compared == 200
    assert outcome.greatest_tip_m.value == outcome.greatest_joint_rad.value == outcome.tip_at_end_m == 0.0
    closing = messages(manual_file)[-1]
    assert isinstance(closing, Closing) and outcome.frames_sha256 == closing.frames_sha256


def test_rerun_with_a_delay_differs_when_the_sticks_move(tmp_path: Path) -> None:
    path = tmp_path / "hand.mcap"
    record_steps(path, bay(), itertools.chain(itertools.repeat(Inputs(), 50), itertools.repeat(PUSH)), 100)
    outcome = rerun(path, ("command_delay=0.5",))
    assert outcome.first is not None and outcome.first.time_s == pytest.approx(51 * 0.02)
    assert outcome.greatest_tip_m.value > 0.0


def test_rerun_in_vernier_takes_longer_and_has_later_lines(run_file: Path) -> None:
    outcome = rerun(run_file, ("phase[0].rate=vernier",))
    assert (outcome.ended_before, outcome.ended_after) == ("completed", "completed")
    assert outcome.time_after_s > outcome.time_before_s
    late = [event for event in outcome.events if event.before_s is not None and event.after_s is not None]
    assert late and all(e.after_s > e.before_s for e in late if e.after_s is not None and e.before_s is not None)


@pytest.mark.parametrize(
    "changes", [("phase[0].rate=vernier",), ("command_delay=0.2", "seed=9"), ("control_period=0.04",)]
)
def test_recording_of_a_rerun_verifies(run_file: Path, tmp_path: Path, changes: tuple[str, ...]) -> None:
    out = tmp_path / "changed.mcap"
    outcome = rerun(run_file, changes, out)
    assert Recording(out).opening.changes == changes
    assert verify(out).equal
    closing = messages(out)[-1]
    assert isinstance(closing, Closing) and closing.frames_sha256 == outcome.frames_sha256
    assert Recording(out).opening.seed == (9 if "seed=9" in changes else 4)


def test_recording_of_a_rerun_can_be_rerun(run_file: Path, tmp_path: Path) -> None:
    one, two = tmp_path / "one.mcap", tmp_path / "two.mcap"
    rerun(run_file, ("phase[0].rate=vernier",), one)
    outcome = rerun(one, ("phase[0].rate=coarse",), two)
    assert verify(two).equal
    assert Recording(two).opening.changes == ("phase[0].rate=coarse",)  # the later change replaces the earlier
    closing = messages(run_file)[-1]
    assert isinstance(closing, Closing) and outcome.frames_sha256 == closing.frames_sha256


@pytest.mark.parametrize("period", ["0.01", "0.005"])
def test_rerun_with_a_finer_period_runs_the_script(run_file: Path, tmp_path: Path, period: str) -> None:
    out = tmp_path / "fine.mcap"
    rerun(run_file, (f"control_period={period}",), out)
    assert {m.by for m in messages(out) if isinstance(m, FrameRecord)} == {"script"}
    last = messages(out)[-1]
    assert isinstance(last, Closing) and last.ended == "completed"


@pytest.mark.parametrize("period", [0.01, 0.04])
def test_rerun_with_another_period_has_the_length_of_the_inputs(manual_file: Path, period: float) -> None:
    outcome = rerun(manual_file, (f"control_period={period}",))
    assert outcome.time_after_s == pytest.approx(outcome.time_before_s)
    assert outcome.greatest_tip_m.value < 0.01


@pytest.mark.parametrize(
    ("change", "error", "text"),
    [
        ("rate", InputError, "'rate'"),
        ("=5", InputError, "'=5'"),
        ("rate=fast", ScenarioError, "coarse, vernier"),
        ("speed=3", ScenarioError, "speed"),
        ("command_delay=0.33", ScenarioError, r"0\.33 s"),
        ("command_delay=nan", ScenarioError, "command_delay"),
        ("control_period=1e-320", ScenarioError, r"0\.001 to 0\.2 s"),
        ("phase[9].rate=vernier", InputError, "item 9"),
        ("title.rate=vernier", InputError, "title"),
        ("arm=nowhere.toml", ScenarioError, "nowhere"),
        ("arm=5", InputError, "arm .*got 5"),
        ("seed=-1", ScenarioError, "seed"),
    ],
)
def test_invalid_change_is_rejected_without_writing_a_file(
    run_file: Path, tmp_path: Path, change: str, error: type[Exception], text: str
) -> None:
    out = tmp_path / "out.mcap"
    with pytest.raises(error, match=text):
        rerun(run_file, (change, "command_delay=0.5") if change.startswith("control_period") else (change,), out)
    assert not out.exists()


def test_existing_recording_is_not_overwritten(run_file: Path) -> None:
    before = run_file.read_bytes()
    with pytest.raises(RecordingError) as caught:
        rerun(run_file, ("rate=vernier",), run_file)
    assert caught.value.fault == "exists"
    with pytest.raises(RecordingError) as caught:
        record(bay(extra=SCRIPT), run_file)
    assert caught.value.fault == "exists"
    assert run_file.read_bytes() == before


def test_header_has_scenario_title_and_version(run_file: Path) -> None:
    start = messages(run_file)[0]
    made = bay(extra=SCRIPT, name="script")
    assert isinstance(start, Opening)
    assert (start.scenario, start.title, start.version) == ("script", "test", aftdeck.__version__)
    assert (start.joints, start.control_period_s, start.scenario_text) == (made.arm.joints, 0.02, made.text)


@pytest.mark.parametrize(("noise", "agrees"), [(1e-12, True), (1e-4, False)])
def test_run_with_masses_agrees_in_another_environment_within_the_tolerance(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, noise: float, agrees: bool
) -> None:
    path = tmp_path / "run.mcap"
    text = 'title = "a run"\nworksite = "space"\nplant = "rigid"\nduration = "4 s"\n'
    text += "[initial]\njoints = [0.0, 0.6, -1.0, 0.0, 0.0, 0.0]\n"
    text += '[[phase]]\nmode = "ORB UNL"\ntranslation = [0.5, 0.0, 0.2]\nduration = "4 s"\n'
    given = parse_scenario(text, "run", "run.toml", tmp_path)
    record(given, path)
    assert verify(path).equal and verify(path).agrees
    exactly = MultibodyPlant.move

    def roughly(plant: MultibodyPlant, state: PlantState, *args: Any, **kwargs: Any) -> None:
        exactly(plant, state, *args, **kwargs)
        assert state.bodies is not None
        state.bodies.physics[1:] += noise

    here = environment("rigid")
    monkeypatch.setattr(MultibodyPlant, "move", roughly)
    assert not verify(path).agrees  # on the same machine, the run has to be equal
    monkeypatch.setattr(replay, "environment", lambda plant: msgspec.structs.replace(here, processor="another"))
    verdict = verify(path)
    assert not verdict.equal
    assert verdict.agrees == agrees
