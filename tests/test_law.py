"""The shared sine and cosine against the standard library, and the compilation of laws."""

from __future__ import annotations

import math
import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import aftdeck
from aftdeck import law
from aftdeck.law import sincos

OURS, THEIRS = 2e-16, 1.2e-16
"""Greatest errors: that of `sincos`, as promised, and that of `math`, which is one unit in the last place."""


def off(angle: float) -> float:
    s, c = sincos(angle)
    return max(abs(s - math.sin(angle)), abs(c - math.cos(angle)))


@settings(derandomize=True, deadline=None, max_examples=500, database=None)
@given(st.floats(-1e5, 1e5))
def test_sine_and_cosine_are_within_the_promised_error(angle: float) -> None:
    assert off(angle) <= OURS + THEIRS


@pytest.mark.parametrize("reach", [1e-8, 1.0, 10.0, 1e3, 1e5])
def test_sine_and_cosine_are_accurate_over_many_angles(reach: float) -> None:
    angles = np.random.default_rng(80).uniform(-reach, reach, 20_000)
    assert max(off(float(a)) for a in angles) <= OURS + THEIRS


def test_sine_and_cosine_are_accurate_near_multiples_of_45_deg() -> None:
    for k in range(-4000, 4000):
        middle = k * math.pi / 4
        for angle in (math.nextafter(middle, -math.inf), middle, math.nextafter(middle, math.inf)):
            assert off(angle) <= OURS + THEIRS


def test_smallest_angles_equal_their_sine() -> None:
    for angle in (0.0, 5e-324, 1e-300, -1e-20, 1e-9):
        assert sincos(angle) == (angle, 1.0)


def test_squares_of_sine_and_cosine_add_up_to_one() -> None:
    for angle in np.random.default_rng(81).uniform(-100, 100, 5000):
        s, c = sincos(float(angle))
        assert s * s + c * c == pytest.approx(1.0, abs=6e-16)


def cache_folder(source: Path, home: Path) -> str:
    """Return the folder in which a copy of the package stores the machine code of its laws."""
    code = "import aftdeck.law as law; print(law._cache())"
    env = {**os.environ, "PYTHONPATH": str(source), "NUMBA_CACHE_DIR": str(home)}
    done = subprocess.run(
        [sys.executable, "-c", code], env=env, capture_output=True, text=True, check=True, timeout=300
    )
    return done.stdout.strip()


@pytest.mark.parametrize(
    "changed", ["law.py", "bodies/closest.py", "kinematics/linkage.py", "steering/layout.py", "steering/limiters.py"]
)
def test_changed_source_selects_another_machine_code_cache(tmp_path: Path, changed: str) -> None:
    shutil.copytree(
        Path(aftdeck.__file__).parent, tmp_path / "src" / "aftdeck", ignore=shutil.ignore_patterns("static")
    )
    before = cache_folder(tmp_path / "src", tmp_path / "cache")
    assert before.startswith(str(tmp_path / "cache"))
    assert cache_folder(tmp_path / "src", tmp_path / "cache") == before
    with (tmp_path / "src" / "aftdeck" / changed).open("a") as file:
        file.write("\nSURPLUS = 1\n")
    assert cache_folder(tmp_path / "src", tmp_path / "cache") != before


def runs(code: str) -> None:
    """Run code in a new process, in which no law has been called."""
    done = subprocess.run([sys.executable, "-c", code], check=False, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr


def test_loading_an_arm_imports_no_numba() -> None:
    runs("""
import sys, aftdeck
for name in ("srms", "concept-1972"):
    aftdeck.load_arm(name)
assert "numba" not in sys.modules
""")


def test_station_and_command_line_import_no_numba() -> None:
    runs("import sys, aftdeck.cli, aftdeck.station.server.serve; assert 'numba' not in sys.modules")


def test_first_call_of_a_law_replaces_all_laws_by_compiled_ones() -> None:
    runs("""
import gc, importlib, pkgutil
import aftdeck
from aftdeck import law
for module in pkgutil.walk_packages(aftdeck.__path__, "aftdeck."):
    if not module.name.endswith("__main__"):
        importlib.import_module(module.name)
from aftdeck.law import nearest
before = [nearest]
assert nearest(1.4) == 1.0
assert nearest is law.nearest is not before.pop()
gc.collect()
left = [one.__wrapped__ for one in gc.get_objects() if type(one) is law._Declared]
assert not left, left
""")


def test_law_missed_by_loading_works_in_python_and_compiled_code() -> None:
    runs("""
from aftdeck import law
kept = [law.nearest]
law.load()
assert kept[0] is not law.nearest and kept[0](1.4) == 1.0
missed = kept[0]

@law.law
def twice(value):
    return 2.0 * missed(value)

assert twice(1.4) == 2.0
""")


def test_law_declared_after_loading_is_compiled_at_once() -> None:
    law.load()

    @law.law
    def half(value: float) -> float:
        return 0.5 * value

    assert not isinstance(half, law._Declared)
    assert half(3.0) == 1.5
