"""Mistakes in a scenario file, and the location, names and values that are reported for them.

Each pattern begins with the location. After it come only names and values, not the wording of the message.
"""

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
    ("next = 'moon'", r"a\.toml:2: next: .*'moon'"),
    (
        "mode = 9",
        r"a\.toml:2: mode: .*9.*1.*8.*OPR CMD.*AUTO 1.*AUTO 2.*AUTO 3.*AUTO 4",
    ),
    ("mode = 0", r"a\.toml:2: mode: .*0.*1.*8"),
    ("mode = 'orb unl'", r"a\.toml:2: mode: .*'orb unl'.*1.*8"),
    ("mode = 6", r"a\.toml:2: mode: PL.*payload.*\[payload\]"),
    ("mode = 7", r"a\.toml:2: mode: ORB LD.*payload.*\[payload\]"),
    ("mode = 'ORB LD'", r"a\.toml:2: mode: ORB LD.*payload"),
    ("mode = 'PL'", r"a\.toml:2: mode: PL.*payload"),
    ("mode = 'AUTO 3'", r"a\.toml:2: mode: AUTO 3.*\[\[sequence\]\].*slot.*3"),
    ("law = 'feedback'", r"a\.toml:2: law: .*position.*closed loop.*open loop.*'feedback'"),
    ("sequence = []\nmode = 'AUTO 1'", r"a\.toml:3: mode: AUTO 1 .*\[\[sequence\]\]"),
    ("mode = 2.0", r"a\.toml:2: mode: .*`int \| str`.*`float`"),
    (
        "arm = 'canadarm3'",
        r"a\.toml:2: arm: .*'canadarm3'.*concept-1972, srms",
    ),
    ("arm = 'none.toml'", r"a\.toml:2: arm: none\.toml: .*No such file or directory"),
    ('arm = "a\\u0000.toml"', r"a\.toml:2: arm: "),
    ("worksite = 'moon'", r"a\.toml:2: worksite: 'moon'"),
    ("[payload]\nmass = 1\ninertia = [1, 1, 3]", r"a\.toml:4: payload\.inertia: .*1, 1, 3 kg m2"),
    ("plant = 'rigid'\npayload = { mass = 1e-9 }", r"a\.toml:2: plant: .*'rigid'.*1e-09 kg"),
    ("plant = 'wooden'", r"a\.toml:2: plant: .*kinematic.*'wooden'"),
    ("rate = 'fast'", r"a\.toml:2: rate: .*coarse.*vernier.*'fast'"),
    ("soft_stops = 'off'", r"a\.toml:2: soft_stops: .*mended, as-flown.*'off'"),
    ("seed = -1", r"a\.toml:2: seed: got -1; .*0 to 9"),
    ("seed = 99999999999999999999999999", r"a\.toml:2: seed: "),
    ("seed = 1.5", r"a\.toml:2: seed: .*`int`.*`float`"),
    ("strict = 'yes'", r"a\.toml:2: strict: .*`bool`.*`str`"),
    ("control_period = 0.5", r"a\.toml:2: control_period: got 0\.5 s; .*0\.001 to 0\.2 s"),
    ("control_period = '0 ms'", r"a\.toml:2: control_period: got 0 s; .*0\.001 to 0\.2 s"),
    ("control_period = nan", r"a\.toml:2: control_period: .*finite.*nan"),
    ("command_delay = -1", r"a\.toml:2: command_delay: got -1 s; .*0 to 30 s"),
    ("command_delay = 0.03", r"a\.toml:2: command_delay: .*0\.03 s.*1\.5.*0\.02 s"),
    ("telemetry_delay = '31 s'", r"a\.toml:2: telemetry_delay: got 31 s; .*0 to 30 s"),
    ("camera_delay = -0.1", r"a\.toml:2: camera_delay: got -0\.1 s; .*0 to 30 s"),
    ("camera_delay = nan", r"a\.toml:2: camera_delay: .*finite.*nan"),
    ("camera_delay = '2 m'", r"a\.toml:2: camera_delay: "),
    ("duration = inf", r"a\.toml:2: duration: .*finite.*inf"),
    ("duration = -1", r"a\.toml:2: duration: got -1 s; .*0 to 86400 s"),
    ("duration = 1e9", r"a\.toml:2: duration: got 1e\+09 s; .*0 to 86400 s"),
    ("duration = 1.01", r"a\.toml:2: duration: .*1\.01 s.*50\.5.*0\.02 s"),
    ("duration = 1e-9", r"a\.toml:2: duration: "),
    ("duration = '2 deg'", r"a\.toml:2: duration: '2 deg'"),
    ("duration = true", r"a\.toml:2: duration: .*'20 ms'.*True"),
    ("arrive_within = 0", r"a\.toml:2: arrive_within: .*above.*0.*0 m"),
    ("arrive_within_angle = -1", r"a\.toml:2: arrive_within_angle: .*above.*0.*-1 rad"),
    ("title = 'again'", r"a\.toml: Cannot overwrite a value"),
    ("colour = 'red'", r"a\.toml:2: colour: .*title.*initial.*text.*arm"),
    ("phase = 3", r"a\.toml:2: phase: .*`array`.*`int`"),
]
TABLES = [
    ("[limits]\nhard = 3", r"a\.toml:5: limits\.hard: .*`array`.*`int`"),
    ("[limits]\nhard = [[0, 1]]", r"a\.toml:5: limits\.hard: .*6 values.*got 1"),
    (
        "[limits]\nreach = [[-9, 9], [0.1, 2], [-2, -0.1], [-1, 1], [-1, 1], [-1, 1]]",
        r"a\.toml:4: limits: shoulder_yaw: reach.*soft.*hard.*hard.*-180.*180",
    ),
    (
        "[limits]\nvernier = [1, 1, 1, 1, 1, 1]",
        r"a\.toml:4: limits: shoulder_yaw: .*0.*vernier.*coarse.*servo.*1",
    ),
    (
        "[limits]\nservo = [0, 0.01, 0.01, 0.01, 0.01, 0.01]",
        r"a\.toml:5: limits\.servo\[0\]: got 0 rad/s or m/s; .*1e-06",
    ),
    ("[limits.por]\ntranslation = 0", r"a\.toml:5: limits\.por\.translation: got 0 m/s; .*1e-06 to 10 m/s"),
    ("[limits.por]\nreached_in = '2 m'", r"a\.toml:5: limits\.por\.reached_in: '2 m'"),
    (
        "[limits.por]\nvernier_translation = 9",
        r"a\.toml:5: limits\.por\.vernier_translation: .*coarse.*0\.6096.*9",
    ),
    ("[limits.por]\nreached_in = -1", r"a\.toml:5: limits\.por\.reached_in: got -1 s; .*0\.001 to 3600 s"),
    (
        "[[sequence]]\nslot = 5\npoint = [{ target = { joints = [0, 1, -1, 0, 0, 0] } }]",
        r"a\.toml:5: sequence\[0\]\.slot: got 5; .*1 to 4",
    ),
    ("[[sequence]]\nslot = 1\npoint = []", r"a\.toml:6: sequence\[0\]\.point: .*`array`.*1"),
    (
        "[[sequence]]\nslot = 1\n[[sequence.point]]\ntarget = {}",
        r"a\.toml:7: sequence\[0\]\.point\[0\]\.target: .*joints.*position",
    ),
    (
        "sequence = [{ slot = 2, point = [{ target = { joints = [0, 9, -1, 0, 0, 0] } }] }]",
        r"a\.toml:4: initial\.sequence: unknown",
    ),
    (
        "[[sequence]]\nslot = 2\npoint = [{ target = { joints = [0, 9, -1, 0, 0, 0] } }]",
        r"a\.toml:6: sequence\[0\]\.point\[0\]\.target\.joints: shoulder_pitch.*515\.662 deg.*hard",
    ),
    (
        "[[sequence]]\nslot = 2\npoint = [{ target = { joints = [0, 1, -1, 0, 0, 0] } }]\n"
        "[[sequence]]\nslot = 2\npoint = [{ target = { joints = [0, 1, -1, 0, 0, 0] } }]",
        r"a\.toml:8: sequence\[1\]\.slot: AUTO 2.*slot",
    ),
    ("[payload]", r"a\.toml:4: payload: .*'mass'"),
    ("[payload]\nmass = 0", r"a\.toml:5: payload\.mass: .*above.*0.*0 kg"),
    ("[payload]\nmass = 1\nmatrix = [[1, 0, 0], [0, 1, 0], [0, 0, -1]]", r"a\.toml:6: payload\.matrix: .*orthonormal"),
    (
        "[payload]\nmass = 1\nmatrix = [[1e300, 0, 0], [0, 1, 0], [0, 0, 1]]",
        r"a\.toml:6: payload\.matrix\[0\]\[0\]: got 1e\+300; ",
    ),
    (
        "[payload]\nmass = 1\nmatrix = [[nan, 0, 0], [0, 1, 0], [0, 0, 1]]",
        r"a\.toml:6: payload\.matrix\[0\]\[0\]: got nan; ",
    ),
    ("[phase]\nmode = 4", r"a\.toml:4: phase: .*`array`.*`object`"),
    ("[clearance]\nwarning = 0", r"a\.toml:5: clearance\.warning: .*above.*0.*0 m"),
    ("[clearance]\ncaution = '60 cm'\nwarning = 0.6", r"a\.toml:5: clearance\.caution: .*above.*0\.6 m"),
    ("[clearance]\ncaution = '10 cm'", r"a\.toml:5: clearance\.caution: .*above.*0\.15 m.*0\.1 m"),
    ("[clearance]\nwarning = '3 kg'", r"a\.toml:5: clearance\.warning: '3 kg'"),
]
PHASES = [
    ("", r"a\.toml:4: phase\[0\]: .*'mode'"),
    ("mode = 11\nduration = 1", r"a\.toml:5: phase\[0\]\.mode: .*11.*1.*8"),
    ("mode = 1\nduration = 1", r"a\.toml:4: phase\[0\]: .*OPR CMD.*target"),
    ("mode = 6\nduration = 1", r"a\.toml:5: phase\[0\]\.mode: PL.*payload"),
    ("mode = 7\nduration = 1", r"a\.toml:5: phase\[0\]\.mode: ORB LD.*payload"),
    ("mode = 'AUTO 4'", r"a\.toml:5: phase\[0\]\.mode: AUTO 4.*\[\[sequence\]\].*slot.*4"),
    ("mode = 'TEST'", r"a\.toml:4: phase\[0\]: .*TEST.*duration"),
    ("mode = 'TEST'\nduration = 1\ndrive = 1", r"a\.toml:7: phase\[0\]\.drive: .*TEST.*drive.*nothing"),
    ("mode = 'DIRECT'\ndrive = 1\nduration = 1", r"a\.toml:4: phase\[0\]: .*DIRECT.*joint"),
    (
        "mode = 4\nduration = 1\npayload_axes = true",
        r"a\.toml:7: phase\[0\]\.payload_axes: .*ORB UNL.*payload_axes",
    ),
    ("mode = 4\nduration = 1\nlaw = 'position'", r"a\.toml:7: phase\[0\]\.law: .*ORB UNL.*law"),
    (
        "mode = 3\ntarget = { joints = [0, 1, -1, 0, 0, 0] }\nlaw = 'position'",
        r"a\.toml:7: phase\[0\]\.law: .*3.*law.*law",
    ),
    ("mode = 4", r"a\.toml:4: phase\[0\]: .*ORB UNL.*duration"),
    ("mode = 4\nduration = 0", r"a\.toml:6: phase\[0\]\.duration: .*above.*0.*0 s"),
    ("mode = 4\nduration = 1\ntranslation = [0, 0, 2]", r"a\.toml:7: phase\[0\]\.translation"),
    ("mode = 4\nduration = 1\ntranslation = [0, 0, nan]", r"a\.toml:7: phase\[0\]\.translation"),
    ("mode = 4\nduration = 1\njoint = 'wrist_roll'", r"a\.toml:7: phase\[0\]\.joint: .*ORB UNL.*joint"),
    ("mode = 2", r"a\.toml:4: phase\[0\]: .*OPR CMD.*target"),
    ("mode = 2\ntarget = {}", r"a\.toml:6: phase\[0\]\.target: .*joints.*position"),
    (
        "mode = 2\ntarget = { joints = [0, 0, 0, 0, 0, 0], yaw = 1 }",
        r"a\.toml:6: phase\[0\]\.target: .*joints.*position.*orientation",
    ),
    (
        "mode = 2\ntarget = { position = [1, 1, 1], yaw = 0, matrix = [[1, 0, 0], [0, 1, 0], [0, 0, 1]] }",
        r"a\.toml:6: phase\[0\]\.target: .*matrix.*roll.*pitch.*yaw",
    ),
    (
        "mode = 2\ntarget = { position = [1, 1, 1], matrix = [[2, 0, 0], [0, 1, 0], [0, 0, 1]] }",
        r"a\.toml:6: phase\[0\]\.target\.matrix\[0\]\[0\]: got 2; ",
    ),
    (
        "mode = 2\ntarget = { joints = [0, 0, 0, 0, 3, 0] }",
        r"a\.toml:6: phase\[0\]\.target\.joints: wrist_yaw.*171\.887 deg.*hard.*-121\.3.*121\.3 deg",
    ),
    (
        "mode = 2\ntarget = { position = [1, 1, 1], frame = 'moon' }",
        r"a\.toml:6: phase\[0\]\.target\.frame: .*'moon'.* L, orbiter, panel, bay",
    ),
    ("mode = 2\ntarget = { joints = [0, 1, -1, 0, 0, 0, 0] }", r"a\.toml:6: phase\[0\]\.target\.joints: .*6.*got 7"),
    ("mode = 'MASTER'\nmaster = [0, 1]", r"a\.toml:6: phase\[0\]\.master: .*6 values.*got 2"),
    (
        "mode = 4\nduration = 1\nlimits = { acceleration = [1, 1, 1, 1, 1] }",
        r"a\.toml:7: phase\[0\]\.limits\.acceleration: .*6 values.*got 5",
    ),
    ("mode = 8\ndrive = 1\nduration = 1", r"a\.toml:4: phase\[0\]: .*SINGLE.*joint"),
    ("mode = 8\njoint = 'thumb'\nduration = 1", r"a\.toml:6: phase\[0\]\.joint: .*'thumb'.*shoulder_yaw"),
    ("mode = 8\njoint = 'wrist_roll'", r"a\.toml:4: phase\[0\]: .*SINGLE.*joint_at.*drive"),
    (
        "mode = 8\njoint = 'wrist_roll'\njoint_at = 0\ndrive = 1",
        r"a\.toml:4: phase\[0\]: .*joint_at.*drive",
    ),
    (
        "mode = 8\njoint = 'wrist_roll'\njoint_at = 10",
        r"a\.toml:7: phase\[0\]\.joint_at: wrist_roll.*572\.958 deg.*hard.*-447.*447 deg",
    ),
    (
        "mode = 8\njoint = 'wrist_roll'\njoint_at = 0\nrotation = [1, 0, 0]",
        r"a\.toml:8: phase\[0\]\.rotation: .*SINGLE",
    ),
]
STARTS = [
    ("", r"a\.toml: .*'initial'"),
    ("[initial]", r"a\.toml:2: initial: .*joints.*pose"),
    ("[initial]\njoints = [0, 1]", r"a\.toml:3: initial\.joints: .*6 values.*wrist_roll.*got 2"),
    (INITIAL + "rates = [0, 0, 0, 0, 0, 0, 0]", r"a\.toml:4: initial\.rates: .*6 values.*got 7"),
    ("[initial]\npose = { position = [10, 0, -3], roll = 0 }\nnear = [0, 1]", r"a\.toml:4: initial\.near: .*6.*got 2"),
    (INITIAL + "[limits]\ncoarse = [0.01]", r"a\.toml:5: limits\.coarse: .*6 values.*got 1"),
    (
        "[initial]\njoints = [0, 9, 0, 0, 0, 0]",
        r"a\.toml:3: initial\.joints: shoulder_pitch.*515\.662 deg.*hard.*-2.*145 deg",
    ),
    ("[initial]\njoints = ['1 m', 0, 0, 0, 0, 0]", r"a\.toml:3: initial\.joints\[0\]: .* got a length, 1 m"),
    ("[initial]\njoints = [0, 1, -1, 0, 0, 0]\nrates = [1, 0, 0, 0, 0, 0]", r"a\.toml:4: initial\.rates: shoulder_yaw"),
    ("[initial.pose]\nframe = 'L'\nposition = [99, 0, 0]", r"a\.toml:2: initial\.pose: .*arm.*reach.*pose"),
    (
        "[initial.pose]\nframe = 'L'\nposition = [9, 0, 0]\nmatrix = [[nan, 0, 0], [0, 1, 0], [0, 0, 1]]",
        r"a\.toml:5: initial\.pose\.matrix\[0\]\[0\]: got nan; .*-1\.001 to 1\.001",
    ),
    (
        "[initial.pose]\nframe = 'L'\nposition = [9, 0, 0]\nmatrix = [[1e300, 0, 0], [0, 1, 0], [0, 0, 1]]",
        r"a\.toml:5: initial\.pose\.matrix\[0\]\[0\]: got 1e\+300; ",
    ),
    (
        "[initial]\njoints = [0, 1, -1, 0, 0, 0]\npose = { position = [0, 0, 0] }",
        r"a\.toml:2: initial: .*joints.*pose",
    ),
]
STEP = '[[step]]\ntitle = "s"\n'
"""A step; it begins in line 4, and its next line is line 6."""
MOVED = "done = { moved = 1 }\n"
STEPS = [
    ("text = 'a'", r"a\.toml:4: step\[0\]: .*'?done'?"),
    ("text = 'a'\ndone = {}", r"a\.toml:7: step\[0\]\.done: .*looked.*moved.*alarm"),
    (MOVED + "text = 'Hold {W}'", r"a\.toml:7: step\[0\]\.text: .*\{W\}.*\{2 in\}.*\{wanting\}.*\+X.*proceed"),
    (MOVED + "text = 'Up {2 lb}'", r"a\.toml:7: step\[0\]\.text: .*\{2 lb\}"),
    (MOVED + "text = 'Wait for *RIGID'", r"a\.toml:7: step\[0\]\.text: .*\*"),
    (MOVED + "text = 'a'\nuses = ['+X']", r"a\.toml:8: step\[0\]\.uses\[0\]: .*'-X: back'.*'\+X'"),
    (MOVED + "text = 'a'\nuses = ['jump: up']", r"a\.toml:8: step\[0\]\.uses\[0\]: .*'jump'.*\+X.*proceed"),
    (MOVED + "text = 'a'\ncameras = ['A', 'Q']", r"a\.toml:8: step\[0\]\.cameras\[1\]: .*'Q'.*A, B, C"),
    (MOVED + "text = 'a'\nmode = 'FLY'", r"a\.toml:8: step\[0\]\.mode: .*'FLY'.*ORB UNL"),
    (MOVED + "text = 'a'\njoint = 'elbow_pitch'", r"a\.toml:4: step\[0\]: .*joint.*joint_at"),
    (MOVED + "text = 'a'\njoint = 'knee'\njoint_at = 0", r"a\.toml:8: step\[0\]\.joint: .*'knee'.*elbow_pitch"),
    (MOVED + "text = 'a'\ngroups = ['lamps']", r"a\.toml:8: step\[0\]\.groups\[0\]: .*thc.*effector.*'lamps'"),
    (MOVED + "text = 'a'\ntarget = { cargo = 'x' }", r"a\.toml:8: step\[0\]\.target\.cargo: .*'x'"),
    ("text = 'a'\ndone = { above = 1 }", r"a\.toml:7: step\[0\]\.done\.above: .*cargo.*seat"),
    ("text = 'a'\ndone = { berth = 'x' }", r"a\.toml:7: step\[0\]\.done\.berth: .*'x'.*bay"),
    ("text = 'a'\ndone = { mode = 'x' }", r"a\.toml:7: step\[0\]\.done\.mode: .*'x'.*ORB UNL"),
    ("text = 'a'\ndone = { held = 1 }", r"a\.toml:7: step\[0\]\.done\.held: .*`bool`.*`int`"),
]
CASES = (
    [(HEAD + line + "\n" + INITIAL, pattern) for line, pattern in HEADS]
    + [(HEAD + INITIAL + table, pattern) for table, pattern in TABLES]
    + [(HEAD + INITIAL + PHASE + phase, pattern) for phase, pattern in PHASES]
    + [(HEAD + INITIAL + STEP + step, pattern) for step, pattern in STEPS]
    + [(HEAD + start, pattern) for start, pattern in STARTS]
)


