"""The command that runs the benchmarks: its table, targets, failures and file; and a tiny run of every benchmark."""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

import pytest

from benchmarks import __main__ as command
from benchmarks.compare import Failed, Paired, Side, check, compare, pair_line, paired
from benchmarks.document import PAGE, QUOTATION, QUOTING, page, quoted
from benchmarks.measure import Figure, absent, against
from benchmarks.names import NAMES, Benchmark
from benchmarks.results import Head, Machine, Outcome, read
from benchmarks.runner import run_one
from benchmarks.table import limit, line, number
from tests.benchmark_samples import RESULTS

ROOT = Path(__file__).resolve().parent.parent
SAMPLES = "tests.benchmark_samples"
HEAD = Head(Machine("a processor", 2, "a system", "3.11"), "2026-01-01 00:00 UTC", "abc", "FULL", 0.5)


def sample(function: str, limit_s: float = 60.0) -> Benchmark:
    return Benchmark("Tests", SAMPLES, function, limit_s=limit_s)


# Table


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0, "0"),
        (5.0, "5"),
        (5655.0, "5,655"),
        (0.00012345, "0.000123"),
        (0.9996, "1.00"),
        (3.28513, "3.29"),
        (28.53, "28.5"),
        (99.96, "100"),
        (-5.4321, "-5.43"),
        (1204.4, "1,204"),
    ],
)
def test_number_is_rounded_as_a_person_would(value: float, text: str) -> None:
    assert number(value) == text


@pytest.mark.parametrize(("value", "text"), [(30.0, "30"), (0.3, "0.3"), (1.25, "1.25"), (1000.0, "1,000"), (0.0, "0")])
def test_target_has_no_zeros_at_its_end(value: float, text: str) -> None:
    assert limit(value) == text


def test_columns_of_the_table_are_aligned() -> None:
    figures = [Figure("a", 3.28513, "s", 1.5, "note"), Figure("a longer name", 1204.4, "ms", 2000.0, "note")]
    lines = [line(figure) for figure in figures]
    assert "3.29 s " in lines[0] and " MISSED ≤ 1.5 " in lines[0] and " ≤ 2,000 " in lines[1]
    assert len({text.index("note") for text in lines}) == 1


def test_long_name_does_not_touch_its_value() -> None:
    assert "n    123,456 " in line(Figure("n" * 80, 123456.0, "us"))


def test_missed_target_is_not_marked_in_a_tiny_run() -> None:
    assert "MISSED" not in line(Figure("a", 2.0, "s", 1.0), judged=False)


# Targets


def test_target_is_a_share_of_a_peer() -> None:
    peer = Figure("NumPy", 50.0, "us")
    met, missed = (against(peer, 0.2, "ours", value, "us") for value in (9.0, 11.0))
    assert (met.target, met.kept, missed.kept) == (10.0, True, False)
    assert "0.18 of “NumPy”, at most 0.2" in line(met)


def test_figure_has_no_target_if_its_peer_is_absent() -> None:
    figure = against(absent("NumPy", "us", "install it"), 0.2, "ours", 9.0, "us", "note")
    assert (figure.target, figure.ratio, figure.kept, figure.note) == (None, None, True, "note")


def test_peer_with_another_unit_is_rejected() -> None:
    with pytest.raises(ValueError, match="'ours' in ms cannot be compared with 'NumPy' in us"):
        against(Figure("NumPy", 1.0, "us"), 0.2, "ours", 9.0, "ms")


@pytest.mark.parametrize("value", [float("nan"), float("inf")])
def test_figure_that_is_not_finite_is_rejected(value: float) -> None:
    with pytest.raises(ValueError, match="expected a finite number"):
        Figure("a", value, "s")


# Runs


def run_command(monkeypatch: pytest.MonkeyPatch, names: dict[str, Benchmark], *arguments: str) -> int:
    monkeypatch.setattr(command, "NAMES", names)
    monkeypatch.setattr(sys, "argv", ["benchmarks", *arguments])
    return command.main()


