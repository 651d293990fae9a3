"""Origin of the two files that a scenario names, the arm's file and the worksite's file, and changes of them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import NamedTuple, Protocol

from aftdeck.arms.load import ArmModel, load_model, model_of
from aftdeck.errors import InputError
from aftdeck.files import Changes, Text, Where, beside, place, put, raw_contents
from aftdeck.scenario.changes import as_toml
from aftdeck.scenario.keys import ARM, SCENARIO, SHAPES, WORKSITE, Change, key_at, of_kind
from aftdeck.worksite.file.load import worksite_text


class Sources(Protocol):
    """Origin of a scenario's arm and worksite, by the names that stand in the scenario's file."""

    def arm(self, name: str) -> ArmModel:
        """Return the arm of a name.

        Raises:
            ArmError: no built-in arm has that name.
            ScenarioError: the arm's file has errors.
        """

    def worksite(self, name: str) -> Text:
        """Return the file name and the text of the worksite of a name.

        Raises:
            ScenarioError: the file does not exist or cannot be read.
        """


class Folder(NamedTuple):
    """Built-in files by their names, and files on the disk by their paths; a path may be relative to the folder."""

    path: Path

    def arm(self, name: str) -> ArmModel:
        """Return the arm of a built-in name or of a path, as `Sources.arm` does."""
        return load_model(beside(name, self.path))

    def worksite(self, name: str) -> Text:
        """Return the worksite's file of a built-in name or of a path, as `Sources.worksite` does."""
        return worksite_text(beside(name, self.path))


class Changed(NamedTuple):
    """Arm and worksite of other sources, with changes in their files."""

    sources: Sources
    arm_changes: Mapping[Where, object]
    shape_changes: Mapping[Where, object]
    worksite_changes: Mapping[Where, object]

    def arm(self, name: str) -> ArmModel:
        """Return the changed arm, as `Sources.arm` does."""
        model = self.sources.arm(name)
        if not self.arm_changes and not self.shape_changes:
            return model
        shapes = model.shapes
        if shapes is None and self.shape_changes:
            raise InputError(f"the arm {model.name!r} has no file of shapes")
        text = changed(Text(f"{model.name}.toml", model.text), self.arm_changes)
        return model_of(text, lambda _: changed(shapes or Text("", ""), self.shape_changes))

    def worksite(self, name: str) -> Text:
        """Return the changed worksite's file, as `Sources.worksite` does."""
        return changed(self.sources.worksite(name), self.worksite_changes)


def apart(sources: Sources, changes: Changes) -> tuple[Sources, dict[Where, object]]:
    """Return the sources with the changes of arm and worksite, and the changes of the scenario's own file."""
    given = [Change(key_at(where), value) for where, value in changes.items()]
    arm, shapes, worksite = (of_kind(given, kind) for kind in (ARM, SHAPES, WORKSITE))
    return Changed(sources, arm, shapes, worksite) if arm or shapes or worksite else sources, of_kind(given, SCENARIO)


def changed(file: Text, changes: Mapping[Where, object]) -> Text:
    """Return a TOML file with changes; its comments are lost, except those that name the changes.

    Raises:
        InputError: a change names a place that the file cannot have.
    """
    if not changes:
        return file
    raw = raw_contents(file)
    for where, value in changes.items():
        put(raw, where, value)
    lines = [f"{as_toml(key)} = {as_toml(value)}" for key, value in raw.items()]
    return Text(file.name, "\n".join([*_comments(file, changes), *lines, ""]))


def _comments(file: Text, changes: Mapping[Where, object]) -> Iterator[str]:
    """Yield a comment for each place that the file has changed, now or before."""
    now = {f"{_CHANGED}{place(where)} = ": as_toml(value) for where, value in changes.items()}
    for line in file.text.splitlines():
        if not line.startswith(_CHANGED):
            break
        if not line.startswith(tuple(now)):
            yield line
    for comment, value in now.items():
        yield comment + value


_CHANGED = "# changed: "
"""Beginning of a comment that names a change."""
