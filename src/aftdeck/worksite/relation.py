"""Relations: relative positions of two parts in which their contact is essential.

Source: *Remote Manipulator Simulation*, final report, chapter IV.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import msgspec

from aftdeck.arrays import Indices

Relation = Literal["acquisition", "docking", "guides", "capture"]
"""Name of a relation: a relative position of two parts in which their contact is essential. The four relations are
those at the bar, the port, the V-guides and the grapple fixture."""
ALIGNED: frozenset[Relation] = frozenset({"docking", "guides"})
"""Relations to which alignment applies: their parts are aligned before they touch."""
FITTING_OF: dict[Relation, str] = {
    "acquisition": "receptacle",
    "docking": "probe",
    "guides": "trunnions",
    "capture": "grapple fixture",
}
"""For each `Relation`, the payload's fitting to which this relation applies."""


class Essential(msgspec.Struct, frozen=True):
    """Two parts whose contact is essential while the parts are in a certain relation."""

    parts: tuple[str, str]
    """Names of the two parts: one part of a payload, and one part of the arm or of a body."""
    relation: Relation
    """Name of the relation. In any other relative position, a contact of the two parts is detrimental."""
    depth: float
    """Greatest penetration depth at which the contact is essential [m]. The test of the relation also uses this value:
    a part may be this far beyond the planes that bound its position."""


@dataclass(frozen=True, eq=False)
class Meeting:
    """Monitored pair of two parts that the task brings into contact.

    Attributes:
        group: index of the pair in the layout.
        payload: index of the payload to which one of the parts belongs.
        relation: name of the relative position in which the two parts may touch.
        depth: permitted penetration depth, and permitted distance past the plane of contact, such as a port's face [m].
        pairs: (m, 2) the pairs of the two parts' solids.
        trunnions: (m,) index of the trunnion that belongs to each pair of solids; (0,) if the relation is not "guides".
    """

    group: int
    payload: int
    relation: Relation
    depth: float
    pairs: Indices
    trunnions: Indices
