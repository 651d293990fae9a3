"""What is found of each watched group in a step: a row of numbers, in L."""

from __future__ import annotations

CLEARANCE = 0
"""The least clearance of the group's solids, negative where they overlap [m]; inf where the group does not count."""
SPEED = 1
"""How fast that clearance closes, positive as they approach [m/s]."""
POINT_A, POINT_B = 2, 5
"""The closest points, of the first and the second part [m]."""
NORMAL, DISTANCE = 8, 11
"""The plane square to the shortest way, halfway: unit normal from the first to the second part [1], distance [m].

Of solids in contact the way is that which takes them apart, and the plane does not separate them; of all others it
does, with all sixteen vertices of the two solids looked at.
"""
FEATURE_A, FEATURE_B = 12, 13
"""What penetrates, touches or is closest, as in `aftdeck.bodies.pair`."""
WHICH = 14
"""Which pair of solids of the layout it is."""
FOUND = 15
"""Length of a row."""
