"""Subroutines of JSC-12628: one function for each subroutine, with the report's symbols.

The package contains no formulas: it calls the simulation's compiled laws. Where the simulation differs from the report,
these functions follow the report, like a scenario with ``strict``. VCLOSE and AVCLMT are as published, RMANGS returns
only the report's branch, and joints have no stops.

Lengths are in metres, or in feet with ``units="ft"``; angles are in radians, times in seconds. Vectors and rotations
are in the report's orbiter frame B unless stated otherwise. The columns of a rotation T_BN are the axes of frame N, in
B. Joint angles are the angles on the panel. They equal the report's angles, except on an arm whose elbow is below the
line from shoulder pitch to wrist pitch. On such an arm, some angles differ from the report's by constants. A
rotation may differ from an orthonormal matrix by 1e-6 in each element of R R^T.

Example:
    >>> import numpy as np
    >>> from aftdeck import jsc12628, load_arm
    >>> arm, theta = load_arm("srms"), np.radians([0, 40, -60, -10, 20, 5])
    >>> r_6B, T_B7, _ = jsc12628.lnkage(arm, theta, units="ft")
    >>> bool(np.allclose(jsc12628.rmangs(arm, r_6B, T_B7, units="ft"), theta))
    True
"""

from aftdeck.jsc12628.limits import Ratlmt, Vtopen, Wanted, avclmt, ratlmt, votran
from aftdeck.jsc12628.linkage import (
    Erates,
    Lnkage,
    LnkagePayload,
    Rmsist,
    erates,
    jacobi,
    lnkage,
    rmangs,
    rmsist,
    rmsrat,
)
from aftdeck.jsc12628.orientation import endori, oriend
from aftdeck.jsc12628.quantities import Units
from aftdeck.jsc12628.steering import Msteer, Phase, msteer, operin
from aftdeck.jsc12628.trajectory import Latraj, Vclose, latraj, vclose, vtopen

__all__ = [
    "Erates",
    "Latraj",
    "Lnkage",
    "LnkagePayload",
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
