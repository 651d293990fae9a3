"""Command line, without the commands on recordings."""

from __future__ import annotations

import json
import math
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

import aftdeck
from aftdeck.scenario.load import built_in, load_scenario
from tests.commands import Run
from tests.waits import WAIT_S


def in_a_process(*arguments: str, **environment: str) -> subprocess.CompletedProcess[bytes]:
    command = [sys.executable, "-m", "aftdeck", *arguments]
    return subprocess.run(command, capture_output=True, timeout=WAIT_S, env={**os.environ, **environment}, check=False)


# --- help and version -------------------------------------------------------------------------------------


def test_help_lists_every_command(run: Run) -> None:
    code, out, _ = run("--help")
    assert code == 0
    for command in ("fly", "run", "check", "scenarios", "arms", "arm"):
        assert f"\n  {command} " in out
    assert "..." not in out.replace("[ARGS]...", ""), "a description is cut off"


@pytest.mark.parametrize("command", ["fly", "run", "check", "scenarios", "arms", "arm"])
def test_help_of_every_command_has_an_example_and_fits_80_columns(run: Run, command: str) -> None:
    code, out, _ = run(command, "--help")
    assert code == 0
    assert f"aftdeck {command}" in out.partition("Example")[2]
    assert max(len(line) for line in out.splitlines()) <= 80


def test_version_is_that_of_the_package(run: Run) -> None:
    assert run("--version") == (0, f"{aftdeck.__version__}\n", "")


def test_missing_command_prints_the_help(run: Run) -> None:
    code, out, err = run()
    assert code == 2
    assert "scenarios" in out + err


@pytest.mark.parametrize(
    ("arguments", "part"),
    [
        (("soar",), "'soar'"),
        (("run",), "'SCENARIO'"),
        (("run", "first-flight", "--fast"), "--fast"),
        (("fly", "--port", "many"), "'--port'"),
        (("arm", "srms", "sideways"), "'sideways'"),
        (("arm", "srms", "forward", *"000000", "--frame", "moon"), "'moon'"),
    ],
)
def test_wrong_usage_exits_with_2_and_names_the_argument(run: Run, arguments: tuple[str, ...], part: str) -> None:
    code, out, err = run(*arguments)
    assert (code, out) == (2, "")
    assert part in err


@pytest.mark.parametrize(
    ("arguments", "parts"),
    [
        (arguments, parts)
        for arguments, *parts in [
            (("run", "nowhere"), "'nowhere'", "concept-1972, "),
            (("run", "nowhere.toml"), "nowhere.toml: ", "No such file or directory"),
            (("fly", "nowhere"), "'nowhere'", "concept-1972, "),
            (("fly", "--port", "70000"), "0 to 65535", "got 70000"),
            (("fly", "--port", "-1"), "0 to 65535", "got -1"),
            (("fly", "--host", ".."), "'..'"),
            (("fly", "--demo", "--operator", "perfect"), "--demo, --policy and --operator", "use one of them"),
            (("fly", "tutorial", "--operator", "quick"), "operator: got 'quick'", "perfect or human"),
            (("fly", "--policy", "none.npz"), "none.npz: cannot be read", "No such file"),
            (("arm", "canadarm9", "limits"), "'canadarm9'"),
            (("arm", "srms", "forward", "1", "2"), "forward", "6", "got 2: 1 2"),
            (("arm", "srms", "limits", "1"), "limits", "0", "got 1: 1"),
            (("arm", "srms", "forward", *"00000", "x"), "forward: 'x'"),
            (("arm", "srms", "forward", *"00000", "nan"), "forward: ", "got 'nan'"),
            (("arm", "srms", "forward", *"00000", "-inf"), "forward: ", "got '-inf'"),
            (("arm", "srms", "forward", *"00000", "1e999"), "forward: ", "got '1e999'"),
            (("arm", "srms", "inverse", "99", *"00000"), "pose"),
        ]
    ],
)
def test_invalid_input_exits_with_2_and_one_line(run: Run, arguments: tuple[str, ...], parts: list[str]) -> None:
    code, out, err = run(*arguments)
    assert (code, out) == (2, "")
    assert err.startswith("aftdeck: ") and all(part in err for part in parts), err
    assert err.count("\n") == 1


# --- run and check ----------------------------------------------------------------------------------------


def test_run_prints_the_summary_as_json(run: Run) -> None:
    summary = run.json("run", "uncradle", "--seed", "7")
    assert set(summary) == {
        "scenario", "seed", "version", "ended", "time_s", "phase", "joints_rad", "tip", "target",
        "position_error_m", "rotation_error_rad", "worst_rate_ratio", "min_clearance_m", "events", "frames_sha256",
        "true_position_error_m", "true_rotation_error_rad",
    }  # fmt: skip
    assert (summary["ended"], summary["seed"], summary["scenario"]) == ("completed", 7, "uncradle")
    degrees = [math.degrees(q) for q in summary["joints_rad"]]
    assert degrees == pytest.approx([0.0, 25.0, -25.0, 5.0, 0.0, 0.0], abs=1e-3)


