"""Change of the scenario by the page in control: every page gets the new session, and recordings are kept."""

from __future__ import annotations

import re
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import get_args

import pytest

from aftdeck.errors import CommandError, ScenarioError
from aftdeck.recording.reader import Recording
from aftdeck.recording.replay import verify
from aftdeck.scenario.build import BUILT_IN
from aftdeck.scenario.load import about, built_in, load_scenario, parse_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.schema import Plant, ScenarioGroup
from aftdeck.station.core.desk import NOT_IN_CONTROL
from aftdeck.station.messages import from_page, to_page
from aftdeck.station.messages.frame import Frame
from aftdeck.station.messages.welcome import Welcome
from aftdeck.station.server.scenario_list import ScenarioList
from aftdeck.station.session.session import Session
from tests.loaded import scenario
from tests.station.pages import Page, Station, served
from tests.station.recordings import ended, files
from tests.waits import WAIT_S

OTHER = "singular"
"""Scenario with the same arm, so that no other laws are compiled."""


@pytest.fixture
def station() -> Iterator[Station]:
    with served(Session(scenario())) as station:
        yield station


def number(message: to_page.Scenarios, name: str) -> int:
    """Return the number of a scenario in the list."""
    return [info.name for info in message.scenarios].index(name)


def choose(page: Page, name: str) -> None:
    """Choose a scenario, once the page is in control."""
    scenarios = page.wait_for(to_page.Scenarios)
    page.wait_for(to_page.Role, lambda role: role.flying)
    page.send(from_page.FlyScenario(page.next_seq(), number(scenarios, name)))


def own_file() -> Scenario:
    """Return a user's scenario with the name of a built-in scenario."""
    text = about("first-flight").file.replace('"First flight"', '"My own flight"')
    return parse_scenario(text, "first-flight", "first-flight.toml", BUILT_IN)


def test_list_says_of_each_built_in_scenario_what_its_file_says() -> None:
    choice = ScenarioList(scenario())
    assert {info.name for info in choice.scenarios} == set(built_in())
    assert choice.scenarios[choice.flown].name == "first-flight"
    assert not any(info.given for info in choice.scenarios)
    for info in choice.scenarios:
        loaded = scenario(info.name)
        assert (info.title, info.text) == (loaded.title, loaded.description)
        assert (info.group, info.minutes) == (loaded.group, loaded.minutes)
        assert info.minutes is not None and info.scripted == bool(loaded.phases)


def test_each_group_has_scenarios_and_each_scenario_precedes_its_next() -> None:
    infos = ScenarioList(scenario()).scenarios
    assert {info.group for info in infos} == set(get_args(ScenarioGroup))
    names = [info.name for info in infos]
    following = [(name, about(name).next) for name in names]
    assert all(names.index(name) < names.index(after) for name, after in following if after is not None)


def test_scenarios_outside_every_order_are_listed_by_name() -> None:
    names = [info.name for info in ScenarioList(scenario()).scenarios]
    following = {name: about(name).next for name in names}
    alone = [name for name in names if following[name] is None and name not in following.values()]
    assert len(alone) > 1
    assert alone == sorted(alone)


def test_own_scenario_that_names_no_group_is_to_fly() -> None:
    text = about("singular").file.replace('group = "learn"\n', "").replace("minutes = 2\n", "")
    own = parse_scenario(text, "own", "own.toml", BUILT_IN)
    info = ScenarioList(own).scenarios[0]
    assert (info.given, info.group, info.minutes) == (True, "fly", None)


def test_own_file_is_listed_beside_the_built_in_scenario_of_its_name() -> None:
    choice = ScenarioList(own_file())
    assert [info.title for info in choice.scenarios if info.name == "first-flight"] == ["My own flight", "First flight"]
    assert choice.flown == 0 and choice.scenarios[0].given
    assert choice.load(0).title == "My own flight"
    assert len(choice.scenarios) == len(built_in()) + 1


