"""The user's folders for compiled code and for data, with a temporary folder in place of one that cannot be written."""

from __future__ import annotations

import functools
import os
import stat
import sys
import tempfile
from pathlib import Path
from typing import Literal

import platformdirs

from aftdeck.lines import print_line
from aftdeck.processes import CHILD

Kind = Literal["cache", "data"]
OWN_CACHE = "NUMBA_CACHE_DIR"
"""Environment variable that names another folder for compiled code."""
_CONTENT: dict[Kind, str] = {"cache": "compiled code", "data": "the list of recordings"}


def user_folder(kind: Kind, kept: str = "") -> Path | None:
    """Return the user's folder for compiled code (``cache``) or for data, which exists and can be written.

    If the usual folder cannot be written, the folder is one that only this user can enter, inside the system's folder
    for temporary files. A line on standard error says so, once.

    Args:
        kind: content of the folder.
        kept: name in the usual folder; if it exists there, that folder is returned, even if it cannot be written now.

    Returns:
        The folder; None if neither can be written, which the line then says.
    """
    usual = usual_folder(kind)
    if usual is not None and ((kept and os.path.exists(usual / kept)) or (cause := _not_writable(usual)) is None):
        return usual
    because = "this user has no home folder" if usual is None else f"{usual} cannot be written ({cause})"
    try:
        other = _temporary() / kind
    except OSError:
        say_once(
            f"{_CONTENT[kind]} is not kept, because {because}, and there is no folder for temporary files{_cure(kind)}"
        )
        return None
    if (cause := _not_own(other.parent) or _not_own(other) or _not_writable(other)) is None:
        say_once(f"{_CONTENT[kind]} is kept in {other}, because {because}")
        return other
    say_once(f"{_CONTENT[kind]} is not kept, because {because}, and {other} neither ({cause}){_cure(kind)}")
    return None


def usual_folder(kind: Kind) -> Path | None:
    """Return the folder of a user with a home folder, whether it exists or not; None if there is no home folder."""
    if kind == "cache" and (own := os.environ.get(OWN_CACHE)):
        return Path(own)
    make = platformdirs.user_cache_dir if kind == "cache" else platformdirs.user_data_dir
    try:
        folder = Path(make("aftdeck", appauthor=False))
    except RuntimeError:
        return None
    return folder if folder.is_absolute() else None  # without a home, "~" stays as it is


@functools.cache
def say_once(sentence: str) -> None:
    """Print a sentence once; a process that another one of this program has started leaves this to the first one."""
    if CHILD not in os.environ:
        print_line(sentence, sys.stderr)


def _cure(kind: Kind) -> str:
    return f"; name a folder by {OWN_CACHE}" if kind == "cache" else ""


def _temporary() -> Path:
    return Path(tempfile.gettempdir()) / (f"aftdeck-{os.getuid()}" if hasattr(os, "getuid") else "aftdeck")


def _not_writable(folder: Path) -> str | None:
    """Make a folder and a file in it; return the reason for which this is not possible, None if it is."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder) as file:
            file.write(b"x")
    except OSError as error:
        return error.strerror or type(error).__name__
    return None


def _not_own(folder: Path) -> str | None:
    """Make a folder that only this user may enter; return the reason if it is somebody else's, or open to others.

    Everybody may write into the folder for temporary files, and compiled code is run.
    """
    try:
        folder.mkdir(mode=0o700, exist_ok=True)
        found = folder.stat(follow_symlinks=False)
    except OSError as error:
        return error.strerror or type(error).__name__
    if not stat.S_ISDIR(found.st_mode) or (hasattr(os, "getuid") and found.st_uid != os.getuid()):
        return "it belongs to another user"
    return "other users can enter it" if hasattr(os, "getuid") and found.st_mode & 0o077 else None
