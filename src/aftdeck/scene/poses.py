"""Poses of an arm's moving frames in scene coordinates, from its joint angles."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from aftdeck.arms.flexures import Flexure
from aftdeck.arms.load import ArmModel
from aftdeck.arms.switched import PRONG, TELESCOPE
from aftdeck.arrays import Array
from aftdeck.elementary import sincos
from aftdeck.frames import SCENE_FROM_PANEL_AXES, SCENE_ORIGIN
from aftdeck.kinematics.bending import bend_frames
from aftdeck.kinematics.frames import RAISED, frames_of, place_frames
from aftdeck.kinematics.linkage import L1
from aftdeck.law import law
from aftdeck.matrices import product
from aftdeck.quaternions import unit_quaternion

Seven = tuple[float, float, float, float, float, float, float]
"""A pose: x, y, z [m], then the quaternion w, x, y, z."""


class ArmPoses:
    """Poses of all frames of an arm in the scene, in the order of `ArmModel.frames`.

    At zero angles every frame is parallel to L. The origin of a joint's frame is the centre of the joint; for the wrist
    roll, it is the centre of the preceding joint. The origin of the telescope's frame is at the shoulder's height. The
    origin of the prong's frame is at the prong's inner face.

    Args:
        model: the arm.
        origin: (3,) the scene's origin in structural coordinates Xo, Yo, Zo [m].
        flexures: the parts that bend.
    """

    def __init__(self, model: ArmModel, origin: Array = SCENE_ORIGIN, flexures: Sequence[Flexure] = ()) -> None:
        self._frames, self._linkage = frames_of(model), model.linkage
        self._stand = float(model.links[L1])
        prong = model.prong
        self._prong = 0.0 if prong is None else prong.least
        turn = product(SCENE_FROM_PANEL_AXES, model.mount.rotation)
        self._base = np.concatenate([point_in_scene(model.mount.origin, origin), turn.ravel()])
        self._rows = self._frames.rows()
        self._poses = np.empty((len(self._rows), 7))
        self._carriers = np.array([part.frame for part in flexures], dtype=np.int64)
        self._ends = np.array([part.end for part in flexures]).reshape(-1, 3)
        self._switched = model.switched
        self._telescope = -1 if model.telescope is None else model.frames.index(model.telescope.frame)

    def at(
        self, angles: Array, stand: float | None = None, prong: float | None = None, bends: Array | None = None
    ) -> list[float]:
        """Return seven numbers per frame (x, y, z [m], w, x, y, z).

        Args:
            angles: (n,) joint angles [rad].
            stand: height of the shoulder above L's origin [m]; None for the height in the arm's model.
            prong: y2 of the prong's inner face [m]; None for the open prong.
            bends: (b, 6) bends of the parts that bend (`kinematics.bending`); None for an unbent arm.
        """
        place_frames(self._frames.joints, angles, *self._telescope_and_prong(stand, prong), self._rows)
        if bends is not None:
            bend_frames(self._carriers, self._ends, bends, self._rows, self._telescope)
        sevens(self._base, self._rows, self._poses)
        flat: list[float] = self._poses.ravel().tolist()
        return flat

    def links(
        self, angles: Sequence[float], stand: float | None = None, prong: float | None = None
    ) -> list[tuple[str, str, Seven]]:
        """Return the links between the frames whose poses `at` returns.

        Each link gives the name of the parent frame, the name of the moving frame, and the pose of the moving frame in
        the parent frame. The arguments are those of `at`.
        """
        height, opening = self._telescope_and_prong(stand, prong)
        names, links = self._frames.names, []
        for n, (row, axis, slides, angle) in enumerate(
            zip(self._frames.joints, self._linkage.axes.tolist(), self._linkage.slides, angles, strict=True)
        ):
            x, y, z = row[:3].tolist()
            down = -height if row[RAISED] else z
            i, j, k = axis
            if slides:
                pose: Seven = (x + angle * i, y + angle * j, down + angle * k, 1.0, 0.0, 0.0, 0.0)
            else:
                s, c = sincos(0.5 * angle)
                pose = (x, y, down, c, s * i, s * j, s * k)
            links.append((names[n], names[n + 1], pose))
        coordinates = {TELESCOPE: height, PRONG: opening}
        for joint in self._switched:
            x, y, z = (0.0 + coordinates[joint.driver] * along for along in joint.axis.tolist())  # + 0.0: no -0.0
            links.append((joint.carrier, joint.frame, (x, y, z, 1.0, 0.0, 0.0, 0.0)))
        return links

    def _telescope_and_prong(self, stand: float | None, prong: float | None) -> tuple[float, float]:
        """Return the height of the shoulder and the position of the prong [m]; defaults replace None."""
        return self._stand if stand is None else stand, self._prong if prong is None else prong


def point_in_scene(panel: Array, origin: Array = SCENE_ORIGIN) -> Array:
    """Convert a point (3,) from the panel frame to the scene [m]; `origin` is the scene's origin in Xo, Yo, Zo."""
    return np.asarray(product(SCENE_FROM_PANEL_AXES, panel) - origin)


@law
def sevens(base: Array, rows: Array, poses: Array) -> None:
    """Convert poses of frames in L, rows (n, 12), to poses in the scene, rows (n, 7).

    `base` (12,) is the row of L's pose in the scene. The quaternions have unit length and w >= 0.
    """
    m = np.empty((3, 3))
    for n in range(rows.shape[0]):
        row, pose = rows[n], poses[n]
        for i in range(3):
            a, b, c = base[3 + 3 * i], base[4 + 3 * i], base[5 + 3 * i]
            pose[i] = base[i] + a * row[0] + b * row[1] + c * row[2]
            for j in range(3):
                m[i, j] = a * row[3 + j] + b * row[6 + j] + c * row[9 + j]
        pose[3], pose[4], pose[5], pose[6] = unit_quaternion(
            m[0, 0], m[0, 1], m[0, 2], m[1, 0], m[1, 1], m[1, 2], m[2, 0], m[2, 1], m[2, 2]
        )
