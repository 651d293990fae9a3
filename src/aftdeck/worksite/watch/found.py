"""Measurements of one group (a monitored pair of parts) in a step: indices of a row of numbers, in L."""

from __future__ import annotations

CLEARANCE = 0
"""Least clearance of the group's solids, negative if they overlap [m]; inf if the group was not measured."""
SPEED = 1
"""Closing speed of that clearance, positive while the parts approach [m/s]."""
POINT_A, POINT_B = 2, 5
"""The closest points, of the first and the second part [m]."""
NORMAL, DISTANCE = 8, 11
"""Plane halfway between the closest points: its unit normal from first to second part [1], and its distance [m].

If the solids are apart, the plane separates all sixteen vertices of the two. If the solids are in contact, the normal
is the direction of the shortest move that separates them, and the plane does not separate them.
"""
FEATURE_A, FEATURE_B = 12, 13
"""Features that penetrate, touch or are closest, as in `aftdeck.bodies.pair`."""
WHICH = 14
"""Index in the layout of the pair of solids with this clearance."""
FOUND = 15
"""Length of a row."""
