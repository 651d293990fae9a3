"""Checks that a concept arm's telescope, booms and end effector fit together.

A pin joins two booms. The plane that contains the pin and bisects the angle between the booms has to separate the two
booms. Each boom therefore has to begin far enough from the pin. Let w be half the width of a boom and theta the angle
of the bend. If the axis of the bend is perpendicular to a side face of the boom, the boom has to begin at least
w tan(theta/2) from the pin. If the axis can have any direction, this least distance is sqrt(2) w tan(theta/2). The
corners of a joint's housing must not be farther from the pin than the end of the nearer boom. The end planes of the
booms then separate the booms from the housing. Both conditions are needed for separating planes SP 11 and SP 12 of the
Remote Manipulator Simulation.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from aftdeck.arms.model import BoomsFile, EffectorFile, HeadingArmFile, StandFile
from aftdeck.files import Problem


def body_problems(file: HeadingArmFile) -> list[Problem]:
    """Return a problem, with its place in the file, for each dimension that does not fit."""
    return [
        *_stand_problems(file.stand),
        *_effector_problems(file.effector),
        *_boom_problems(file.booms, *_bends(file)),
    ]


def _bends(file: HeadingArmFile) -> tuple[float, float]:
    """Return the greatest bend of the elbow, and of the wrist, inside the hard stops [rad]; DIRECT can reach both."""
    hard = file.limits.hard.value
    elbow = max(abs(angle) for angle in hard[2])
    heading, pitch = (min(max(abs(angle) for angle in hard[joint]), math.pi) for joint in (3, 4))
    # the component of the end effector's direction along the lower arm is cos(heading) cos(pitch)
    cosines = [math.cos(h) * math.cos(p) for h in (0.0, heading) for p in (0.0, pitch)]
    return elbow, math.acos(min(cosines))


def _stand_problems(stand: StandFile) -> Iterator[Problem]:
    least, start, greatest = stand.least.value, stand.start.value, stand.greatest.value
    if not 0.0 < least <= start <= greatest:
        yield Problem(("stand",), f"expected 0 < least <= start <= greatest, got {least:g}, {start:g}, {greatest:g} m")
    below = stand.top_below_shoulder.value
    if not 0.0 < below < least:
        what = f"has to be above 0 and less than the least length, got {below:g} m"
        yield Problem(("stand", "top_below_shoulder"), what)
    yield from _above_zero("stand", rate=stand.rate.value, side=stand.side.value)
    tube, sleeve = stand.tube_side.value, stand.side.value
    if not 0.0 < tube <= sleeve:
        what = f"has to be above 0 and at most the stand's side, {sleeve:g} m, got {tube:g} m"
        yield Problem(("stand", "tube_side"), what)


def _effector_problems(e: EffectorFile) -> Iterator[Problem]:
    for name, (near, far) in (("palm", e.palm.value), ("fingers", e.fingers.value)):
        if not 0.0 <= near < far:
            what = f"expected 0 <= begin < end along the end effector, got {near:g} to {far:g} m"
            yield Problem(("effector", name), what)
    yield from _above_zero(
        "effector",
        palm_half_width=e.palm_half_width.value,
        palm_half_height=e.palm_half_height.value,
        finger_thickness=e.finger_thickness.value,
        finger_half_height=e.finger_half_height.value,
        prong_rate=e.prong_rate.value,
    )
    opened, closed, fixed = e.prong_open.value, e.prong_closed.value, e.fixed_finger.value
    if not opened < closed < fixed:
        yield Problem(
            ("effector",),
            "the prong closes towards the fixed finger: expected prong_open < prong_closed < fixed_finger, "
            f"got {opened:g}, {closed:g}, {fixed:g} m",
        )


def _boom_problems(b: BoomsFile, elbow: float, wrist: float) -> Iterator[Problem]:
    begin, end = b.stub.value
    if not begin < end:
        what = f"expected begin < end along the end effector, got {begin:g} to {end:g} m"
        yield Problem(("booms", "stub"), what)
    diagonal = math.sqrt(2.0)
    for pin, boom, set_back, half_width, bend in (
        ("elbow", "the arm's booms", b.set_back.value, 0.5 * b.side.value, elbow),
        ("wrist", "the lower arm", b.set_back.value, diagonal * 0.5 * b.side.value, wrist),
        ("wrist", "the stub", begin, diagonal * 0.5 * b.stub_side.value, wrist),
    ):
        if bend >= math.pi or set_back < half_width * math.tan(0.5 * bend):
            needed = "" if bend >= math.pi else f": {half_width * math.tan(0.5 * bend):g} m is needed"
            yield Problem(
                ("booms",),
                f"{boom} set back by {set_back:g} m from the {pin} cannot bend by {math.degrees(bend):g} deg, "
                f"which the hard stops allow{needed}",
            )
    for pin, side, allowed in (
        ("shoulder", b.shoulder_housing.value, b.set_back.value),
        ("elbow", b.elbow_housing.value, b.set_back.value),
        ("wrist", b.wrist_housing.value, min(b.set_back.value, begin)),
    ):
        corner = 0.5 * math.sqrt(3.0) * side
        if not 0.0 < corner <= allowed:
            what = f"its corners are {corner:g} m from the pin, but the booms begin at {allowed:g} m"
            yield Problem(("booms", f"{pin}_housing"), what)


def _above_zero(table: str, **lengths: float) -> Iterator[Problem]:
    for name, value in lengths.items():
        if value <= 0.0:
            yield Problem((table, name), f"has to be above 0, got {value:g}")
