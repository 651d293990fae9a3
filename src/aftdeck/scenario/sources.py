"""Origin of the two files that a scenario names: the arm's file and the worksite's file."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple, Protocol

from aftdeck.arms.load import ArmModel, load_model
from aftdeck.files import Text, beside
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