def test_failed_benchmark_costs_its_line_and_the_exit_code(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    file = tmp_path / "folder" / "results.jsonl"
    monkeypatch.setenv(RESULTS, str(file))
    names = {"bad": sample("fails"), "good": sample("counts")}
    code = run_command(monkeypatch, names, "--tiny", "--out", str(file))
    output = capsys.readouterr().out
    assert code == 1
    (failure,) = (text for text in output.splitlines() if "FAILED" in text)
    assert failure.endswith("LookupError: nothing found")
    assert "Traceback" not in output
    head, (bad, good) = read(file)
    assert (head.size, head.machine.cores > 0, good.benchmark, good.error) == ("TINY", True, "good", "")
    assert "Traceback" in bad.details and bad.error == "LookupError: nothing found"
    assert good.figures[0].value == 2.0, "the file has its first line and the first outcome when the next one runs"


@pytest.mark.parametrize(("arguments", "code"), [((), 1), (("--tiny",), 0)])
def test_missed_target_counts_in_a_full_run_only(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
    arguments: tuple[str, ...],
    code: int,
) -> None:
    out = ("--out", str(tmp_path / "results.jsonl"))
    assert run_command(monkeypatch, {"good": sample("works")}, *arguments, *out) == code
    assert ("1 missed" in capsys.readouterr().out) == bool(code)


def test_json_has_the_figures_and_the_failures(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    names = {"bad": sample("fails"), "good": sample("works")}
    assert run_command(monkeypatch, names, "--json", "--out", str(tmp_path / "results.jsonl")) == 1
    document = json.loads(capsys.readouterr().out)
    assert [(figure["name"], figure["value"], figure["kept"]) for figure in document["figures"]] == [
        ("length", 2, False)
    ]
    assert document["failed"] == {"bad": "LookupError: nothing found"}


@pytest.mark.parametrize(
    ("function", "error"),
    [
        ("crashes", "ended with exit code 3"),
        ("hangs", "did not end within 2 s"),
        ("repeats", "two figures of the same name"),
    ],
)
def test_outcome_of_a_broken_benchmark_says_what_happened(function: str, error: str) -> None:
    outcome = run_one("bad", sample(function, 2.0 if function == "hangs" else 60.0), "FULL")
    assert error in outcome.error
    assert not outcome.figures


def test_every_module_that_measures_has_a_name() -> None:
    measuring = {
        f"benchmarks.{path.stem}"
        for path in (ROOT / "benchmarks").glob("*.py")
        if "\nFULL" in path.read_text(encoding="utf-8")
    }
    assert {benchmark.module for benchmark in NAMES.values()} == measuring


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.browser) if name == "page" else name for name in NAMES]
)
def test_benchmark_works_on_a_tiny_load(name: str) -> None:
    outcome = run_one(name, NAMES[name], "TINY")
    assert not outcome.error, outcome.details
    assert outcome.figures or outcome.lines


# Page of figures


def test_page_of_figures_has_tables_by_subject() -> None:
    figures = Figure("speed", 3.28513, "us", 2.0, "note"), absent("peer", "ms", "install it")
    failed = Outcome("help", 1.0, error="OSError: gone")
    rest = [Outcome(name, 1.0) for name, one in NAMES.items() if one.by_default and name not in ("rate-law", "help")]
    text = page(HEAD, [failed, *rest, Outcome("rate-law", 1.0, "Measure.", figures)])
    assert "| speed | 3.29 µs | **Missed:** ≤ 2 | note |" in text
    assert "| peer | – | | not measured: install it |" in text
    assert (
        text.index("## Compiled laws") < text.index("| speed") < text.index("## Station") and "## Physics" not in text
    )
    assert "Failed: OSError: gone" in text
    assert all(part in text for part in ("a processor, 2 cores", "2026-01-01", "| commit | abc |"))


def test_tiny_results_make_no_page() -> None:
    with pytest.raises(ValueError, match="expected FULL"):
        page(Head(HEAD.machine, HEAD.date, HEAD.commit, "TINY", None), [])


def test_page_of_figures_needs_every_benchmark_that_runs_by_default() -> None:
    with pytest.raises(ValueError, match="has no rate-law, steering"):
        page(HEAD, [Outcome("help", 1.0)])


def test_quotation_gets_the_value_of_its_figure() -> None:
    outcomes = [Outcome("start", 1.0, figures=(Figure("first frame", 3.28513, "s"),))]
    text = 'after [9 s](docs/figures.md#start "first frame") or [so](figures.md#start)'
    assert quoted(text, outcomes) == text.replace("9 s", "3.29 s")


def test_quotation_of_an_unknown_figure_is_rejected() -> None:
    with pytest.raises(ValueError, match="no figure 'last' of the benchmark 'start'; available: first"):
        quoted('[1 s](figures.md#start "last")', [Outcome("start", 1.0, figures=(Figure("first", 1.0, "s"),))])


def test_quotations_agree_with_the_page_of_figures() -> None:
    sections = PAGE.read_text(encoding="utf-8").split("\n### ")[1:]
    quotations = [found for file in QUOTING for found in QUOTATION.finditer(file.read_text(encoding="utf-8"))]
    wrong = [
        found[0]
        for found in quotations
        if not any(
            section.startswith(f"`{found['name']}`")
            and f"\n| {found['figure']} | {' '.join(found['value'].split())} |" in section
            for section in sections
        )
    ]
    assert quotations and not wrong


