"""Planes D1 to D3 of a frame, for runs that did not keep what the collision program sent.

They follow the rule of `historical.rms_vs_output`: the inner faces of HEX 1 to 3 about a held bar, and planes of the
collision test otherwise. The normals point from the hexahedron to the bar.
"""

from __future__ import annotations

from aftdeck.bodies.separation import separation
from aftdeck.historical.frame_words import WordPlane
from aftdeck.historical.rms_vs_output import INNER, Planes
from aftdeck.mainprior.shapes import BAR, Stage
from aftdeck.mainprior.tables import X1

HEXES = tuple(others[0] for _, others in X1.tests)
"""Clusters of HEX 1, HEX 2 and HEX 3."""


def received_planes(stage: Stage, held: bool) -> Planes:
    """Return D1 to D3 in R; None where hexahedron and bar touch, or if there is no bar. `held`: the bar is acquired."""
    if BAR not in stage.bodies:
        return None, None, None
    first, second, third = (
        _inner(stage, cluster, face) if held else _tested(stage, cluster)
        for cluster, face in zip(HEXES, INNER, strict=True)
    )
    return first, second, third


def _inner(stage: Stage, cluster: int, face: int) -> WordPlane:
    x, y, z, distance = stage.bodies[cluster].faces[face].tolist()
    return WordPlane((x, y, z), distance)


def _tested(stage: Stage, cluster: int) -> WordPlane | None:
    plane = separation(stage.bodies[cluster].points, stage.bodies[BAR].points).plane
    if plane is None:
        return None
    x, y, z = plane.normal.tolist()
    return WordPlane((x, y, z), plane.distance)
