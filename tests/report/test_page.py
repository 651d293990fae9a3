"""Report page of recordings: what it contains, and that it needs nothing else."""

from __future__ import annotations

import csv
import math
import re
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest
import scipy.stats
from pyarrow import parquet

import aftdeck
from aftdeck.operators.pilot import pilot
from aftdeck.operators.spec import OperatorSpec
from aftdeck.recording.reader import Recording
from aftdeck.recording.run import record
from aftdeck.recording.trial import Trial
from aftdeck.report.catalogue import METRICS, named
from aftdeck.report.intervals import mean_interval, wilson
from aftdeck.report.metrics.path import PATH
from aftdeck.report.of_recording import metrics_of
from aftdeck.report.page.gather import Gathered, gathered
from aftdeck.report.page.pictures import best_cameras
from aftdeck.report.page.runs import page
from aftdeck.report.table import RUN_COLUMNS
from aftdeck.scenario.load import load_scenario
from aftdeck.scene.cameras import SceneCameras
from aftdeck.visual.scene import VisualScene
from tests.commands import Run

WICKED = "<script>alert('x')</script> & co"


@pytest.fixture(scope="module")
def tutorial(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Recording of a capture."""
    path = tmp_path_factory.mktemp("runs") / "tutorial.mcap"
    scenario = load_scenario("tutorial")
    record(scenario, path, inputs=pilot(scenario, OperatorSpec("perfect"), 1), trial=Trial("P07", WICKED))
    return path


@pytest.fixture(scope="module")
def run_data(tutorial: Path) -> Gathered:
    return gathered(Recording(tutorial))


@pytest.fixture(scope="module")
def page_of_a_run(run_data: Gathered) -> str:
    return page([run_data])


class Reader(HTMLParser):
    """Reader of the tags of a page."""

    def __init__(self) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.addresses: list[str] = []
        self.texts: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        self.addresses += [value or "" for name, value in attrs if name in ("src", "href", "xlink:href", "action")]

    def handle_data(self, data: str) -> None:
        self.texts.append(data)


def read(text: str) -> Reader:
    reader = Reader()
    reader.feed(text)
    return reader


def test_the_metrics_are_those_of_the_report_command(tutorial: Path, run_data: Gathered) -> None:
    assert run_data.metrics == metrics_of(Recording(tutorial))


def test_the_path_is_as_long_as_the_metric(run_data: Gathered) -> None:
    length = float(np.linalg.norm(np.diff(run_data.tip, axis=0), axis=1).sum())
    tip_path = run_data.metrics[PATH].number
    assert length == pytest.approx(tip_path, rel=0.02)


def test_key_moments_are_in_order_and_once(run_data: Gathered) -> None:
    titles = [moment.title for moment in run_data.moments]
    ticks = [moment.frame.tick for moment in run_data.moments]
    assert titles[0] == "start" and titles[-1] == "end" and "acquired" in titles and "smallest clearance" in titles
    assert ticks == sorted(set(ticks))
    least = next(moment for moment in run_data.moments if moment.title == "smallest clearance").frame.work.nearest
    clearance = run_data.metrics[named("min_clearance_m")].number
    assert least is not None and least.clearance == pytest.approx(clearance)


def test_a_page_requests_nothing_and_runs_no_code(page_of_a_run: str, run_data: Gathered) -> None:
    for text in (page_of_a_run, page([run_data, run_data])):
        found = read(text)
        assert all(address.startswith(("data:", "#")) for address in found.addresses)
        assert "script" not in found.tags and "link" not in found.tags
        assert not re.search(r"url\((?!#)", text)
        assert any(WICKED in text for text in found.texts)


def test_only_the_style_and_charts_are_not_escaped() -> None:
    folder = Path(aftdeck.__file__).parent
    templates = [path for path in folder.rglob("*.html") if "static" not in path.parts]
    shown = [name for path in templates for name in re.findall(r"([\w.]+)\s*\|\s*safe", path.read_text("utf-8"))]
    assert sorted(shown) == ["chart.svg", "style"]
    assert not [path for path in templates if "autoescape" in path.read_text("utf-8")]


def test_a_page_has_every_metric_and_every_event(page_of_a_run: str, run_data: Gathered) -> None:
    texts = read(page_of_a_run).texts
    assert {metric.title for metric in run_data.metrics} <= set(texts)
    assert {event.text for event in run_data.events} <= set(texts)
    assert {step.title for step in run_data.progress.steps} <= set(texts)


def test_equal_runs_give_equal_pages(page_of_a_run: str, run_data: Gathered) -> None:
    assert page([run_data]) == page_of_a_run


def test_a_camera_behind_a_body_comes_after_those_that_see_the_tip(run_data: Gathered) -> None:
    moment = run_data.moments[-1]  # the end effector holds the payload over the bay
    ordered = best_cameras(VisualScene(run_data.scenario), SceneCameras(run_data.scenario), moment)
    assert "KEEL" not in ordered[:2]  # the payload hides the tip from the camera below it


def test_intervals_are_those_of_the_distributions() -> None:
    values = [3.1, 2.7, 4.4, 3.9, 3.3]
    mean, half = np.mean(values), scipy.stats.sem(values) * scipy.stats.t.ppf(0.975, 4)
    assert mean_interval(values) == pytest.approx((mean, mean - half, mean + half), rel=1e-3)
    for done, count in ((0, 7), (3, 7), (7, 7), (40, 100)):
        expected = scipy.stats.binomtest(done, count).proportion_ci(method="wilson")
        assert wilson(done, count)[1:] == pytest.approx((expected.low, expected.high))
    assert math.isnan(wilson(0, 0).value)


def test_both_tables_have_the_same_values(run: Run, tutorial: Path, tmp_path: Path) -> None:
    assert run("report", str(tutorial), "--table", str(tmp_path / "runs.csv"))[0] == 0
    assert run("report", str(tutorial), "--table", str(tmp_path / "runs.parquet"))[0] == 0
    with (tmp_path / "runs.csv").open(newline="", encoding="utf-8") as file:
        (text,) = csv.DictReader(file)
    (row,) = parquet.read_table(tmp_path / "runs.parquet").to_pylist()
    assert list(row) == list(text) == [*RUN_COLUMNS, *(metric.column for metric in METRICS)]
    for name, value in row.items():
        if isinstance(value, float):
            assert float(text[name]) == value
        else:
            assert text[name] == ("" if value is None else str(value))


def test_the_command_writes_a_page_once(run: Run, tutorial: Path, tmp_path: Path) -> None:
    out = tmp_path / "report.html"
    assert run("report", str(tutorial), "-o", str(out))[0] == 0
    written = out.read_text(encoding="utf-8")
    code, _, error = run("report", str(tutorial), "-o", str(out))
    assert code == 2 and str(out) in error
    assert out.read_text(encoding="utf-8") == written
    assert run("report", str(tutorial), "-o", str(tmp_path / "report.pdf"))[0] == 2