def test_page_of_figures_has_every_benchmark_that_runs_by_default() -> None:
    text = PAGE.read_text(encoding="utf-8")
    assert [name for name, one in NAMES.items() if one.by_default and f"### `{name}`\n" not in text] == []


# Comparison with a commit


FAKE = """
import json, sys
NAMES = {names}
if __name__ == "__main__":
    figures = [dict(name="time", value={value}, unit="s", target=None, note="", kept=True)]
    print(json.dumps(dict(machine=dict(), figures=figures)))
"""


def write_tree(root: Path, names: dict[str, str], value: Any) -> None:
    for folder in ("benchmarks", "src/aftdeck"):
        (root / folder).mkdir(parents=True, exist_ok=True)
        (root / folder / "__init__.py").touch()
    (root / "benchmarks" / "__main__.py").write_text(FAKE.format(names=names, value=value), encoding="utf-8")
    simulation = "class Simulation:\n    def __init__(self, name): pass\n    def step(self): pass\n"
    (root / "src" / "aftdeck" / "__init__.py").write_text(simulation, encoding="utf-8")


def commit(root: Path) -> None:
    """Commit all files."""
    identity = ["-c", "user.name=Test", "-c", "user.email=test@example.org"]
    for arguments in (["add", "."], ["commit", "--quiet", "-m", "files"]):
        subprocess.run(["git", *identity, *arguments], cwd=root, check=True)


@pytest.fixture
def repository(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Repository whose commit takes 2 s and whose changed files take 3 s; temporary folders are made in `temp`."""
    root, temp = tmp_path / "repository", tmp_path / "temp"
    temp.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(temp))
    write_tree(root, {"both": "", "old": ""}, 2.0)
    subprocess.run(["git", "init", "--quiet"], cwd=root, check=True)
    commit(root)
    write_tree(root, {"both": "", "new": ""}, 3.0)
    return root


def test_comparison_pairs_the_figures_of_both_sides(
    repository: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "results.jsonl"
    assert compare("HEAD", [], file, rounds=2, root=repository) == 0
    output = capsys.readouterr().out
    assert "only now has: new" in output and "only HEAD has: old" in output
    row = output.split("spread of the paired ratios\n")[1].splitlines()[0]
    assert row.split() == ["time", "2", "3", "s", "1.50", "1.50", "to", "1.50"]
    stored = json.loads(file.read_text(encoding="utf-8").splitlines()[1])
    assert (stored["base"], stored["now"]) == ([2.0, 2.0], [3.0, 3.0])
    assert not list((tmp_path / "temp").iterdir())


def test_comparison_with_a_broken_commit_leaves_no_folder(repository: Path, tmp_path: Path) -> None:
    source = repository / "src" / "aftdeck" / "__init__.py"
    source.write_text("raise ImportError('broken')", encoding="utf-8")
    commit(repository)
    with pytest.raises(SystemExit, match="HEAD: ImportError: broken"):
        compare("HEAD", ["both"], tmp_path / "results.jsonl", rounds=1, root=repository)
    assert not list((tmp_path / "temp").iterdir())


def test_unknown_commit_is_rejected(repository: Path, tmp_path: Path) -> None:
    with pytest.raises(SystemExit, match="got 'no-such-commit', expected a commit"):
        compare("no-such-commit", [], tmp_path / "results.jsonl", rounds=1, root=repository)


def test_side_that_imports_another_source_is_rejected(tmp_path: Path) -> None:
    with pytest.raises(SystemExit, match="expected it in"):
        check(Side("base", tmp_path))


def test_spread_is_that_of_the_paired_ratios() -> None:
    pair = Paired("b", "time", "s", (1.0, 2.0, 4.0), (1.1, 2.0, 8.0))
    assert pair_line(pair).split()[1:] == ["2", "2", "s", "1.00", "1.00", "to", "2.00"]


def test_figures_without_a_partner_are_not_paired() -> None:
    one, two = Figure("one", 1.0, "s"), Figure("two", 2.0, "s")
    assert [pair.figure for pair in paired("b", [[one, two]], [[one]])] == ["one"]
    assert paired("b", [[two, two]], [[two]]) == [], "a name that occurs twice is no name"


def test_failure_of_a_side_is_stored(repository: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    write_tree(repository, {"both": ""}, "1 / 0")
    file = tmp_path / "results.jsonl"
    assert compare("HEAD", ["both"], file, rounds=2, root=repository) == 1
    stored = Failed(**json.loads(file.read_text(encoding="utf-8").splitlines()[1]))
    assert (stored.side, "ZeroDivisionError" in stored.error) == ("now", True)
    assert "FAILED on now" in capsys.readouterr().out
