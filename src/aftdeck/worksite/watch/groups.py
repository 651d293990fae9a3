"""All solids of a run and the monitored pairs of parts, packed for the laws.

The operator reads the names of *parts* ("lower boom", "bay wall port"). The laws measure *solids*; a part consists of
one or several solids. A *group* is a monitored pair of parts. Its pairs of solids combine each solid of the first part
with each solid of the second part. The clearance of a group is the least clearance of these pairs of solids.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from functools import cached_property
from itertools import product
from typing import NamedTuple

import msgspec
import numpy as np

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.bodies.hexahedron import BODY, VERTICES
from aftdeck.bodies.hexahedron_check import hexahedra
from aftdeck.bodies.solid import Solid
from aftdeck.errors import InputError
from aftdeck.law import law
from aftdeck.lent import lend
from aftdeck.matrices import lengths

PartPair = tuple[str, str]
Placing = Callable[[Indices], Array]
"""Function that places solids, given by their indices, and returns all solids (n, 52): those placed are in L, where
they are now; others may be where they were before."""

POSE = 12
"""Number of values in a frame's pose: its origin [m], then its rotation row by row."""
CENTRE, RADIUS = BODY, BODY + 3
"""Indices in the row of a packed solid: first value of the centre, and radius, of the bounding sphere [m]. They follow
the packed body, with which the row begins."""
SOLID = BODY + 4
"""Number of values in the row of a packed solid."""
_ROOM = 1e-9
"""Margin added to the radius of a bounding sphere [m]: more than the rounding error at 1 km from the origin."""


class PackedLayout(NamedTuple):
    """The fields of a `Layout` that the laws read, under the same names."""

    solids: Array
    frame: Indices
    pairs: Indices
    begins: Indices
    between_frames: Indices
    reach: Array


LayoutArrays = tuple[Array, Indices, Indices, Indices, Indices, Array]
"""The arrays of a `PackedLayout`, as Python passes them to a law."""


@law
def layout_from(arrays: LayoutArrays) -> PackedLayout:
    """Return the arrays of a layout under their names, lent: they have to live until the calling law returns."""
    a, b, c, d, e, f = arrays
    return PackedLayout(lend(a), lend(b), lend(c), lend(d), lend(e), lend(f))


class Layout(msgspec.Struct, frozen=True, eq=False, dict=True):
    """The solids of a run in packed arrays, all read-only. Every index counts from zero."""

    frames: tuple[str, ...]
    """Names of the coordinate frames, in the order of the rows of every `frames` array (F, 12)."""
    parts: tuple[str, ...]
    part_frame: Indices
    """(p,) the frame of each part."""
    solids: Array
    """(n, 52) packed bodies with their bounding spheres, each in its own frame."""
    frame: Indices
    """(n,) the frame of each solid."""
    groups: Indices
    """(g, 2) the two parts of each group."""
    pairs: Indices
    """(m, 2) the two solids of each pair; the pairs are sorted by group."""
    begins: Indices
    """(g + 1,) index of each group's first pair; the last entry is m."""
    between_frames: Indices
    """(g, 2) the frames of the two parts of each group."""
    reach: Array
    """(F,) upper bound of the distance from a frame's origin to any point of the frame's solids [m]."""

    @cached_property
    def packed(self) -> PackedLayout:
        """Arrays that the laws read."""
        return PackedLayout(self.solids, self.frame, self.pairs, self.begins, self.between_frames, self.reach)

    @cached_property
    def arrays(self) -> LayoutArrays:
        """The same arrays as a plain tuple."""
        return self.solids, self.frame, self.pairs, self.begins, self.between_frames, self.reach

    @cached_property
    def all_solids(self) -> Indices:
        """(n,) index of each solid."""
        return np.arange(len(self.solids))

    def named(self, group: int) -> PartPair:
        """Return the names of the two parts of a group."""
        a, b = self.groups[group].tolist()
        return self.parts[a], self.parts[b]

    def part(self, name: str) -> int:
        """Return the index of a part.

        Raises:
            InputError: no part has that name.
        """
        if name not in self.parts:
            raise InputError(f"no part is called {name!r}; parts are {', '.join(self.parts)}")
        return self.parts.index(name)

    def between(self, some: Collection[str], others: Collection[str]) -> Mask:
        """Return a mask (g,): 1 for each group of one part in `some` and one part in `others`."""
        a, b = (np.isin(self.groups, [self.part(name) for name in names]) for names in (some, others))
        return ((a[:, 0] & b[:, 1]) | (a[:, 1] & b[:, 0])).astype(np.uint8)

    def carried(self, frames: Collection[str]) -> Mask:
        """Return a mask (g,): 1 for each group with a part in one of these frames.

        Raises:
            InputError: a frame is not in the layout.
        """
        unknown = set(frames) - set(self.frames)
        if unknown:
            raise InputError(f"no frame is called {min(unknown)!r}; frames are {', '.join(self.frames)}")
        inside = np.isin(self.part_frame, [self.frames.index(name) for name in frames])
        return np.asarray(inside[self.groups[:, 0]] | inside[self.groups[:, 1]], np.uint8)

    def parts_in(self, frame: str) -> tuple[str, ...]:
        """Return the names of the parts in a frame."""
        return tuple(part for part, k in zip(self.parts, self.part_frame, strict=True) if self.frames[k] == frame)


