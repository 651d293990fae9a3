"""Scenarios in empty space: the Shuttle's arm on a fixed orbiter."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from aftdeck.frames import Pose, oriend
from aftdeck.scenario.load import parse_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.steering.mode import LawChoice


def in_space(
    plant: str, joints: Sequence[float], *, pounds: float = 0.0, ahead: float = 0.0, phases: str = ""
) -> Scenario:
    """Return a scenario in empty space.

    Args:
        plant: the plant.
        joints: (6,) joint angles at the start [rad].
        pounds: mass of the payload [lb]; 0 for none.
        ahead: distance of the payload's centre from the tip, along the end effector's axis [m].
        phases: the script, as in a scenario's file.
    """
    payload = f"[payload]\nmass = '{pounds} lb'\nposition = [{ahead}, 0.0, 0.0]\n" if pounds else ""
    text = f"""
title = "a motion in empty space"
worksite = "space"
plant = "{plant}"
duration = "900 s"
dynamics = {{ orbiter = "fixed" }}
[initial]
joints = {list(joints)}
{payload}{phases}"""
    return parse_scenario(text, "motion", "motion.toml", Path())


def move_to(tip: Pose, law: LawChoice) -> str:
    """Return a phase of a script: a motion in OPR CMD that ends at a pose of the tip in L."""
    roll, pitch, yaw = oriend(tip.rotation)
    place = f"position = {tip.position.tolist()}, roll = {roll}, pitch = {pitch}, yaw = {yaw}"
    return f"[[phase]]\nmode = 'OPR CMD'\nlaw = '{law}'\ntarget = {{ frame = 'L', {place} }}\n"
