"""What of a scenario's arm, starts and cameras meets something, over sampled poses: for ``aftdeck check`` and tests.

It takes a second or so. What is cheap, and makes a run senseless, is found at load by `scenario.fit`.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from aftdeck.arms.model import HeadingArmFile
from aftdeck.arms.solids import solids_of
from aftdeck.bodies.overlap import deepest
from aftdeck.errors import AftdeckError
from aftdeck.files import Problem, Where
from aftdeck.scenario.fit import TOLERANCE
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.relative import at_cargo, composed, scene_in_l, takes
from aftdeck.scenario.target import AtCargo, AtSeat
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.simulation.site import site_of
from aftdeck.simulation.survey_cameras import cameras
from aftdeck.simulation.survey_poses import bodies, placed, stops
from aftdeck.worksite.conditions import shown

Array = NDArray[np.float64]


def survey(scenario: Scenario) -> list[Problem]:
    """Return each thing that meets another, with both names and how deep, and its place in the scenario's file.

    Looked at are the starts of the scenario, the arm's parts that no run watches against each other at combinations of
    its hard stops, and cameras (`simulation.survey_cameras`). Told as well is a payload in a seat that the hand cannot
    reach inside the soft stops, with the telescope as at the start.

    Raises:
        ScenarioError: the arm holds at a start what its hand could not have taken so.
    """
    return [*_starts(scenario), *_reached(scenario), *_folded(scenario), *cameras(scenario)]


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
    for k, (how, angles, stand, prong) in enumerate(stops(scenario)):
        there = bodies(scenario, placed(scenario, angles, stand, prong))
        for pair in pairs:
            depth = deepest(there[pair[0]], there[pair[1]])
            if k == 0:
                usual[pair] = depth
            elif depth > max(usual[pair] + TOLERANCE, worst.get(pair, (0.0, ""))[0]):
                worst[pair] = depth, how
    for (a, b), (depth, how) in worst.items():
        yield Problem(("arm",), f"{a} is {shown(depth, 'm', model.units)} inside {b} {how}")
