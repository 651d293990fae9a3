"""Skipped tests fail a run that requires all tests, unless they are listed."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.skips import MAY_SKIP, VARIABLE

ROOT = Path(__file__).parents[1]
TESTS = """
import pytest

def test_runs():
    pass

def test_skips():
    pytest.skip("it rains")

@pytest.mark.skipif(True, reason="it snows")
def test_never_runs():
    pass

@pytest.mark.xfail
def test_fails():
    assert False
"""
FILE = """
import pytest

pytest.importorskip("a_library_that_is_nowhere")
"""
LISTED = """
from tests.skips import MAY_SKIP

MAY_SKIP["test_one.py::test_[sn]*"] = "it rains"
"""


def ended(folder: Path, *options: str, required: str = "1") -> tuple[int, str]:
    """Return the exit code and the output of a run of the tests in a folder."""
    environment = os.environ | {VARIABLE: required, "PYTHONPATH": str(ROOT), "PYTEST_ADDOPTS": ""}
    plugins = ["-p", "tests.skips", "-p", "no:cacheprovider", "-p", "no:hypothesispytest"]  # the last takes a second
    done = subprocess.run(
        [sys.executable, "-m", "pytest", *plugins, "--rootdir", folder, *options],
        env=environment, cwd=folder, capture_output=True, text=True, timeout=120, check=False,
    )  # fmt: skip
    return done.returncode, done.stdout


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "test_one.py").write_text(TESTS, encoding="utf-8")
    return tmp_path


@pytest.mark.parametrize("options", [(), ("-n", "2")], ids=["one process", "two processes"])
def test_skips_fail_the_run_and_are_listed(folder: Path, options: tuple[str, ...]) -> None:
    (folder / "test_two.py").write_text(FILE, encoding="utf-8")
    code, out = ended(folder, *options)
    assert code == 1
    lines = out.partition("not listed in tests.skips")[2].splitlines()
    assert lines[1:3] == ["test_one.py::test_never_runs: it snows", "test_one.py::test_skips: it rains"]
    assert lines[3].startswith("test_two.py: could not import 'a_library_that_is_nowhere'")
    assert "test_fails" not in out


def test_listed_skip_passes_only_with_its_reason(folder: Path) -> None:
    (folder / "conftest.py").write_text(LISTED, encoding="utf-8")
    assert ended(folder, "test_one.py::test_skips")[0] == 0
    assert ended(folder, "test_one.py::test_never_runs")[0] == 1


def test_skips_pass_where_not_all_tests_are_required(folder: Path) -> None:
    assert ended(folder, required="0")[0] == 0


@pytest.mark.parametrize("listed", MAY_SKIP)
def test_listed_test_exists_and_gives_the_listed_reason(listed: str) -> None:
    file, _, name = listed.partition("::")
    text = (ROOT / file).read_text(encoding="utf-8")
    assert f"def {name.removesuffix('*')}" in text
    assert f'"{MAY_SKIP[listed]}"' in text
