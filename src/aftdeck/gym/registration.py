"""Registration of the environments with Gymnasium; an environment's own modules are imported when one is made."""

from __future__ import annotations

import gymnasium

from aftdeck.gym.mission.definition import MISSIONS
from aftdeck.gym.reach.definition import ID, MOST_STEPS


def register_all() -> None:
    """Register all environments, unless they are registered already."""
    if ID in gymnasium.registry:
        return
    gymnasium.register(
        ID,
        entry_point="aftdeck.gym.reach.single:ReachEnv",
        vector_entry_point="aftdeck.gym.reach.vector:ReachVectorEnv",
        max_episode_steps=MOST_STEPS,
    )
    for mission in MISSIONS.values():
        gymnasium.register(
            mission.id,
            entry_point=f"aftdeck.gym.mission.env:{mission.name}Env",
            vector_entry_point=f"aftdeck.gym.mission.vector:{mission.name}VectorEnv",
            max_episode_steps=mission.most_steps,
        )
