"""Header of a recording, and the scenario rebuilt from it. The header has all data from which the run starts."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import NamedTuple

from aftdeck.arms.load import ArmModel, load_model, model_of
from aftdeck.errors import InputError, RecordingError, ScenarioError
from aftdeck.files import MOST_BYTES, Text, Where
from aftdeck.law_folder import state_of_the_laws
from aftdeck.recording.environment import environment, machine
from aftdeck.recording.records import FORMAT, Opening
from aftdeck.recording.trial import NO_TRIAL, Trial
from aftdeck.scenario.changes import parse_change
from aftdeck.scenario.load import scenario_from
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.sources import Folder
from aftdeck.simulation.state import State
from aftdeck.state_part import declaration
from aftdeck.units import short
from aftdeck.version import __version__

MOST_PROBLEMS = 20
"""Maximum number of problems of recorded texts that are listed."""


def opening(
    scenario: Scenario,
    seed: int,
    began_ns: int,
    trial: Trial = NO_TRIAL,
    *,
    real_time: bool = False,
) -> Opening:
    """Return the header of a recording.

    Args:
        scenario: the scenario of the run.
        seed: the seed of the run.
        began_ns: wall time at which the run begins, since 1970 [ns].
        trial: participant and condition.
        real_time: whether the steps are due at times of the wall clock.
    """
    model = scenario.arm.model
    return Opening(
        format=FORMAT,
        version=__version__,
        laws=state_of_the_laws(),
        machine=machine(),
        began=datetime.fromtimestamp(began_ns / 1e9, UTC).isoformat(timespec="milliseconds"),
        scenario=scenario.name,
        title=scenario.title,
        seed=seed,
        control_period_s=scenario.control_period,
        joints=scenario.arm.joints,
        scenario_text=scenario.text,
        arm_text=model.text,
        shapes_file=model.source.shapes or "",
        shapes_text=model.shapes.text if model.shapes else "",
        worksite_text=scenario.worksite.text,
        changes=scenario.changes,
        participant=trial.participant,
        condition=trial.condition,
        digests=declaration(State),
        environment=environment(scenario.plant),
        real_time=real_time,
    )


class _Texts(NamedTuple):
    """Arm and worksite of a recorded scenario, whatever names or paths stand in the scenario's text."""

    model: ArmModel
    worksite_file: Text

    def arm(self, _: str) -> ArmModel:
        """Return the arm."""
        return self.model

    def worksite(self, _: str) -> Text:
        """Return the worksite's text."""
        return self.worksite_file


def scenario_of(start: Opening, changes: Mapping[Where, object] | None = None) -> Scenario:
    """Return the scenario of a recording, rebuilt from the header only.

    No file is read except the files that `changes` names: a path within a recorded text is not followed.

    Args:
        start: header of the recording.
        changes: new values, by their location in the scenario's file. A relative path to an arm or a worksite is
            relative to the working folder.

    Raises:
        RecordingError: the header lacks a text or has too long a text, or contradicts its texts.
        InputError: a location in `changes` does not exist in the scenario's file, or the value of an arm or worksite is
            not a text.
        ScenarioError: the scenario is not valid in this version or with these changes.
    """
    new = dict(changes or {})
    recorded = dict(parse_change(change) for change in start.changes)
    text = _short_enough("scenario", start.scenario_text)
    try:
        texts = _Texts(_arm_of(start, new), _worksite_of(start, new))
        scenario = scenario_from(text, start.scenario, "the recorded scenario", texts, recorded | new)
    except ScenarioError as error:
        raise ScenarioError(_few(error.problems)) from None
    if not new:
        _check_header(start, scenario)
    return scenario


def _arm_of(start: Opening, changes: Mapping[Where, object]) -> ArmModel:
    if (named := changes.get(("arm",))) is not None:
        return load_model(_from_here("arm", named))

    def shapes(_: str) -> Text:
        if not start.shapes_text:
            raise RecordingError("the recorded arm has a shapes file, but the recording does not contain its text")
        return Text("the recorded shapes", _short_enough("shapes", start.shapes_text))

    return model_of(Text("the recorded arm", _short_enough("arm", start.arm_text)), shapes)


def _worksite_of(start: Opening, changes: Mapping[Where, object]) -> Text:
    if (named := changes.get(("worksite",))) is not None:
        return Folder(Path.cwd()).worksite(_from_here("worksite", named))
    return Text("the recorded worksite", _short_enough("worksite", start.worksite_text))


def _from_here(key: str, value: object) -> str:
    if not isinstance(value, str):
        raise InputError(f"{key} must be a built-in name or a path, got {value!r}")
    return value


def _few(problems: Sequence[str]) -> list[str]:
    """Return the first problems; a stranger's file may have thousands."""
    more = len(problems) - MOST_PROBLEMS
    return [*problems[:MOST_PROBLEMS], *([f"and {more} more problems"] if more > 0 else [])]


def _short_enough(what: str, text: str) -> str:
    if len(text) > MOST_BYTES:
        raise RecordingError(f"the recorded {what} has {len(text)} characters; at most {MOST_BYTES} are allowed")
    return text


def _check_header(start: Opening, scenario: Scenario) -> None:
    """Check that the header states what its texts say.

    Raises:
        RecordingError: it does not.
    """
    said = {
        "title": (start.title, scenario.title),
        "joints": (start.joints, scenario.arm.joints),
        "control_period_s": (start.control_period_s, scenario.control_period),
        "shapes_file": (start.shapes_file, scenario.arm.model.source.shapes or ""),
    }
    for name, (given, expected) in said.items():
        if given != expected:
            raise RecordingError(
                f"the header has {name} = {short(given)}, but its texts say {short(expected)}", "damaged"
            )
