"""What of a scenario's arm, starts and cameras meets something, over sampled poses: for ``aftdeck check`` and tests.

It takes a second or so. What is cheap, and makes a run senseless, is found at load by `scenario.fit`.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import product

import numpy as np
from numpy.typing import NDArray

from aftdeck.arms.model import HeadingArmFile
from aftdeck.arms.solids import solids_of
from aftdeck.bodies.cameras import Camera
from aftdeck.bodies.overlap import deepest
from aftdeck.bodies.pose import pose_of
from aftdeck.errors import AftdeckError
from aftdeck.files import Problem, Where
from aftdeck.frames import Pose
from aftdeck.kinematics.frames import frames_of, place_frames
from aftdeck.scenario.cameras import cameras_of
from aftdeck.scenario.fit import TOLERANCE, Parts, hands
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.relative import at_cargo, composed, scene_in_l, takes
from aftdeck.scenario.target import AtCargo, AtSeat
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.simulation.site import site_of
from aftdeck.worksite.check import distance
from aftdeck.worksite.conditions import shown

Array = NDArray[np.float64]


def survey(scenario: Scenario) -> list[Problem]:
    """Return each thing that meets another, with both names and how deep, and its place in the scenario's file.

    Looked at are the starts of the scenario, the arm's parts that no run watches against each other at combinations of
    its hard stops, cameras on the arm there, and cameras on payloads that the hand holds or a seat has. Told as well is
    a payload in a seat that the hand cannot reach inside the soft stops, with the telescope as at the start.

    Raises:
        ScenarioError: the arm holds at a start what its hand could not have taken so.
    """
    return [*_starts(scenario), *_reached(scenario), *_folded(scenario), *_cameras(scenario)]


def _starts(scenario: Scenario) -> Iterator[Problem]:
    """Yield the detrimental contacts with which the problem or a part of it begins."""
    sim = Simulation(scenario)
    units = scenario.arm.model.units
    starts: list[tuple[Where, Inputs]] = [(("initial",), Inputs())]
    starts += [(("initialise", part), Inputs(initialise=part)) for part in scenario.parts if part != "full problem"]
    for where, inputs in starts:
        for contact in sim.step(inputs).work.contacts:
            if not contact.essential and contact.clearance < -TOLERANCE:
                depth = shown(-contact.clearance, "m", units)
                yield Problem(where, f"{contact.a} is {depth} inside {contact.b}")


def _reached(scenario: Scenario) -> Iterator[Problem]:
    """Yield payloads that the hand cannot take in a seat that they start in, or that the script uses."""
    model = scenario.arm.model
    arm = scenario.arm
    if isinstance(model.source, HeadingArmFile):
        arm = arm.at(stand=scenario.start.stand)
    used = {phase.target.seat for phase in scenario.phases if isinstance(phase.target, AtSeat)}
    scene = scene_in_l(model.mount, scenario.worksite.origin)
    low, high = arm.limits.soft.T
    for k, one in enumerate(scenario.cargo):
        for seat in scenario.worksite.seats:
            wanted = seat.name in used or seat.name == one.start.seat
            if not wanted or not takes(model, one) or seat.lacks(one.probe, one.trunnions):
                continue
            tip = composed(scene, composed(seat.seated(one.probe), at_cargo(model, one, AtCargo(k))))
            what = f"the hand cannot take {one.name} in the seat {seat.name!r}"
            try:
                found = arm.inverse(tip, near=scenario.start.angles)
            except AftdeckError as error:
                yield Problem(("cargo", k), f"{what}: {error}")
                continue
            if not ((low <= found) & (found <= high)).all(axis=1).any():
                joint = int(np.maximum(low - found[0], found[0] - high).argmax())
                angle = f"{model.joints[joint]} would be at {math.degrees(found[0, joint]):.4g} deg"
                yield Problem(("cargo", k), f"{what}: {angle}, outside its soft stops")


def _poses(scenario: Scenario) -> Iterator[tuple[str, Array, float, float]]:
    """Yield the middle of the arm's hard limits, and every combination of its hard stops, each with what it is."""
    model = scenario.arm.model
    low, high = model.limits.hard.T
    stand, prong = float(model.links[0]), 0.0
    ends = [stand]
    if isinstance(model.source, HeadingArmFile):
        ends = [float(model.source.stand.least.value), float(model.source.stand.greatest.value)]
        prong = float(model.source.effector.prong_open.value)
    yield "at the middle of its limits", 0.5 * (low + high), ends[0], prong
    turns = np.where(high - low < 2.0 * math.pi, high, 0.5 * (low + high))  # a full turn has its middle as well
    for joints in product(*zip(low, turns, strict=True)):
        degrees = ", ".join(f"{math.degrees(angle):.0f}" for angle in joints)
        for end in ends:
            yield f"at joint angles {degrees} deg", np.array(joints), end, prong


