"""Results of a study on disk: one line for each finished case, so that a study can end and continue at any moment.

Each line has a digest of itself and of the lines before it, so that a line that was changed, added, moved or removed is
found; only lines removed at the end are not, and their cases run again. This is no signature: a person who rewrites the
whole file can also compute its digests.
"""

from __future__ import annotations

import fcntl
import hashlib
import os
import re
from collections.abc import Iterable
from pathlib import Path
from types import TracebackType

import msgspec

from aftdeck.errors import AftdeckError
from aftdeck.law_folder import state_of_the_laws
from aftdeck.study.case import Outcome
from aftdeck.study.file import Study
from aftdeck.study.rows import RowCheck
from aftdeck.version import __version__
from aftdeck.whole_file import write_whole

LINES, LOCK, COPY, ABOUT = "cases.jsonl", "lock", "study.toml", "study.json"
"""Files of a store: a line for each case, the lock, a copy of the study file, and what the results depend on."""
_SEALED = re.compile(rb'(\{.*),"chain":"([0-9a-f]{64})"\}', re.DOTALL)
"""A line: the result of a case without its last brace, and the digest."""


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
        self._head: str
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
        line, head = _sealed(outcome, self._head)
        try:
            while line:  # what is cut by a full disk or a kill is removed at the next start
                line = line[os.write(self._file, line) :]
        except OSError as error:
            raise StoreError(f"{self.folder / LINES}: cannot be written: {error.strerror or error}") from None
        self._outcomes[index], self._head = outcome, head

    def drop_failed(self) -> None:
        """Forget the cases that ended with an error, so that they run again."""
        self._outcomes = {index: outcome for index, outcome in self._outcomes.items() if not outcome.row["error"]}
        lines, self._head = _lines(self._outcomes.values(), _first(self._study))
        write_whole(self.folder / LINES, lines)
        os.close(self._file)
        self._file = os.open(self.folder / LINES, os.O_RDWR | os.O_APPEND)

    def _read(self) -> None:
        """Read all complete lines, and cut off an incomplete last one."""
        data = (self.folder / LINES).read_bytes()
        whole = data.rfind(b"\n") + 1
        if whole < len(data):
            os.ftruncate(self._file, whole)
        self._outcomes, self._head = _decoded(data[:whole], self.folder / LINES, self._study)


def outcomes_in(folder: Path, study: Study) -> list[Outcome]:
    """Return the results that a folder has now, in order of their indices, while a study may be running in it.

    Raises:
        StoreError: the folder has no results, or has those of another study.
    """
    path = folder / LINES
    if not check_about(folder, study) or not path.exists():
        raise StoreError(f"{folder}: has no results of a study yet")
    data = path.read_bytes()
    found, _ = _decoded(data[: data.rfind(b"\n") + 1], path, study)
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


def _first(study: Study) -> str:
    """Return the digest before the first line: what the results depend on."""
    return hashlib.sha256(msgspec.json.encode(about(study))).hexdigest()


def _digest(head: str, body: bytes) -> str:
    return hashlib.sha256(head.encode() + body).hexdigest()


def _sealed(outcome: Outcome, head: str) -> tuple[bytes, str]:
    """Return the line of a result, and its digest; `head` is the digest of the line before."""
    body = msgspec.json.encode(outcome)[:-1]
    digest = _digest(head, body)
    return b'%b,"chain":"%b"}\n' % (body, digest.encode()), digest


def _lines(outcomes: Iterable[Outcome], head: str) -> tuple[bytes, str]:
    """Return the lines of results, and the digest of the last line."""
    lines = []
    for outcome in outcomes:
        line, head = _sealed(outcome, head)
        lines.append(line)
    return b"".join(lines), head


def _decoded(data: bytes, path: Path, study: Study) -> tuple[dict[int, Outcome], str]:
    """Return the results in complete lines, by their indices, and the digest of the last line.

    Raises:
        StoreError: a line is not one that this study wrote there.
    """
    found: dict[int, Outcome] = {}
    head, check = _first(study), RowCheck(study)
    for number, line in enumerate(data.split(b"\n")[:-1], 1):
        try:
            outcome, head = _opened(line, head)
            problem = check.problem(outcome.row)
            index = int(str(outcome.row["index"])) if not problem else -1
            if index in found:
                problem = f"a line before it has the case {index}, too"
        except (msgspec.DecodeError, ValueError, RecursionError) as error:
            problem = str(error)
        if problem:
            raise StoreError(f"{path}:{number}: this study did not write this line ({problem}); use another folder")
        found[index] = outcome
    return found, head


def _opened(line: bytes, head: str) -> tuple[Outcome, str]:
    """Return the result in a line, and the line's digest; raise ValueError if the digest is wrong."""
    match = _SEALED.fullmatch(line)
    if match is None or _digest(head, match[1]) != match[2].decode():
        raise ValueError("it, or a line before it, was changed, moved or removed")
    return msgspec.json.decode(match[1] + b"}", type=Outcome), match[2].decode()
