"""Station that shows the episodes of an environment: ``render_mode="human"``."""

from __future__ import annotations

import socket
import time

import numpy as np
import pytest

from aftdeck.gym.mission.env import CaptureEnv
from aftdeck.gym.reach.single import ReachEnv
from aftdeck.station.messages.frame import Frame
from aftdeck.station.messages.welcome import Welcome
from tests.station.pages import Page, Server

STEPS = 3


def port_of(env: CaptureEnv | ReachEnv, printed: str) -> int:
    assert env.station is not None
    assert printed == f"Aftdeck station, to observe: {env.station.address}\n"
    host, port = env.station.address.removeprefix("http://").removesuffix("/").split(":")
    assert host == "127.0.0.1"
    return int(port)


def shown_at(page: Page, tick: int) -> Frame:
    return page.wait_for(Frame, lambda frame: frame.tick == tick)


def test_pages_see_each_episode_as_the_environment_computes_it(capsys: pytest.CaptureFixture[str]) -> None:
    env = CaptureEnv(render_mode="human")
    assert env.render() is None and capsys.readouterr().out == ""
    env.reset(seed=0)
    rng = np.random.default_rng(0)
    port = port_of(env, capsys.readouterr().out)
    with Server(port).page() as page:
        for seed in (1, 2):
            env.reset(seed=seed)
            welcome = page.wait_for(Welcome)
            assert [step.title for step in welcome.steps] == [env.task_step.title]
            began = time.monotonic()
            for _ in range(STEPS):
                env.step(rng.uniform(-1.0, 1.0, 8).astype(np.float32))
            assert time.monotonic() - began > 0.09 * STEPS  # real time
            own = env.simulation.look()
            assert shown_at(page, own.tick).angles == own.angles
            assert env.station is not None and env.station.session is not None
            assert env.station.session._sim.seal() == env.simulation.seal()
        page.push((1.0, 0.0, 0.0))
        assert "observes" in page.rejection()
    env.close()
    with socket.socket() as probe:
        assert probe.connect_ex(("127.0.0.1", port)) != 0


def test_station_shows_the_goal_of_reach_and_equals_the_compiled_environment() -> None:
    env, same = ReachEnv(render_mode="human", clip_actions=True), ReachEnv(clip_actions=True)
    env.reset(seed=3), same.reset(seed=3)
    action = np.array([2.0, 0.3, -0.4, 0.1, -0.2, 0.3], dtype=np.float32)
    for _ in range(STEPS):
        assert np.array_equal(env.step(action)[0], same.step(action)[0])
    assert env.station is not None and env.station.session is not None
    sim, (angles, goal) = env.station.session._sim, env._reach.now()
    assert sim.frame is not None and sim.frame.angles == tuple(angles.tolist())
    (step,) = sim.scenario.steps
    assert np.array_equal(step.target.pose.position, goal.position)  # type: ignore[union-attr]
    env.close()
