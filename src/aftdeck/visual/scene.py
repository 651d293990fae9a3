"""Visual scene of a scenario: for each frame and camera, the priority output table and the placed clusters."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.bodies.cameras import Camera, view
from aftdeck.bodies.pose import HERE, POSE
from aftdeck.errors import InputError, SimulationError
from aftdeck.matrices import lengths, product
from aftdeck.scenario.all_cameras import first_setting
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.payload import PART
from aftdeck.scenario.relative import inverted, scene_in_l
from aftdeck.scene.cameras import SceneCameras, turn
from aftdeck.simulation.frame import Frame
from aftdeck.tuples import Vec3
from aftdeck.visual.clusters import Clusters, clusters_of
from aftdeck.visual.lists import permanent_list
from aftdeck.visual.order import (
    COMPARED,
    CUTS,
    FIRST,
    HIDING,
    INSIDE,
    MOST_CUTS,
    OVERLAPS,
    RANKED,
    SECOND,
    TOO_MANY,
    Entries,
    ordered,
)
from aftdeck.visual.outlines import NEAR
from aftdeck.visual.polygons import MOST_POLYGONS, Polygons
from aftdeck.visual.store import Store
from aftdeck.visual.trees import Forest
from aftdeck.visual.workspace import Workspace
from aftdeck.worksite.watch.pairs import STILL

_MOST_HOUSINGS = 1024
"""Greatest number of positions of eyes whose surroundings are remembered."""
_SAME_PLACE = 1e-9
"""Distance up to which two positions of an eye count as the same [m]."""


class Aim(NamedTuple):
    """A camera at one moment.

    Attributes:
        name: name of the camera.
        position: (3,) position of the eye, in the scene [m].
        axes: (3, 3) rows are the directions right, down and ahead, in the scene.
        wide: tangent of half the horizontal field of view; for an eye behind a window, that of the window's opening.
        high: tangent of half the vertical field of view, or of the opening.
        part: width and height of what is seen, as fractions of the picture; less than 1 only behind a window.
        hidden: names of parts that are not in the picture: the camera's own housing.
    """

    name: str
    position: Array
    axes: Array
    wide: float
    high: float
    part: tuple[float, float]
    hidden: frozenset[str]


class Eye(NamedTuple):
    """Eye of an engineering view, in the scene.

    Attributes:
        position: position [m].
        ahead: direction of view.
        up: direction that is upwards in the picture, not along `ahead`.
        field_of_view: horizontal field of view [rad].
    """

    position: Vec3
    ahead: Vec3
    up: Vec3
    field_of_view: float


class Arguments(NamedTuple):
    """Arguments of `order.ordered`, under the names of its parameters."""

    store: Store
    frame: Indices
    trims: Indices
    bisected: Indices
    poses: Array
    shown: Mask
    wide: float
    high: float
    placed: Store
    forest: Forest
    listed: Mask
    rank: Indices
    memory: Array
    entries: Entries
    table: Indices
    notes: Indices


class Order(NamedTuple):
    """Order of the clusters in a picture.

    Attributes:
        clusters: the priority output table: a cluster for each polyhedron in the picture, highest priority first. A
            cluster that was cut is there once for each of its pieces.
        compared: number of pairs of polyhedra that were compared.
        ranked: how many of them were compared by a list or a tree.
        cuts: number of cuts that were needed because of cycles.
        overlaps: number of compared pairs that overlap in space, whose order is therefore uncertain.
        overlapping: parts of the first such pair; None if there is none.
    """

    clusters: tuple[int, ...]
    compared: int
    ranked: int
    cuts: int
    overlaps: int
    overlapping: tuple[str, str] | None


class VisualScene:
    """Visual scene of a scenario.

    Attributes:
        clusters: the clusters.
        cameras: the scenario's cameras, by name.
    """

    def __init__(self, scenario: Scenario) -> None:
        self.clusters: Clusters = clusters_of(scenario)
        self._scenario = scenario
        self._placed = SceneCameras(scenario)
        self.cameras = self._placed.cameras
        model = scenario.arm.model
        mount = inverted(scene_in_l(model.mount, scenario.worksite.origin))
        self._fixed = {body.name: (body.fixed_to, body.pose) for body in scenario.worksite.bodies}
        self._fixed[model.linkage.frames[0]] = "orbiter", mount
        self._own = scenario.payload is not None
        ours = self.clusters
        self._work = Workspace([cluster.body for cluster in ours.clusters])
        self._lists: dict[str, tuple[int, ...] | None] = {}
        self._eyes: dict[str, Array] = {}
        self._housings: dict[tuple[str, Vec3], frozenset[str]] = {}

    def aim(self, frame: Frame, name: str, aspect: float) -> Aim:
        """Return a camera's position and directions in a frame.

        Parts that contain the eye in the frame of the camera's own body are not in the picture: they are the camera's
        housing, or the cabin around an eye behind a window.

        Args:
            frame: the frame.
            name: name of the camera.
            aspect: width of the picture divided by its height.

        Raises:
            InputError: there is no such camera.
        """
        position, axes, seen = self._placed.seen(frame, self.bodies_at(frame), name)
        camera = self.cameras[name]
        wide = math.tan(0.5 * seen.field_of_view)
        high, part = wide / aspect, (1.0, 1.0)
        if camera.pane is not None:
            opening = 0.5 * camera.pane.width / camera.pane.distance, 0.5 * camera.pane.height / camera.pane.distance
            part = min(1.0, opening[0] / wide), min(1.0, opening[1] / high)
        return Aim(name, position, axes, part[0] * wide, part[1] * high, part, self._around(camera, seen.position))

    def free_aim(self, name: str, eye: Eye, aspect: float) -> Aim:
        """Return an engineering view from an eye at any place; nothing is left out of it.

        Args:
            name: name of the engineering view.
            eye: the eye.
            aspect: width of the picture divided by its height.

        Raises:
            InputError: there is no such view, or the directions of the eye are no directions.
        """
        self._placed.camera(name)
        ahead, up = np.array(eye.ahead), np.array(eye.up)
        right = np.cross(ahead, up)
        if not (lengths(ahead) > 0.0 and lengths(right) > _SAME_PLACE * lengths(ahead) * lengths(up)):
            raise InputError(
                f"an eye cannot look along {eye.ahead} with {eye.up} upwards; give two different directions"
            )
        ahead, right = ahead / lengths(ahead), right / lengths(right)
        wide = math.tan(0.5 * eye.field_of_view)
        axes = np.array([right, np.cross(ahead, right), ahead])
        return Aim(name, np.array(eye.position), axes, wide, wide / aspect, (1.0, 1.0), frozenset())

    def order(self, frame: Frame, aim: Aim) -> Order:
        """Return the order of the clusters in a picture.

        Raises:
            SimulationError: the camera is inside a cluster or touches one, or the clusters cannot be put in order.
        """
        count, notes = self._put_in_order(self.arguments(frame, aim), frame, aim), self._work.notes.tolist()
        pair = (self._part(notes[FIRST]), self._part(notes[SECOND])) if notes[OVERLAPS] else None
        owners = self._work.placed.owner[self._work.table[:count]]
        return Order(tuple(owners.tolist()), notes[COMPARED], notes[RANKED], notes[CUTS], notes[OVERLAPS], pair)

    def hidden_pairs(self) -> list[tuple[int, int]]:
        """Return the pairs of clusters of the last picture of which the first hides a part of the second."""
        entries, owner = self._work.entries, self._work.placed.owner
        pairs = sorted(map(tuple, entries.pairs[: self._work.notes[HIDING]].tolist()))
        return [(int(owner[entries.body[a]]), int(owner[entries.body[b]])) for a, b in pairs]

    def polygons(self, frame: Frame, aim: Aim) -> Polygons:
        """Return the polygons of a picture, in the order in which they are painted; the arrays belong to the caller.

        Raises:
            SimulationError: the camera is inside a cluster or touches one, or the clusters cannot be put in order.
        """
        given = self.arguments(frame, aim)
        count = self._put_in_order(given, frame, aim)
        drawn = self._work.polygons(count, aim.wide, aim.high, self.clusters.marks, given.frame, given.poses)
        if drawn is None:
            raise SimulationError(f"the picture of camera {aim.name} has more than {MOST_POLYGONS} polygons")
        return drawn

    def _put_in_order(self, given: Arguments, frame: Frame, aim: Aim) -> int:
        """Fill the priority output table; return the number of its entries."""
        work = self._work
        count = ordered(*given)
        if count >= 0:
            return int(count)
        when = f"camera {aim.name} at {frame.time_s:g} s"
        if count == INSIDE:
            raise SimulationError(f"{when} is inside {self._part(int(work.notes[FIRST]))} or touches it")
        what = "more pieces of bodies" if count == TOO_MANY else f"more than {MOST_CUTS} cuts"
        raise SimulationError(f"the picture of {when} needs {what} than there is room for")

    def permanent_list(self, camera: str) -> tuple[int, ...] | None:
        """Return the permanent priority list of a camera: clusters of its frame, highest priority first.

        Returns:
            The list; None if the camera is not fixed to the orbiter or to ``space``, or if its list would have a cycle.

        Raises:
            InputError: there is no such camera.
        """
        own = self._placed.camera(camera)
        if camera not in self._lists:
            frame, eye = self._home(own, view(own, first_setting(self._scenario, own)).position)
            found = None
            if frame in STILL and frame in self.clusters.frames:
                members = np.flatnonzero(self.clusters.frame == self.clusters.frames.index(frame))
                found = permanent_list(self.clusters.store, members, eye)
                self._eyes[camera] = eye
            self._lists[camera] = found
        return self._lists[camera]

    def _listed(self, aim: Aim, poses: Array) -> tuple[Mask, Indices]:
        """Return the frames (F,) for which the camera has a permanent list, and the ranks (N,) in these lists.

        The list is valid for the eye at the initial setting of the camera's drives; pan and tilt may move the eye.
        """
        ours = self.clusters
        listed, rank = np.zeros(len(ours.frames), np.uint8), np.zeros(len(ours.clusters), np.int64)
        own = self.permanent_list(aim.name)
        if own:
            home = ours.frame[own[0]]
            rotation = poses[home, 3:].reshape(3, 3)
            if np.abs(product(rotation.T, poses[home, :3]) + self._eyes[aim.name]).max() < _SAME_PLACE:
                listed[home] = 1
                rank[list(own)] = np.arange(len(own))
        return listed, rank

    def arguments(self, frame: Frame, aim: Aim) -> Arguments:
        """Return the arguments of `order.ordered` for a picture; the result is written into some of them."""
        ours, work, absent = self.clusters, self._work, aim.hidden | self.absent(frame)
        shown = np.array([cluster.part not in absent for cluster in ours.clusters], np.uint8)
        poses = self._in_camera(frame, aim)
        listed, rank = self._listed(aim, poses)
        return Arguments(
            ours.store, ours.frame, ours.trims, ours.bisected, poses, shown, aim.wide, aim.high,
            work.placed, ours.forest, listed, rank, work.memory(aim.name), work.entries, work.table, work.notes,
        )  # fmt: skip

    def _part(self, cluster: int) -> str:
        return self.clusters.clusters[cluster].part

    def absent(self, frame: Frame) -> frozenset[str]:
        """Return the parts that do not exist in a frame: the scenario's own payload, unless it is attached."""
        return frozenset((PART,)) if self._own and frame.attached != 1 else frozenset()

    def bodies_at(self, frame: Frame) -> dict[str, Array]:
        """Return the pose (7,) of each drawn body in the scene."""
        return self._placed.bodies_at(frame)

    def frames_at(self, frame: Frame) -> Array:
        """Return the poses (F, 12) of the frames that carry clusters, in the scene."""
        bodies = self.bodies_at(frame)
        found = np.empty((len(self.clusters.frames), POSE))
        for row, name in zip(found, self.clusters.frames, strict=True):
            if name == "orbiter":
                row[:] = HERE
            elif name == "space":
                row[:] = HERE
                row[:3] = -self._placed.poses.orbiter_travel(frame)
            else:
                row[:3] = bodies[name][:3]
                row[3:] = np.ravel(turn(bodies[name]))
        return found

    def _in_camera(self, frame: Frame, aim: Aim) -> Array:
        """Return the poses (F, 12) of the frames that carry clusters, in the coordinates of a camera."""
        poses = self.frames_at(frame)
        found = np.empty_like(poses)
        found[:, :3] = product(poses[:, :3] - aim.position, aim.axes.T)
        found[:, 3:] = product(aim.axes, poses[:, 3:].reshape(-1, 3, 3)).reshape(-1, 9)
        return found

    def _home(self, camera: Camera, point: Vec3) -> tuple[str, Array]:
        """Return the frame to which a camera's body is fixed, and in it a point (3,) of the body's own frame [m]."""
        if camera.body not in self._fixed:
            return camera.body, np.array(point)
        frame, pose = self._fixed[camera.body]
        return frame, product(pose.rotation, np.array(point)) + pose.position

    def _around(self, camera: Camera, eye: Vec3) -> frozenset[str]:
        """Return the parts that contain a camera's eye and are fixed to the camera's body.

        Args:
            camera: the camera.
            eye: position of the eye in the body's frame [m].
        """
        if (camera.name, eye) not in self._housings:
            frame, at = self._home(camera, eye)
            if len(self._housings) == _MOST_HOUSINGS:
                self._housings.clear()
            self._housings[camera.name, eye] = frozenset(
                cluster.part
                for cluster in self.clusters.clusters
                if cluster.frame == frame
                and (cluster.body.planes[:, :3] @ at <= cluster.body.planes[:, 3] + NEAR).all()
            )
        return self._housings[camera.name, eye]
