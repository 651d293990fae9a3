"""The subroutines of JSC-12628, one call each, in the report's symbols.

A thin layer over the compiled laws that the simulation flies, without a formula of its own. Where the simulation
differs from the source, these calls are the source's (a scenario's ``strict``): VCLOSE and AVCLMT as restored, RMANGS's
own branch, no stops of joints.

Lengths are metres, or feet with ``units="ft"``; angles are radians, times seconds. Vectors and rotations are in the
report's orbiter frame B unless said otherwise. A rotation T_BN has the axes of frame N as its columns, in B. Joint
angles are the operator's: those of the report, but for the offsets of an elbow that lies beneath the boom line.

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
