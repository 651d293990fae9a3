"""What can be wrong in a scenario file, and what is said of it."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from aftdeck.errors import ScenarioError
from aftdeck.scenario.load import load_scenario, parse_scenario

HEAD = 'title = "t"\n'
INITIAL = "[initial]\njoints = [0, 1, -1, 0, 0, 0]\n"
PHASE = "[[phase]]\n"


def problems(text: str) -> list[str]:
    with pytest.raises(ScenarioError) as caught:
        parse_scenario(text, "a", "a.toml", Path("."))
    return list(caught.value.problems)


HEADS = [
    (
        "mode = 9",
        "a.toml:2: mode: no mode 9: there are 1 to 8 and the panel's OPR CMD, AUTO 1, AUTO 2, AUTO 3, AUTO 4, ",
    ),
    ("mode = 0", "a.toml:2: mode: no mode 0: there are 1 to 8 and the panel's"),
    ("mode = 'orb unl'", "a.toml:2: mode: no mode 'orb unl': there are 1 to 8 and the panel's"),
    ("mode = 6", "a.toml:2: mode: PL moves a payload, and the scenario has none: add a [payload] table"),
    ("mode = 7", "a.toml:2: mode: ORB LD moves a payload, and the scenario has none: add a [payload] table"),
    ("mode = 'ORB LD'", "a.toml:2: mode: ORB LD moves a payload, and the scenario has none"),
    ("mode = 'PL'", "a.toml:2: mode: PL moves a payload, and the scenario has none"),
    ("mode = 'AUTO 3'", "a.toml:2: mode: AUTO 3 has no points: add a [[sequence]] with slot = 3"),
    ("law = 'feedback'", "a.toml:2: law: expected one of position, closed loop, open loop, got 'feedback'"),
    ("sequence = []\nmode = 'AUTO 1'", "a.toml:3: mode: AUTO 1 has no points"),
    ("mode = 2.0", "a.toml:2: mode: Expected `int | str`, got `float`"),
    (
        "arm = 'canadarm3'",
        "a.toml:2: arm: no arm 'canadarm3': built in are concept-1972, srms; a path to an arm file ends in .toml",
    ),
    ("arm = 'none.toml'", "a.toml:2: arm: none.toml: cannot be read: No such file or directory"),
    ('arm = "a\\u0000.toml"', "a.toml:2: arm: "),
    ("worksite = 'moon'", "a.toml:2: worksite: 'moon'"),
    ("plant = 'flexible'", "a.toml:2: plant: expected one of kinematic, got 'flexible'"),
    ("rate = 'fast'", "a.toml:2: rate: expected one of coarse, vernier, got 'fast'"),
    ("soft_stops = 'off'", "a.toml:2: soft_stops: expected one of mended, as-flown, got 'off'"),
    ("seed = -1", "a.toml:2: seed: Expected `int` >= 0"),
    ("seed = 99999999999999999999999999", "a.toml:2: seed: "),
    ("seed = 1.5", "a.toml:2: seed: Expected `int`, got `float`"),
    ("strict = 'yes'", "a.toml:2: strict: Expected `bool`, got `str`"),
    ("control_period = 0.5", "a.toml:2: control_period: has to be between 0.001 and 0.2 s, got 0.5 s"),
    ("control_period = '0 ms'", "a.toml:2: control_period: has to be between 0.001 and 0.2 s, got 0 s"),
    ("control_period = nan", "a.toml:2: control_period: expected a finite number in s, got nan"),
    ("command_delay = -1", "a.toml:2: command_delay: has to be between 0 and 30 s, got -1 s"),
    (
        "command_delay = 0.03",
        "a.toml:2: command_delay: has to be a whole number of control periods: 0.03 s is 1.5 of 0.02 s",
    ),
    ("telemetry_delay = '31 s'", "a.toml:2: telemetry_delay: has to be between 0 and 30 s, got 31 s"),
    ("camera_delay = -0.1", "a.toml:2: camera_delay: has to be between 0 and 30 s, got -0.1 s"),
    ("camera_delay = nan", "a.toml:2: camera_delay: expected a finite number in s, got nan"),
    ("camera_delay = '2 m'", "a.toml:2: camera_delay: "),
    ("duration = inf", "a.toml:2: duration: expected a finite number in s, got inf"),
    ("duration = -1", "a.toml:2: duration: has to be above 0 and at most 86400 s, got -1 s"),
    ("duration = 1e9", "a.toml:2: duration: has to be above 0 and at most 86400 s, got 1e+09 s"),
    ("duration = 1.01", "a.toml:2: duration: has to be a whole number of control periods: 1.01 s is 50.5 of 0.02 s"),
    ("duration = 1e-9", "a.toml:2: duration: "),
    ("duration = '2 deg'", "a.toml:2: duration: '2 deg' is not a time: write a number in s, or a number with its unit"),
    ("duration = true", "a.toml:2: duration: expected a number in s or a string such as '20 ms', got True"),
    ("arrive_within = 0", "a.toml:2: arrive_within: has to be above 0, got 0 m"),
    ("arrive_within_angle = -1", "a.toml:2: arrive_within_angle: has to be above 0, got -1 rad"),
    ("title = 'again'", "a.toml: Cannot overwrite a value"),
    ("colour = 'red'", "a.toml:2: colour: unknown field; allowed here: title, initial, text, arm"),
    ("phase = 3", "a.toml:2: phase: Expected `array`, got `int`"),
]
TABLES = [
    ("[limits]\nhard = 3", "a.toml:5: limits.hard: Expected `array`, got `int`"),
    ("[limits]\nhard = [[0, 1]]", "a.toml:5: limits.hard: Expected `array` of length 6, got 1"),
    (
        "[limits]\nreach = [[-9, 9], [0.1, 2], [-2, -0.1], [-1, 1], [-1, 1], [-1, 1]]",
        "a.toml:4: limits: shoulder_yaw: reach limits have to be inside the soft stops, and these inside the hard "
        "stops; got hard -180 to 180",
    ),
    (
        "[limits]\nvernier = [1, 1, 1, 1, 1, 1]",
        "a.toml:4: limits: shoulder_yaw: expected 0 < vernier <= coarse <= servo, got 1,",
    ),
    ("[limits]\nservo = [0, 0, 0, 0, 0, 0]", "a.toml:4: limits: shoulder_yaw: expected 0 < vernier"),
    ("[limits.por]\ntranslation = 0", "a.toml:5: limits.por.translation: has to be above 0, got 0"),
    ("[limits.por]\nreached_in = '2 m'", "a.toml:5: limits.por.reached_in: '2 m' is not a time"),
    (
        "[limits.por]\nvernier_translation = 9",
        "a.toml:5: limits.por.vernier_translation: has to be at most the coarse limit 0.6096, got 9",
    ),
    ("[limits.por]\nreached_in = -1", "a.toml:5: limits.por.reached_in: has to be above 0, got -1"),
    (
        "[[sequence]]\nslot = 5\npoint = [{ target = { joints = [0, 1, -1, 0, 0, 0] } }]",
        "a.toml:5: sequence[0].slot: Expected `int` <= 4",
    ),
    ("[[sequence]]\nslot = 1\npoint = []", "a.toml:6: sequence[0].point: Expected `array` of length >= 1"),
    (
        "[[sequence]]\nslot = 1\n[[sequence.point]]\ntarget = {}",
        "a.toml:7: sequence[0].point[0].target: give joints (six angles), or a position",
    ),
    (
        "sequence = [{ slot = 2, point = [{ target = { joints = [0, 9, -1, 0, 0, 0] } }] }]",
        "a.toml:4: initial.sequence: unknown field",
    ),
    (
        "[[sequence]]\nslot = 2\npoint = [{ target = { joints = [0, 9, -1, 0, 0, 0] } }]",
        "a.toml:6: sequence[0].point[0].target.joints: shoulder_pitch at 515.662 deg is outside its hard limits",
    ),
    (
        "[[sequence]]\nslot = 2\npoint = [{ target = { joints = [0, 1, -1, 0, 0, 0] } }]\n"
        "[[sequence]]\nslot = 2\npoint = [{ target = { joints = [0, 1, -1, 0, 0, 0] } }]",
        "a.toml:8: sequence[1].slot: AUTO 2 already has points; give each slot once",
    ),
    ("[payload]", "a.toml:4: payload: the field 'mass' is missing"),
    ("[payload]\nmass = 0", "a.toml:5: payload.mass: has to be above 0, got 0 kg"),
    ("[payload]\nmass = 1\nmatrix = [[1, 0, 0], [0, 1, 0], [0, 0, -1]]", "a.toml:6: payload.matrix: is not a right"),
    ("[payload]\nmass = 1\nmatrix = [[1e300, 0, 0], [0, 1, 0], [0, 0, 1]]", "a.toml:6: payload.matrix: is not a r"),
    ("[payload]\nmass = 1\nmatrix = [[nan, 0, 0], [0, 1, 0], [0, 0, 1]]", "a.toml:6: payload.matrix: expected fin"),
    ("[phase]\nmode = 4", "a.toml:4: phase: Expected `array`, got `object`"),
    ("[clearance]\nwarning = 0", "a.toml:5: clearance.warning: has to be above 0, got 0 m"),
    (
        "[clearance]\ncaution = '60 cm'\nwarning = 0.6",
        "a.toml:5: clearance.caution: has to be above the warning at 0.6 m",
    ),
    ("[clearance]\ncaution = '10 cm'", "a.toml:5: clearance.caution: has to be above the warning at 0.15 m, got 0.1 m"),
    ("[clearance]\nwarning = '3 kg'", "a.toml:5: clearance.warning: '3 kg' is not a length"),
]
PHASES = [
    ("", "a.toml:4: phase[0]: the field 'mode' is missing"),
    ("mode = 11\nduration = 1", "a.toml:5: phase[0].mode: no mode 11: there are 1 to 8 and the panel's"),
    ("mode = 1\nduration = 1", "a.toml:4: phase[0]: mode OPR CMD needs a target"),
    ("mode = 6\nduration = 1", "a.toml:5: phase[0].mode: PL moves a payload, and the scenario has none"),
    ("mode = 7\nduration = 1", "a.toml:5: phase[0].mode: ORB LD moves a payload, and the scenario has none"),
    ("mode = 'AUTO 4'", "a.toml:5: phase[0].mode: AUTO 4 has no points: add a [[sequence]] with slot = 4"),
    ("mode = 'TEST'", "a.toml:4: phase[0]: mode TEST needs a duration"),
    ("mode = 'TEST'\nduration = 1\ndrive = 1", "a.toml:7: phase[0].drive: mode TEST takes no drive; it takes nothing"),
    ("mode = 'DIRECT'\ndrive = 1\nduration = 1", "a.toml:4: phase[0]: mode DIRECT needs a joint"),
    (
        "mode = 4\nduration = 1\npayload_axes = true",
        "a.toml:7: phase[0].payload_axes: mode ORB UNL takes no payload_axes; it takes",
    ),
    ("mode = 4\nduration = 1\nlaw = 'position'", "a.toml:7: phase[0].law: mode ORB UNL takes no law; it takes"),
    (
        "mode = 3\ntarget = { joints = [0, 1, -1, 0, 0, 0] }\nlaw = 'position'",
        "a.toml:7: phase[0].law: mode 3 selects the steering law; leave law out",
    ),
    ("mode = 4", "a.toml:4: phase[0]: mode ORB UNL needs a duration"),
    ("mode = 4\nduration = 0", "a.toml:6: phase[0].duration: has to be above 0, got 0 s"),
    ("mode = 4\nduration = 1\ntranslation = [0, 0, 2]", "a.toml:7: phase[0].translation"),
    ("mode = 4\nduration = 1\ntranslation = [0, 0, nan]", "a.toml:7: phase[0].translation"),
    ("mode = 4\nduration = 1\njoint = 'wrist_roll'", "a.toml:7: phase[0].joint: mode ORB UNL takes no joint; it takes"),
    ("mode = 2", "a.toml:4: phase[0]: mode OPR CMD needs a target"),
    ("mode = 2\ntarget = {}", "a.toml:6: phase[0].target: give joints (six angles), or a position"),
    (
        "mode = 2\ntarget = { joints = [0, 0, 0, 0, 0, 0], yaw = 1 }",
        "a.toml:6: phase[0].target: give either joints, or a position with an orientation, not both",
    ),
    (
        "mode = 2\ntarget = { position = [1, 1, 1], yaw = 0, matrix = [[1, 0, 0], [0, 1, 0], [0, 0, 1]] }",
        "a.toml:6: phase[0].target: give either a matrix or roll, pitch, yaw, not both",
    ),
    (
        "mode = 2\ntarget = { position = [1, 1, 1], matrix = [[2, 0, 0], [0, 1, 0], [0, 0, 1]] }",
        "a.toml:6: phase[0].target.matrix: is not a right-handed orthonormal matrix",
    ),
    (
        "mode = 2\ntarget = { joints = [0, 0, 0, 0, 3, 0] }",
        "a.toml:6: phase[0].target.joints: wrist_yaw at 171.887 deg is outside its hard limits -121.3 to 121.3 deg",
    ),
    (
        "mode = 2\ntarget = { position = [1, 1, 1], frame = 'moon' }",
        "a.toml:6: phase[0].target.frame: no frame 'moon': there are L, orbiter, panel, bay",
    ),
    ("mode = 8\ndrive = 1\nduration = 1", "a.toml:4: phase[0]: mode SINGLE needs a joint"),
    ("mode = 8\njoint = 'thumb'\nduration = 1", "a.toml:6: phase[0].joint: no joint 'thumb': there are shoulder_yaw"),
    ("mode = 8\njoint = 'wrist_roll'", "a.toml:4: phase[0]: mode SINGLE needs joint_at, or drive"),
    (
        "mode = 8\njoint = 'wrist_roll'\njoint_at = 0\ndrive = 1",
        "a.toml:4: phase[0]: give either joint_at or drive, not both",
    ),
    (
        "mode = 8\njoint = 'wrist_roll'\njoint_at = 10",
        "a.toml:7: phase[0].joint_at: wrist_roll at 572.958 deg is outside its hard limits -447 to 447 deg",
    ),
    ("mode = 8\njoint = 'wrist_roll'\njoint_at = 0\nrotation = [1, 0, 0]", "a.toml:8: phase[0].rotation: mode SINGLE"),
]
STARTS = [
    ("", "a.toml: the field 'initial' is missing"),
    ("[initial]", "a.toml:2: initial: give either joints (six angles) or a pose"),
    ("[initial]\njoints = [0, 1]", "a.toml:3: initial.joints: Expected `array` of length 6, got 2"),
    (
        "[initial]\njoints = [0, 9, 0, 0, 0, 0]",
        "a.toml:3: initial.joints: shoulder_pitch at 515.662 deg is outside its hard limits -2 to 145 deg",
    ),
    ("[initial]\njoints = ['1 m', 0, 0, 0, 0, 0]", "a.toml:3: initial.joints[0]: '1 m' is not an angle"),
    ("[initial]\njoints = [0, 1, -1, 0, 0, 0]\nrates = [1, 0, 0, 0, 0, 0]", "a.toml:4: initial.rates: shoulder_yaw"),
    ("[initial.pose]\nframe = 'L'\nposition = [99, 0, 0]", "a.toml:2: initial.pose: the arm cannot reach this pose"),
    (
        "[initial.pose]\nframe = 'L'\nposition = [9, 0, 0]\nmatrix = [[nan, 0, 0], [0, 1, 0], [0, 0, 1]]",
        "a.toml:5: initial.pose.matrix: expected finite numbers",
    ),
    (
        "[initial.pose]\nframe = 'L'\nposition = [9, 0, 0]\nmatrix = [[1e300, 0, 0], [0, 1, 0], [0, 0, 1]]",
        "a.toml:5: initial.pose.matrix: is not a right-handed orthonormal matrix",
    ),
    (
        "[initial]\njoints = [0, 1, -1, 0, 0, 0]\npose = { position = [0, 0, 0] }",
        "a.toml:2: initial: give either joints (six angles) or a pose",
    ),
]
CASES = (
    [(HEAD + line + "\n" + INITIAL, said) for line, said in HEADS]
    + [(HEAD + INITIAL + table, said) for table, said in TABLES]
    + [(HEAD + INITIAL + PHASE + phase, said) for phase, said in PHASES]
    + [(HEAD + start, said) for start, said in STARTS]
)


@pytest.mark.parametrize(("text", "said"), CASES, ids=[said[:60] for _, said in CASES])
def test_a_mistake_is_told_with_its_line(text: str, said: str) -> None:
    found = problems(text)
    assert any(problem.startswith(said) for problem in found), found


@pytest.mark.parametrize(("text", "said"), CASES, ids=[said[:60] for _, said in CASES])
def test_one_mistake_is_told_once(text: str, said: str) -> None:
    joints = re.search(r"shoulder_yaw: (reach|expected)", said)  # said of each joint
    assert len(problems(text)) == 1 or joints


def test_mistakes_of_every_kind_come_together() -> None:
    text = "mode = 9\ncontrol_period = 9\n[initial]\njoints = [9, 9, 9, 9, 9, 99]\n" + PHASE + "mode = 4\n"
    found = problems(HEAD + text + PHASE + "mode = 8\njoint = 'thumb'\n")
    assert len(found) == 11
    for part in ("mode: no mode 9", "control_period", "shoulder_yaw", "wrist_roll", "needs a duration", "thumb"):
        assert any(part in problem for problem in found)


def test_a_broken_arm_file_is_told_with_its_own_lines(tmp_path: Path) -> None:
    (tmp_path / "broken.toml").write_text('name = "b"\nunits = "cubits"\n')
    file = tmp_path / "s.toml"
    file.write_text(HEAD + "arm = 'broken.toml'\n" + INITIAL)
    with pytest.raises(ScenarioError) as caught:
        load_scenario(file)
    assert all(problem.startswith("s.toml:2: arm: broken.toml") for problem in caught.value.problems)
    assert any("broken.toml:2: units" in problem for problem in caught.value.problems)


def test_a_file_that_is_not_there_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ScenarioError, match="cannot be read: No such file"):
        load_scenario(tmp_path / "none.toml")
