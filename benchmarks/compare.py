"""Comparison with a commit: both run their own benchmark of the same name, in turn, and the figures are paired.

The commit's files are unpacked into a temporary folder. Its programs use the packages of this Python, and only the
sources of that folder. Earlier commits know only ``python -m benchmarks --json NAME``, so both sides are run by it.
"""

from __future__ import annotations

import io
import json
import math
import os
import shutil
import statistics
import subprocess
import sys
import tarfile
import tempfile
from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

import msgspec

from benchmarks import results
from benchmarks.measure import Figure
from benchmarks.names import NAMES
from benchmarks.results import ROOT
from benchmarks.runner import call
from benchmarks.table import NAME, number, unit_text

LIMIT_S = 1200.0
"""Time after which a run of one side is ended [s]."""
PAGE = Path("src/aftdeck/station/static")
"""Folder of the built page, which git does not store."""
WITH_PAGE = {"page"}
"""Benchmarks whose figures depend on the page."""
_SOURCE = "import aftdeck; print(aftdeck.__file__)"
_NAMES = "import benchmarks.__main__ as commands; print(*commands.NAMES)"
_FIRST = "import aftdeck; aftdeck.Simulation('first-flight').step()"


class Side(NamedTuple):
    """Working tree whose benchmarks are run.

    Attributes:
        title: name in the output.
        root: folder of the tree.
    """

    title: str
    root: Path


class Failed(msgspec.Struct, frozen=True):
    """Run of one side that gave no figures: name, side, error in one line, and last output."""

    benchmark: str
    side: str
    error: str
    details: str


class Paired(msgspec.Struct, frozen=True):
    """Figure of both sides.

    Attributes:
        benchmark: name of the benchmark.
        figure: name of the figure.
        unit: its unit.
        base: its values on the base, one for each round.
        now: its values on this tree, one for each round.
    """

    benchmark: str
    figure: str
    unit: str
    base: tuple[float, ...]
    now: tuple[float, ...]

    @property
    def ratios(self) -> tuple[float, ...]:
        """Value of this tree divided by the base's, for each round whose base is not 0."""
        return tuple(now / base for now, base in zip(self.now, self.base, strict=True) if base)


def compare(commit: str, names: list[str], file: Path, rounds: int, root: Path = ROOT) -> int:
    """Compare this tree with a commit; print and store the figures of each benchmark as they come.

    Args:
        commit: commit of the base.
        names: benchmarks to run; empty for all that both have and that run by default.
        file: file of results.
        rounds: number of runs of each side.
        root: this tree.

    Returns:
        Exit code: 1 if a run failed.
    """
    results.begin(file, results.here("FULL"))
    failed = False
    with unpacked(commit, root) as base:
        sides = Side(commit, base), Side("now", root)
        for side in sides:
            check(side)
        full = results.git(root, "rev-parse", "--short=10", commit)
        print(f"base: {commit} ({full}); now: {results.commit_of(root)}; {rounds} runs of each side in turn")
        for name in _common(sides, names, same_page=_same_page(commit, root)):
            print(f"\n{name}\n{_heads()}", flush=True)
            found = _rounds(sides, name, rounds)
            for row in found:
                results.append(file, row)
                print(f"  FAILED on {row.side}: {row.error}" if isinstance(row, Failed) else pair_line(row), flush=True)
                failed = failed or isinstance(row, Failed)
    print(f"\nResults: {file}")
    return 1 if failed else 0


def _rounds(sides: tuple[Side, Side], name: str, rounds: int) -> Sequence[Paired | Failed]:
    """Run a benchmark of both sides in turn; return the paired figures, or the first failure."""
    made: tuple[list[list[Figure]], list[list[Figure]]] = [], []
    for _ in range(rounds):
        for side, figures in zip(sides, made, strict=True):
            found = _measured(side, name)
            if isinstance(found, Failed):
                return [found]
            figures.append(found)
    return paired(name, *made)


def paired(benchmark: str, base: list[list[Figure]], now: list[list[Figure]]) -> list[Paired]:
    """Return the figures that both sides have, once, in every round."""
    values = [[_values(figures) for figures in side] for side in (base, now)]
    both = [one for one in now[0] if all(one.name in made for side in values for made in side)]
    pairs = [tuple(tuple(made[one.name] for made in side) for side in values) for one in both]
    return [Paired(benchmark, one.name, one.unit, *pair) for one, pair in zip(both, pairs, strict=True)]


def _values(figures: list[Figure]) -> dict[str, float]:
    """Return the values by name; names that occur twice, as in earlier versions, are left out."""
    counts = Counter(figure.name for figure in figures)
    return {figure.name: figure.value for figure in figures if figure.value is not None and counts[figure.name] == 1}