def test_every_page_gets_the_new_scenario_and_the_operator_stays(station: Station) -> None:
    with station.page() as operator, station.page() as observer:
        choose(operator, OTHER)
        for page in (operator, observer):
            message = page.wait_for(to_page.Scenarios, lambda message: message.coming is not None)
            assert message.scenarios[message.flown].name == "first-flight"
            assert page.wait_for(Welcome).scenario == OTHER
            message = page.wait_for(to_page.Scenarios, lambda message: message.coming is None)
            assert message.scenarios[message.flown].name == OTHER
        frame = operator.flown(operator.push((1.0, 0.0, 0.0)))
        assert frame.translation == (1.0, 0.0, 0.0)
        assert observer.wait_for(Frame, lambda frame: frame.tick > 1).angles != tuple(scenario().initial_angles)
        with station.unannounced() as late:
            assert late.greet().scenario == OTHER
    assert station.get("/health") == (200, "flying\n")


def test_arm_stops_while_another_scenario_is_prepared(station: Station, monkeypatch: pytest.MonkeyPatch) -> None:
    made = threading.Event()
    another = Session.another

    def slow(self: Session, chosen: Scenario, *, shown: bool) -> Session:
        assert made.wait(WAIT_S)
        return another(self, chosen, shown=shown)

    monkeypatch.setattr(Session, "another", slow)
    with station.page() as page:
        page.flown(page.push((1.0, 0.0, 0.0)))
        page.wait_for(Frame, lambda frame: frame.translation[0] == 1.0)
    with station.page() as page:
        choose(page, OTHER)
        page.wait_for(Frame, lambda frame: frame.translation == (0.0, 0.0, 0.0) and not any(frame.rates_commanded))
        page.send(from_page.FlyScenario(page.next_seq(), 0))
        assert "'Three singularities'" in page.rejection()
        page.push((1.0, 0.0, 0.0))
        page.send(from_page.EnterMode(page.next_seq(), "END EFF"))
        assert page.wait_for(to_page.Refused).seq == page.seq
        assert page.wait_for(Frame).translation == (0.0, 0.0, 0.0)
        page.send(from_page.SetBrakes(page.next_seq(), on=True))
        page.wait_for(Frame, lambda frame: frame.brakes)
        made.set()
        assert page.wait_for(Welcome).scenario == OTHER


@pytest.mark.slow
def test_scenario_restarts_on_another_plant_and_its_recording_knows_it(tmp_path: Path) -> None:
    with served(Session(scenario(), record=tmp_path)) as station, station.page() as page:
        scenarios = page.wait_for(to_page.Scenarios)
        page.wait_for(to_page.Role, lambda role: role.flying)
        page.wait_for(Frame, lambda frame: frame.tick > 5)
        page.send(from_page.FlyScenario(page.next_seq(), scenarios.flown, "rigid"))
        assert page.wait_for(Welcome, lambda welcome: welcome.plant == "rigid").scenario == "first-flight"
        page.wait_for(Frame, lambda frame: frame.tick > 20 and frame.dynamics is not None)
        page.send(from_page.FlyScenario(page.next_seq(), scenarios.flown, "kinematic"))
        page.wait_for(Welcome, lambda welcome: welcome.plant == "kinematic")
        page.wait_for(Frame, lambda frame: frame.tick > 20 and frame.dynamics is None)
        page.send(from_page.FlyScenario(page.next_seq(), scenarios.flown, "kinematic"))
        assert re.match("'First flight' .*Restart", page.rejection())
    recorded = [Recording(path).opening for path in files(tmp_path)]
    assert [tuple(start.changes) for start in recorded] == [(), ("plant=rigid",), ("plant=kinematic",)]
    assert all(verify(path).equal for path in files(tmp_path))


def test_script_flies_a_chosen_scenario_until_a_stick_moves(station: Station) -> None:
    with station.page() as page:
        scenarios = page.wait_for(to_page.Scenarios)
        page.wait_for(to_page.Role, lambda role: role.flying)
        other = number(scenarios, OTHER)
        page.send(from_page.FlyScenario(page.next_seq(), other, demo=True))
        assert page.wait_for(Welcome, lambda welcome: welcome.scenario == OTHER).phases != ()
        page.wait_for(Frame, lambda frame: frame.by == "script")
        page.flown(page.push((1.0, 0.0, 0.0)))
        assert page.wait_for(Frame).by == "hand"
        page.send(from_page.FlyScenario(page.next_seq(), other))
        assert "running already" in page.rejection()
        page.send(from_page.FlyScenario(page.next_seq(), other, demo=True))  # from the beginning
        page.wait_for(Frame, lambda frame: frame.by == "script" and frame.tick < 50)
        page.send(from_page.Restart(page.next_seq()))
        page.wait_for(Frame, lambda frame: frame.by == "hand" and frame.tick < 50)
        page.send(from_page.FlyScenario(page.next_seq(), scenarios.flown))
        page.wait_for(Welcome, lambda welcome: welcome.scenario != OTHER)
        assert page.wait_for(Frame).by == "hand"


