"""Poses of all coordinate frames, and the place that is nearest to one of them."""

from __future__ import annotations

from aftdeck.arrays import Array, Indices
from aftdeck.bodies.pose import HERE, compose, relative
from aftdeck.kinematics.frames import place_frames, place_prong
from aftdeck.law import law
from aftdeck.worksite.watch.groups import POSE


@law
def place_everything(
    joints: Array,
    scene: Array,
    axes: Array,
    orbiter: Array,
    carrier: Indices,
    rides: Array,
    angles: Array,
    stand: float,
    prong: float,
    true: Array,
    base: Array,
    frames: Array,
) -> None:
    """Compute the poses of all coordinate frames: the orbiter's, the arm's, ``space``, and one for each payload.

    Args:
        joints: (n, 9) as `kinematics.frames.Frames.joints`.
        scene: (12,) the orbiter's frame in L.
        axes: (3, 3) the orbiter's axes (forward, starboard, down) in L, as columns.
        orbiter: (3,) displacement of the orbiter along its axes [m].
        carrier: (c,) for each payload, the row of the frame that carries the payload; negative if no frame carries it
            (the payload floats).
        rides: (c, 12) pose of each payload in the frame that carries it. For a floating payload, the pose is in a
            frame that is fixed in space and coincided with L at the start.
        angles: (n,) joint angles [rad].
        stand: height of the shoulder above L's origin [m].
        prong: y2 of the prong's inner face [m].
        true: (f, 12) poses of the arm's frames in L, without the prong's; (0, 12) if they follow from the joint angles.
        base: (12,) pose of L in the frame that is fixed in space and coincided with L at the start, apart from
            `orbiter`.
        frames: (F, 12) output: poses in L.
    """
    space = len(frames) - len(carrier) - 1
    if true.shape[0] == 0:
        place_frames(joints, angles, stand, prong, frames[1:space])
    else:
        frames[1:space] = true
        place_prong(prong, joints.shape[0], frames[1:space])
    for k in range(POSE):
        frames[0, k] = frames[space, k] = scene[k]
    for i in range(3):
        frames[space, i] -= axes[i, 0] * orbiter[0] + axes[i, 1] * orbiter[1] + axes[i, 2] * orbiter[2]
    for c in range(len(carrier)):
        if carrier[c] >= 0:
            continue
        row = frames[space + 1 + c]
        for k in range(POSE):
            row[k] = rides[c, k]
        for i in range(3):
            row[i] += frames[space, i] - scene[i]
    _see_from(base, carrier, frames)
    for c in range(len(carrier)):
        if carrier[c] >= 0:
            compose(frames[carrier[c]], rides[c], frames[space + 1 + c])


@law
def _see_from(base: Array, carrier: Indices, frames: Array) -> None:
    """Convert the poses of ``space`` and of the floating payloads to the axes of L, if L has turned or moved."""
    moves = False
    for k in range(POSE):
        moves = moves or base[k] != HERE[k]
    if not moves:
        return
    space = len(frames) - len(carrier) - 1
    for row in range(space, len(frames)):
        if row == space or carrier[row - space - 1] < 0:
            there = frames[row].copy()
            relative(base, there, frames[row])


@law
def nearest_place(frames: Array, row: int, rows: Indices, places: Array, within: float) -> int:
    """Return the index of the pose whose position is nearest to a frame's origin; -1 if none is nearer than `within`.

    Args:
        frames: (F, 12) poses of the frames, in L.
        row: row of the frame.
        rows: (n,) rows of the frames in which the poses are given.
        places: (n, 12) the poses in these frames.
        within: search radius [m].
    """
    best, least = -1, within * within
    for p in range(len(rows)):
        square = 0.0
        for i in range(3):
            b = frames[rows[p]]
            along = b[3 + 3 * i] * places[p, 0] + b[4 + 3 * i] * places[p, 1] + b[5 + 3 * i] * places[p, 2]
            away = frames[row, i] - b[i] - along
            square += away * away
        if square < least:
            best, least = p, square
    return best
