"""A joint that slides has units of length where a joint that turns has angles: in files, texts, tables and commands."""

from __future__ import annotations

import re

import pytest

from aftdeck.arms.load import HERE, PorLimits, model_of
from aftdeck.errors import ScenarioError
from aftdeck.files import Text, read
from aftdeck.operators.approach import Speeds
from aftdeck.operators.decide import moved
from aftdeck.operators.pilot import Pilot, pilot
from aftdeck.operators.spec import OperatorSpec
from aftdeck.report.strips import sources
from aftdeck.scenario.load import load_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.scene.stick_axes import StickAxes
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.simulation.run import run as run_with
from aftdeck.simulation.series.groups import columns_of, in_series
from aftdeck.station.conversion.welcome_of import welcome_of
from aftdeck.task.progress import Progress
from aftdeck.task.remaining import Aims
from tests.commands import Run
from tests.loaded import CHAINS

SINGLE = {"name": "one", "mode": "SINGLE", "duration": "1 s"}
RAIL = CHAINS / "rail.toml"
ANGLES = ["-30 deg", "80 deg", "-100 deg", "-70 deg", "15 deg", "-40 deg"]


def given(changes: dict[object, object]) -> Scenario:
    return load_scenario(CHAINS / "fly-rail.toml", changes)


@pytest.mark.parametrize(
    ("changes", "why"),
    [
        ({("initial", "joints"): ["20 deg", *ANGLES]}, "rail slides: expected a length, .* got an angle"),
        (
            {("initial", "joints"): ["1 m", "1 ft", *ANGLES[1:]]},
            "shoulder_yaw turns: expected an angle, .* got a length",
        ),
        ({("initial", "joints"): ["7 m", *ANGLES]}, "rail at 7 m is outside its hard limits -6 m to 6 m"),
        ({("initial", "joints"): ["7 s", *ANGLES]}, "neither an angle nor a length"),
        ({("initial", "rates"): ["1 deg/s"] + [0] * 6}, "rail slides: expected a speed"),
        ({("initial", "rates"): ["1 m/s"] + [0] * 6}, "rail starts at 1 m/s; its servo gives at most 0.2 m/s"),
        ({("limits", "soft"): [["-1 deg", "1 deg"]] * 7}, "rail slides: expected a length"),
        ({("limits", "servo"): ["1 m/s"] * 7}, "shoulder_yaw turns: expected an angular rate"),
        ({("phase", 2, "joint_at"): "20 deg"}, "rail slides: expected a length"),
        ({("phase", 2, "joint_at"): "6.5 m"}, "outside its hard limits"),
        ({("phase", 0): {**SINGLE, "joint": "rail", "joint_rate": "1 deg/s"}}, "rail slides: expected a speed"),
        ({("phase", 0): {**SINGLE, "joint": "elbow", "joint_rate": "1 m/s"}}, "elbow turns: expected an angular rate"),
        ({("phase", 7, "master"): [0.0, 90.0, *[0.0] * 5]}, "shoulder_yaw: got 90 rad; expected -62.84 to 62.84 rad"),
    ],
)
def test_a_value_with_the_unit_of_the_other_kind_is_an_error(changes: dict[object, object], why: str) -> None:
    with pytest.raises(ScenarioError, match=why):
        given(changes)


def test_a_bare_number_is_in_the_si_unit_of_each_joint() -> None:
    made = given({("initial", "joints"): [0.5, 0.1, 1.2, -1.5, -1.0, 0.2, -0.5]})
    assert made.start.angles.tolist() == [0.5, 0.1, 1.2, -1.5, -1.0, 0.2, -0.5]
    assert given({("initial", "joints"): ["50 cm", *ANGLES]}).start.angles[0] == pytest.approx(0.5)


def test_columns_strips_and_messages_have_the_unit_of_the_joint() -> None:
    made = given({})
    columns = {one.name: one.unit for reading in in_series(made) for one in columns_of(reading, made)}
    assert columns["angle_rail_m"] == "m" and columns["rate_rail_m_s"] == "m/s"
    assert columns["angle_elbow_rad"] == "rad"
    kinds = {source.blank.name: source.blank.quantity for source in sources(made)}
    assert (kinds["Rail"], kinds["Elbow"]) == ("length", "angle")
    assert [joint.slides for joint in welcome_of(made, demo=False).joints] == [True, *[False] * 6]


STEP = {"title": "Along the rail", "text": "Go.", "joint": "rail", "joint_at": "1.2 m"}


def test_a_step_asks_for_a_length_and_ends_there() -> None:
    made = given({("step",): [{**STEP, "done": {"within": "1 cm"}}]})
    sim, (step,), aims = Simulation(made), made.steps, Aims(made)
    left = aims.remaining(sim.look(), step)
    assert left is not None and (left.to, left.near) == ("rail", (0.01, 0.01))
    assert left.distance == pytest.approx(0.7)
    while not left.arrived and sim.look().time_s < 30.0:
        sim.step(Inputs(mode="SINGLE", joint=0, drive=1.0 if left.angle > 0.15 else 0.1))
        left = aims.remaining(sim.look(), step)
        assert left is not None
    assert abs(sim.look().angles[0] - 1.2) <= 0.01
    with pytest.raises(ScenarioError, match="a step with a joint that slides has only within"):
        given({("step",): [{**STEP, "done": {"within_angle": "1 deg"}}]})


