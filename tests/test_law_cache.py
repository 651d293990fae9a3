"""Machine code on disk: whatever happens to the files, a law gives its result, and the files are written again."""

from __future__ import annotations

import gc
import importlib.util
import random
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from aftdeck import law
from aftdeck.folders import say_once
from aftdeck.law_cache import LawCache, in_memory
from aftdeck.law_digest import Options
from aftdeck.law_folder import ENDING

OPTIONS = Options(fused=False, inlined=True)
SOURCE = """
def hypotenuse(a, b):
    return (a * a + b * b) ** 0.5
"""


def flip(data: bytes, at: int) -> bytes:
    """Return data with one bit changed."""
    return data[:at] + bytes([data[at] ^ (1 << at % 8)]) + data[at + 1 :]


def _loop_of_links(path: Path) -> None:
    path.unlink()
    path.symlink_to(path)


def _folder(path: Path) -> None:
    path.unlink()
    path.mkdir()
    (path / "file").touch()


DAMAGE: dict[str, Callable[[Path, random.Random], object]] = {
    "empty": lambda path, _: path.write_bytes(b""),
    "missing": lambda path, _: path.unlink(),
    "cut": lambda path, rng: path.write_bytes(path.read_bytes()[: rng.randrange(path.stat().st_size)]),
    "longer": lambda path, rng: path.write_bytes(path.read_bytes() + rng.randbytes(9)),
    "noise": lambda path, rng: path.write_bytes(rng.randbytes(path.stat().st_size)),
    "one bit": lambda path, rng: path.write_bytes(flip(path.read_bytes(), rng.randrange(path.stat().st_size))),
    "zeros at the end": lambda path, _: path.write_bytes(path.read_bytes()[:4096].ljust(path.stat().st_size, b"\0")),
    "a folder": lambda path, _: _folder(path),
    "a loop of links": lambda path, _: _loop_of_links(path),
}


class Laws:
    """A law in a file, compiled again and again with the same cache."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder / "cache"
        source = folder / "some_laws.py"
        source.write_text(SOURCE)
        spec = importlib.util.spec_from_file_location("some_laws", source)
        assert spec is not None and spec.loader is not None
        self.module: ModuleType = importlib.util.module_from_spec(spec)
        sys.modules[spec.name] = self.module  # the machine code names it
        spec.loader.exec_module(self.module)

    def was_compiled(self) -> bool:
        """Call the law as a new process would; return whether it had to be compiled."""
        import numba  # noqa: PLC0415

        in_memory.clear()
        compiled: Any = numba.njit(self.module.hypotenuse)
        compiled._cache = LawCache(self.module.hypotenuse, OPTIONS, self.folder)
        assert compiled(3.0, 4.0) == 5.0
        gc.collect()  # nothing of an earlier compilation helps
        return bool(compiled.stats.cache_misses)

    def files(self) -> list[Path]:
        """Return the files of the cache."""
        return list(self.folder.rglob(f"*{ENDING}"))


@pytest.fixture(scope="module")
def laws(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Laws]:
    """A law whose machine code is on disk."""
    laws = Laws(tmp_path_factory.mktemp("laws"))
    assert laws.was_compiled() and not laws.was_compiled()
    yield laws
    del sys.modules["some_laws"]


@pytest.mark.parametrize("damage", DAMAGE)
@pytest.mark.parametrize("seed", [1, 2])
def test_a_damaged_file_is_compiled_and_written_again(laws: Laws, damage: str, seed: int) -> None:
    (file,) = laws.files()
    DAMAGE[damage](file, random.Random(seed))
    assert laws.was_compiled()
    if damage == "a folder":  # it cannot be replaced; the law is compiled each time
        shutil.rmtree(file)
        assert laws.was_compiled()
    assert not laws.was_compiled()
    assert len(laws.files()) == 1


def test_a_law_from_a_file_needs_nothing_of_a_compilation(laws: Laws) -> None:
    code = f"""
import sys
sys.path.insert(0, {str(laws.folder.parent)!r})
import numba, some_laws
from pathlib import Path
from aftdeck.law_cache import LawCache
from aftdeck.law_digest import Options
law = numba.njit(some_laws.hypotenuse)
law._cache = LawCache(some_laws.hypotenuse, Options(fused=False, inlined=True), Path({str(laws.folder)!r}))
assert law(3.0, 4.0) == 5.0 and not law.stats.cache_misses
assert "numba.np.linalg" not in sys.modules and law.overloads.popitem()[1].library._shared_module is None
"""
    done = subprocess.run([sys.executable, "-c", code], check=False, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr


def test_a_file_of_another_signature_is_not_run(laws: Laws) -> None:
    (file,) = laws.files()
    import numba  # noqa: PLC0415

    other: Any = numba.njit(laws.module.hypotenuse)
    other._cache = LawCache(laws.module.hypotenuse, OPTIONS, laws.folder)
    assert other(3, 4) == 5.0
    (second,) = (path for path in laws.files() if path != file)
    shutil.copy(second, file)
    assert laws.was_compiled()
    second.unlink()


def test_another_source_has_machine_code_of_its_own(laws: Laws, tmp_path: Path) -> None:
    changed = Laws(tmp_path)
    changed.folder = laws.folder
    assert not changed.was_compiled(), "the same source in another folder"
    (tmp_path / "another").mkdir()
    source = tmp_path / "another" / "some_laws.py"
    source.write_text(SOURCE.replace("0.5", "0.25"))
    code = f"""
import sys, numba
from pathlib import Path
sys.path.insert(0, {str(source.parent)!r})
import some_laws
from aftdeck.law_cache import LawCache
from aftdeck.law_digest import Options
law = numba.njit(some_laws.hypotenuse)
law._cache = LawCache(some_laws.hypotenuse, Options(fused=False, inlined=True), Path({str(laws.folder)!r}))
print(law(3.0, 4.0))
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=300)
    assert float(done.stdout) == 5.0**0.5


def test_a_folder_that_cannot_be_written_is_said_once(
    laws: Laws, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    say_once.cache_clear()
    (tmp_path / "file").touch()
    closed = Laws(tmp_path)
    closed.folder = tmp_path / "file" / "cache"
    assert closed.was_compiled() and closed.was_compiled()
    assert [str(tmp_path / "file") in line for line in capsys.readouterr().err.splitlines()] == [True]


def test_laws_use_this_cache() -> None:
    law.load()

    @law.law
    def third(value: float) -> float:
        return value / 3.0

    assert isinstance(third._cache, LawCache)  # type: ignore[attr-defined]
