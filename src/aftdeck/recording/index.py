"""List of the recordings made on this machine, in a database of the user."""

from __future__ import annotations

import functools
import os
import sqlite3
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Literal

import msgspec

from aftdeck.errors import RecordingError
from aftdeck.folders import user_folder
from aftdeck.recording.delays import Delays
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import Opening

BUSY_S = 5.0
"""Longest wait for another program that locks the database [s]."""
FRESH_S = 3.0
"""Limit of the time since the last write to a file [s]; below this limit, the file counts as still being recorded."""
_FILE = "recordings.sqlite"
_TABLE = """
    create table if not exists recordings (
        path text primary key, scenario text not null, title text not null, seed integer not null,
        version text not null, began text not null, ended text not null, time_s real not null, bytes integer not null
    )
"""
_ADDED = ("participant", "condition", "changes", "chain", "grade")
"""Text columns that lists of earlier versions do not have."""
_DELAYS = {"late_steps": "integer", "worst_s": "real", "lost_s": "real"}
"""Columns for the delays of the steps, with their types; null in lists and recordings of earlier versions."""
_COLUMNS = f"path, scenario, title, seed, version, began, ended, time_s, bytes, {', '.join((*_ADDED, *_DELAYS))}"


_PATH = "cast(? as text)"
"""Parameter for a path. Its bytes are stored as a text, because a path may have bytes that are not UTF-8."""


class Entry(msgspec.Struct, frozen=True):
    """Recording in the list."""

    path: str
    """Path of the file, by which it can be opened; to show it, use `encodable`."""
    scenario: str
    title: str
    seed: int
    version: str
    began: str
    """Wall time, ISO 8601, UTC."""
    ended: str
    """``completed``, ``time``, ``fault``, ``stopped`` or ``restarted``; ``cut`` if the program was killed or the
    recording failed; ``recording`` during the run."""
    time_s: float
    """Simulated time [s]."""
    bytes: int
    participant: str = ""
    """Code of the participant; empty if not given."""
    condition: str = ""
    """Condition of the trial; empty if not given."""
    changes: str = ""
    """``KEY=VALUE, KEY=VALUE``: changes of the scenario; empty if it was not changed."""
    chain: str = ""
    """Head of the hash chain with which the recording ended; empty if this list does not have it."""
    grade: str = ""
    """Grade of the operator's task: ``A`` to ``D``; empty if the task was not completed or has no grade."""
    late_steps: int | None = None
    """Number of steps that began more than one control period late; None if the run was not in real time, if an
    earlier version recorded it, and during the run."""
    worst_s: float | None = None
    """Greatest delay of a step [s]; None as for `late_steps`."""
    lost_s: float | None = None
    """Time that the station did not make up [s]; None as for `late_steps`."""
    state: Literal["here", "gone", "unreadable"] = "here"


