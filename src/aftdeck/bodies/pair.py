"""Packed record of a pair of hexahedra: its last measurement, from which the next search starts.

A record of zeros belongs to a pair that was never measured. A record that is old, or that belongs to other bodies, may
change the speed of the next measurement and the last digits of the clearance. It never changes a verdict.
"""

from __future__ import annotations

CONTACT = 1e-9
"""Greatest clearance at which bodies count as in contact [m] (assumed). When two faces exactly touch, rounding decides
the sign of the clearance."""

CLEARANCE = 0
"""Distance between the bodies [m]; if they overlap, the negative of the penetration depth."""
POINT_A, POINT_B = 1, 4
"""Closest point of body a, and of body b [m]."""
NORMAL, DISTANCE = 7, 10
"""Separating plane: its unit normal from a to b [1], and its distance from the origin [m]. The normal is zero if the
bodies collide or no plane is known."""
FEATURE_A, FEATURE_B = 11, 12
"""Features of a and of b that touch, pierce or are closest. A feature is stored as the sum of 2**(v - 1) over its
vertices v."""
SIZE, SIMPLEX = 13, 14
"""Simplex at which the last search in the Minkowski difference ended: its number of corners (at most 3), and these
corners. A corner is stored as 8 i + j, for vertex i of body a and vertex j of body b, numbered from zero."""
PAIR = 17
"""Number of values in a packed pair."""

WHOLE = 255
"""Feature value of the whole body."""
