"""Fit the springs of the Shuttle's arm to its published frequencies, for several masses of the heavy payload.

The published table has the straight arm without and with a heavy payload, which it does not describe, on a fixed and on
a free orbiter. The command prints, for each mass of a uniform cylinder across the arm, the rms error of the 24
frequencies and the ten stiffnesses of [flexibility] in srms.toml. Of equally good fits, the one nearest to the present
stiffnesses is taken.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import mujoco
import numpy as np
from scipy.optimize import least_squares

from aftdeck.arms.load import ArmModel, load_model
from aftdeck.arms.masses import flexibility_needed
from aftdeck.arrays import Array
from aftdeck.plant.multibody.build import arm_spec, attach
from aftdeck.plant.multibody.frequencies import RIGID_MODES, matrices, natural_frequencies
from aftdeck.plant.multibody.view import View
from aftdeck.plant.usual_payload import usual_payload
from aftdeck.units import INCH, POUND
from aftdeck.worksite.model import OrbiterMass

PUBLISHED = {
    (False, False): (0.346, 0.461, 3.554, 4.228, 14.98, 15.14),
    (False, True): (0.355, 0.463, 3.557, 4.230, 15.00, 15.14),
    (True, False): (0.0274, 0.0329, 0.0578, 0.1399, 0.4383, 2.976),
    (True, True): (0.0439, 0.0591, 0.0719, 0.1431, 0.4405, 3.499),
}
"""Frequencies, by whether the arm has the payload and whether the orbiter is free [Hz]."""
EMPTY = OrbiterMass(85e3, (1.02e6, 7.82e6, 8.16e6), (1097 * INCH, 0.0, 375 * INCH))
"""Empty orbiter."""
MASSES = (28_000, 32_000, 36_000, 40_000, 45_000, 50_000, 55_000, 65_000)
"""Masses of the payload [lb]."""
PITCH = 1
KEPT = 0.004
"""Weight of a stiffness that is twice or half the present one, as an error of a frequency [1]."""
NAMES = ("shoulder", "elbow", "wrist", "EI 1", "EI 2", "GJ 1", "GJ 2", "base x", "base y", "base z")


class Case(NamedTuple):
    """Arm in one row of the published table.

    Attributes:
        mass: mass matrix.
        share: for each degree of freedom, its stiffness divided by that of its spring, in the column of the spring.
        rigid: number of modes without frequency.
        published: frequencies [Hz].
    """

    mass: Array
    share: Array
    rigid: int
    published: Array

    def errors(self, springs: Array) -> Array:
        """Return the relative errors of the frequencies with these stiffnesses."""
        found = natural_frequencies(self.mass, np.diag(self.share @ springs))
        return found[self.rigid : self.rigid + 6] / self.published - 1.0


def springs_of(arm: ArmModel) -> Array:
    """Return the present stiffnesses, as in `NAMES`."""
    f = flexibility_needed(arm)
    return np.array([*f.gearboxes[[0, 2, 3]], *f.bending, *f.torsion, *f.base])


def cases(arm: ArmModel, pounds: float) -> Iterator[Case]:
    """Yield the cases of the published table, with a payload of this mass."""
    for (loaded, free), published in PUBLISHED.items():
        spec = arm_spec(arm, flexible=True, orbiter=EMPTY.in_l(arm.mount) if free else None)
        if loaded:
            attach(spec, usual_payload(pounds * POUND, PITCH))
        view = View(spec.compile(), arm)
        forward = np.array([math.pi if free else 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])
        view.set_joints(forward, np.zeros(6), float(arm.links[0]))
        mujoco.mj_forward(view.model, view.data)
        mass, stiffness = matrices(view)
        present, column = springs_of(arm), [_spring(name, arm.joints) for name in _names(view)]
        share = np.zeros((len(mass), len(NAMES)))
        for row, which in enumerate(column):
            if which is not None:
                share[row, which] = stiffness[row, row] / present[which]
        yield Case(mass, share, RIGID_MODES if free else 0, np.array(published))


def _names(view: View) -> list[str]:
    """Return the name of the joint of each degree of freedom that no motor moves."""
    model = view.model
    free = np.setdiff1d(np.arange(model.nv), view.motor_rates)
    return [model.joint(model.dof_jntid[k]).name for k in free]


def _spring(name: str, joints: tuple[str, ...]) -> int | None:
    """Return the number of a joint's spring in `NAMES`; None for the free orbiter."""
    kind, _, rest = name.partition(".")
    if kind == "gearbox":
        return (0, 0, 1, 2, 2, 2)[joints.index(rest)]
    if kind == "base":
        return 7 + "xyz".index(rest)
    if kind in ("upper_boom", "lower_boom"):
        return (5 if rest == "torsion" else 3) + (kind == "lower_boom")
    return None


def main() -> None:
    """Print the fits."""
    arm = load_model("srms")
    present = np.log(springs_of(arm))
    print(f"| payload, lb | rms, % | greatest, % | {' | '.join(NAMES)} |")
    print(f"|---{'|---' * (len(NAMES) + 2)}|")
    for pounds in MASSES:
        rows = list(cases(arm, pounds))

        def errors(x: Array, rows: list[Case] = rows) -> Array:
            return np.concatenate([row.errors(np.exp(x)) for row in rows])

        def weighed(x: Array) -> Array:
            return np.concatenate([errors(x), KEPT * (x - present) / math.log(2.0)])

        found = least_squares(weighed, present).x
        off = 100.0 * errors(found)
        values = " | ".join(f"{value:.2g}" for value in np.exp(found))
        print(f"| {pounds:,} | {np.sqrt(np.mean(off**2)):.1f} | {np.abs(off).max():.0f} | {values} |", flush=True)


if __name__ == "__main__":
    main()
