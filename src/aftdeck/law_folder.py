"""Folder of the laws' machine code: its name is a digest of all laws.

Numba's own cache checks only the file that defines a function, not the files of the functions that it calls. If a law
changed in one file, the cached code of its callers would still contain the old version. The machine code is therefore
in a folder whose name is a digest of all laws. This folder is inside `NUMBA_CACHE_DIR` if that variable is set,
otherwise inside the user's cache folder. Checkouts with the same laws share it.
"""

from __future__ import annotations

import contextlib
import functools
import hashlib
import re
import shutil
import time
from pathlib import Path

from aftdeck.folders import user_folder

ENDING = ".law"
"""End of the names of the files with machine code."""
_DECLARED = re.compile(rb"^@(elementary_|large_)?law$", re.MULTILINE)
"""Decorator of a law, in a source file."""
_KEPT = 30 * 86_400.0
"""Time after which unused machine code of another version of the laws is deleted [s]."""


def compiled_before(package: str = "") -> bool:
    """Return whether the cache on disk contains machine code of this version of the laws.

    Args:
        package: name of the package whose laws count, such as ``aftdeck.visual``; if it is empty, all laws count.
    """
    folder = cache_folder()
    return folder is not None and any(folder.glob(f"{package}*/*{ENDING}"))


@functools.cache
def state_of_the_laws() -> str:
    """Return a 16-digit digest of `law.py` and of the sources of every subpackage that contains a law."""
    digest, home = hashlib.sha256(), Path(__file__).parent
    sources = {path: path.read_bytes() for path in sorted(home.rglob("*.py"))}
    packages = {path.relative_to(home).parts[0] for path, text in sources.items() if _DECLARED.search(text)}
    packages.add("law.py")
    for path, text in sources.items():
        if path.relative_to(home).parts[0] in packages:
            digest.update(text)
    return digest.hexdigest()[:16]


@functools.cache
def cache_folder() -> Path | None:
    """Return the cache folder for this version of the laws; None if no folder can be written.

    Also delete the folders of other versions that have been unused for more than `_KEPT`.
    """
    name = f"laws-{state_of_the_laws()}"
    home = user_folder("cache", name)
    if home is None:
        return None
    folder = home / name
    with contextlib.suppress(OSError):
        folder.mkdir(exist_ok=True)
        folder.touch()
        for other in home.glob("laws-*"):
            if time.time() - other.stat().st_mtime > _KEPT:
                shutil.rmtree(other, ignore_errors=True)
    return folder
