"""Folder of the machine code: what is still used stays, and what no process has used for a month goes."""

from __future__ import annotations

import os
import time
from pathlib import Path

import pytest

from aftdeck import law_folder
from aftdeck.law_folder import cache_folder, compiled_before, mark_used, mark_version

DAY = 86_400.0


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty cache folder of this process."""
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    monkeypatch.setattr(law_folder, "cache_folder", cache_folder.__wrapped__)
    return tmp_path


def aged(path: Path, days: float) -> Path:
    """Make a file that was used last some days ago."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.touch()
    then = time.time() - days * DAY
    os.utime(path, (then, then))
    return path


def test_unused_files_and_folders_of_earlier_programs_go_once_a_day(home: Path) -> None:
    folder = cache_folder.__wrapped__()
    assert folder == home / "laws" and folder.is_dir()
    old, new = aged(folder / "aftdeck.x" / "a.law", 31), aged(folder / "aftdeck.x" / "b.law", 29)
    earlier, kept = home / "laws-0123456789abcdef", home / "laws-fedcba9876543210"
    aged(earlier / "aftdeck.x" / "a.law", 40)
    kept.mkdir()
    os.utime(earlier, (0.0, 0.0))
    cache_folder.__wrapped__()
    assert old.exists() and earlier.exists(), "the folder is new, so it was not cleaned today"
    os.utime(folder, (0.0, 0.0))
    cache_folder.__wrapped__()
    assert not old.exists() and new.exists() and not earlier.exists() and kept.exists()
    assert time.time() - folder.stat().st_mtime < DAY


def test_file_that_is_read_stays(home: Path) -> None:
    file = aged(home / "a.law", 31)
    mark_used(file)
    assert time.time() - file.stat().st_mtime < DAY
    before = aged(file, 0.5).stat().st_mtime
    mark_used(file)
    assert file.stat().st_mtime == before, "once a day is enough"
    mark_used(home / "missing.law")


def test_a_version_counts_as_compiled_for_the_packages_that_it_has_compiled(home: Path) -> None:
    folder = cache_folder.__wrapped__()
    assert folder is not None and not compiled_before()
    mark_version.__wrapped__(folder, "aftdeck.steering.msteer")
    assert compiled_before() and compiled_before("aftdeck.steering") and not compiled_before("aftdeck.visual")
