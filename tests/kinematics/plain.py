"""Run laws on fixed numbers and print the results as JSON, for runs with and without NUMBA_DISABLE_JIT."""

from __future__ import annotations

import json
import sys
from typing import Any

import numpy as np

import aftdeck
from aftdeck.scenario.load import load_scenario

ANGLES = np.random.default_rng(40).uniform(-2.0, 2.0, (20, 6))
TWISTS = np.random.default_rng(41).uniform(-0.2, 0.2, (20, 6))
STEPS = 120


def results() -> dict[str, list[Any]]:
    """Return kinematic results for an arm of each family, and results of the first steps of three scenarios."""
    found: dict[str, list[Any]] = {}
    for name in ("srms", "concept-1972"):
        arm = aftdeck.load_arm(name)
        pose = arm.forward(ANGLES)
        found |= {
            f"{name} position": pose.position.tolist(),
            f"{name} rotation": pose.rotation.tolist(),
            f"{name} jacobian": arm.jacobian(ANGLES).tolist(),
            f"{name} rates": np.asarray(arm.joint_rates(ANGLES, TWISTS)).tolist(),
            f"{name} singularities": np.stack(arm.singularities(ANGLES)).tolist(),
            f"{name} inverse": [arm.inverse(arm.forward(q), near=q, limits=False).tolist() for q in ANGLES],
        }
    for name in ("first-flight", "sts-400-closed", "uncradle"):
        sim = aftdeck.Simulation(load_scenario(name))
        frames = [sim.step() for _ in range(STEPS)]
        found[name] = [[*f.angles, *f.rates_commanded, *f.twist_commanded, f.ratio] for f in frames]
    return found


if __name__ == "__main__":
    json.dump(results(), sys.stdout)
