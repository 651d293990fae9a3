"""Planes D1 to D3 as the scene program has them: those that it received, or, without these, planes of a frame.

The normals point from the hexahedron to the bar. The collision program sends no plane for a hexahedron that touches the
bar. The scene program then keeps the last one, because the report's collision program leaves a colliding hexahedron's
plane as it was (COLLIDE does not reach SPTSG).
"""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.historical.frame_words import WordPlane
from aftdeck.historical.rms_vs_output import INNER, Planes
from aftdeck.mainprior.shapes import BAR, Body, Stage
from aftdeck.mainprior.tables import X1
from aftdeck.scene.solids import RIMS
from aftdeck.visual.planes import plane_of
from aftdeck.visual.store import Polyhedron, store_of

HEXES = tuple(others[0] for _, others in X1.tests)
"""Clusters of HEX 1, HEX 2 and HEX 3."""
NONE: Planes = (None, None, None)
"""Planes before the first ones are received, or without a bar."""


def kept(last: Planes, sent: Planes) -> Planes:
    """Return the planes that the scene program has after a step, from those before it and those sent in it."""
    first, second, third = (old if new is None else new for old, new in zip(last, sent, strict=True))
    return first, second, third


def planes_in(stage: Stage, held: bool) -> Planes:
    """Return planes D1 to D3 of a frame, in R.

    About a held bar they are the inner faces of HEX 1 to 3, as in `historical.rms_vs_output`; otherwise, planes that
    separate the hexahedra and the bar, or that cut least of them where these overlap.

    Args:
        stage: the frame.
        held: whether the bar is acquired.
    """
    if BAR not in stage.bodies:
        return NONE
    bar = stage.bodies[BAR]
    first, second, third = (
        _word_plane(stage.bodies[cluster].faces[face] if held else _between(stage.bodies[cluster], bar))
        for cluster, face in zip(HEXES, INNER, strict=True)
    )
    return first, second, third


def _between(a: Body, b: Body) -> Array:
    found = np.empty(4)
    plane_of(store_of([Polyhedron(body.points, body.faces, RIMS) for body in (a, b)]), 0, 1, found)
    return found


def _word_plane(plane: Array) -> WordPlane:
    x, y, z, distance = plane.tolist()
    return WordPlane((x, y, z), distance)
