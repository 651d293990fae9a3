"""The console of a session answers in a process of its own, so that no control step waits for a new scenario."""

from __future__ import annotations

import os
import pickle
import random
import signal

import pytest

from aftdeck.errors import InputError
from aftdeck.exact_pickle import pickled
from aftdeck.law_cache import only_kept
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation import in_flight
from aftdeck.simulation.in_flight import make
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.station.core.typewriter import Now
from aftdeck.station.session.session import Session
from aftdeck.station.session.typing_process import ENDED, TypingProcess
from tests.legal_changes import changing, random_change
from tests.station.pages import until

CONCEPT = "concept-1972"
CHANGE = "clearance.caution = 0.9"


def test_session_makes_no_scenario_in_its_own_process(monkeypatch: pytest.MonkeyPatch) -> None:
    session = Session(load_scenario(CONCEPT))
    try:
        session.step()
        monkeypatch.setattr(in_flight, "in_force", None)  # calling it fails
        assert session.type_line(f"set {CHANGE}").lines == (CHANGE,)
        assert session.type_line("set clearance.warning = 0.2").lines == ("clearance.warning = 0.2",)
        session.step()
        assert session._frame is not None
        assert session._frame.changes == ("clearance.caution=0.9", "clearance.warning=0.2")
        assert session.type_line("set clearance.caution = 0.8").lines == ("clearance.caution = 0.8",)
        session.step()
        assert session._frame.changes == ("clearance.warning=0.2", "clearance.caution=0.8")
        assert session.complete_line("set clearance.cau") == ("clearance.caution",)
        assert session.type_line("set mode = 3").refused
    finally:
        session.close()


def test_ended_process_is_told_and_the_next_line_starts_another() -> None:
    console, now = TypingProcess(load_scenario(CONCEPT)), Now(None, {})
    console.reply("help", now)
    assert console.pid is not None
    os.kill(console.pid, signal.SIGKILL)
    with pytest.raises(InputError, match=ENDED):
        console.reply("help", now)
    assert console.reply("changes", now).lines == ("no value has been changed",)
    pid = console.pid
    console.close()
    until(lambda: not _alive(pid), "the process has ended")
    with pytest.raises(InputError, match="closed"):
        console.reply("help", now)
    assert console.completions("set clearance.cau", now) == ()


def _alive(pid: int | None) -> bool:
    assert pid is not None
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return True


@pytest.mark.parametrize(
    ("name", "plant"),
    [
        (CONCEPT, "kinematic"),
        (CONCEPT, "rigid"),
        ("srms-berth", "kinematic"),
        ("srms-berth", "rigid"),
        ("srms-berth", "flexible"),
    ],
)
def test_constants_from_another_process_give_the_same_run_and_the_same_machine_code(name: str, plant: str) -> None:
    scenario = load_scenario(name, {"plant": plant})
    rng, sticks = random.Random(name), Inputs(translation=(1.0, -0.5, 0.0), rotation=(0.0, 0.3, 0.0))
    here, there = Simulation(scenario), Simulation(scenario)
    here.step(sticks)
    there.step(sticks)
    for _ in range(3):
        changes = random_change(rng, changing(scenario), here.prepare)
        flown = Inputs(translation=(1.0, -0.5, 0.0), changes=changes)
        after = here.step(flown)
        there.prepare(changes, pickle.loads(pickled(make(scenario, after.changes))))
        with only_kept():
            assert there.step(flown).sha256 == after.sha256
            assert [there.step(sticks).sha256 for _ in range(5)] == [here.step(sticks).sha256 for _ in range(5)]
