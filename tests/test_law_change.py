"""Laws that begin as plain Python, and are compiled by another process meanwhile."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from aftdeck.recording.reader import Recording
from aftdeck.recording.replay import verify
from tests.loaded import scenario

BEGIN = """
import os, sys, time
from aftdeck import law, law_cache, law_change
from tests import few_laws
os.environ[few_laws.PID] = str(os.getpid())
law.run_plain()
assert few_laws.third(1.0) == 1.0 / 3.0 and "numba" not in sys.modules
told = []
laws = law_change.Laws(tell=told.append)
"""


def runs(code: str, folder: Path, cwd: Path | None = None, *, closed: bool = False) -> None:
    """Run code in a new process with a folder for machine code, or, if `closed`, without any folder to write into."""
    env = {**os.environ, "NUMBA_CACHE_DIR": str(folder), "PYTHONPATH": str(Path(__file__).parents[1])}
    if closed:
        (folder / "sitecustomize.py").write_text(f"import tempfile; tempfile.tempdir = {__file__!r}")
        env |= {"NUMBA_CACHE_DIR": __file__, "PYTHONPATH": os.pathsep.join((str(folder), env["PYTHONPATH"]))}
    done = subprocess.run(
        [sys.executable, "-c", code], check=False, capture_output=True, text=True, timeout=900, env=env, cwd=cwd
    )
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("where", ["a folder", "no folder"])
def test_laws_change_over_between_two_calls(where: str, tmp_path: Path) -> None:
    again = "assert law_cache.in_memory" if where == "no folder" else ""
    runs(
        BEGIN
        + """
laws.want(few_laws.call, files=2)
assert law.is_plain() and not laws.wait(0.0)
placeholder = [few_laws.ninth]
assert few_laws.ninth(9.0) == 1.0 and few_laws.ninth is placeholder[0]
while not laws.wait(0.01):
    assert few_laws.ninth(9.0) == 1.0
assert not laws.failure and not law.is_plain()
assert few_laws.third(3.0) == 1.0 and few_laws.ninth is not placeholder[0]
assert not few_laws.ninth.stats.cache_misses
shares = [progress.share for progress in told if progress is not None]
assert shares == sorted(shares) and shares[0] == 0.0 and shares[-1] > 0.9 and told[-1] is None
"""
        + again,
        tmp_path,
        closed=where == "no folder",
    )


def test_kept_laws_are_loaded_at_once_and_used_from_the_next_call_on(tmp_path: Path) -> None:
    runs("from tests import few_laws; few_laws.call()", tmp_path)
    runs(
        BEGIN
        + """
laws.want(few_laws.call)
assert laws.wait(0.0) and not told and not law.is_plain()
few_laws.call()
assert not few_laws.ninth.stats.cache_misses
""",
        tmp_path,
    )


def test_a_process_that_runs_kept_laws_compiles_nothing(tmp_path: Path) -> None:
    runs("from tests import few_laws; few_laws.third(1.0)", tmp_path)
    runs(
        """
from aftdeck import law
from tests import few_laws
law.run_kept()
assert few_laws.third(3.0) == 1.0 and few_laws.ninth(9.0) == 1.0
assert few_laws.third.compiled.stats.cache_hits and not few_laws.ninth.compiled.stats.cache_misses
""",
        tmp_path,
    )


@pytest.mark.parametrize(("call", "word"), [("call_and_fail", "no such arm"), ("call_and_end", "ended")])
def test_a_failed_compilation_leaves_plain_python_and_says_why(call: str, word: str, tmp_path: Path) -> None:
    runs(
        BEGIN
        + f"""
laws.want(few_laws.{call})
assert laws.wait(60.0) and {word!r} in laws.failure, laws.failure
assert laws.progress is None and law.is_plain() and few_laws.ninth(9.0) == 1.0
""",
        tmp_path,
    )


def test_a_process_of_compiled_laws_waits_for_more_of_them(tmp_path: Path) -> None:
    runs(
        BEGIN.replace("law.run_plain()", "law.load()").replace('and "numba" not in sys.modules', "")
        + """
