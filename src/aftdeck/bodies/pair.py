"""What is remembered of a watched pair, packed: the last answer, which is also where the next search starts.

All zeros is a pair never looked at. What stands in it may be stale or of other bodies: it makes an answer quicker or
slower, never another one.
"""

from __future__ import annotations

CONTACT = 1e-9
"""Greatest clearance of bodies in contact [m]: in exact face contact rounding decides the sign (assumed)."""

CLEARANCE = 0
"""Distance of the bodies, or minus their penetration depth [m]."""
POINT_A, POINT_B = 1, 4
"""The closest pair, a point of each body [m]."""
NORMAL, DISTANCE = 7, 10
"""The separating plane, its unit normal from a to b; a zero normal where they collide, or none is known [1, m]."""
FEATURE_A, FEATURE_B = 11, 12
"""The features that touch, pierce or are closest, each the sum of 2**(v - 1) over its vertices v."""
SIZE, SIMPLEX = 13, 14
"""How many corners of the Minkowski difference span the closest point, at most 3, and which: 8 a + b from zero."""
PAIR = 17
"""Length of a packed pair."""

WHOLE = 255
"""The feature that is the whole body."""
