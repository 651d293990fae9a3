"""Built-in studies."""

from __future__ import annotations

import pytest

from aftdeck.study.case import Runner
from aftdeck.study.design import cases
from aftdeck.study.file import built_in, load_study
from aftdeck.study.plan import plan_of


@pytest.mark.parametrize("name", built_in())
def test_scenario_of_a_built_in_case_can_be_built(name: str) -> None:
    study = load_study(name)
    runner, every = Runner(plan_of(study)), cases(study)
    assert study.spec.text
    for case in (every[0], every[len(every) // 2], every[-1]):
        runner.scenario(case)


def test_wider_capture_envelope_never_loses_a_capture() -> None:
    study = load_study("capture-tolerance")
    every, repeats = cases(study), study.spec.repeats
    assert {case.cells[1:] for case in every[:repeats]} == {case.cells[1:] for case in every[-repeats:]}
    runner = Runner(plan_of(study))
    narrow, wide = every[0], every[-repeats]
    assert narrow.cells[1:] == wide.cells[1:]
    captured = [bool(runner.run(case).row["success"]) for case in (narrow, wide)]
    assert captured == sorted(captured)
