"""The look ahead as pages get it: the ghost is drawn where the bodies will be."""

from __future__ import annotations

import msgspec
import pytest

from aftdeck import Inputs, Simulation
from aftdeck.scenario.load import load_scenario
from aftdeck.station.conversion.frame_of import Displays
from aftdeck.station.conversion.welcome_of import welcome_of
from aftdeck.station.messages import from_page
from aftdeck.station.session.session import LOOK_EVERY, LOOK_S
from tests.station.flying import comes, flying
from tests.station.pages import STILL

FORWARD = Inputs(translation=(1.0, 0.3, 0.0))


@pytest.mark.parametrize("name", ["srms-deploy", "concept-1972", "free-flyer", "first-flight"])
def test_the_ghost_stands_where_the_bodies_are_when_the_time_is_over(name: str) -> None:
    scenario = load_scenario(name)
    sim, displays, welcome = Simulation(scenario), Displays(scenario), welcome_of(scenario, demo=False)
    for _ in range(25):
        frame = sim.step(FORWARD)
    ahead = displays.ahead(sim.ahead(2.0), frame)
    for _ in range(round(2.0 / scenario.control_period)):
        frame = sim.step(FORWARD)
    shown = displays.frame(frame, 0)
    bodies = {body.name: i for i, body in enumerate(welcome.bodies)}
    ghosts = welcome.ghost
    assert len(ahead.poses) == 7 * len(ghosts)
    assert {bodies[cargo.name] for cargo in scenario.cargo} <= set(ghosts)
    floats = {cargo.name for cargo in scenario.cargo if not cargo.start.seat}
    for k, body in enumerate(ghosts):
        if welcome.bodies[body].name in floats:
            continue  # what floats goes on by itself; the ghost shows what the sticks do
        assert ahead.poses[7 * k : 7 * k + 7] == pytest.approx(shown.display.poses[7 * body : 7 * body + 7], abs=1e-8)


def test_pages_are_told_of_it_several_times_a_second_and_set_how_far() -> None:
    with flying() as session:
        told = comes(session, lambda frame: frame.display.ahead is not None, "a look ahead").display.ahead
        assert told is not None and told.seconds == LOOK_S and not told.held and not told.moves
        session.steer(from_page.Sticks(1, (1.0, 0.0, 0.0), STILL, 0.0))
        comes(
            session,
            lambda frame: frame.display.ahead is not None and frame.display.ahead.held and frame.display.ahead.moves,
            "it moves",
        )
        session.command(from_page.LookAhead(2, 12.0))
        comes(session, lambda frame: frame.display.ahead is not None and frame.display.ahead.seconds == 12.0, "12 s")
        session.let_go()
        rests = comes(
            session,
            lambda f: f.display.ahead is not None and not f.display.ahead.held and f.display.ahead.stopping == 0.0,
            "rest",
        )
        assert rests.display.ahead is not None and rests.display.ahead.moves  # the last axis used, at full deflection


def test_a_restart_forgets_the_axis_that_was_used_last() -> None:
    with flying() as session:
        session.steer(from_page.Sticks(1, (1.0, 0.0, 0.0), STILL, 0.0))
        comes(session, lambda frame: frame.display.ahead is not None and frame.display.ahead.held, "it is held")
        session.let_go()
        session.command(from_page.Restart(2))
        comes(
            session,
            lambda f: f.tick > LOOK_EVERY and f.display.ahead is not None and not f.display.ahead.moves,
            "nothing moves",
        )


@pytest.mark.parametrize("seconds", [1.0, 21.0, "5", None])
def test_other_times_are_refused(seconds: object) -> None:
    text = msgspec.json.encode({"type": "look_ahead", "seq": 1, "seconds": seconds})
    with pytest.raises(msgspec.ValidationError):
        msgspec.json.decode(text, type=from_page.FromPage)