def _placed(scenario: Scenario, angles: Array, stand: float, prong: float) -> dict[str, Pose]:
    """Return the pose in L of each frame of the arm."""
    arm = frames_of(scenario.arm.model)
    rows = arm.rows()
    place_frames(arm.joints, angles, stand, prong, rows)
    return {name: pose_of(row) for name, row in zip(arm.names, rows, strict=True)}


def _bodies(scenario: Scenario, frames: dict[str, Pose]) -> Parts:
    found: Parts = {}
    for solid in solids_of(scenario.arm.model):
        pose = frames[solid.frame]
        found.setdefault(solid.part, []).append(solid.vertices @ pose.rotation.T + pose.position)
    return found


def _folded(scenario: Scenario) -> Iterator[Problem]:
    """Yield pairs of the arm's parts that no run watches and that are deeper in each other at stops than in between.

    Not looked at: an arm whose solids cover round parts from outside, which overlap by design where a joint holds them.
    """
    model = scenario.arm.model
    if not isinstance(model.source, HeadingArmFile):
        return
    home = {solid.part: solid.frame for solid in solids_of(model)}
    layout = site_of(scenario).layout
    watched = {frozenset(layout.named(group)) for group in range(len(layout.groups))}
    pairs = [(a, b) for a in home for b in home if a < b and home[a] != home[b] and frozenset((a, b)) not in watched]
    usual: dict[tuple[str, str], float] = {}
    worst: dict[tuple[str, str], tuple[float, str]] = {}
    for k, (how, angles, stand, prong) in enumerate(_poses(scenario)):
        bodies = _bodies(scenario, _placed(scenario, angles, stand, prong))
        for pair in pairs:
            depth = deepest(bodies[pair[0]], bodies[pair[1]])
            if k == 0:
                usual[pair] = depth
            elif depth > max(usual[pair] + TOLERANCE, worst.get(pair, (0.0, ""))[0]):
                worst[pair] = depth, how
    for (a, b), (depth, how) in worst.items():
        yield Problem(("arm",), f"{a} is {shown(depth, 'm', model.units)} inside {b} {how}")


def _cameras(scenario: Scenario) -> Iterator[Problem]:
    """Yield cameras that stand in a part of the arm, or in what is round a payload that carries them."""
    cameras = [camera for camera in cameras_of(scenario) if camera.kind == "camera"]
    on_arm = [camera for camera in cameras if camera.body in scenario.arm.model.frames]
    told: set[tuple[str, str]] = set()
    for how, angles, stand, prong in _poses(scenario):
        frames = _placed(scenario, angles, stand, prong)
        bodies = _bodies(scenario, frames)
        for camera in on_arm:
            pose = frames[camera.body]
            for part in _inside(pose.rotation @ np.array(camera.position) + pose.position, bodies):
                if (camera.name, part) not in told:
                    told.add((camera.name, part))
                    yield Problem(("worksite",), f"camera {camera.name} is inside {part} {how}")
    for one in scenario.cargo:
        own = [camera for camera in cameras if camera.body == one.name]
        for how, hand in hands(scenario.arm.model, scenario.worksite, one).items():
            yield from _held(own, hand, f"with the hand, {how}, at its bar")
        for seat in scenario.worksite.seats:
            if seat.lacks(one.probe, one.trunnions):
                continue
            pose = seat.seated(one.probe)
            around: Parts = {}
            for solid in scenario.worksite.solids:
                there = (solid.vertices - pose.position) @ pose.rotation
                around.setdefault(solid.part, []).append(there)
            yield from _held(own, around, f"with {one.name} in the seat {seat.name!r}")


def _held(cameras: list[Camera], around: Parts, how: str) -> Iterator[Problem]:
    for camera in cameras:
        for part in _inside(np.array(camera.position), around):
            yield Problem(("worksite",), f"camera {camera.name} is inside {part} {how}")


def _inside(point: Array, parts: Parts) -> Iterator[str]:
    """Yield the parts that a point is in."""
    for part, bodies in parts.items():
        if any(_in_box(point, body) and distance(point, body) == 0.0 for body in bodies):
            yield part


def _in_box(point: Array, body: Array) -> bool:
    return bool((body.min(axis=0) <= point).all() and (point <= body.max(axis=0)).all())
