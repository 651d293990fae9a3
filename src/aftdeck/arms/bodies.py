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
        *_length_problems(file),
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


def _length_problems(file: HeadingArmFile) -> Iterator[Problem]:
    """Yield a problem for each boom whose two set-backs leave no body between its pins."""
    back = file.booms.set_back.value
    for name, length in (("upper_arm", file.geometry.upper_arm.value), ("lower_arm", file.geometry.lower_arm.value)):
        if not length > 2.0 * back:
            what = f"has to be longer than its two set-backs of {back:g} m, got {length:g} m"
            yield Problem(("geometry", name), what)


def _stand_problems(stand: StandFile) -> Iterator[Problem]:
    least, start, greatest = stand.least.value, stand.start.value, stand.greatest.value
    if not least <= start <= greatest:
        yield Problem(("stand",), f"expected least <= start <= greatest, got {least:g}, {start:g}, {greatest:g} m")
    below = stand.top_below_shoulder.value
    if not below < least:
        what = f"has to be less than the least length, got {below:g} m"
        yield Problem(("stand", "top_below_shoulder"), what)
    tube, sleeve = stand.tube_side.value, stand.side.value
    if not tube <= sleeve:
        what = f"has to be at most the stand's side, {sleeve:g} m, got {tube:g} m"
        yield Problem(("stand", "tube_side"), what)


def _effector_problems(e: EffectorFile) -> Iterator[Problem]:
    for name, (near, far) in (("palm", e.palm.value), ("fingers", e.fingers.value)):
        if not 0.0 <= near < far:
            what = f"expected 0 <= begin < end along the end effector, got {near:g} to {far:g} m"
            yield Problem(("effector", name), what)
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
        if not corner <= allowed:
            what = f"its corners are {corner:g} m from the pin, but the booms begin at {allowed:g} m"
            yield Problem(("booms", f"{pin}_housing"), what)
