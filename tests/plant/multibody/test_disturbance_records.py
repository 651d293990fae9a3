"""Disturbances as inputs and as plans: times, log, time histories, recordings, restored states, refusals."""

from __future__ import annotations

import itertools
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import aftdeck
from aftdeck.errors import InputError, ScenarioError
from aftdeck.recording.reader import Recording
from aftdeck.recording.replay import verify
from aftdeck.recording.run import record
from aftdeck.report.series import series_of
from aftdeck.scenario.disturbance import Disturbance
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Run, Simulation, run
from tests.each import each, seeds
from tests.plant.multibody.disturbed import KINDS, given, name_of, planned
from tests.plant.multibody.flights import scenario
from tests.plant.multibody.test_payloads import bodies_of


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("by", ["script", "hand", "inputs"])
def test_disturbance_acts_with_every_operator_and_is_the_same_as_an_input(kind: str, by: str) -> None:
    one = Disturbance(name_of(kind), (5.0, -8.0, 3.0), (1.0, 2.0, 3.0), "L", (0.1, 0.2, 0.3))
    lines = planned(one.on, 0.2, 0.3, force=list(one.force), torque=list(one.torque), frame="L", at=list(one.at or ()))
    plain = Simulation(given("flexible", kind, lines))
    other = Simulation(given("flexible", kind, "" if by == "inputs" else lines))
    for n in range(40):
        plain.advance(Inputs())
        if by == "script":
            other.advance()
        else:
            other.advance(Inputs(disturbances=(one,) if by == "inputs" and 10 <= n < 25 else ()))
        a, b = plain.look().dynamics, other.look().dynamics
        assert a is not None and b is not None
        assert a.disturbances == b.disturbances and bool(a.disturbances) == (10 <= n < 25)
        assert np.array_equal(bodies_of(plain).physics, bodies_of(other).physics) or by == "script"


@pytest.mark.parametrize("plant", ["rigid", "flexible"])
@pytest.mark.parametrize("kind", KINDS)
def test_state_saved_during_a_disturbance_continues_to_the_last_bit(plant: str, kind: str) -> None:
    fields = {"force": [3.0, 4.0, -5.0], "torque": [1.0, 0.0, 2.0], "at": [0.1, 0.0, 0.0]}
    sim = Simulation(given(plant, kind, planned(name_of(kind), 0.1, 0.517, **fields)))
    extra = Disturbance("tip", (0.0, 2.0, 0.0), frame="tip")
    for n in range(20):
        sim.advance(Inputs(disturbances=(extra,) if n > 10 else ()))
    other = Simulation(sim.scenario)
    for _ in range(7):  # its workspace is elsewhere
        other.advance(Inputs(mode="ORB UNL", translation=(1.0, 0.0, 0.0)))
    other.restore(sim.save())
    for n in range(30):
        inputs = Inputs(disturbances=(extra,) if n % 3 else ())
        assert sim.step(inputs) == other.step(inputs)
    assert sim.save() == other.save()


@pytest.mark.parametrize("plant", ["rigid", "flexible"])
@pytest.mark.parametrize("kind", KINDS)
@each("seed", seeds(1, 10))
def test_recorded_run_with_disturbances_repeats_exactly(plant: str, kind: str, seed: int, tmp_path: Path) -> None:
    rng = np.random.default_rng(seed)
    lines = planned(name_of(kind), 0.11, 0.77, force=(10.0 * rng.uniform(-1.0, 1.0, 3)).tolist(), frame="tip")
    noise = rng.uniform(-3.0, 3.0, (60, 6))

    def hand(sim: Simulation) -> Inputs | None:
        n = 0 if sim.frame is None else sim.frame.tick
        if n >= len(noise):
            return None
        force, torque = tuple(noise[n, :3].tolist()), tuple(noise[n, 3:].tolist())
        return Inputs(disturbances=(Disturbance("tip", force, torque, "space", (0.1, 0.0, 0.0)),) if n > 5 else ())

    file = tmp_path / "run.mcap"
    made = given(plant, kind, lines)
    record(made, file, inputs=hand)
    verdict = verify(file)
    assert verdict.equal and verdict.whole and verdict.frames == len(noise), verdict
    table, recorded = run(made, inputs=hand).table("disturbances"), series_of(Recording(file), ("disturbances",))
    assert list(table) == list(recorded)
    for column in table:
        assert np.asarray(recorded[column]) == pytest.approx(np.asarray(table[column]), abs=1.1e-3)
    assert np.abs(table["tip_disturbing_torque_x_n_m"]).max() > 0.1


def test_history_adds_up_what_acts_on_a_body() -> None:
    text = planned("payload", 0.0, 1.0, force=[1.0, 2.0, 3.0], torque=[4.0, 0.0, 0.0], frame="L")
    sim = Simulation(given("rigid", "worksite's payload", text))

    def hand(now: Simulation) -> Inputs | None:
        tick = 0 if now.frame is None else now.frame.tick
        return Inputs(disturbances=(Disturbance("payload", (10.0, 0.0, 0.0), frame="L"),)) if tick < 5 else None

    table = run(sim.scenario, inputs=hand).table("disturbances")
    assert np.asarray(table["payload_1_disturbing_force_x_n"]) == pytest.approx(11.0)
    assert np.asarray(table["payload_1_disturbing_force_y_n"]) == pytest.approx(2.0)
    assert np.asarray(table["payload_1_disturbing_torque_x_n_m"]) == pytest.approx(4.0)
    assert not np.any(table["tip_disturbing_force_x_n"])


