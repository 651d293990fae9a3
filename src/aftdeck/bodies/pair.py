"""Packed record of a pair of hexahedra: its last measurement, from which the next search starts.

A record of all zeros is a pair that was never measured. A record may be old or belong to other bodies: this may
change the speed of the next measurement and the last digits of its clearance, but no verdict.
"""

from __future__ import annotations

CONTACT = 1e-9
"""Greatest clearance of bodies in contact [m] (assumed); in exact face contact, rounding decides the sign."""

CLEARANCE = 0
"""Distance of the bodies, or minus their penetration depth [m]."""
POINT_A, POINT_B = 1, 4
"""Closest points, one of each body [m]."""
NORMAL, DISTANCE = 7, 10
"""Separating plane: its unit normal from a to b [1], and its distance [m]. The normal is zero if the bodies collide or
no plane is known."""
FEATURE_A, FEATURE_B = 11, 12
"""Features that touch, pierce or are closest, each stored as the sum of 2**(v - 1) over its vertices v."""
SIZE, SIMPLEX = 13, 14
"""Number of corners of the Minkowski difference that span the closest point, at most 3, and these corners, each
stored as 8 a + b, with the vertices a and b numbered from zero."""
PAIR = 17
"""Length of a packed pair."""

WHOLE = 255
"""Feature value of the whole body."""
