"""TABLES IV, VII and VIII, and Figure 19: clusters, planes, trees and permanent lists of RMS-VS.

Source: Remote Manipulator Simulation, final report, chapter V.C. The scan of Figures 19 and 20 is legible in parts.
What it shows: the tree Y2, the clusters 16 to 19 with their order of insertion in X1, the names and the systems of the
trees, and that Z1 is a part of Z2. TABLE VIII shows the system of planes 1, 7 to 9, 11, 12, 15, 16 and D3. All else is
our reading (probable) or our choice (assumed); `docs/mainprior.md` lists both. Numbers above 21 (clusters) and above 16
(planes) are ours, for shapes that the report's model did not have.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final, Literal, NamedTuple, TypeAlias

from aftdeck.mainprior.trees import Sorted, Split

System = Literal["LR", "L0", "L1", "L2", "LP", "LW", "LS"]
"""Coordinate systems, under the names of their L vectors (TABLE V)."""
CODES: Final[Mapping[System, int]] = {
    "LR": 0b000,
    "L0": 0b001,
    "L1": 0b010,
    "L2": 0b011,
    "LP": 0b100,
    "LW": 0b101,
    "LS": 0b110,
}
"""L vector select codes, TABLE IV. LW (wrist heading, for a housing) and LS (`space`, for a CAE that the orbiter
leaves) are ours."""


class Numbered(NamedTuple):
    """Cluster of the report, as a part of our worksite.

    Attributes:
        part: name of the part; ``{payload}`` stands for the payload's name.
        system: coordinate system in which the cluster is fixed.
    """

    part: str
    system: System


CLUSTERS: Final[Mapping[int, Numbered]] = {
    1: Numbered("cabin", "LR"),
    2: Numbered("wing port", "LR"),
    3: Numbered("bay wall port", "LR"),
    4: Numbered("bay floor", "LR"),
    6: Numbered("bay wall starboard", "LR"),
    7: Numbered("wing starboard", "LR"),
    8: Numbered("aft body", "LR"),
    10: Numbered("tail", "LR"),
    11: Numbered("{payload} probe", "LP"),
    12: Numbered("stand", "LR"),
    13: Numbered("upper boom", "L0"),
    14: Numbered("lower boom", "L1"),
    15: Numbered("stub", "L2"),
    16: Numbered("fixed finger", "L2"),
    17: Numbered("palm", "L2"),
    18: Numbered("prong", "L2"),
    19: Numbered("{payload} receptacle", "LP"),
    20: Numbered("{payload}", "LP"),
    21: Numbered("CAE", "LS"),
    22: Numbered("shoulder", "L0"),
    23: Numbered("elbow", "L1"),
    24: Numbered("wrist", "LW"),
    25: Numbered("nose", "LR"),
    26: Numbered("telescope", "LR"),
}
"""Clusters by their numbers. 1 to 12 are read from TABLE VII and Y2 (probable); 16 to 19 and 21 are the report's; 11,
13 to 15 and 20 are assumed; 22 to 26 are ours."""
BESIDE: Final[Mapping[int, tuple[int, ...]]] = {1: (1, 25), 12: (26, 12)}
"""Clusters of ours that share the place of one cluster of the report: its cabin has a nose, its STAND a telescope."""

_SYSTEMS: Final[Mapping[str, System]] = {
    **dict.fromkeys(("18", "19"), "L0"),
    **dict.fromkeys(("11", "20", "21"), "L1"),
    **dict.fromkeys(("12", "13", "14", "15", "22"), "L2"),
    **dict.fromkeys(("8", "9"), "LP"),
}
"""L vectors for the tests of planes that are not in R, TABLE VIII. 13 and 14 are illegible: L2, as for 12 and 15 around
them."""


def system_of(plane: str) -> System:
    """Return the system in which a plane is tested: R, unless TABLE VIII has another one."""
    return _SYSTEMS.get(plane, "LR")


BISECTING = ("11", "12")
"""Planes that bisect the bends of the arm (Figure 14)."""
RECEIVED = ("D1", "D2", "D3")
"""Planes that the collision program sends: between HEX 1 to 3 and the bar."""

X1 = Sorted(Split("14", 17, Split("15", 16, 18)), 19, (("D1", (17,)), ("D2", (16,)), ("D3", (18,))))
"""End effector and bar: 17 is the palm, 16 and 18 are the fingers; D1 to D3 are tested in this order."""
_HAND = Sorted(
    Split("12", Split("13", X1, 15), 14), 24, (("21", (14,)), ("22", (15, 16, 17, 18, 19)))
)  # the housing of the wrist is on both sides of plane 12
Z1 = Sorted(
    Split("11", _HAND, Split("18", 13, 22)), 23, (("19", (13, 22)), ("20", (14, 24, 15, 16, 17, 18, 19)))
)  # the housing of the elbow is on both sides of plane 11
"""Arm without payload."""
_BODY = Split("9", 11, 20)
Z2 = Split("8", Z1, _BODY)
"""Arm with payload."""
_SIDES = Split("7", 2, 3), Split("6", 7, 6)
Y2 = Split("1", Split("4", 1, Split("5", 8, Split("2", _SIDES[0], Split("3", _SIDES[1], 4)))), (10, 12))
"""Shuttle without payload: the whole tree is legible, but for one leaf (4)."""
Y1 = Split(
    "1",
    Split("4", 1, Split("5", 8, Split("2", _SIDES[0], Split("3", _SIDES[1], Split("17", _BODY, 4))))),
    (10, 12),
)
"""Shuttle with payload: Y2 with the payload over the floor (assumed: the scan shows LP, and all others LR)."""
W1 = Split("16", (12, 1), (10, 8))
"""Shuttle front and rear (assumed: the scan shows its name only; plane 16 is in no other tree)."""

TREES: Final[Mapping[str, Split | Sorted]] = {"Z1": Z1, "Z2": Z2, "Y1": Y1, "Y2": Y2, "W1": W1}


class Tested(NamedTuple):
    """Reference to a tree with a mode test (Figure 15b).

    Attributes:
        kind: tree type: Z, manipulator arm; Y, shuttle.
        limit: mode upper limit: up to this mode it is tree number 1, above it tree number 2.
    """

    kind: Literal["Z", "Y"]
    limit: int

    def tree(self, mode: int) -> str:
        """Return the name of the tree in a mode."""
        return f"{self.kind}{1 if mode <= self.limit else 2}"


Item: TypeAlias = int | str | Tested
"""Entry of a permanent list: a cluster, the name of a tree, or a tree with a mode test."""


def tree_name(item: Item, mode: int) -> str:
    """Return the name of an entry's tree in a mode; empty for a cluster."""
    if isinstance(item, Tested):
        return item.tree(mode)
    return item if isinstance(item, str) else ""


LISTS: Final[Mapping[str, tuple[Item, ...]]] = {
    "A": (12, 1, "Z2", 4, 3, 2, 6, 7, 10, 8, 21),
    "B": (3, "Z2", 2, 4, 6, 7, "W1", 21),
    "C": (10, 8, "Z2", 12, 4, 3, 2, 6, 7, 1, 21),
    "D": (6, "Z2", 7, 4, 3, 2, "W1", 21),
    "E": (12, 1, "Z2", 4, 3, 2, 6, 7, 10, 8, 21),
    "F": (Tested("Z", 1), Tested("Y", 1), 21),
    "G": (Tested("Z", 1), Tested("Y", 1), 21),
    "H": (21, Tested("Z", 2), Tested("Y", 2)),
    "I": (12, 1, 21, "Z2", 4, 3, 2, 6, 7, 10, 8),
}
"""Permanent priority lists of the station points, TABLE VII; highest priority first. In B, the scan has 17 for 7."""


def text(item: Item) -> str:
    """Return an entry of a list as in TABLE VII."""
    return item.kind if isinstance(item, Tested) else "Z" if item == "Z2" else str(item)
