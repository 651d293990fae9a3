"""Machine code of laws on disk, or in memory if there is no folder for it.

A damaged file is one that is not there: the law is compiled again, and the file written again. Numba's own cache raises
errors of its format instead, and runs machine code that was damaged in the file. The digest in a file shows damage, not
forgery: other users must not be able to write into the folder.
"""

from __future__ import annotations

import contextlib
import functools
import hashlib
import importlib
import pickle
import sys
import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from aftdeck.errors import InputError
from aftdeck.folders import say_once
from aftdeck.law_digest import Options, digest_of, digest_of_types
from aftdeck.law_folder import ENDING, mark_used, mark_version
from aftdeck.whole_file import write_whole

_SEAL = hashlib.sha256().digest_size
"""Length of the digest with which a file begins [bytes]."""
in_memory: dict[str, bytes] = {}
"""Contents of the files of a process without a folder, by their names."""
observers: list[Callable[[str], None]] = []
"""Called with the name of each file that was read or written: a process that compiles for another one counts them."""


class NotKept(Exception):
    """There is no machine code of a law that was called inside `only_kept`."""


class _Here(threading.local):
    """State of a thread: `only_kept` is True inside the function of this name."""

    only_kept = False


here = _Here()


@contextlib.contextmanager
def only_kept() -> Iterator[None]:
    """Call laws in this thread as machine code from the cache only.

    Raises:
        NotKept: a law was called whose machine code is not there.
    """
    before, here.only_kept = here.only_kept, True
    try:
        yield
    finally:
        here.only_kept = before


class LawCache:
    """Machine code of one law: one file for each signature. It is a cache of Numba's dispatcher.

    A file begins with the SHA-256 of the rest: the signature, the large laws that the law calls, and Numba's result of
    the compilation. Its name contains a digest of everything on which the machine code depends.
    """

    def __init__(self, law: Callable[..., Any], options: Options, folder: Path | None) -> None:
        """Prepare the cache.

        Args:
            law: function, from a file.
            options: how it is compiled.
            folder: folder of the files; None: they are in memory.
        """
        self._law, self._options, self._folder = law, options, folder

    @property
    def cache_path(self) -> str:
        """Folder of the files; empty if they are in memory."""
        return str(self._folder or "")

    def load_overload(self, signature: Any, target: Any) -> Any:
        """Return the result of the compilation for a signature; None if there is none, or if the file is damaged.

        Raises:
            NotKept: there is none, and the call is inside `only_kept`.
        """
        name = self._name(signature, target.codegen())
        result = _result(self._read(name), signature, target)
        if result is None and here.only_kept:
            raise NotKept(name)
        if result is not None:
            self._separate(signature, result)
            self._tell(name)
        return result

    def save_overload(self, signature: Any, compiled: Any) -> None:
        """Write the result of a compilation for a signature. If this fails, one line of the process says so."""
        if compiled.lifted or compiled.library.has_dynamic_globals:  # it contains addresses of this process
            return
        name = self._name(signature, compiled.codegen)
        needs = _linking().needs_of(compiled.library)
        data = importlib.import_module("numba.core.serialize").dumps((signature, needs, compiled._reduce()))
        self._separate(signature, compiled)
        self._write(name, hashlib.sha256(data).digest() + data)
        self._tell(name)

    def _separate(self, signature: Any, result: Any) -> None:
        """Let other laws call a large law where it is."""
        if not self._options.inlined:
            _linking().separate(result.library, self._law, signature, result.fndesc.llvm_func_name)

    def _name(self, signature: Any, codegen: Any) -> str:
        depends = (
            signature,
            digest_of_types(signature),
            codegen.magic_tuple(),
            importlib.import_module("numba").__version__,
            sys.version_info[:2],
            digest_of(self._law),
            self._options,
            _how_laws_are_compiled(),
        )
        digest = hashlib.sha256(repr(depends).encode()).hexdigest()[:16]
        return f"{self._law.__module__}/{self._law.__name__}-{digest}{ENDING}"

    def _read(self, name: str) -> bytes:
        """Return the content of a file; empty if it is not there, or damaged."""
        data = in_memory.get(name, b"")
        if not data and self._folder is not None:
            with contextlib.suppress(OSError):
                data = (self._folder / name).read_bytes()
                mark_used(self._folder / name)
        return data[_SEAL:] if hashlib.sha256(data[_SEAL:]).digest() == data[:_SEAL] else b""

    def _write(self, name: str, data: bytes) -> None:
        try:
            if self._folder is not None:
                return write_whole(self._folder / name, data)
        except InputError:
            say_once(f"compiled code cannot be written into {self._folder}; it is compiled again at each start")
        in_memory[name] = data
        return None

    def _tell(self, name: str) -> None:
        if self._folder is not None:
            mark_version(self._folder, self._law.__module__)
        for observer in observers:
            observer(name)


def _result(data: bytes, signature: Any, target: Any) -> Any:
    """Return a result of Numba's compilation from a file's content; None if it is not one for this signature."""
    try:
        kept, needs, result = pickle.loads(data)  # not damaged
        if kept != signature or not _linking().are_met(needs):
            return None
        result = importlib.import_module("aftdeck.law_library").rebuilt(target, result)
        result.library.needs = needs
        return result
    except NotKept:
        raise
    except Exception:  # whatever another version of Numba raises: compile again
        return None


def _linking() -> Any:
    return importlib.import_module("aftdeck.law_link")


@functools.cache
def _how_laws_are_compiled() -> str:
    sources = (Path(__file__).with_name(name).read_bytes() for name in ("law.py", "law_link.py"))
    return hashlib.sha256(b"".join(sources)).hexdigest()
