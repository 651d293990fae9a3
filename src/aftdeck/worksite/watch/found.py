"""Measurements of one group (a monitored pair of parts) in a step: indices into the group's row. Vectors are in L."""

from __future__ import annotations

CLEARANCE = 0
"""Least clearance of the group's solids, negative if they overlap [m]; inf if the group was not measured."""
POINT_A, POINT_B = 1, 4
"""Closest point of the first part, and of the second part [m]."""
NORMAL, DISTANCE = 7, 10
"""Plane halfway between the closest points: its unit normal from first to second part [1], and its distance from L's
origin [m].

If the solids are apart, the plane separates all eight vertices of one solid from those of the other. If the solids are
in contact, the normal is the direction of the shortest move that separates them, and the plane does not separate them.
"""
FEATURE_A, FEATURE_B = 11, 12
"""Feature of the first part, and of the second part, that penetrates, touches or is closest; `aftdeck.bodies.pair`."""
WHICH = 13
"""Index of the pair of solids with the least clearance, in `Layout.pairs`."""
FOUND = 14
"""Length of a row."""
