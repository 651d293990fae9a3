"""Machine code of laws on disk.

A damaged file is one that is not there: the law is compiled again, and the file written again. Numba's own cache raises
errors of its format instead, and runs machine code that was damaged in the file. The digest in a file shows damage, not
forgery: other users must not be able to write into the folder.
"""

from __future__ import annotations

import functools
import hashlib
import importlib
import pickle
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

from aftdeck.errors import InputError
from aftdeck.folders import say_once
from aftdeck.whole_file import write_whole

ENDING = ".law"
"""End of the names of the files."""
_SEAL = hashlib.sha256().digest_size
"""Length of the digest with which a file begins [bytes]."""


class LawCache:
    """Machine code of one law: one file for each signature. It is a cache of Numba's dispatcher.

    A file begins with the SHA-256 of the rest: the signature, and Numba's result of the compilation. Its name contains
    a digest of everything on which the machine code depends, except for the laws that this law calls: a folder holds
    the machine code of one version of all laws.
    """

    def __init__(self, law: Callable[..., Any], folder: Path) -> None:
        """Prepare the cache.

        Args:
            law: function, from a file.
            folder: folder for this version of all laws.
        """
        self._law, self._folder = law, folder / law.__module__

    @property
    def cache_path(self) -> str:
        """Folder of the files."""
        return str(self._folder)

    def load_overload(self, signature: Any, target: Any) -> Any:
        """Return the result of the compilation for a signature; None if there is none, or if the file is damaged."""
        target.refresh()
        try:
            data = self._path(signature, target.codegen()).read_bytes()
        except OSError:
            return None
        if hashlib.sha256(data[_SEAL:]).digest() != data[:_SEAL]:
            return None
        try:
            kept, result = pickle.loads(data[_SEAL:])  # not damaged
            return _numba("compiler").CompileResult._rebuild(target, *result) if kept == signature else None
        except Exception:  # whatever another version of Numba raises: compile again
            return None

    def save_overload(self, signature: Any, compiled: Any) -> None:
        """Write the result of a compilation for a signature. If this fails, one line of the process says so."""
        if compiled.lifted or compiled.library.has_dynamic_globals:  # it contains addresses of this process
            return
        data = _numba("serialize").dumps((signature, compiled._reduce()))
        try:
            write_whole(self._path(signature, compiled.codegen), hashlib.sha256(data).digest() + data)
        except InputError:
            say_once(f"compiled code cannot be written into {self._folder.parent}; it is compiled again at each start")

    def _path(self, signature: Any, codegen: Any) -> Path:
        cells = [cell.cell_contents for cell in self._law.__closure__ or ()]
        depends = (
            signature,
            codegen.magic_tuple(),
            importlib.import_module("numba").__version__,
            sys.version_info[:2],
            _digest_of(self._law.__code__.co_filename),
            self._law.__code__.co_firstlineno,
            _numba("serialize").dumps(cells) if cells else b"",
        )
        digest = hashlib.sha256(repr(depends).encode()).hexdigest()[:16]
        return self._folder / f"{self._law.__name__}-{digest}{ENDING}"


def _numba(module: str) -> Any:
    return importlib.import_module(f"numba.core.{module}")


@functools.cache
def _digest_of(source: str) -> str:
    return hashlib.sha256(Path(source).read_bytes()).hexdigest()
