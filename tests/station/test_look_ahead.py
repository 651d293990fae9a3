"""Look-ahead as pages receive it: poses of the ghost, settings, and reset."""

from __future__ import annotations

import msgspec
import pytest

from aftdeck import Inputs, Simulation
from aftdeck.scenario.load import load_scenario
from aftdeck.station.conversion.frame_of import Displays
from aftdeck.station.conversion.welcome_of import welcome_of
from aftdeck.station.core.core import LOOK_S
from aftdeck.station.core.look import EVERY
from aftdeck.station.messages import from_page
from tests.station.flying import flying, step_until
from tests.station.pages import STILL

FORWARD = Inputs(translation=(1.0, 0.3, 0.0))


@pytest.mark.parametrize("name", ["srms-deploy", "concept-1972", "free-flyer", "first-flight"])
def test_ghost_has_the_poses_that_the_bodies_reach(name: str) -> None:
    scenario = load_scenario(name)
    sim, displays, welcome = Simulation(scenario), Displays(scenario), welcome_of(scenario, demo=False)
    for _ in range(25):
        frame = sim.step(FORWARD)
    ahead = displays.ahead(sim.ahead(2.0), frame)
    for _ in range(round(2.0 / scenario.control_period)):
        frame = sim.step(FORWARD)
    shown = displays.frame(frame, 0)
    bodies = {body.name: i for i, body in enumerate(welcome.bodies)}
    assert len(ahead.poses) == 7 * len(welcome.ghost)
    assert {bodies[cargo.name] for cargo in scenario.payloads} <= set(welcome.ghost)
    free = {cargo.name for cargo in scenario.payloads if not cargo.start.berth}
    for k, body in enumerate(welcome.ghost):
        if welcome.bodies[body].name in free:
            continue  # a free payload drifts; the look-ahead predicts only the motion by the sticks
        assert ahead.poses[7 * k : 7 * k + 7] == pytest.approx(shown.display.poses[7 * body : 7 * body + 7], abs=1e-8)


def test_frames_carry_a_look_ahead_over_the_time_that_a_page_sets() -> None:
    with flying() as session:
        first = step_until(session, lambda frame: frame.display.ahead is not None, "a look-ahead").display.ahead
        assert first is not None and first.seconds == LOOK_S and not first.held and not first.moves
        session.accept(from_page.Sticks(1, (1.0, 0.0, 0.0), STILL, 0.0))
        step_until(
            session,
            lambda frame: frame.display.ahead is not None and frame.display.ahead.held and frame.display.ahead.moves,
            "it moves",
        )
        session.accept(from_page.LookAhead(2, 12.0))
        step_until(
            session, lambda frame: frame.display.ahead is not None and frame.display.ahead.seconds == 12.0, "12 s"
        )
        session.set_unattended()
        at_rest = step_until(
            session,
            lambda f: f.display.ahead is not None and not f.display.ahead.held and f.display.ahead.stopping == 0.0,
            "rest",
        )
        assert at_rest.display.ahead is not None
        assert at_rest.display.ahead.moves, "predicted with the axis that was deflected last"


def test_restart_resets_the_axis_that_was_used_last() -> None:
    with flying() as session:
        session.accept(from_page.Sticks(1, (1.0, 0.0, 0.0), STILL, 0.0))
        step_until(session, lambda frame: frame.display.ahead is not None and frame.display.ahead.held, "it is held")
        session.set_unattended()
        session.accept(from_page.Restart(2))
        step_until(
            session,
            lambda f: f.tick > EVERY and f.display.ahead is not None and not f.display.ahead.moves,
            "nothing moves",
        )


@pytest.mark.parametrize("seconds", [1.0, 21.0, "5", None])
def test_time_span_out_of_range_is_rejected(seconds: object) -> None:
    text = msgspec.json.encode({"type": "look_ahead", "seq": 1, "seconds": seconds})
    with pytest.raises(msgspec.ValidationError):
        msgspec.json.decode(text, type=from_page.FromPage)
