"""Observations from the row of a state: they are the readings of the frame, and what the reward needs is in it."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

from aftdeck.arrays import Array
from aftdeck.gym.mission.definition import observations
from aftdeck.gym.mission.env import CaptureEnv, DockEnv, ExtractEnv, MissionEnv
from aftdeck.gym.mission.observation import Observer
from aftdeck.gym.mission.score import ABOVE, AIMS, ANGLE, CONTACT, DISTANCE, MET
from aftdeck.scenario.schema import Plant
from aftdeck.scene.stick_axes import StickAxes
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.readings.reading import Known
from aftdeck.simulation.readings.table import named
from aftdeck.simulation.run import Simulation
from aftdeck.steering.mode import MODES
from aftdeck.task.along_sticks import seen_along
from aftdeck.task.remaining import Aims
from tests.gym.test_missions import careful, flown

FLOWN = [
    *((CaptureEnv, name, "kinematic") for name in ("tutorial", "concept-1972", "free-flyer", "srms-deploy")),
    *((kind, name, "kinematic") for kind in (ExtractEnv, DockEnv) for name in ("concept-1972", "free-flyer")),
    (CaptureEnv, "tutorial", "flexible"),
    (DockEnv, "concept-1972", "rigid"),
    (DockEnv, "srms-berth", "kinematic"),
]


def read(env: MissionEnv, sim: Simulation) -> Array:
    """Return the observation as the readings of the frame have it, before it is limited."""
    frame, scenario = sim.look(), sim.scenario
    left = Aims(scenario).remaining(frame, env.task_step)
    known = Known(frame, scenario, along=seen_along(frame, left, StickAxes(scenario).in_l(frame)))
    readings = [named(group.reading) for group in observations(len(scenario.arm.joints))]
    scale = env._observer.scale
    values = np.array([value for reading in readings for value in reading.values(known)], np.float64)
    return (values - scale.zero) / scale.one


def compare(env: MissionEnv, sim: Simulation, observer: Observer) -> None:
    """Compare an observation, and what the reward needs, with the frame."""
    frame, scenario = sim.look(), sim.scenario
    seen, scored = observer.of(sim)
    expected = np.clip(read(env, sim), observer.scale.low, observer.scale.high)
    np.testing.assert_array_equal(seen, expected.astype(np.float32))
    aims = Aims(scenario)
    left = aims.remaining(frame, env.task_step)
    assert scored[AIMS] == (left is not None)
    if left is not None:
        assert scored[DISTANCE] == pytest.approx(left.distance, abs=1e-9)
        assert scored[ANGLE] == pytest.approx(abs(left.angle), abs=1e-9)
        target = env.task_step.target
        assert target is not None
        assert scored[ABOVE] == pytest.approx(aims.places.above(frame, target), abs=1e-9)
    conditions = frame.work.conditions
    assert scored[MET] == pytest.approx(np.mean([one.holds for one in conditions]) if conditions else 0.0)
    assert scored[CONTACT] == any(not contact.essential for contact in frame.work.contacts)


def inputs(generator: np.random.Generator, modes: list[str]) -> Iterator[Inputs]:
    """Yield random sticks and switches."""
    while True:
        sticks = generator.uniform(-1.0, 1.0, 6).tolist()
        yield Inputs(
            translation=tuple(sticks[:3]),
            rotation=tuple(sticks[3:]),
            mode=generator.choice(modes) if generator.random() < 0.2 else None,
            rate=generator.choice(["coarse", "vernier"]) if generator.random() < 0.3 else None,
            effector=generator.choice(["close", "open"]) if generator.random() < 0.3 else None,
            payload_axes=bool(generator.random() < 0.5),
        )


@pytest.mark.parametrize(("kind", "scenario", "plant"), FLOWN)
def test_observation_is_that_of_the_readings(kind: type[MissionEnv], scenario: str, plant: Plant) -> None:
    env = kind(scenario, plant)
    generator = np.random.default_rng(len(scenario))
    modes = [name for name, mode in MODES.items() if mode.kind in ("manual", "single")]
    for seed in range(2):
        seen, _ = env.reset(seed=seed)
        compare(env, env.simulation, env._observer)
        for _ in range(40):
            seen, _, over, _, _ = env.step(careful(env, seen))
            compare(env, env.simulation, env._observer)
            if over:
                break
        env.reset(seed=seed)
        for given, _ in zip(inputs(generator, modes), range(60), strict=False):
            env.simulation.hold(given, 4)
            compare(env, env.simulation, env._observer)


@pytest.mark.parametrize("kind", [CaptureEnv, DockEnv])
def test_observation_is_that_of_the_readings_until_the_task_is_done(kind: type[MissionEnv]) -> None:
    env = kind()
    _, seen, success = flown(env, 3)
    assert success
    compare(env, env.simulation, env._observer)
    assert seen[-1] == pytest.approx(env._observer.of(env.simulation)[0])


def test_contact_that_ended_with_the_capture_does_not_count() -> None:
    """Parts of a captured payload and the end effector may still overlap; they are no longer monitored."""
    env = CaptureEnv()
    assert flown(env, 3)[2]
    worksite = env.simulation.parts[1].worksite
    group = int(np.flatnonzero((worksite.watch.active == 0) & (worksite.contacts.essential == 0))[0])
    worksite.contacts.count[group] = 1
    assert worksite.logged_contacts == ()
    assert env.simulation.look().work.contacts == ()
    assert env._observer.of(env.simulation)[1][CONTACT] == 0.0
