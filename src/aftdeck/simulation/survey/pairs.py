"""Survey of a scenario in sampled poses, for ``aftdeck check`` and tests: overlaps, cameras inside parts, and reach.

The survey takes about a second, and the time that a run of the script takes. When a scenario is loaded, only the quick
checks of `scenario.fit` run; they find errors that make a run meaningless.
"""

from __future__ import annotations

from collections.abc import Iterator

from aftdeck.bodies.overlap import deepest
from aftdeck.files import Problem, Where
from aftdeck.scenario.fit import TOLERANCE
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.on_arm import arm_solids
from aftdeck.simulation.constants.site import site_of
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.simulation.survey.cameras import cameras
from aftdeck.simulation.survey.lenses import lenses_in_script, without_housing
from aftdeck.simulation.survey.poses import bodies, placed, stops
from aftdeck.simulation.survey.reach import reach
from aftdeck.worksite.conditions import quantity_text


def survey(scenario: Scenario) -> list[Problem]:
    """Return all problems found, each with its location in the scenario's file.

    The survey finds:

    - detrimental contacts at the starts of the scenario;
    - payloads and targets out of reach (`survey.reach`);
    - overlaps of two arm parts at combinations of the joints' hard stops, if the two are not a monitored pair;
    - cameras inside parts (`survey.cameras`), and while the script runs (`survey.lenses`);
    - cameras without a housing.

    Raises:
        ScenarioError: at a start, the arm holds a payload in a pose in which it could not have captured the payload.
    """
    found = [*_starts(scenario), *reach(scenario), *_folded(scenario), *cameras(scenario)]
    return [*found, *without_housing(scenario), *lenses_in_script(scenario)]


def _starts(scenario: Scenario) -> Iterator[Problem]:
    """Yield the detrimental contacts at the initial state and at each start of `[initialise]`."""
    sim = Simulation(scenario)
    units = scenario.arm.model.units
    starts: list[tuple[Where, Inputs]] = [(("initial",), Inputs())]
    starts += [(("initialise", part), Inputs(initialise=part)) for part in scenario.parts if part != "full problem"]
    for where, inputs in starts:
        for contact in sim.step(inputs).work.contacts:
            if not contact.essential and contact.clearance < -TOLERANCE:
                depth = quantity_text(-contact.clearance, "m", units)
                yield Problem(where, f"{contact.a} is {depth} inside {contact.b}")


def _folded(scenario: Scenario) -> Iterator[Problem]:
    """Yield the pairs of arm parts that are not monitored and overlap more at hard stops than at mid-range.

    An arm whose solids enclose round parts is not tested: its solids overlap at the joints by design.
    """
    model = scenario.arm.model
    if model.covered:
        return
    home = {solid.part: solid.frame for solid in arm_solids(model, scenario.worksite)}
    layout = site_of(scenario).layout
    monitored = {frozenset(layout.named(group)) for group in range(len(layout.groups))}
    pairs = [(a, b) for a in home for b in home if a < b and home[a] != home[b] and frozenset((a, b)) not in monitored]
    usual: dict[tuple[str, str], float] = {}
    worst: dict[tuple[str, str], tuple[float, str]] = {}
    for k, (how, angles, stand, prong) in enumerate(stops(scenario)):
        parts = bodies(scenario, placed(scenario, angles, stand, prong))
        for pair in pairs:
            depth = deepest(parts[pair[0]], parts[pair[1]])
            if k == 0:
                usual[pair] = depth
            elif depth > max(usual[pair] + TOLERANCE, worst.get(pair, (0.0, ""))[0]):
                worst[pair] = depth, how
    for (a, b), (depth, how) in worst.items():
        yield Problem(("arm",), f"{a} is {quantity_text(depth, 'm', model.units)} inside {b} {how}")
