"""The compilation of laws."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import aftdeck
from aftdeck import law


def state(source: Path) -> str:
    """Return the digest of all laws of a copy of the package, which recordings and studies contain."""
    code = "from aftdeck.law_folder import state_of_the_laws; print(state_of_the_laws())"
    env = {**os.environ, "PYTHONPATH": str(source)}
    done = subprocess.run(
        [sys.executable, "-c", code], env=env, capture_output=True, text=True, check=True, timeout=300
    )
    return done.stdout.strip()


@pytest.mark.parametrize(
    "changed",
    [
        "law.py",
        "elementary.py",
        "quaternions.py",
        "bodies/closest.py",
        "kinematics/linkage.py",
        "steering/layout.py",
        "steering/limiters.py",
    ],
)
def test_changed_source_has_another_digest_of_all_laws(tmp_path: Path, changed: str) -> None:
    shutil.copytree(
        Path(aftdeck.__file__).parent, tmp_path / "src" / "aftdeck", ignore=shutil.ignore_patterns("static")
    )
    before = state(tmp_path / "src")
    assert state(tmp_path / "src") == before
    with (tmp_path / "src" / "aftdeck" / changed).open("a") as file:
        file.write("\nSURPLUS = 1\n")
    assert state(tmp_path / "src") != before


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


def test_scenario_loaded_without_numba_starts_where_a_compiled_one_does() -> None:
    runs("""
import sys, numpy as np, aftdeck
from aftdeck import law
from aftdeck.scenario.load import built_in

def loaded():
    return {name: aftdeck.load_scenario(name) for name in built_in()}

def targets(scenario):
    sequences = [point.target for points in scenario.sequences.values() for point in points]
    return [phase.target for phase in scenario.phases] + sequences

plain = loaded()
assert "numba" not in sys.modules
law.load()
for name, compiled in loaded().items():
    assert plain[name].initial_angles.tobytes() == compiled.initial_angles.tobytes(), name
    assert repr(targets(plain[name])) == repr(targets(compiled)), name
""")


def test_law_outside_interpreted_loads_numba_also_in_another_thread() -> None:
    runs("""
import sys, threading, aftdeck
from aftdeck import law
arm = aftdeck.load_arm("srms")
with law.interpreted():
    pose = arm.forward([0.0, 0.5, -1.0, 0.1, 0.2, 0.3])
    assert "numba" not in sys.modules
    other = threading.Thread(target=arm.forward, args=([0.0] * 6,))
    other.start()
    other.join()
assert "numba" in sys.modules
assert arm.forward([0.0, 0.5, -1.0, 0.1, 0.2, 0.3]).position.tobytes() == pose.position.tobytes()
""")


def test_interpreted_that_ends_inside_another_leaves_the_other_in_force() -> None:
    runs("""
import sys, aftdeck
from aftdeck import law
arm = aftdeck.load_arm("srms")
with law.interpreted():
    with law.interpreted():
        pass
    arm.forward([0.0, 0.5, -1.0, 0.1, 0.2, 0.3])
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
from aftdeck.elementary import nearest
before = [nearest]
assert nearest(1.4) == 1.0
assert nearest is before[0], "an elementary law runs as plain Python before the laws are loaded"
law.load()
from aftdeck import elementary
assert nearest is elementary.nearest is not before.pop() and nearest(1.4) == 1.0
gc.collect()
left = [one.__wrapped__ for one in gc.get_objects() if type(one) is law._Declared]
assert not left, left
""")


def test_law_missed_by_loading_works_in_python_and_compiled_code() -> None:
    runs("""
from aftdeck import law
from aftdeck import elementary
kept = [elementary.nearest]
law.load()
assert kept[0] is not elementary.nearest and kept[0](1.4) == 1.0
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


@pytest.mark.slow
def test_plain_python_gives_numbers_of_the_same_types_as_machine_code() -> None:
    """A frame of numbers of NumPy could neither be recorded nor sent to a page."""
    runs("""
import os
os.environ["NUMBA_DISABLE_JIT"] = "1"
import msgspec
from aftdeck import Inputs, Simulation
from aftdeck.scenario.load import built_in
for name in built_in():
    sim = Simulation(name)
    for inputs in (Inputs(translation=(0.1, 0.2, 0.3), rotation=(0.3, 0.2, 0.1)), None):
        msgspec.json.encode(sim.step(inputs))
""")
