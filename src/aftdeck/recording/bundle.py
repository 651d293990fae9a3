"""Header of a recording, and the scenario rebuilt from it. The header has all data from which the run starts."""

from __future__ import annotations

import platform
import re
import tomllib
from collections.abc import Mapping
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path
from tempfile import TemporaryDirectory

from aftdeck.errors import InputError, RecordingError
from aftdeck.files import Where
from aftdeck.law import state_of_the_laws
from aftdeck.recording.records import FORMAT, Opening
from aftdeck.recording.trial import NO_TRIAL, Trial
from aftdeck.scenario.load import parse_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.state import State
from aftdeck.state_part import declaration
from aftdeck.version import __version__

_ARM = "f/f/f/f/f/f/f/f/arm.toml"
"""Path of the arm file in a temporary folder.

The path has eight subfolders: the relative path of a shapes file may contain up to eight ``..`` without leaving the
temporary folder.
"""
_WORKSITE = "worksite.toml"
_KEY = re.compile(r"[A-Za-z_][A-Za-z0-9_]*(\[\d+\])*(\.[A-Za-z_][A-Za-z0-9_]*(\[\d+\])*)*")


def opening(
    scenario: Scenario,
    seed: int,
    began_ns: int,
    changes: tuple[str, ...] = (),
    trial: Trial = NO_TRIAL,
    *,
    real_time: bool = False,
) -> Opening:
    """Return the header of a recording.

    Args:
        scenario: the scenario of the run.
        seed: the seed of the run.
        began_ns: wall time at which the run begins, since 1970 [ns].
        changes: the changes from the scenario's text to this scenario, each as KEY=VALUE.
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
        changes=changes,
        participant=trial.participant,
        condition=trial.condition,
        digests=declaration(State),
        real_time=real_time,
    )


def machine() -> str:
    """Return names and versions on which a frame's last digits may depend: processor, system, Python, NumPy, Numba."""
    return (
        f"{platform.machine()} {platform.processor()}".strip()
        + f", {platform.system()}, Python {platform.python_version()}, NumPy {version('numpy')}, "
        + f"Numba {version('numba')}"
    )


def scenario_of(start: Opening, changes: Mapping[Where, object] | None = None) -> Scenario:
    """Return the scenario of a recording, rebuilt from the header only.

    Args:
        start: header of the recording.
        changes: new values, by their location in the scenario's file. A relative path to an arm or a worksite is
            relative to the working folder.

    Raises:
        RecordingError: the path of the arm's shapes file leads out of the temporary folder of the recorded files.
        InputError: a location in `changes` does not exist in the scenario's file, or the value of an arm or worksite is
            not a text.
        ScenarioError: the scenario is not valid in this version or with these changes.
    """
    before = dict(parse_change(change) for change in start.changes)
    in_file: dict[Where, object] = {("arm",): _ARM, ("worksite",): _WORKSITE}
    changes = before | in_file | {where: _from_here(where, value) for where, value in (changes or {}).items()}
    with TemporaryDirectory(prefix="aftdeck-") as name:
        folder = Path(name)
        files = {folder / _ARM: start.arm_text, folder / _WORKSITE: start.worksite_text}
        if start.shapes_file:
            files[(folder / _ARM).parent / start.shapes_file] = start.shapes_text
        for file, text in files.items():
            if not file.resolve().is_relative_to(folder.resolve()):
                raise RecordingError(
                    f"the shapes file of the recorded arm is outside the recording: {start.shapes_file!r}"
                )
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")
        return parse_scenario(start.scenario_text, start.scenario, "the recorded scenario", folder, changes)


def parse_change(text: str) -> tuple[Where, object]:
    """Return the location in a scenario's file and the new value from the text ``KEY=VALUE``.

    The value is read as TOML if it is valid TOML (``0.5``, ``true``, ``[1, 2]``), otherwise as text (``0.5 ft/s``).

    Raises:
        InputError: the text is not ``KEY=VALUE``.
    """
    key, equals, value = text.partition("=")
    key = key.strip()
    if not equals or not _KEY.fullmatch(key):
        raise InputError(
            f"a change must be KEY=VALUE with a key of the scenario's file, such as command_delay=0.5, "
            f"limits.por.translation='1 ft/s' or phase[0].rate=vernier; got {text!r}"
        )
    where = tuple(int(i) if i else name for name, i in re.findall(r"([A-Za-z_][A-Za-z0-9_]*)|\[(\d+)\]", key))
    value = value.strip()
    try:
        read = tomllib.loads(f"value = {value}")
    except (ValueError, RecursionError):
        return where, value
    return where, read["value"] if len(read) == 1 else value


def _from_here(where: Where, value: object) -> object:
    if where in (("arm",), ("worksite",)):
        if not isinstance(value, str):
            raise InputError(f"{where[0]} must be a built-in name or a path, got {value!r}")
        return str(Path(value).absolute()) if value.endswith(".toml") else value
    return value
