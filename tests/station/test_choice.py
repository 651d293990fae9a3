"""Another scenario chosen from the page: every page comes along, and nothing recorded is lost."""

from __future__ import annotations

import re
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from aftdeck.errors import ScenarioError
from aftdeck.recording.reader import Recording
from aftdeck.recording.replay import verify
from aftdeck.scenario.load import HERE, about, built_in, load_scenario, parse_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.station.messages import from_page, to_page
from aftdeck.station.messages.frame import Frame
from aftdeck.station.messages.welcome import Welcome
from aftdeck.station.server.scenario_list import ScenarioList
from aftdeck.station.session.session import Session
from tests.station.pages import OBSERVES, WAIT_S, Page, Station, scenario, served
from tests.station.test_recording import ended, files

OTHER = "singular"
"""Of the same arm, so that no other law is compiled."""


@pytest.fixture
def station() -> Iterator[Station]:
    with served(Session(scenario())) as station:
        yield station


def number(told: to_page.Scenarios, name: str) -> int:
    return [info.name for info in told.scenarios].index(name)


def choose(page: Page, name: str) -> None:
    """Ask for a scenario, once the page flies."""
    told = page.wait_for(to_page.Scenarios)
    page.wait_for(to_page.Role, lambda role: role.flying)
    page.say(from_page.FlyScenario(page.next_seq(), number(told, name)))


def own_file() -> Scenario:
    """A user's file that has a built-in scenario's name."""
    text = about("first-flight").file.replace('"First flight"', '"My own flight"')
    return parse_scenario(text, "first-flight", "first-flight.toml", HERE)


def test_every_built_in_scenario_can_be_chosen_by_what_its_file_says() -> None:
    choice = ScenarioList(scenario())
    assert {info.name for info in choice.scenarios} == set(built_in())
    assert choice.scenarios[choice.flown].name == "first-flight"
    assert not any(info.given for info in choice.scenarios)
    for name in ("first-flight", OTHER):
        info = choice.scenarios[number(choice.message(), name)]
        assert (info.title, info.text) == (load_scenario(name).title, load_scenario(name).description)


def test_a_file_of_the_users_own_stays_in_the_list_beside_its_namesake() -> None:
    choice = ScenarioList(own_file())
    assert [info.title for info in choice.scenarios if info.name == "first-flight"] == ["My own flight", "First flight"]
    assert choice.flown == 0 and choice.scenarios[0].given
    assert choice.load(0).title == "My own flight"
    assert len(choice.scenarios) == len(built_in()) + 1


def test_every_page_comes_along_and_the_same_one_flies(station: Station) -> None:
    with station.page() as flier, station.page() as watcher:
        choose(flier, OTHER)
        for page in (flier, watcher):
            assert page.wait_for(to_page.Scenarios, lambda told: told.coming is not None).flown != 0
            assert page.wait_for(Welcome).scenario == OTHER
            told = page.wait_for(to_page.Scenarios, lambda told: told.coming is None)
            assert told.scenarios[told.flown].name == OTHER
        frame = flier.flown(flier.push((1.0, 0.0, 0.0)))
        assert frame.translation == (1.0, 0.0, 0.0)
        assert watcher.wait_for(Frame, lambda frame: frame.tick > 1).angles != tuple(scenario().initial_angles)
        with station.stranger() as late:
            assert late.greet().scenario == OTHER
    assert station.get("/health") == (200, "flying\n")


def test_the_arm_comes_to_rest_while_another_is_made_ready(station: Station, monkeypatch: pytest.MonkeyPatch) -> None:
    made = threading.Event()
    another = Session.another

    def slow(self: Session, chosen: Scenario) -> Session:
        assert made.wait(WAIT_S)
        return another(self, chosen)

    monkeypatch.setattr(Session, "another", slow)
    with station.page() as page:
        page.flown(page.push((1.0, 0.0, 0.0)))
        page.wait_for(Frame, lambda frame: frame.translation[0] == 1.0)
    with station.page() as page:
        choose(page, OTHER)
        page.wait_for(Frame, lambda frame: frame.translation == (0.0, 0.0, 0.0) and not any(frame.rates_commanded))
        page.say(from_page.FlyScenario(page.next_seq(), 0))
        assert "is being made ready: wait until it flies" in page.refusal()
        page.push((1.0, 0.0, 0.0))
        page.say(from_page.EnterMode(page.next_seq(), "END EFF"))
        assert "the arm rests meanwhile" in page.refusal()
        assert page.wait_for(Frame).translation == (0.0, 0.0, 0.0)
        page.say(from_page.SetBrakes(page.next_seq(), on=True))
        page.wait_for(Frame, lambda frame: frame.brakes)
        made.set()
        assert page.wait_for(Welcome).scenario == OTHER


def test_each_scenario_has_a_recording_of_its_own_and_the_first_is_kept(tmp_path: Path) -> None:
    with served(Session(scenario(), record=tmp_path)) as station, station.page() as page:
        page.wait_for(Frame, lambda frame: frame.tick > 20)
        with station.page():
            page.flown(page.push((1.0, 0.0, 0.0)))
        page.say(from_page.FlyScenario(page.next_seq(), number(ScenarioList(scenario()).message(), OTHER)))
        page.wait_for(Welcome)
        page.wait_for(Frame, lambda frame: frame.tick > 20 and frame.display.recording_s is not None)
    first, second = files(tmp_path)
    assert [Recording(path).opening.scenario for path in (first, second)] == ["first-flight", OTHER]
    assert [ended(path) for path in (first, second)] == ["stopped", "stopped"]
    assert verify(first).equal and verify(second).equal


def test_what_cannot_be_flown_is_refused_and_the_flight_steps(
    station: Station, monkeypatch: pytest.MonkeyPatch
) -> None:
    with station.page() as page, station.page() as watcher:
        watcher.say(from_page.FlyScenario(watcher.next_seq(), 0))
        assert watcher.refusal() == OBSERVES
        told = page.wait_for(to_page.Scenarios)
        page.say(from_page.FlyScenario(page.next_seq(), len(told.scenarios)))
        assert re.search(rf"0 to {len(told.scenarios) - 1}\b.* {len(told.scenarios)}$", page.refusal())
        page.say(from_page.FlyScenario(page.next_seq(), told.flown))
        assert re.match("'First flight' .*Restart", page.refusal())

        def broken(self: ScenarioList, chosen: int) -> Scenario:
            raise ScenarioError(["singular.toml: is gone"])

        monkeypatch.setattr(ScenarioList, "load", broken)
        page.say(from_page.FlyScenario(page.next_seq(), number(told, OTHER)))
        assert re.match("'Three singularities' .*singular.toml", page.refusal())
        after = page.wait_for(to_page.Scenarios, lambda told: told.coming is None)
        assert after.flown == told.flown
    station.is_unhurt()


def test_the_server_ends_at_once_though_a_scenario_is_being_made_ready(monkeypatch: pytest.MonkeyPatch) -> None:
    never = threading.Event()
    monkeypatch.setattr(Session, "another", lambda *_: never.wait(WAIT_S))
    with served(Session(scenario())) as station, station.page() as page:
        choose(page, OTHER)
        page.wait_for(to_page.Scenarios, lambda told: told.coming is not None)
        begun = time.monotonic()
    assert time.monotonic() - begun < WAIT_S / 4
    never.set()