def test_scenario_without_a_script_is_not_flown_by_it() -> None:
    text, *_ = about("first-flight").file.split("[[phase]]")
    choice = ScenarioList(parse_scenario(text, "mine", "mine.toml", BUILT_IN))
    assert not choice.scenarios[0].scripted
    with pytest.raises(CommandError, match="no script"):
        choice.choose(0, demo=True)


def test_own_file_restarts_on_another_plant() -> None:
    choice = ScenarioList(own_file())
    other = choice.load(0, "flexible")
    assert (other.title, other.plant) == ("My own flight", "flexible")
    with pytest.raises(CommandError):
        choice.choose(0, "kinematic")
    choice.choose(0, "rigid")


def test_plant_that_a_scenario_cannot_have_is_refused_and_the_run_continues() -> None:
    with served(Session(load_scenario("concept-1972"))) as station, station.page() as page:
        scenarios = page.wait_for(to_page.Scenarios)
        page.wait_for(to_page.Role, lambda role: role.flying)
        page.send(from_page.FlyScenario(page.next_seq(), scenarios.flown, "flexible"))
        assert "flexibility" in page.rejection()
        page.wait_for(Frame, lambda frame: frame.dynamics is None)


@pytest.mark.slow
def test_each_scenario_is_recorded_into_its_own_file(tmp_path: Path) -> None:
    with served(Session(scenario(), record=tmp_path)) as station, station.page() as page:
        page.wait_for(Frame, lambda frame: frame.tick > 20)
        with station.page():
            page.flown(page.push((1.0, 0.0, 0.0)))
        page.send(from_page.FlyScenario(page.next_seq(), number(ScenarioList(scenario()).message(), OTHER)))
        page.wait_for(Welcome)
        page.wait_for(Frame, lambda frame: frame.tick > 20 and frame.display.recording_s is not None)
    first, second = files(tmp_path)
    assert [Recording(path).opening.scenario for path in (first, second)] == ["first-flight", OTHER]
    assert [ended(path) for path in (first, second)] == ["stopped", "stopped"]
    assert verify(first).equal and verify(second).equal


def test_invalid_choice_is_rejected_and_the_run_continues(station: Station, monkeypatch: pytest.MonkeyPatch) -> None:
    with station.page() as page, station.page() as observer:
        observer.send(from_page.FlyScenario(observer.next_seq(), 0))
        assert observer.rejection() == NOT_IN_CONTROL
        before = page.wait_for(to_page.Scenarios)
        page.send(from_page.FlyScenario(page.next_seq(), len(before.scenarios)))
        assert re.search(rf"0 to {len(before.scenarios) - 1}\b.* {len(before.scenarios)}$", page.rejection())
        page.send(from_page.FlyScenario(page.next_seq(), before.flown))
        assert re.match("'First flight' .*Restart", page.rejection())

        def broken(self: ScenarioList, chosen: int, plant: Plant | None) -> Scenario:
            raise ScenarioError(["singular.toml: is gone"])

        monkeypatch.setattr(ScenarioList, "load", broken)
        page.send(from_page.FlyScenario(page.next_seq(), number(before, OTHER)))
        assert re.match("'Three singularities' .*singular.toml", page.rejection())
        after = page.wait_for(to_page.Scenarios, lambda message: message.coming is None)
        assert after.flown == before.flown
    station.check_running()


def test_server_ends_while_a_scenario_is_prepared(monkeypatch: pytest.MonkeyPatch) -> None:
    never = threading.Event()
    monkeypatch.setattr(Session, "another", lambda *_: never.wait(WAIT_S))
    with served(Session(scenario())) as station, station.page() as page:
        choose(page, OTHER)
        page.wait_for(to_page.Scenarios, lambda message: message.coming is not None)
        begun = time.monotonic()
    assert time.monotonic() - begun < WAIT_S / 4
    never.set()
