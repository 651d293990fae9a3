"""Helpers for tests of surfaces."""

from __future__ import annotations

from collections import Counter

from aftdeck.scene.mesh import Mesh


def closed(surface: Mesh) -> bool:
    """Return whether a mesh is closed: each edge occurs exactly once in each direction."""
    edges = Counter((t[k], t[(k + 1) % 3]) for t in surface.faces.tolist() for k in range(3))
    return all(times == 1 and edges[b, a] == 1 for (a, b), times in edges.items())
