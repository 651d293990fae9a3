"""Registration of the environments with Gymnasium; an environment's own modules are imported when one is made."""

from __future__ import annotations

import gymnasium

from aftdeck.gym.mission.definition import MISSIONS
from aftdeck.gym.reach.definition import MOST_STEPS


def register_all() -> None:
    """Register all environments, unless they are registered already."""
    if "aftdeck/Reach-v0" in gymnasium.registry:
        return
    gymnasium.register(
        "aftdeck/Reach-v0",
        entry_point="aftdeck.gym.reach.single:ReachEnv",
        vector_entry_point="aftdeck.gym.reach.vector:ReachVectorEnv",
        max_episode_steps=MOST_STEPS,
    )
    for mission in MISSIONS:
        gymnasium.register(
            f"aftdeck/{mission.name}-v0",
            entry_point=f"aftdeck.gym.mission.env:{mission.name}Env",
            max_episode_steps=mission.most_steps,
        )
