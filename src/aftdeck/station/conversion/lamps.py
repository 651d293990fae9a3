"""Lamps that are lit in a frame, each with its cause."""

from __future__ import annotations

from aftdeck.kinematics.singular import NAMES
from aftdeck.scenario.model import Scenario
from aftdeck.simulation import frame as sim
from aftdeck.simulation.log import joint_label
from aftdeck.station.messages.frame import FlightLamp, Lamp
from aftdeck.worksite.report import Work


def lamps(scenario: Scenario, frame: sim.Frame) -> tuple[Lamp, ...]:
    """Return the lit lamps, each with its cause."""
    joints = [joint_label(name) for name in scenario.arm.joints]
    lit = []
    if frame.singular:
        shown = ", ".join(
            f"{name} {abs(d):.2f}" for name, d in zip(NAMES, frame.singularity, strict=True) if name in frame.singular
        )
        lit.append(Lamp("SINGULAR", "caution", shown))
    zones: tuple[tuple[FlightLamp, int], ...] = (
        ("REACH LIM", sim.PAST_REACH),
        ("SOFT STOP", sim.PAST_SOFT),
    )
    for name, zone in zones:
        past = [joint for joint, z in zip(joints, frame.zones, strict=True) if z >= zone]
        if past:
            lit.append(Lamp(name, "caution", ", ".join(past)))
    held = [limit.text for limit in frame.limits if limit.kind == "soft stop"]
    if held and not any(lamp.name == "SOFT STOP" for lamp in lit):
        lit.append(Lamp("SOFT STOP", "caution", held[0]))
    rate = [limit.text for limit in frame.limits if limit.kind == "joint rate"]
    if rate:
        lit.append(Lamp("RATE LIM", "info", rate[0]))
    near = frame.work.nearest
    if near is not None and frame.work.clearance_level != "info":
        lit.append(Lamp("CLEARANCE", frame.work.clearance_level, f"{near.a} to {near.b}"))
    return (*lit, *_effector_lamps(frame.work))


def _effector_lamps(work: Work) -> tuple[Lamp, ...]:
    """Return DERIGIDIZE while the snares hold a payload without rigidizing it, and RELEASE while they release it."""
    hand = work.hand
    if hand.carriage is None or "RIGID" in hand.flags or not any(cargo.held for cargo in work.cargo):
        return ()
    releases = hand.switch == "open"
    moves = releases or hand.switch == "close" if hand.mode == "auto" else hand.rigid != "off"
    text = "the payload is captured, not rigidized"
    lamps = [Lamp("DERIGIDIZE", "info" if moves or releases else "caution", text)]
    if releases and hand.rigid == "off":
        lamps.append(Lamp("RELEASE", "info", "the payload is being released"))
    return tuple(lamps)