def layout_of(frames: tuple[str, ...], solids: Sequence[Solid], part_pairs: Iterable[PartPair]) -> Layout:
    """Check and pack the solids of a run.

    Args:
        frames: names of the coordinate frames, in the order of the rows of the `frames` arrays.
        solids: all solids, including those whose part is in no pair.
        part_pairs: the monitored pairs of parts, each pair once.

    Raises:
        InputError: a solid is not a convex hexahedron or its frame is unknown; a part has solids in two frames; a pair
            is listed twice, names an unknown part, or has two parts in the same frame.
    """
    home: dict[str, str] = {}
    for solid in solids:
        if solid.frame not in frames:
            raise InputError(f"{solid.part}: no frame is called {solid.frame!r}; frames are {', '.join(frames)}")
        if home.setdefault(solid.part, solid.frame) != solid.frame:
            raise InputError(
                f"{solid.part} has solids in {home[solid.part]} and in {solid.frame}; a part has one frame"
            )
    parts = tuple(home)
    of_part: dict[str, list[int]] = {part: [] for part in parts}
    for k, solid in enumerate(solids):
        of_part[solid.part].append(k)
    groups: list[PartPair] = []
    for a, b in part_pairs:
        _check_pair(a, b, home)
        if (a, b) in groups or (b, a) in groups:
            raise InputError(f"{a} – {b}: this pair is listed twice")
        groups.append((a, b))
    pairs = [list(product(of_part[a], of_part[b])) for a, b in groups]
    part_frame = _fixed([frames.index(frame) for frame in home.values()])
    indices = _fixed([(parts.index(a), parts.index(b)) for a, b in groups]).reshape(-1, 2)
    packed, frame_of = _packed(solids), _fixed([frames.index(solid.frame) for solid in solids])
    reach = np.zeros(len(frames))
    np.maximum.at(reach, frame_of, lengths(packed[:, CENTRE : CENTRE + 3]) + packed[:, RADIUS])
    reach.flags.writeable = False
    return Layout(
        frames,
        parts,
        part_frame,
        packed,
        frame_of,
        indices,
        _fixed([pair for group in pairs for pair in group]).reshape(-1, 2),
        _fixed(np.cumsum([0, *map(len, pairs)])),
        _fixed(part_frame[indices]),
        reach,
    )


def _check_pair(a: str, b: str, home: dict[str, str]) -> None:
    """Reject a pair of parts that cannot be monitored (InputError)."""
    for part in (a, b):
        if part not in home:
            raise InputError(f"{a} – {b}: no solid belongs to {part!r}; parts are {', '.join(home)}")
    if home[a] == home[b]:
        raise InputError(f"{a} – {b}: both are fixed to {home[a]} and cannot move relative to each other")


def _packed(solids: Sequence[Solid]) -> Array:
    """Return packed solids (n, 52): bodies with their bounding spheres.

    The centre of a sphere is the centre of the solid's bounding box.
    """
    vertices = np.array([solid.vertices for solid in solids], dtype=np.float64).reshape(-1, VERTICES, 3)
    middle = 0.5 * (vertices.min(axis=1) + vertices.max(axis=1))
    radius = lengths(vertices - middle[:, None]).max(axis=1) + _ROOM
    packed = np.hstack([hexahedra(vertices, [solid.part for solid in solids]), middle, radius[:, None]])
    packed.flags.writeable = False
    return packed


def _fixed(numbers: object) -> Indices:
    found = np.array(numbers, dtype=np.int64)
    found.flags.writeable = False
    return found