laws.want(few_laws.call)
assert told and told[-1] is None
assert not few_laws.ninth.stats.cache_misses
few_laws.call()
assert not few_laws.ninth.stats.cache_misses
""",
        tmp_path,
    )


def test_laws_that_two_calls_want_change_over_after_both(tmp_path: Path) -> None:
    runs(
        BEGIN
        + """
laws.want(few_laws.call, files=2)
laws.want(few_laws.call_one, files=1)
while not laws.wait(0.01):
    few_laws.call()
assert not laws.failure and not law.is_plain()
""",
        tmp_path,
    )


def test_without_numba_nothing_is_compiled(tmp_path: Path) -> None:
    code = BEGIN.replace("import os, sys, time", "import os, sys, time\nos.environ['NUMBA_DISABLE_JIT'] = '1'")
    runs(
        code.replace('and "numba" not in sys.modules', "")
        + "\nlaws.want(few_laws.call)\nassert laws.wait(0.0) and not told and not law.is_plain()",
        tmp_path,
    )


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize(
    ("module", "call"), [("aftdeck.visual.warm", "warm_up"), ("aftdeck.gym.reach.batch", "_call_laws")]
)
def test_bar_of_other_laws_knows_the_number_of_their_files(module: str, call: str, tmp_path: Path) -> None:
    runs(
        BEGIN
        + f"""
from {module} import FILES, {call}
laws.want({call}, files=FILES)
while not laws.wait(1.0):
    pass
assert not laws.failure, laws.failure
from aftdeck.law_folder import cache_folder
files = list(cache_folder().rglob("*.law"))
assert 0.8 < len(files) / FILES < 1.2, len(files)
""",
        tmp_path,
    )


FLIGHT = """
import sys, time
from pathlib import Path
from aftdeck import law, law_cache, law_change
from aftdeck.law_folder import compiled_before
from tests.loaded import scenario
law.run_plain()
from aftdeck.recording.run import record
from aftdeck.simulation.warm import warm_up

flown = scenario("first-flight")
laws = law_change.Laws(background=False)
ticks = []

def stepped(sim):
    if len(ticks) == 50:
        laws.want(warm_up, flown)
        {wait}
    ticks.append(law.is_plain())

record(flown, Path("run.mcap"), stepped=stepped)
assert ticks[49] and not ticks[-1] and not laws.failure, laws.failure
missed = [
    name for module in list(sys.modules.values()) if module.__name__.startswith("aftdeck.")
    for name, value in vars(module).items() if getattr(getattr(value, "stats", None), "cache_misses", None)
]
assert not missed, missed
"""


def test_recording_across_the_change_is_equal_to_the_last_bit(tmp_path: Path) -> None:
    folder = os.environ.get("NUMBA_CACHE_DIR")
    code = FLIGHT.replace("{wait}", "")
    env = {**os.environ, "PYTHONPATH": str(Path(__file__).parents[1])}
    scenario("first-flight")  # the laws are compiled
    done = subprocess.run(
        [sys.executable, "-c", code], check=False, capture_output=True, text=True, timeout=300, env=env, cwd=tmp_path
    )
    assert done.returncode == 0, (folder, done.stderr)
    assert verify(tmp_path / "run.mcap").equal


@pytest.mark.slow
def test_flight_with_nothing_compiled_changes_over_and_the_number_of_files_is_that_of_the_bar(tmp_path: Path) -> None:
    code = FLIGHT.replace("{wait}", "while not laws.wait(1.0): pass") + (
        "\nfiles = list(law_cache.cache_folder().rglob('*.law'))"
        "\nassert 0.8 < len(files) / law_change.FILES < 1.2, len(files)"
    ).replace("law_cache.cache_folder", "__import__('aftdeck.law_folder').law_folder.cache_folder")
    runs(code, tmp_path / "cache", tmp_path)
    assert verify(tmp_path / "run.mcap").equal
    assert Recording(tmp_path / "run.mcap").opening.title