def test_run_prints_the_summary_as_text(run: Run) -> None:
    code, out, err = run("run", "uncradle")
    assert (code, err) == (0, "")
    assert out.startswith("uncradle: completed after ")
    assert "frames     sha256 " in out


FAULT = """
title = "Too late"
text = "The elbow cannot be there in a second."
arm = "srms"
duration = "60 s"
[initial]
joints = [0, "60 deg", "-90 deg", 0, 0, 0]
[[phase]]
name = "too soon"
mode = "SINGLE"
joint = "elbow_pitch"
joint_at = "-100 deg"
duration = "1 s"
"""


def test_run_that_ends_in_a_fault_exits_with_1(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "late.toml"
    path.write_text(FAULT, encoding="utf-8")
    code, out, _ = run("run", str(path))
    assert code == 1
    assert out.startswith("late: ENDED IN A FAULT after ")
    code, out, _ = run("run", str(path), "--json")
    assert (code, json.loads(out)["ended"]) == (1, "fault")


@pytest.mark.slow
def test_check_passes_every_built_in_scenario(run: Run) -> None:
    for name in ("first-flight", "sts-400-closed", "uncradle"):
        code, out, err = run("check", name)
        assert (code, err) == (0, "")
        assert out.startswith(f"{name}: good. ")
        assert run.json("check", name) == {"scenario": name, "problems": [], "cautions": []}


def test_run_prints_cautions_on_standard_error_only(run: Run, tmp_path: Path) -> None:
    text = load_scenario("concept-1972").text.replace('"payload"', '"free flyer"')
    path = tmp_path / "wide.toml"
    duration = next(line for line in text.splitlines() if line.startswith("duration"))
    wide = text.replace(duration, 'duration = "0.1 s"') + '\n[dimensions]\nflyer_width = "15.5 ft"\n'
    path.write_text(wide, encoding="utf-8")
    code, out, err = run("run", str(path), "--json")
    assert code == 0 and json.loads(out)["ended"] == "time"
    assert re.search(r"^caution: wide\.toml:\d+: cargo\[0\]: .*bay wall", err, re.MULTILINE), err
    path.write_text(wide.replace("15.5 ft", "13 ft"), encoding="utf-8")
    assert "caution:" not in run("run", str(path), "--json")[2]


def test_check_lists_every_error_with_its_line(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "wrong.toml"
    wrong = FAULT.replace('"60 s"', '"60 kg"').replace('"1 s"', '"1 s"\nspeed = 3').replace("-100 deg", "-100 s")
    path.write_text(wrong, encoding="utf-8")
    code, out, err = run("check", str(path))
    assert (code, out) == (2, "")
    lines = wrong.splitlines()
    for text, start in (("kg", "duration"), ("-100 s", "joint_at"), ("speed", "speed")):
        number = next(i for i, line in enumerate(lines, 1) if line.startswith(start))
        assert any(f"wrong.toml:{number}: " in line and text in line for line in err.splitlines()), err
    code, out, err = run("check", str(path), "--json")
    assert (code, err) == (2, "")
    assert len(json.loads(out)["problems"]) == 3


def test_check_reports_an_impossible_capture(run: Run, tmp_path: Path) -> None:
    text = load_scenario("concept-1972").text
    file = tmp_path / "over.toml"
    file.write_text(text.replace('above = "0.36 in"', 'above = "1 in"'))
    code, out, err = run("check", str(file))
    assert (code, out) == (2, "")
    assert "over: initialise.extraction.grasped: " in err


def test_check_reports_a_missing_arm(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "armless.toml"
    path.write_text(FAULT.replace('"srms"', '"nowhere.toml"'), encoding="utf-8")
    code, out, _ = run("check", str(path), "--json")
    assert code == 2
    assert "nowhere" in json.loads(out)["problems"][0]


# --- lists and the arm ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "arguments",
    [("scenarios",), ("arms",), ("arm", "srms", "modes"), ("arm", "srms", "limits"),
     ("arm", "srms", "limits", "--deg"), ("arm", "concept-1972", "limits", "--deg"), ("arm", "concept-1972", "modes")],
    ids=" ".join,
)  # fmt: skip
def test_tables_fit_80_columns(run: Run, arguments: tuple[str, ...]) -> None:
    code, out, err = run(*arguments)
    assert (code, err) == (0, "")
    assert max(len(line) for line in out.splitlines()) <= 80
    if "limits" in arguments:
        assert all(f"\n{joint} " in out for joint in aftdeck.load_arm(arguments[1]).joints)


def test_lists_are_printed_as_json(run: Run) -> None:
    _, out, _ = run("scenarios", "--json")
    assert [row["name"] for row in json.loads(out)] == list(built_in())
    _, out, _ = run("arms", "--json")
    assert [row["name"] for row in json.loads(out)] == ["concept-1972", "srms"]
    _, out, _ = run("arm", "srms", "modes", "--json")
    assert {row["position"]: row["laws"] for row in json.loads(out)} == {
        "OPR CMD": [2, 1, 3], "AUTO 1": [2, 1, 3], "AUTO 2": [2, 1, 3], "AUTO 3": [2, 1, 3], "AUTO 4": [2, 1, 3],
        "TEST": [0], "ORB UNL": [4], "END EFF": [5], "ORB LD": [4, 7], "PL": [6], "SINGLE": [8], "DIRECT": [9],
        "MASTER": [10],
    }  # fmt: skip


def test_limits_are_printed_in_the_given_unit(run: Run) -> None:
    limits = run.json("arm", "srms", "limits", "--deg")
    assert (limits["angle_unit"], limits["rate_unit"]) == ("deg", "deg/s")
    in_radians = run.json("arm", "srms", "limits")
    for row, other in zip(limits["joints"], in_radians["joints"], strict=True):
        assert row["hard"] == pytest.approx([math.degrees(x) for x in other["hard"]], abs=1e-6)
        assert row["servo_rate"] == pytest.approx(math.degrees(other["servo_rate"]), abs=1e-6)


NEGATIVE = ("-10", "25.5", "-2.5e1", "-.5", "-0", "+7")


@pytest.mark.parametrize("frame", ["L", "orbiter", "panel"])
@pytest.mark.parametrize("name", ["srms", "concept-1972"])
def test_inverse_reverses_forward_in_every_coordinate_frame(run: Run, name: str, frame: str) -> None:
    pose = run.json("arm", name, "forward", *NEGATIVE, "--deg", "--frame", frame)
    assert pose["frame"] == frame
    assert pose["position_unit"] == ("in" if frame == "panel" else "m")
    numbers = [*pose["position"], pose["roll"], pose["pitch"], pose["yaw"]]
    answer = run.json("arm", name, "inverse", *(repr(x) for x in numbers), "--deg", "--frame", frame)
    expected = [float(text) for text in NEGATIVE]
    assert any(row == pytest.approx(expected, abs=1e-6) for row in answer["solutions"])


def test_cradled_arm_has_the_panels_cradled_position(run: Run) -> None:
    pose = run.json("arm", "srms", "forward", *"000000", "--frame", "panel")
    assert pose["position"] == pytest.approx([-1282.5, -108.0, -445.0], abs=0.5)


# --- terminals and pipes ----------------------------------------------------------------------------------


@pytest.mark.slow
def test_ascii_terminal_gets_question_marks() -> None:
    plain = in_a_process("scenarios", PYTHONIOENCODING="ascii", PYTHONUTF8="0")
    assert (plain.returncode, plain.stderr) == (0, b"")
    assert b"+25?" in plain.stdout
    for_scripts = in_a_process("scenarios", "--json", PYTHONIOENCODING="ascii", PYTHONUTF8="0")
    texts = {row["name"]: row["text"] for row in json.loads(for_scripts.stdout)}
    assert "+25°" in texts["uncradle"]


def test_utf_8_terminal_gets_all_characters() -> None:
    assert "+25°, elbow to" in in_a_process("scenarios", PYTHONIOENCODING="utf-8", COLUMNS="200").stdout.decode()


def test_reader_that_closes_the_pipe_early_is_no_error() -> None:
    read, write = os.pipe()
    os.close(read)
    command = [sys.executable, "-m", "aftdeck", "scenarios"]
    try:
        ended = subprocess.run(command, stdout=write, stderr=subprocess.PIPE, timeout=WAIT_S, check=False)
    finally:
        os.close(write)
    assert ended.stderr == b""
    assert ended.returncode == 141


def test_help_imports_no_slow_library() -> None:
    code = (
        "import sys\nfrom aftdeck.cli import main\nsys.argv = ['aftdeck', '--help']\n"
        "try:\n    main()\nexcept SystemExit:\n    pass\n"
        "print(sorted({'numpy', 'numba', 'mujoco', 'pint', 'uvicorn', 'starlette', 'rich'} & set(sys.modules)))"
    )
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=WAIT_S, check=True)
    assert ended.stdout.splitlines()[-1] == "[]"