class Index:
    """List of recordings, with one row for each file.

    Raises:
        RecordingError: from every method, if the database cannot be read or written.
    """

    def __init__(self, path: Path | None = None) -> None:
        self._given = path

    @functools.cached_property
    def path(self) -> Path:
        """Path of the database."""
        if self._given is not None:
            return self._given
        folder = user_folder("data", _FILE)
        if folder is None:
            raise RecordingError("the list of recordings cannot be used: no folder can be written")
        return folder / _FILE

    def begin(self, path: Path, opening: Opening) -> None:
        """Add a recording that has begun."""
        row = (opening.scenario, opening.title, opening.seed, opening.version, opening.began, "recording", 0.0, 0)
        trial = (opening.participant, opening.condition, ", ".join(opening.changes), "", "")
        with self._open() as database:
            database.execute(
                f"insert or replace into recordings ({_COLUMNS}) "
                f"values ({', '.join([_PATH, *'?' * _COLUMNS.count(',')])})",
                (_key(path), *row, *trial, None, None, None),
            )

    def end(
        self,
        path: Path,
        ended: str,
        time_s: float,
        chain: str = "",
        delays: Delays | None = None,
        grade: str = "",
    ) -> None:
        """Store how a recording ended: simulated time [s], size, head of the hash chain, delays of the steps, grade."""
        size = path.stat().st_size if os.path.exists(path) else 0
        with self._open() as database:
            database.execute(
                "update recordings set ended = ?, time_s = ?, bytes = ?, chain = ?, grade = ?, late_steps = ?, "
                f"worst_s = ?, lost_s = ? where path = {_PATH}",
                (ended, time_s, size, chain, grade, *_delay_columns(delays).values(), _key(path)),
            )

    def chain_of(self, path: Path) -> str:
        """Return the head of the hash chain with which a recording ended; empty if the list does not have it."""
        with self._open() as database:
            row = database.execute(f"select chain from recordings where path = {_PATH}", (_key(path),)).fetchone()
        return str(row[0]) if row else ""

    def entries(self, scenario: str = "", ended: str = "", since: str = "", participant: str = "") -> list[Entry]:
        """Return the recordings, newest first. If a recording has no end in the list, read the recording's file.

        Args:
            scenario: return only recordings of this scenario; empty for all.
            ended: return only recordings with this value of `Entry.ended`; empty for all.
            since: return only recordings that began at this time or later: ISO 8601, complete or only the beginning,
                such as the date; empty for all.
            participant: return only recordings of this participant; empty for all.
        """
        with self._open() as database:
            rows = database.execute(f"select {_COLUMNS} from recordings order by began desc, path").fetchall()
        entries = [self._updated(Entry(*row)) for row in rows]
        return [
            entry
            for entry in entries
            if (not scenario or entry.scenario == scenario)
            and (not ended or entry.ended == ended)
            and (not participant or entry.participant == participant)
            and entry.began >= since
        ]

    def _updated(self, entry: Entry) -> Entry:
        """Return an entry, updated from its file."""
        file = Path(entry.path)
        try:
            status = file.stat()
        except (OSError, ValueError):
            return msgspec.structs.replace(entry, state="gone")
        size = status.st_size
        if entry.ended != "recording" or time.time() - status.st_mtime < FRESH_S:
            return msgspec.structs.replace(entry, bytes=size)
        try:
            recording = Recording(file)
            for _ in recording.messages():
                pass
        except RecordingError:
            return msgspec.structs.replace(entry, bytes=size, state="unreadable")
        return msgspec.structs.replace(
            entry,
            ended=recording.ended or "cut",
            time_s=recording.time_s,
            bytes=size,
            **_delay_columns(recording.delays),
        )

    def forget(self, entries: list[Entry]) -> None:
        """Remove entries from the list, without deleting their files."""
        with self._open() as database:
            keys = [(_key(Path(entry.path)),) for entry in entries]
            database.executemany(f"delete from recordings where path = {_PATH}", keys)

    def delete(self, entries: list[Entry]) -> None:
        """Delete the entries' files, and remove the entries from the list.

        Raises:
            RecordingError: a file cannot be deleted or is being recorded; the entries before it in `entries` have then
                already been deleted.
        """
        for entry in entries:
            if entry.state == "here" and entry.ended == "recording":
                raise RecordingError(f"{entry.path}: is being recorded and cannot be deleted; end the run first")
            try:
                Path(entry.path).unlink(missing_ok=True)
            except OSError as error:
                raise RecordingError(f"{entry.path}: cannot be deleted: {error.strerror or error}") from None
            self.forget([entry])

    @contextmanager
    def _open(self) -> Iterator[sqlite3.Connection]:
        try:
            self.path.parent.mkdir(parents=True, exist_ok=True)
            database = sqlite3.connect(self.path, timeout=BUSY_S)
            database.text_factory = os.fsdecode
            try:
                with database:
                    _make_table(database)
                    yield database
            finally:
                database.close()
        except (OSError, sqlite3.Error, UnicodeError) as error:
            raise RecordingError(f"{self.path}: the list of recordings cannot be used: {error}") from None


def _key(path: Path) -> bytes:
    """Return the path of a recording as it identifies the recording in the list."""
    return os.fsencode(path.absolute())


def _make_table(database: sqlite3.Connection) -> None:
    """Create the table if it is missing, and add the columns that an earlier version did not create."""
    database.execute(_TABLE)
    if _missing(database):
        database.execute("begin immediate")  # another program may be about to add the same columns
        for column in _missing(database):
            kind = _DELAYS.get(column, "text not null default ''")
            database.execute(f"alter table recordings add column {column} {kind}")


def _missing(database: sqlite3.Connection) -> list[str]:
    columns = {name for _, name, *_ in database.execute("pragma table_info(recordings)")}
    return [column for column in (*_ADDED, *_DELAYS) if column not in columns]


def _delay_columns(delays: Delays | None) -> dict[str, float | None]:
    """Return the values of the columns `_DELAYS`, in their order."""
    return {column: None if delays is None else getattr(delays, column) for column in _DELAYS}