def _heads() -> str:
    return f"  {'':<{NAME}}  {'base':>9}  {'now':>9}  {'':<5}  {'ratio':>6}  spread of the paired ratios"


def pair_line(pair: Paired) -> str:
    """Return one line: both medians, their ratio, and the least and the greatest ratio of a pair."""
    base, now = statistics.median(pair.base), statistics.median(pair.now)
    ratio = f"{now / base:>6.2f}" if base else f"{'–':>6}"
    spread = f"{min(pair.ratios):.2f} to {max(pair.ratios):.2f}" if pair.ratios else ""
    row = f"  {pair.figure:<{NAME}}  {number(base):>9}  {number(now):>9}  {unit_text(pair.unit):<5}  {ratio}  {spread}"
    return row.rstrip()


@contextmanager
def unpacked(commit: str, root: Path) -> Iterator[Path]:
    """Unpack a commit into a temporary folder, with this tree's built page; delete the folder at the end.

    Raises:
        SystemExit: git does not know the commit.
    """
    done = subprocess.run(["git", "archive", commit], cwd=root, capture_output=True, check=False)
    if done.returncode:
        raise SystemExit(f"--base: got {commit!r}, expected a commit: {done.stderr.decode().strip()}")
    with tempfile.TemporaryDirectory(prefix="base") as folder:
        with tarfile.open(fileobj=io.BytesIO(done.stdout)) as archive:
            archive.extractall(folder, filter="data")
        if (root / PAGE).is_dir():
            shutil.copytree(root / PAGE, Path(folder) / PAGE, dirs_exist_ok=True)
        yield Path(folder)


def check(side: Side) -> None:
    """Check that a side's programs use its own sources, and let it compile its laws.

    Raises:
        SystemExit: they use other sources, or fail.
    """
    source = Path(_printed(side, _SOURCE))
    if side.root.resolve() not in source.resolve().parents:
        raise SystemExit(f"{side.title}: got aftdeck from {source}, expected it in {side.root}")
    _printed(side, _FIRST)


def _printed(side: Side, code: str) -> str:
    """Return what Python code prints with the sources of a side.

    Raises:
        SystemExit: the code fails.
    """
    command = [sys.executable, "-c", code]
    done = subprocess.run(
        command, cwd=side.root, env=_environment(side), check=False, capture_output=True, text=True, timeout=LIMIT_S
    )
    if done.returncode:
        raise SystemExit(f"{side.title}: {done.stderr.strip().rpartition(chr(10))[2]}")
    return done.stdout.strip()


def _environment(side: Side) -> dict[str, str]:
    return os.environ | {"PYTHONPATH": f"{side.root / 'src'}{os.pathsep}{side.root}"}


def _common(sides: tuple[Side, Side], names: list[str], *, same_page: bool) -> list[str]:
    """Return the names that both sides have; print the names that only one has or that are not compared."""
    base, now = (_printed(side, _NAMES).split() for side in sides)
    asked = names or [name for name in now if name not in NAMES or NAMES[name].by_default]
    for title, ours, theirs in (("now", now, base), (sides[0].title, base, now)):
        if alone := [name for name in ours if name not in theirs and (name in asked or not names)]:
            print(f"only {title} has: {', '.join(alone)}")
    left = [name for name in asked if name in WITH_PAGE and not same_page]
    if left:
        print(f"not compared, because web/ differs and only this tree's page is built: {', '.join(left)}")
    return [name for name in asked if name in base and name in now and name not in left]


def _same_page(commit: str, root: Path) -> bool:
    return not subprocess.run(["git", "diff", "--quiet", commit, "--", "web"], cwd=root, check=False).returncode


def _measured(side: Side, name: str) -> list[Figure] | Failed:
    """Run a benchmark of a side; return its figures that have a value."""
    with tempfile.TemporaryDirectory(prefix="bench") as folder:
        output, errors = Path(folder) / "output.json", Path(folder) / "errors.txt"
        environment = _environment(side) | {results.FOLDER_VARIABLE: folder}
        command = [sys.executable, "-m", "benchmarks", "--json", name]
        code = call(command, side.root, environment, output, LIMIT_S, errors)
        said, details = (file.read_text(encoding="utf-8", errors="replace") for file in (output, errors))
    if code is None:
        return Failed(name, side.title, f"TimeoutError: did not end within {LIMIT_S:g} s", details)
    try:
        document = json.loads(said)
    except ValueError:
        last = details.strip().rpartition("\n")[2]
        return Failed(name, side.title, f"ChildProcessError: ended with exit code {code}: {last}", details)
    if error := document.get("failed", {}).get(name):
        return Failed(name, side.title, error, details)
    rows = [row for row in document["figures"] if row["value"] is not None and math.isfinite(row["value"])]
    return [Figure(row["name"], row["value"], row["unit"]) for row in rows]