def test_commands_print_and_read_lengths(run: Run) -> None:
    limits = run.json("arm", str(RAIL), "limits", "--deg")["joints"]
    assert (limits[0]["unit"], limits[0]["hard"], limits[1]["unit"]) == ("m", [-6.0, 6.0], "deg")
    at = [run.json("arm", str(RAIL), "forward", str(x), *["0"] * 6, "--deg")["position"][0] for x in (0.0, 1.5)]
    assert at[1] - at[0] == pytest.approx(1.5)
    solved = run.json("arm", str(RAIL), "inverse", "7", "0", "-3", "0", "0", "0", "--deg")
    assert solved["joint_units"] == ["m", *["deg"] * 6] and abs(solved["solutions"][0][0]) <= 6.0


@pytest.mark.parametrize(
    ("old", "new", "why"),
    [
        ('servo = "0.2 m/s"', 'servo = "2 deg/s"', "speed"),
        ('hard = ["-6 m", "6 m"]', 'hard = ["-60 deg", "60 deg"]', "length"),
        ('servo = "0.2 m/s"\n', "", "rail slides, driven by steering: servo missing"),
        ('servo = "0.2 m/s"\n', 'servo = "0.2 m/s"\non = "elbow"\n', "takes no on"),
        ('soft = ["-5.9 m", "5.9 m"]', 'soft = ["-7 m", "7 m"]', "got hard -6 to 6 m; soft -7 to 7 m"),
        ('servo = "0.2 m/s"', 'servo = "0.05 m/s"', "got 0.03, 0.1, 0.05 m/s"),
        ("gain = { value = [2e4,", "gain = { value = ['2e4 N*m*s/rad',", "rail slides: expected a linear damping"),
        (
            "friction = { value = [20, 20,",
            "friction = { value = ['20 N', '20 N',",
            "shoulder_yaw turns: expected a torque",
        ),
        (
            'kind = "slide"\n',
            'kind = "slide"\ndriver = "telescope"\n',
            "the telescope switch: least, greatest, start, rate missing",
        ),
    ],
)
def test_an_arm_file_with_a_wrong_slide_is_an_error(old: str, new: str, why: str) -> None:
    text = RAIL.read_text(encoding="utf-8")
    assert old in text
    with pytest.raises(ScenarioError, match=re.escape(why)):
        model_of(Text("rail.toml", text.replace(old, new, 1)), lambda _: Text("", ""))


def test_servo_of_a_slide_may_have_its_units() -> None:
    text = RAIL.read_text(encoding="utf-8").replace("gain = { value = [2e4,", "gain = { value = ['20 N*s/mm',", 1)
    servo = model_of(Text("rail.toml", text), lambda _: Text("", "")).servo
    assert servo is not None and servo.gain[0] == pytest.approx(2e4)


@pytest.mark.parametrize("driver", ["telescope", "prong"])
def test_a_telescope_without_a_prong_or_the_reverse_is_an_error(driver: str) -> None:
    tables = (HERE / "concept-1972.toml").read_text(encoding="utf-8").split("[[joint]]")
    (number,) = (k for k, table in enumerate(tables) if f'driver = "{driver}"' in table)
    tables[number - 1] += "".join(tables.pop(number).partition("[[por]]")[1:])  # the tables behind the last joint stay
    with pytest.raises(ScenarioError, match="expected both, or neither"):
        model_of(Text("bad.toml", "[[joint]]".join(tables)), lambda name: read(HERE / name))


def test_synthetic_operator_finishes_a_step_of_a_joint_that_slides() -> None:
    done = {"within": "1 cm", "sticks_released": True}
    made = given({("step",): [{**STEP, "mode": "SINGLE", "done": done}]})
    operator = pilot(made, OperatorSpec("perfect"), 1)
    assert isinstance(operator, Pilot)
    assert run_with(made, inputs=operator, keep_frames=False).summary.ended == "completed"
    assert operator.progress.present is None and operator.progress.skipped == ()


@pytest.mark.parametrize(
    ("joint", "slides", "done"),
    [
        ("rail", True, {}),
        ("rail", True, {"within": "1 cm"}),
        ("elbow", False, {}),
        ("elbow", False, {"within_angle": "1 deg"}),
    ],
)
def test_a_joint_slows_down_by_the_acceleration_of_its_kind(joint: str, slides: bool, done: dict[str, str]) -> None:
    at = "10 cm" if slides else "-110 deg"
    made = given({("step",): [{**STEP, "joint": joint, "joint_at": at, "done": {**done, "mode": "MASTER"}}]})
    progress, sim = Progress(made), Simulation(made)
    frame = sim.look()
    progress.see(frame)
    assert progress.present is not None
    drives = set()
    for fast in (1.0, 1e-9):
        metres, angles = (1e-3, fast) if slides else (fast, 1e-3)
        speeds = Speeds(1.0, 1.0, 1.0, PorLimits((1.0, 1.0), (1.0, 1.0), metres, angles))
        drives.add(moved(frame, progress.present, progress, StickAxes(made).in_l(frame), speeds, None).drive)
    assert len(drives) == 1 and 0.0 not in drives
