"""What the priority routine makes of a frame, as plain values: lists, trees with their tests, vectors, and the POT."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import NamedTuple

from aftdeck.historical.rms_vs_output import Planes
from aftdeck.mainprior.planes import Plane
from aftdeck.mainprior.routine import Priority, PriorityRoutine
from aftdeck.mainprior.tables import CODES, LISTS, TREES, Item, system_of, text, tree_name
from aftdeck.mainprior.trace import Select
from aftdeck.mainprior.trees import Son, Sorted, Split
from aftdeck.mainprior.vectors import DISPLAY
from aftdeck.simulation.frame import Frame
from aftdeck.tuples import Vec3

TRUE, FALSE = "T", "F"
"""Branches of a node: the sons on the TRUE and on the FALSE side."""


class TreeLine(NamedTuple):
    """Line of a tree.

    Attributes:
        depth: number of nodes above it.
        branch: T or F; empty for the root, and for the tree and the tests of a special priority.
        plane: name of the plane; empty for a leaf.
        system: L vector with which the plane is tested; empty for a leaf.
        clusters: clusters of a leaf, or clusters behind the plane of a special priority's test.
        sorted_in: the cluster that a special priority sorts in; 0 in other lines.
    """

    depth: int
    branch: str
    plane: str
    system: str
    clusters: tuple[int, ...]
    sorted_in: int


class PlaneTest(NamedTuple):
    """Test of the observer against a plane.

    Attributes:
        plane: its name.
        system: L vector with which it is tested.
        normal: unit normal N, to the TRUE side; None if no plane was ever received.
        distance: D [m]; None as for `normal`.
        eye: height of the eye over the plane [m]; positive on the TRUE side. None as for `normal`.
    """

    plane: str
    system: str
    normal: Vec3 | None
    distance: float | None
    eye: float | None


class Unseparated(NamedTuple):
    """Two clusters that a plane of the routine should separate and does not, so that their order may be wrong.

    Attributes:
        plane: name of the plane; in a list, the face of a fixed cluster that comes nearest to separating them.
        before: number and part of the cluster with the higher priority.
        behind: number and part of the other one.
    """

    plane: str
    before: tuple[int, str]
    behind: tuple[int, str]


class RoutineExplained(NamedTuple):
    """What the routine makes of a frame for a station point.

    Attributes:
        mode: the task phase.
        table_vii: row of TABLE VII, with the trees of this mode.
        permanent_list: the list for the shapes of the scenario, likewise.
        replaced: planes of Figure 19 that do not divide these shapes.
        report_trees: the trees of Figure 19 that the list names.
        trees: these trees for the shapes of the scenario.
        tests: the planes of these trees.
        l_vectors: L vectors by system [m].
        p_vectors: PC, PL and PE by system [half the width of the picture].
        table: the priority output table: names of L vectors, and numbers of clusters.
        table_by_table_vii: the same with TABLE VII's own list, which was made for other shapes.
        parts: parts of the clusters, by number.
        unseparated: pairs of clusters in the picture of which one can hide the other, and that no plane separates.
    """

    mode: int
    table_vii: tuple[str, ...]
    permanent_list: tuple[str, ...]
    replaced: tuple[str, ...]
    report_trees: dict[str, tuple[TreeLine, ...]]
    trees: dict[str, tuple[TreeLine, ...]]
    tests: tuple[PlaneTest, ...]
    l_vectors: dict[str, Vec3]
    p_vectors: dict[str, Vec3]
    table: tuple[str | int, ...]
    table_by_table_vii: tuple[str | int, ...]
    parts: dict[str, str]
    unseparated: tuple[Unseparated, ...]


def explained_by_routine(
    routine: PriorityRoutine, frame: Frame, station: str, shown: Collection[int], received: Planes | None = None
) -> RoutineExplained:
    """Return what the routine makes of a frame.

    Args:
        routine: the routine of the scenario.
        frame: the frame.
        station: camera A to I.
        shown: clusters of the visual scene that are in the picture, by their indices there; the routine does not know
            the housings of cameras among them.
        received: D1 to D3, as the scene program has them; None to compute them from the frame.

    Raises:
        InputError: the camera is not a station point.
    """
    found = routine.priority(frame, station, received)
    names = [name for item in found.items if (name := tree_name(item, found.mode))]
    trees = {name: tuple(_lines(routine.fit.trees[name])) for name in names}
    planes = dict.fromkeys(line.plane for lines in trees.values() for line in lines if line.plane)
    part, numbers = routine.shapes.part, routine.shapes.numbers
    return RoutineExplained(
        found.mode,
        _row(LISTS[station], found.mode),
        _row(found.items, found.mode),
        routine.fit.replaced,
        {name: tuple(_lines(TREES[name])) for name in names},
        trees,
        tuple(_test(name, found.planes.get(name), found) for name in planes),
        {system: _three(found.vectors.eye[system]) for system in CODES if system in found.vectors.eye},
        {
            name + system[1:]: _three(row)
            for system in CODES
            if system in found.vectors.display
            for name, row in zip(DISPLAY, found.vectors.display[system], strict=True)
        },
        _steps(found),
        _steps(routine.priority(frame, station, received, routine.report_items(station))),
        {str(number): part(number) for number in sorted(found.clusters)},
        tuple(
            Unseparated(one.plane, (one.before, part(one.before)), (one.behind, part(one.behind)))
            for one in routine.unproved(found, {numbers[k] for k in shown if k in numbers})
        ),
    )


def _steps(found: Priority) -> tuple[str | int, ...]:
    return tuple(step.system if isinstance(step, Select) else step.cluster for step in found.table)


def _row(items: tuple[Item, ...], mode: int) -> tuple[str, ...]:
    return tuple(tree_name(item, mode) or text(item) for item in items)


def _lines(son: Son, depth: int = 0, branch: str = "") -> Iterator[TreeLine]:
    """Yield the lines of a tree, a father before its sons."""
    if isinstance(son, Split):
        yield TreeLine(depth, branch, son.plane, system_of(son.plane), (), 0)
        yield from _lines(son.true, depth + 1, TRUE)
        yield from _lines(son.false, depth + 1, FALSE)
    elif isinstance(son, Sorted):
        yield TreeLine(depth, branch, "", "", (), son.cluster)
        yield from _lines(son.tree, depth + 1)
        for plane, others in son.tests:
            yield TreeLine(depth + 1, "", plane, system_of(plane), others, 0)
    else:
        yield TreeLine(depth, branch, "", "", (son,) if isinstance(son, int) else son, 0)


def _test(name: str, plane: Plane | None, found: Priority) -> PlaneTest:
    if plane is None:
        return PlaneTest(name, system_of(name), None, None, None)
    eye = plane.height(found.vectors.eye[plane.system])
    return PlaneTest(name, plane.system, _three(plane.normal), plane.distance, eye)


def _three(values: object) -> Vec3:
    x, y, z = (float(value) for value in values)  # type: ignore[attr-defined]
    return x, y, z