def test_log_says_when_a_disturbance_begins_and_ends() -> None:
    done = _flown(given("rigid", "tip", planned("tip", 0.1, 0.2, force=[30.0, 0.0, 40.0])), 40)
    lines = [(event.time_s, event.text) for event in done.events if event.kind == "disturbance"]
    assert [round(time, 6) for time, _ in lines] == [0.12, 0.32]
    assert "tip" in lines[0][1] and "50 N" in lines[0][1]


def _flown(made: Scenario, steps: int) -> Run:
    def hand(sim: Simulation) -> Inputs | None:
        return Inputs() if sim.frame is None or sim.frame.tick < steps else None

    return run(made, inputs=hand)


def test_command_delay_does_not_delay_disturbances() -> None:
    push = (Disturbance("tip", (1.0, 0.0, 0.0)),)
    sim = Simulation(given("rigid", "tip", "command_delay = '0.2 s'\n"))
    shown = [sim.step(Inputs(disturbances=push if n == 3 else ())).dynamics for n in range(20)]
    assert [n for n, dynamics in enumerate(shown) if dynamics is not None and dynamics.disturbances] == [3]


@pytest.mark.parametrize(
    ("fields", "key"),
    [
        ("on = 'nothing'\nduration = 1\nforce = [1, 0, 0]", "on"),
        ("on = 'payload'\nduration = 1\nforce = [1, 0, 0]", "on"),
        ("on = 'orbiter'\nduration = 1\nforce = [1, 0, 0]", "on"),
        ("on = 'tip'\nduration = 1\nforce = [1, 0, 0]\nframe = 'scene'", "frame"),
        ("on = 'tip'\nduration = 0\nforce = [1, 0, 0]", "duration"),
        ("on = 'tip'\nduration = 1\nforce = [1e9, 0, 0]", "force"),
        ("on = 'tip'\nduration = 1\nforce = ['1 m', 0, 0]", "force"),
        ("on = 'tip'\nduration = 1", ""),
    ],
)
def test_impossible_disturbance_of_a_scenario_is_rejected_with_its_place(fields: str, key: str) -> None:
    with pytest.raises(ScenarioError, match=rf"flight\.toml:\d+: disturbance\[0\]{'.' if key else ''}{key}"):
        scenario("rigid", f"[[disturbance]]\n{fields}\n")


@pytest.mark.parametrize("name", ["loaded", "srms-berth", "concept-1972-script"])
def test_plant_without_forces_rejects_disturbances(name: str) -> None:
    one = {"on": "tip", "duration": 1.0, "force": [1.0, 0.0, 0.0]}
    changes: dict[tuple[str | int, ...], object] = {("plant",): "kinematic", ("disturbance",): [one]}
    with pytest.raises(ScenarioError, match=r"disturbance\[0\]"):
        aftdeck.load_scenario(name, changes)
    sim = Simulation(aftdeck.load_scenario(name, {("plant",): "kinematic"}))
    before = sim.save()
    with pytest.raises(InputError, match=r"^disturbances: "):
        sim.advance(Inputs(disturbances=(Disturbance("tip", (1.0, 0.0, 0.0)),)))
    assert sim.save() == before


WRONG: list[Any] = [
    Disturbance("nothing"),
    Disturbance("tip", frame="scene"),
    Disturbance("tip", (math.nan, 0.0, 0.0)),
    Disturbance("tip", torque=(1e9, 0.0, 0.0)),
    Disturbance("tip", at=(1e9, 0.0, 0.0)),
    Disturbance("tip", ("1", 0.0, 0.0)),  # type: ignore[arg-type]
    Disturbance("tip", (1.0, 0.0)),  # type: ignore[arg-type]
    Disturbance(3),  # type: ignore[arg-type]
    "tip",
]


@pytest.mark.parametrize("wrong", WRONG)
def test_wrong_disturbance_of_the_inputs_is_rejected_and_changes_nothing(wrong: Any) -> None:
    sim = Simulation(given("rigid", "tip"))
    before = sim.save()
    with pytest.raises(InputError, match=r"^disturbances: "):
        sim.advance(Inputs(disturbances=(wrong,)))
    assert sim.save() == before


def test_numbers_of_any_type_are_flown_as_plain_ones() -> None:
    one, other = (Simulation(given("rigid", "tip")) for _ in range(2))
    odd: Any = [Disturbance(np.str_("tip"), np.array([1, 2, 3]), [0, np.float32(0.5), 0], at=np.zeros(3))]  # type: ignore[arg-type]
    plain = Inputs(disturbances=(Disturbance("tip", (1.0, 2.0, 3.0), (0.0, 0.5, 0.0), at=(0.0, 0.0, 0.0)),))
    assert one.step(Inputs(disturbances=odd)) == other.step(plain)
    assert one.given == plain


def test_own_payload_is_disturbed_only_while_it_is_attached() -> None:
    phases = "".join(
        f"[[phase]]\nmode = 'ORB UNL'\nduration = '0.2 s'\n{fields}"
        for fields in ("", "[phase.payload]\nmass = 500\n", "detached = true\n")
    )
    made = scenario("rigid", phases, head=planned("payload", 0.0, 1.0, force=[2.0, 0.0, 0.0]))
    shown = [frame.dynamics.disturbances for frame in run(made).frames if frame.dynamics]
    acts = [key for key, _ in itertools.groupby(bool(one) for one in shown)]
    assert acts == [False, True, False] and sum(map(bool, shown)) == 10
    sim = Simulation(made)
    with pytest.raises(InputError, match=r"^disturbances: .*attached"):
        sim.advance(Inputs(disturbances=(Disturbance("payload", (1.0, 0.0, 0.0)),)))
