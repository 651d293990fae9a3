"""Flight of a policy outside its environment: the scenario in which it flies, and its pilot for one run."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from aftdeck.errors import InputError
from aftdeck.files import Changes
from aftdeck.gym.mission.definition import MISSIONS
from aftdeck.gym.mission.pilot import MissionPilot
from aftdeck.gym.policy import Policy
from aftdeck.gym.reach.definition import ID as REACH
from aftdeck.gym.reach.goals import goals_scenario, has_goals
from aftdeck.gym.reach.pilot import ReachPilot
from aftdeck.scenario.load import load_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation


def scenario_of_policy(policy: Policy, given: str | None, seed: int, plant: str | None) -> Scenario:
    """Return the scenario in which a policy flies.

    Args:
        policy: the policy.
        given: name or path of a scenario, for Capture, Extract and Dock; None for that of the environment.
        seed: seed of the goals of Reach.
        plant: the plant; None for that of the policy's keywords or else of the scenario.

    Raises:
        InputError: a scenario is given for Reach.
        ScenarioError: the scenario does not exist, or has errors.
    """
    plant = policy.keywords.get("plant") if plant is None else plant
    changes: Changes = {} if plant is None else {("plant",): plant}
    if policy.environment == REACH:
        if given is not None:
            raise InputError(
                f"scenario: got {given!r}, expected none: a policy of {REACH} flies to {REACH}'s own random goals"
            )
        return goals_scenario(seed, changes)
    own = policy.keywords.get("scenario") or MISSIONS[policy.environment].scenario
    return load_scenario(given or own, changes)


def pilot_of_policy(policy: Policy, scenario: Scenario) -> Callable[[], Callable[[Simulation], Inputs | None]]:
    """Return a function that begins a run: it returns the policy's pilot, as the argument `inputs` of `aftdeck.run`.

    Raises:
        InputError: the policy cannot fly this scenario, because it has no goals of Reach or no step of the
            environment's kind, or because its arm has another number of joints.
    """
    if policy.environment == REACH:
        if not has_goals(scenario):
            raise InputError(f"scenario: {scenario.name!r} has no goals of {REACH}, expected one of `goals_scenario`")
        return partial(ReachPilot, scenario, policy)
    MissionPilot(scenario, policy)  # raises the error now
    return partial(MissionPilot, scenario, policy)
