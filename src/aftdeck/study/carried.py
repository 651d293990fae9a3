"""Texts of all files that a study's runs need, so that a worker needs none of these files."""

from __future__ import annotations

import tomllib
from collections.abc import Iterable
from pathlib import Path

import msgspec

from aftdeck.arms.load import ArmModel, model_of
from aftdeck.errors import AftdeckError, InputError
from aftdeck.files import Problem, Text, Where
from aftdeck.scenario.keys import Change
from aftdeck.scenario.load import Source, scenario_from
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.sources import Folder


class ArmTexts(msgspec.Struct, frozen=True):
    """Texts of an arm."""

    arm: Text
    shapes: Text | None


class Carried(msgspec.Struct, frozen=True):
    """A scenario's text, and the texts of the arms and worksites that it or its changes name."""

    name: str
    file: str
    text: str
    arms: dict[str, ArmTexts]
    """Arms, by the names that stand in the scenario's file."""
    worksites: dict[str, Text]

    def scenario(self, changes: Iterable[Change]) -> Scenario:
        """Return the scenario with changes of its files.

        Raises:
            AftdeckError: the scenario is not valid with these changes.
        """
        given = {(*key.prefix, *key.where): value for key, value in changes}
        return scenario_from(self.text, self.name, self.file, self, given)

    def arm(self, name: str) -> ArmModel:
        """Return an arm, as `scenario.sources.Sources.arm` does."""
        texts = self.arms.get(name)
        if texts is None:
            raise InputError(f"the study does not carry the arm {name!r}")
        shapes = texts.shapes

        def shape_text(wanted: str) -> Text:
            if shapes is None:
                raise InputError(f"the study does not carry the shape file {wanted!r}")
            return shapes

        return model_of(texts.arm, shape_text)

    def worksite(self, name: str) -> Text:
        """Return a worksite's text, as `scenario.sources.Sources.worksite` does."""
        text = self.worksites.get(name)
        if text is None:
            raise InputError(f"the study does not carry the worksite {name!r}")
        return text


def carry(source: Source, levels: Iterable[tuple[Where, Change]]) -> tuple[Carried, list[Problem]]:
    """Return the texts of all files that a scenario needs, and the problems with the files that changes name.

    Args:
        source: the scenario.
        levels: all changes of the study, with their places in the study file.

    Raises:
        AftdeckError: a file that the scenario itself names is missing or has errors.
    """
    folder = Folder(source.folder.resolve())
    raw = tomllib.loads(source.text)
    arms = {name: _arm(folder, name) for name in [_named(raw.get("arm"), "srms")]}
    worksites = {name: folder.worksite(name) for name in [_named(raw.get("worksite"), "orbiter")]}
    problems = []
    for where, (key, value) in levels:
        if key.kind != "scenario" or not isinstance(value, str):
            continue
        try:
            if key.where == ("arm",):
                arms[value] = _arm(folder, value)
            elif key.where == ("worksite",):
                worksites[value] = folder.worksite(value)
        except AftdeckError as error:
            problems.append(Problem(where, str(error)))
    return Carried(source.name, source.file, source.text, arms, worksites), problems


def _named(value: object, default: str) -> str:
    return value if isinstance(value, str) else default


def _arm(folder: Folder, name: str) -> ArmTexts:
    model = folder.arm(name)
    return ArmTexts(Text(f"{Path(name).stem}.toml", model.text), model.shapes)
