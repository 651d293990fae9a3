"""Forces and torques on bodies of a MuJoCo model for one control period: disturbances, and jets of payloads.

They act at the centre of mass of their body, constant in the axes of the world, in each of MuJoCo's own steps. After
the period they are zero again, so that a period without them costs nothing.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import mujoco
import numpy as np

from aftdeck.plant.plant import Push


class Pushes:
    """Forces and torques in one compiled model and its workspace."""

    def __init__(self, model: Any, data: Any, hand: str) -> None:
        """Find the bodies; `hand` is the name of the body of the arm's last joint."""
        self._model, self._data = model, data
        names = {"hand": hand, "attached": "payload", "orbiter": "orbiter"}
        self._bodies: dict[int | str, int] = {
            key: mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, name) for key, name in names.items()
        }
        for body in range(model.nbody):
            kind, _, number = model.body(body).name.partition(".")
            if kind == "cargo":
                self._bodies[int(number)] = body

    def begin(self, pushes: Sequence[Push]) -> None:
        """Add forces and torques to those of the orbiter's jets; the bodies are where the period begins."""
        model, data = self._model, self._data
        mujoco.mj_kinematics(model, data)
        for push in pushes:
            body = self._bodies[push.on]
            data.xfrc_applied[body, :3] += push.force
            data.xfrc_applied[body, 3:] += push.torque + np.cross(push.place - data.xipos[body], push.force)

    def end(self, pushes: Sequence[Push]) -> None:
        """Remove all forces and torques from the bodies."""
        for push in pushes:
            self._data.xfrc_applied[self._bodies[push.on]] = 0.0
