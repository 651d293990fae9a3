"""Folder of the laws' machine code, which all versions of the laws share.

The name of each file has a digest of everything on which its content depends (`law_digest.py`), so that a new version
of the program compiles again only what has changed. The folder is inside `NUMBA_CACHE_DIR` if that variable is set,
otherwise inside the user's cache folder.
"""

from __future__ import annotations

import contextlib
import functools
import hashlib
import os
import re
import shutil
import time
from pathlib import Path

from aftdeck.folders import user_folder

ENDING = ".law"
"""End of the names of the files with machine code."""
_NAME = "laws"
_VERSIONS = "versions"
"""Folder with an empty file for each version of the laws and each package whose laws were compiled in this version."""
_DECLARED = re.compile(rb"^@(elementary_|large_)?law$", re.MULTILINE)
"""Decorator of a law, in a source file."""
_DAY = 86_400.0
_KEPT = 30 * _DAY
"""Time after which a file that no process has used is deleted [s]."""


def compiled_before(package: str = "") -> bool:
    """Return whether the cache on disk contains machine code of this version of the laws.

    Args:
        package: name of the package whose laws count, such as ``aftdeck.visual``; if it is empty, all laws count.
    """
    folder = cache_folder()
    return folder is not None and any((folder / _VERSIONS).glob(f"{state_of_the_laws()}-{package}*"))


@functools.cache
def state_of_the_laws() -> str:
    """Return a 16-digit digest of `law.py` and of the sources of every subpackage that contains a law."""
    digest = hashlib.sha256()
    for entry in sorted(Path(__file__).parent.iterdir()):
        paths = sorted(entry.rglob("*.py")) if entry.is_dir() else [entry] if entry.suffix == ".py" else []
        texts = [path.read_bytes() for path in paths]
        if entry.name == "law.py" or any(map(_declares, texts)):
            for text in texts:
                digest.update(text)
    return digest.hexdigest()[:16]


def _declares(text: bytes) -> bool:
    """Return whether a source declares a law; most have no word at the end of a line that could do so."""
    return b"law\n" in text and _DECLARED.search(text) is not None


@functools.cache
def cache_folder() -> Path | None:
    """Return the cache folder; None if no folder can be written. Once a day, delete what has been unused for long."""
    home = user_folder("cache", _NAME)
    if home is None:
        return None
    folder = home / _NAME
    with contextlib.suppress(OSError):
        folder.mkdir(exist_ok=True)
        if _is_old(folder, _DAY):
            folder.touch()
            _clean(folder)
    return folder


@functools.cache
def mark_version(folder: Path, module: str) -> None:
    """Note that a law of a module was compiled, or its machine code read, in this version of the laws."""
    with contextlib.suppress(OSError):
        (folder / _VERSIONS).mkdir(parents=True, exist_ok=True)
        (folder / _VERSIONS / f"{state_of_the_laws()}-{module}").touch()


def mark_used(path: Path) -> None:
    """Note that a file is still used, once a day."""
    with contextlib.suppress(OSError):
        if _is_old(path, _DAY):
            os.utime(path)


def _is_old(path: Path, age: float) -> bool:
    return time.time() - path.stat().st_mtime > age


def _clean(folder: Path) -> None:
    """Delete the files that no process has used for `_KEPT`, and the folders of earlier programs, one a version."""
    for path in folder.rglob("*"):
        with contextlib.suppress(OSError):
            if path.is_file() and _is_old(path, _KEPT):
                path.unlink()
    for path in folder.parent.glob(f"{_NAME}-*"):
        with contextlib.suppress(OSError):
            if _is_old(path, _KEPT):
                shutil.rmtree(path, ignore_errors=True)
