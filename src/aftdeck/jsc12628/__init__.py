"""Subroutines of JSC-12628, one function each, in the report's symbols.

The package is a thin layer over the simulation's compiled laws, without a formula of its own. Where the simulation
differs from the source, these functions follow the source (a scenario's ``strict``): VCLOSE and AVCLMT as published,
RMANGS's own branch, no joint stops.

Lengths are metres, or feet with ``units="ft"``; angles are radians, times seconds. Vectors and rotations are in the
report's orbiter frame B unless stated otherwise. A rotation T_BN has the axes of frame N as its columns, in B. Joint
angles are the operator's: those of the report, except for the offsets of an elbow that lies beneath the boom line.

Example:
    >>> import numpy as np
    >>> from aftdeck import jsc12628, load_arm
    >>> arm, theta = load_arm("srms"), np.radians([0, 40, -60, -10, 20, 5])
    >>> r_6B, T_B7, _ = jsc12628.lnkage(arm, theta, units="ft")
    >>> bool(np.allclose(jsc12628.rmangs(arm, r_6B, T_B7, units="ft"), theta))
    True
"""

from aftdeck.frames import endori, oriend
from aftdeck.jsc12628.limits import Ratlmt, Vtopen, Wanted, avclmt, ratlmt, votran
from aftdeck.jsc12628.linkage import (
    Erates,
    Lnkage,
    Rmsist,
    erates,
    jacobi,
    lnkage,
    rmangs,
    rmsist,
    rmsrat,
)
from aftdeck.jsc12628.quantities import Units
from aftdeck.jsc12628.steering import Msteer, Phase, msteer, operin
from aftdeck.jsc12628.trajectory import Latraj, Vclose, latraj, vclose, vtopen

__all__ = [
    "Erates",
    "Latraj",
    "Lnkage",
    "Msteer",
    "Phase",
    "Ratlmt",
    "Rmsist",
    "Units",
    "Vclose",
    "Vtopen",
    "Wanted",
    "avclmt",
    "endori",
    "erates",
    "jacobi",
    "latraj",
    "lnkage",
    "msteer",
    "operin",
    "oriend",
    "ratlmt",
    "rmangs",
    "rmsist",
    "rmsrat",
    "vclose",
    "votran",
    "vtopen",
]
