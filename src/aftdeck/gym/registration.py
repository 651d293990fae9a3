"""Registration of the environments with Gymnasium; the environments' own modules are imported when one is made."""

from __future__ import annotations

import gymnasium

REACH = "aftdeck/Reach-v0"


def register_all() -> None:
    """Register all environments, unless they are registered already."""
    if REACH not in gymnasium.registry:
        gymnasium.register(
            REACH,
            entry_point="aftdeck.gym.reach.single:ReachEnv",
            vector_entry_point="aftdeck.gym.reach.vector:ReachVectorEnv",
            max_episode_steps=500,
        )
