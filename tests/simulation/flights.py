"""Runs with random inputs, and their contacts and log lines, for tests of the worksite."""

from __future__ import annotations

import functools
from collections.abc import Iterable, Iterator
from itertools import pairwise
from pathlib import Path

import msgspec
import numpy as np

import aftdeck
from aftdeck import Inputs
from aftdeck.arms.solids import solids_of
from aftdeck.scenario.load import parse_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.worksite.report import Near
from tests.simulation.concept import vec3

Pair = tuple[str, str]

SRMS = """title = "test"
arm = "srms"
worksite = "orbiter"
duration = "3600 s"
{head}
[[cargo]]
name = "payload"
[initial]
near = ["-35 deg", "87 deg", "-109 deg", "-79 deg", "16 deg", "-123 deg"]
{grasped}
[initial.pose]
frame = "panel"
position = ["{x} in", "{y} in", "{z} in"]
pitch = "{pitch} deg"
yaw = "{yaw} deg"
roll = "{roll} deg"
"""
GRASPED = """[initial.grasped]
cargo = "payload"
joints = ["-31.097 deg", "80.888 deg", "-120.011 deg", "-61.23 deg", "16.592 deg", "-127.91 deg"]
"""
FIXTURE = 400.0 + 2.26 / 0.0254
"""Zo of the payload's grapple fixture in the bay [in]."""
OVER = -903.7323
"""X of the end effector above the fixture, in the panel frame [in]."""


@functools.cache
def srms(
    above: float, x: float = 0.0, y: float = 0.0, turned: tuple[float, float, float] = (0.0, 0.0, 0.0), *,
    held: bool = False, head: str = "",
) -> Scenario:  # fmt: skip
    """Return a scenario that starts above the payload's fixture in the bay, offset from it [in] and rotated [deg]."""
    roll, pitch, yaw = turned
    text = SRMS.format(
        x=OVER + x, y=y, z=-(FIXTURE + above), pitch=270.0 + pitch, yaw=yaw, roll=roll,
        grasped=GRASPED if held else "", head=head,
    )  # fmt: skip
    return parse_scenario(text, "test", "test.toml", Path("."))


MODES = ("ORB UNL", "ORB LD", "END EFF", "PL", "SINGLE", "DIRECT", "MASTER")


def random_inputs(
    rng: np.random.Generator,
    steps: int,
    deflection: float = 1.0,
    *,
    switches: float = 0.15,
    without: tuple[str, ...] = (),
    every: int = 16,
) -> Iterator[Inputs]:
    """Yield random inputs: sticks in every direction, changed every few steps, and random switches.

    Args:
        rng: random generator.
        steps: number of inputs.
        deflection: greatest deflection of the sticks, 0 to 1.
        switches: probability of a switch command when the sticks change, 0 to 1.
        without: switches that are not commanded.
        every: steps between two changes of the sticks.
    """
    held = Inputs()
    for k in range(steps):
        if k % every == 0:
            some = rng.random(5) < 0.6
            held = Inputs(
                vec3(deflection * rng.uniform(-1.0, 1.0, 3) * some[0]),
                vec3(deflection * rng.uniform(-1.0, 1.0, 3) * some[1]),
                drive=float(deflection * rng.uniform(-1.0, 1.0)),
                telescope=float(deflection * rng.choice([-1.0, 0.0, 1.0]) * some[2]),
                orbiter=vec3(rng.choice([-1.0, 0.0, 1.0], 3) * some[3]),
            )
            put = {name: values[rng.integers(len(values))] for name, values in SWITCHES.items() if name not in without}
            yield _with(held, {name: value for name, value in put.items() if rng.random() < switches})
        else:
            yield held


SWITCHES: dict[str, list[object]] = {
    "mode": list(MODES),
    "joint": list(range(6)),
    "rate": ["coarse", "vernier"],
    "effector": ["stop", "close", "open"],
    "effector_mode": ["auto", "manual"],
    "rigid": ["off", "rigid", "derigid"],
    "latch": ["latch", "unlatch"],
}


def _with(inputs: Inputs, put: dict[str, object]) -> Inputs:
    """Return inputs with additional switch commands."""
    return msgspec.structs.replace(inputs, **put)


def flown(made: Scenario | aftdeck.Simulation, given: Iterable[Inputs]) -> list[Frame]:
    """Return the frames of a run with manual inputs."""
    sim = made if isinstance(made, aftdeck.Simulation) else aftdeck.Simulation(made)
    return [sim.step(inputs) for inputs in given]


@functools.cache
def arm_parts(arm: str) -> frozenset[str]:
    """Return the parts of a built-in arm."""
    return frozenset(solid.part for solid in solids_of(aftdeck.load_arm(arm).model))


def log_of(frames: Iterable[Frame]) -> list[str]:
    """Return the log lines except those of the kind `clearance`, which occur in most runs."""
    return [event.text for frame in frames for event in frame.events if event.kind != "clearance"]


def events_of(frames: Iterable[Frame]) -> list[tuple[str, str]]:
    """Return kind and level of the log's lines, except those of the kind `clearance`."""
    return [(event.kind, event.level) for frame in frames for event in frame.events if event.kind != "clearance"]


def movers(scenario: Scenario, frame: Frame) -> set[str]:
    """Return the parts that move with the arm: its own parts, and those of the payload that is held in a frame."""
    own = set(arm_parts("srms" if scenario.worksite.name == "orbiter" else "concept-1972"))
    held = [cargo.name for cargo in frame.work.cargo if cargo.held]
    return own | {solid.part for cargo in scenario.payloads if cargo.name in held for solid in cargo.solids}


def harmful(scenario: Scenario, frame: Frame) -> dict[Pair, Near]:
    """Return the detrimental contacts of the arm and of the held payload in a frame, by pair."""
    mine = movers(scenario, frame)
    return {(c.a, c.b): c for c in frame.work.contacts if not c.essential and {c.a, c.b} & mine}


def is_initialised(frame: Frame) -> bool:
    """Return whether the run was re-initialised in the step of a frame."""
    return any(event.kind == "initialise" for event in frame.events)


def same_possession(one: Frame, other: Frame) -> bool:
    """Return whether the same payloads are held and fixed in two frames."""
    return [(c.held, c.seat) for c in one.work.cargo] == [(c.held, c.seat) for c in other.work.cargo]


def in_turn(frames: list[Frame]) -> Iterator[tuple[Frame, Frame]]:
    """Yield each frame with the previous frame. Frames in which the run was re-initialised are left out."""
    return ((before, now) for before, now in pairwise(frames) if not is_initialised(now))
