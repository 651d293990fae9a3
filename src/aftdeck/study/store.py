"""Results of a study on disk: one line for each finished case, so that a study can end and continue at any moment."""

from __future__ import annotations

import fcntl
import hashlib
import os
from pathlib import Path
from types import TracebackType

import msgspec

from aftdeck.errors import AftdeckError
from aftdeck.law import state_of_the_laws
from aftdeck.study.case import Outcome
from aftdeck.study.file import Study
from aftdeck.version import __version__
from aftdeck.whole_file import write_whole

LINES, LOCK, COPY, ABOUT = "cases.jsonl", "lock", "study.toml", "study.json"
"""Files of a store: a line for each case, the lock, a copy of the study file, and what the results depend on."""


class StoreError(AftdeckError):
    """A folder of results that cannot be used."""


class About(msgspec.Struct, frozen=True):
    """What the results of a study depend on."""

    title: str
    study_sha256: str
    """Digest of the study file."""
    files_sha256: str
    """Digest of the texts of the scenario, the arms and the worksites."""
    version: str
    laws: str


def about(study: Study) -> About:
    """Return what the results of a study depend on."""
    files = hashlib.sha256(msgspec.json.encode(study.carried, order="deterministic")).hexdigest()
    own = hashlib.sha256(study.source.text.encode()).hexdigest()
    return About(study.spec.title, own, files, __version__, state_of_the_laws())


class Store:
    """Results of a study in a folder. One process at a time uses it; others are refused."""

    def __init__(self, folder: Path, study: Study) -> None:
        """Open the folder, or create it.

        Raises:
            StoreError: the folder has the results of another study or of another version, or is in use, or cannot be
                written.
        """
        self.folder, self._study = folder, study
        self._outcomes: dict[int, Outcome] = {}
        try:
            folder.mkdir(parents=True, exist_ok=True)
            self._lock = os.open(folder / LOCK, os.O_RDWR | os.O_CREAT, 0o644)
        except OSError as error:
            raise StoreError(f"{folder}: cannot be written: {error.strerror or error}") from None
        try:
            fcntl.flock(self._lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            os.close(self._lock)
            raise StoreError(f"{folder}: another process runs a study in this folder") from None
        try:
            if not check_about(folder, study):
                _describe(folder, study)
            self._file = os.open(folder / LINES, os.O_RDWR | os.O_CREAT | os.O_APPEND, 0o644)
            self._read()
        except BaseException:
            os.close(self._lock)
            raise

    def __enter__(self) -> Store:
        return self

    def __exit__(
        self, _kind: type[BaseException] | None, _error: BaseException | None, _trace: TracebackType | None
    ) -> None:
        os.close(self._file)
        os.close(self._lock)

    @property
    def done(self) -> frozenset[int]:
        """Indices of the finished cases."""
        return frozenset(self._outcomes)

    def outcomes(self) -> list[Outcome]:
        """Return the results of all finished cases, in order of their indices."""
        return [self._outcomes[index] for index in sorted(self._outcomes)]

    def add(self, index: int, outcome: Outcome) -> None:
        """Add the result of a case; it is on disk when the call returns.

        Raises:
            StoreError: the disk is full, or the file cannot be written.
        """
        if index in self._outcomes:
            return
        line = msgspec.json.encode(outcome) + b"\n"
        try:
            while line:  # what is cut by a full disk or a kill is removed at the next start
                line = line[os.write(self._file, line) :]
        except OSError as error:
            raise StoreError(f"{self.folder / LINES}: cannot be written: {error.strerror or error}") from None
        self._outcomes[index] = outcome

    def drop_failed(self) -> None:
        """Forget the cases that ended with an error, so that they run again."""
        self._outcomes = {index: outcome for index, outcome in self._outcomes.items() if not outcome.row["error"]}
        lines = b"".join(msgspec.json.encode(outcome) + b"\n" for outcome in self._outcomes.values())
        write_whole(self.folder / LINES, lines)
        os.close(self._file)
        self._file = os.open(self.folder / LINES, os.O_RDWR | os.O_APPEND)

    def _read(self) -> None:
        """Read all complete lines, and cut off an incomplete last one."""
        data = (self.folder / LINES).read_bytes()
        whole = data.rfind(b"\n") + 1
        if whole < len(data):
            os.ftruncate(self._file, whole)
        self._outcomes = _decoded(data[:whole], self.folder / LINES)


def outcomes_in(folder: Path, study: Study) -> list[Outcome]:
    """Return the results that a folder has now, in order of their indices, while a study may be running in it.

    Raises:
        StoreError: the folder has no results, or has those of another study.
    """
    path = folder / LINES
    if not check_about(folder, study) or not path.exists():
        raise StoreError(f"{folder}: has no results of a study yet")
    data = path.read_bytes()
    found = _decoded(data[: data.rfind(b"\n") + 1], path)
    return [found[index] for index in sorted(found)]


def check_about(folder: Path, study: Study) -> bool:
    """Return whether a folder has results of this study; False if it has none at all.

    Raises:
        StoreError: it has results of another study, or of another version.
    """
    mine, path = about(study), folder / ABOUT
    if not path.exists():
        if (folder / LINES).exists():
            raise StoreError(f"{folder}: has {LINES} but no {ABOUT}; use another folder")
        return False
    try:
        theirs = msgspec.json.decode(path.read_bytes(), type=About)
    except (OSError, msgspec.DecodeError) as error:
        raise StoreError(f"{path}: cannot be read: {error}") from None
    if theirs == mine:
        return True
    texts = {
        "study_sha256": "the study file has changed",
        "files_sha256": "the scenario, an arm or a worksite has changed",
        "version": f"it was started by Aftdeck {theirs.version}, and this is {mine.version}",
        "laws": "the laws of this version differ",
        "title": "the title has changed",
    }
    why = next(text for field, text in texts.items() if getattr(theirs, field) != getattr(mine, field))
    raise StoreError(f"{folder}: has results of another study ({why}); use another folder")


def _describe(folder: Path, study: Study) -> None:
    """Write what the results depend on, and a copy of the study file."""
    write_whole(folder / COPY, study.source.text)
    write_whole(folder / ABOUT, msgspec.json.format(msgspec.json.encode(about(study)), indent=2) + b"\n")


def _decoded(data: bytes, path: Path) -> dict[int, Outcome]:
    """Return the results in complete lines, by their indices."""
    found: dict[int, Outcome] = {}
    for number, line in enumerate(data.splitlines(), 1):
        try:
            outcome = msgspec.json.decode(line, type=Outcome)
            found.setdefault(int(str(outcome.row["index"])), outcome)
        except (msgspec.DecodeError, KeyError, ValueError) as error:
            raise StoreError(f"{path}:{number}: cannot be read: {error}; use another folder") from None
    return found
