"""``python -m benchmarks [NAME...]``: run benchmarks and print their figures as they come.

Each benchmark has a process of its own. Each result is also appended to a file. The exit code is 1 if a benchmark fails
or misses a target.
"""

from __future__ import annotations

import argparse
import json
import signal
import sys
from pathlib import Path

import msgspec

from benchmarks import results
from benchmarks.compare import compare
from benchmarks.names import NAMES
from benchmarks.results import Head, Outcome
from benchmarks.runner import run_all
from benchmarks.table import line


def main() -> int:
    """Run the benchmarks that the arguments name."""
    given = _arguments()
    file = given.out or results.new_file()
    if given.base:
        return compare(given.base, given.names, file, given.rounds)
    size = "TINY" if given.tiny else "FULL"
    names = given.names or [name for name, one in NAMES.items() if given.tiny or one.by_default]
    head = results.here(size)
    results.begin(file, head)
    if not given.json:
        print(_title(head), flush=True)
    outcomes = []
    for outcome in run_all([(name, NAMES[name]) for name in names], size):
        results.append(file, outcome)
        outcomes.append(outcome)
        if not given.json:
            print(report(outcome, judged=not given.tiny), flush=True)
    missed = [figure for outcome in outcomes for figure in outcome.figures if not figure.kept and not given.tiny]
    failed = [outcome.benchmark for outcome in outcomes if outcome.error]
    if given.json:
        print(json.dumps(_as_json(head, outcomes), indent=2))
    else:
        print(f"\n{len(failed)} failed{_listed(failed)}, {len(missed)} missed their targets. Results: {file}")
    return 1 if failed or missed else 0


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=__doc__)
    asked = ", ".join(name for name, one in NAMES.items() if not one.by_default)
    names = f"one of {', '.join(NAMES)}; default: all but {asked}"
    parser.add_argument("names", nargs="*", metavar="NAME", help=names)
    parser.add_argument("--json", action="store_true", help="print JSON at the end, for scripts")
    parser.add_argument("--tiny", action="store_true", help="only show that all work, in a minute; judge no target")
    parser.add_argument("--out", type=Path, metavar="FILE", help="file of results; default: a new one in build/bench/")
    parser.add_argument("--base", metavar="COMMIT", help="run the same benchmarks of a commit, in turn, and compare")
    parser.add_argument("--rounds", type=int, default=3, help="number of runs of each side with --base (default 3)")
    given = parser.parse_args()
    if unknown := [name for name in given.names if name not in NAMES]:
        parser.error(f"unknown benchmark {unknown[0]!r}; available: {', '.join(NAMES)}")
    if given.base and (given.tiny or given.json):
        parser.error("--base goes with neither --tiny nor --json")
    if given.rounds < 1:
        parser.error(f"--rounds: got {given.rounds}, expected at least 1")
    return given


def _title(head: Head) -> str:
    machine = head.machine
    busy = "" if head.busy is None else f", load average {head.busy:g}"
    return (
        f"{machine.processor}, {machine.cores} cores, {machine.system}, Python {machine.python}{busy}\n"
        f"commit {head.commit or 'unknown'}, {head.date}"
    )


def report(outcome: Outcome, *, judged: bool) -> str:
    """Return the lines that are printed about a benchmark.

    Args:
        outcome: what it gave.
        judged: True if missed targets are marked.
    """
    if outcome.error:
        return f"\n{outcome.benchmark}  FAILED after {outcome.seconds:.1f} s: {outcome.error}"
    lines = [line(figure, judged=judged) for figure in outcome.figures]
    return "\n".join([f"\n{outcome.benchmark}  ({outcome.seconds:.1f} s)", *lines, *outcome.lines])


def _listed(names: list[str]) -> str:
    return f" ({', '.join(names)})" if names else ""


def _as_json(head: Head, outcomes: list[Outcome]) -> dict[str, object]:
    """Return the document of ``--json``. Earlier versions read `machine` and `figures` of it."""
    figures = [figure for outcome in outcomes for figure in outcome.figures]
    return {
        **msgspec.to_builtins(head),
        "figures": [{**msgspec.to_builtins(figure), "kept": figure.kept} for figure in figures],
        "failed": {outcome.benchmark: outcome.error for outcome in outcomes if outcome.error},
    }


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))  # ends the benchmark too, and deletes temporary folders
    sys.exit(main())
