"""Last minutes of a run, for pages that draw strips."""

from __future__ import annotations

import pytest

from aftdeck.report.lamps import Lamp
from aftdeck.report.strips import blank, curve_values
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.station.core import recent
from aftdeck.station.core.recent import RecentRun
from aftdeck.station.messages import from_page, kinds, to_page
from aftdeck.station.session.session import Session
from tests.loaded import scenario
from tests.station.pages import served
from tests.station.stepped import step_of

LIT = Lamp("RATE LIM", "caution", "cause")
PERIOD = 0.02
EVERY = round(recent.SPACING_S / PERIOD)


class KeptRun:
    """Run whose last minutes are kept."""

    def __init__(self) -> None:
        self.simulation = Simulation(scenario())
        self.recent = RecentRun(scenario())

    def fly(self, steps: int, *lamps: Lamp, monitors: tuple[tuple[str, ...], ...] = (("A",), ("B",))) -> None:
        for _ in range(steps):
            frame = self.simulation.step(Inputs(translation=(0.5, 0.0, 0.0)))
            self.recent.see(step_of(frame, lamps, monitors))


def test_page_receives_all_data_first_and_then_only_new_data() -> None:
    run = KeptRun()
    run.fly(3 * EVERY)
    found = run.recent.news(None)
    assert found is not None
    first, mark = found
    assert [strip.name for strip in first.strips] == [strip.name for strip in blank(scenario())]
    assert [sample.time_s for sample in first.samples] == pytest.approx([(1 + i * EVERY) * PERIOD for i in range(3)])
    assert run.recent.news(mark) is None
    run.fly(EVERY)
    found = run.recent.news(mark)
    assert found is not None
    assert (found[0].strips, len(found[0].samples), found[0].lanes) == ((), 1, ())


def test_sample_has_the_value_of_every_curve() -> None:
    run = KeptRun()
    run.fly(50 * EVERY + 1)
    found = run.recent.news(None)
    assert found is not None
    assert run.simulation.frame is not None
    exact = curve_values(scenario())(run.simulation.frame, None)
    assert found[0].samples[-1].values == pytest.approx(exact, abs=0.51 * 10**-recent.DECIMALS)


def test_lanes_are_sent_again_when_an_interval_begins() -> None:
    run = KeptRun()
    run.fly(EVERY)
    found = run.recent.news(None)
    assert found is not None
    run.fly(EVERY, LIT, monitors=(("A",), ("C", "D")))
    later = run.recent.news(found[1])
    assert later is not None
    lanes = {lane.name: [stretch.label for stretch in lane.stretches] for lane in later[0].lanes}
    assert lanes["MON 2"] == ["B", "C | D"]
    assert lanes["Alarms"] == ["", "RATE LIM"]


def test_data_older_than_the_last_minutes_is_deleted(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(recent, "KEPT_S", 2.0)
    run = KeptRun()
    for i in range(40):
        run.fly(EVERY, monitors=(("A",), (f"{i}",)))
    found = run.recent.news(None)
    assert found is not None
    news, _ = found
    assert len(news.samples) == 20
    assert news.samples[-1].time_s - news.samples[0].time_s <= 2.0
    second = next(lane for lane in news.lanes if lane.name == "MON 2")
    assert len(second.stretches) <= 22
    assert second.stretches[0].end_s >= news.samples[0].time_s - 2 * recent.SPACING_S


def test_only_pages_with_strips_receive_them_and_a_restart_clears_them() -> None:
    with served(Session(scenario())) as station, station.unannounced() as strips, station.page() as page:
        strips.send(from_page.Hello(kinds.PROTOCOL, shows=True, strips=True))
        assert strips.wait_for(to_page.Recent).strips
        assert not strips.wait_for(to_page.Recent).strips
        page.send(from_page.Restart(page.next_seq()))
        first = strips.wait_for(to_page.Recent, lambda recent: bool(recent.strips))
        assert first.samples[0].time_s == pytest.approx(PERIOD)
        assert not any(isinstance(page.receive(), to_page.Recent) for _ in range(30))
