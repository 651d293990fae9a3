"""How an arm's hand takes hold of the payloads of a place: constants for the laws of `worksite`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from aftdeck.arms.load import ArmModel
from aftdeck.arrays import Array, Indices
from aftdeck.bodies.pose import row_of
from aftdeck.worksite.acquisition import Tolerances
from aftdeck.worksite.cargo import part_of
from aftdeck.worksite.grapple import CaptureEnvelope
from aftdeck.worksite.model import BarAcquisition, Cargo, SnareCapture, Worksite
from aftdeck.worksite.snare import SnareTimes

HEXES = ("palm", "fixed finger", "prong")
"""HEX 1 to 3."""


@dataclass(frozen=True, eq=False)
class Bar:
    """A prong about a bar.

    Attributes:
        tolerances: of acquisition.
        packed: (5,) the same for the law.
        which: for each cargo, (4,) the layout's solids that are HEX 1 to 3 and its bar; None: it has none.
        fixed_finger: y2 of the fixed finger's inner face [m].
    """

    tolerances: Tolerances
    packed: Array
    which: tuple[Indices | None, ...]
    fixed_finger: float


@dataclass(frozen=True, eq=False)
class Snares:
    """Snares about a grapple fixture's pin.

    Attributes:
        envelope: where the pin may stand.
        times: of the parts.
        fixtures: for each cargo, (12,) its fixture's pose in its axes; None: it has none.
    """

    envelope: CaptureEnvelope
    times: SnareTimes
    fixtures: tuple[Array | None, ...]

    def fixture(self, k: int) -> Array:
        """The fixture of a cargo that has one."""
        fixture = self.fixtures[k]
        assert fixture is not None, "only cargo with a fixture is captured"
        return fixture


def bar_of(model: ArmModel, worksite: Worksite, cargo: tuple[Cargo, ...], parts: Sequence[str]) -> Bar | None:
    """How a prong takes hold here; None: the arm has none, or the place no rules for it. `parts`: of all solids."""
    rule, prong = worksite.acquisition, model.equipment.prong
    if prong is None or not isinstance(rule, BarAcquisition):
        return None
    spacing = rule.prong_spacing + prong.fixed_finger
    tolerances = Tolerances(spacing, rule.window, rule.front, rule.rear, rule.fingers_within)
    return Bar(
        tolerances,
        tolerances.packed(),
        tuple(
            None
            if one.receptacle is None
            else np.array([parts.index(name) for name in (*HEXES, part_of(one.name, "receptacle"))], dtype=np.int64)
            for one in cargo
        ),
        prong.fixed_finger,
    )


def snares_of(worksite: Worksite, cargo: tuple[Cargo, ...]) -> Snares | None:
    """How snares take hold here; None: the place has no rules for them."""
    rule = worksite.acquisition
    if not isinstance(rule, SnareCapture):
        return None
    return Snares(
        CaptureEnvelope(rule.radial, rule.nearest, rule.farthest, rule.pitch, rule.yaw, rule.roll),
        SnareTimes(rule.ring, rule.carriage, rule.tension),
        tuple(None if one.grapple is None else row_of(one.grapple) for one in cargo),
    )