@pytest.mark.parametrize(("text", "pattern"), CASES, ids=[pattern[:60] for _, pattern in CASES])
def test_mistake_is_reported_with_its_line(text: str, pattern: str) -> None:
    found = problems(text)
    assert any(re.match(pattern, problem) for problem in found), found


@pytest.mark.parametrize(("text", "pattern"), CASES, ids=[pattern[:60] for _, pattern in CASES])
def test_mistake_is_reported_once(text: str, pattern: str) -> None:
    for_each_joint = "limits: shoulder_yaw: " in pattern
    assert len(problems(text)) == 1 or for_each_joint


def test_mistakes_of_all_kinds_are_reported_together() -> None:
    text = "mode = 9\ncontrol_period = 9\n[initial]\njoints = [9, 9, 9, 9, 9, 59]\n" + PHASE + "mode = 4\n"
    found = problems(HEAD + text + PHASE + "mode = 8\njoint = 'thumb'\n")
    assert len(found) == 11
    for part in ("mode: no mode 9", "control_period", "shoulder_yaw", "wrist_roll", "needs a duration", "thumb"):
        assert any(part in problem for problem in found)


def test_invalid_arm_file_is_reported_with_its_own_lines(tmp_path: Path) -> None:
    (tmp_path / "broken.toml").write_text('name = "b"\nunits = "cubits"\n')
    file = tmp_path / "s.toml"
    file.write_text(HEAD + "arm = 'broken.toml'\n" + INITIAL)
    with pytest.raises(ScenarioError) as caught:
        load_scenario(file)
    assert all(problem.startswith("s.toml:2: arm: broken.toml") for problem in caught.value.problems)
    assert any("broken.toml:2: units" in problem for problem in caught.value.problems)


def test_missing_scenario_file_is_rejected(tmp_path: Path) -> None:
    with pytest.raises(ScenarioError, match="cannot be read: No such file"):
        load_scenario(tmp_path / "none.toml")
