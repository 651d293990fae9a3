"""One run of a study."""

from __future__ import annotations

from pathlib import Path

import pytest

from aftdeck.recording.reader import Recording
from aftdeck.recording.replay import verify
from aftdeck.report.of_recording import metrics_of
from aftdeck.report.table import cells
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.run import run
from aftdeck.study.case import Runner
from aftdeck.study.columns import FIXED_COLUMNS
from aftdeck.study.design import cases
from aftdeck.study.plan import plan_of
from tests.study.studies import loaded

HEAD = 'title = "A"\nscenario = "short.toml"\n'


def test_row_has_the_metrics_of_the_run(tmp_path: Path) -> None:
    study = loaded(tmp_path)
    case = cases(study)[2]
    recording = tmp_path / "case.mcap"
    row = Runner(plan_of(study)).run(case, recording).row
    alone = run(load_scenario(tmp_path / "short.toml", {("limits", "por", "translation"): "2 ft/s"}))
    assert row["state_sha256"] == alone.frames[-1].sha256
    assert row["speed_ft_s"] == 2.0
    recorded = cells(metrics_of(Recording(recording)))
    assert {name: row[name] for name in study.metric_columns} == pytest.approx(recorded, abs=1e-3)
    assert list(row) == ["index", "seed", "speed_ft_s", *FIXED_COLUMNS[2:], *study.metric_columns]


def test_recording_of_a_case_can_be_re_simulated(tmp_path: Path) -> None:
    text = (
        HEAD + '[[factor]]\nname = "arm"\n[[factor.level]]\nname = "long"\n'
        'set = { arm = "concept-1972", "arm.dimensions.boom" = "27 ft", worksite = "concept-1972" }\n'
    )
    study = loaded(tmp_path, text.replace('"27 ft",', '"27 ft", "initial.joints" = [0, 0.6, -1.9, 0, 0, 0],'))
    recording = tmp_path / "case.mcap"
    outcome = Runner(plan_of(study)).run(cases(study)[0], recording)
    assert outcome.row["error"] == ""
    assert verify(recording).agrees


def test_error_of_a_run_is_in_its_row(tmp_path: Path) -> None:
    text = HEAD + '[[factor]]\nkey = "duration"\nlevels = ["2 s", "0.03 s"]\n'
    study = loaded(tmp_path, text)
    runner = Runner(plan_of(study))
    good, bad = (runner.run(case).row for case in cases(study))
    assert (good["error"], good["ended"], good["success"]) == ("", "completed", True)
    assert "duration" in str(bad["error"]) and not bad["success"]
    assert all(bad[name] is None for name in study.metric_columns)
    assert list(good) == list(bad)


@pytest.mark.parametrize(
    ("rule", "success"),
    [
        ("at_most = { run_time_s = 1.0 }", True),
        ("at_most = { run_time_s = 0.1 }", False),
        ("at_least = { tip_path_m = 0.01 }", True),
        ("at_least = { captures = 1 }", False),
        ("at_most = { peak_contact_force_n = 1e9 }", False),  # the run has no such value
    ],
)
def test_success_needs_every_bound(tmp_path: Path, rule: str, success: bool) -> None:
    study = loaded(tmp_path, f"{HEAD}[success]\n{rule}\n")
    assert Runner(plan_of(study)).run(cases(study)[0]).row["success"] is success


def test_run_that_did_not_complete_is_no_success_unless_the_rule_allows_it(tmp_path: Path) -> None:
    factor = '[[factor]]\nkey = "duration"\nlevels = ["0.2 s"]\n'
    for rule, success in (("completed", False), ("any", True)):
        study = loaded(tmp_path, f'{HEAD}{factor}[success]\nended = "{rule}"\n')
        row = Runner(plan_of(study)).run(cases(study)[0]).row
        assert (row["ended"], row["success"]) == ("fault", success)


def test_camera_of_a_monitor_decides_the_angle_of_the_picture(tmp_path: Path) -> None:
    study = loaded(tmp_path, f'{HEAD}[[factor]]\nkey = "monitors.mon_1"\nlevels = ["A", "B", "none"]\n')
    runner = Runner(plan_of(study))
    a, b, unknown = (runner.run(case).row for case in cases(study))
    assert a["stick_to_picture_angle_rad"] != b["stick_to_picture_angle_rad"]
    assert a["state_sha256"] == b["state_sha256"]
    assert "none" in str(unknown["error"])
