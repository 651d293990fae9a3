"""Constants of capture by the end effector, for the laws of `worksite`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from aftdeck.arms.load import ArmModel
from aftdeck.arrays import Array, Indices
from aftdeck.bodies.pose import row_of
from aftdeck.worksite.capture.acquisition import MEASURED, Tolerances, acquire
from aftdeck.worksite.capture.grapple import CaptureEnvelope
from aftdeck.worksite.capture.snare import SnareTimes
from aftdeck.worksite.model import BarAcquisition, SnareCapture, Worksite
from aftdeck.worksite.payload import Cargo, part_of

HEXES = ("palm", "fixed finger", "prong")
"""Parts of the concept arm's end effector: HEX 1 to 3."""


@dataclass(frozen=True, eq=False)
class Bar:
    """Constants of capture by a prong about a bar.

    Attributes:
        tolerances: tolerances of acquisition.
        packed: (5,) `tolerances` as an array for the law.
        bars: (c, 4) for each payload, the indices of four solids in the layout: HEX 1, HEX 2, HEX 3 and the payload's
            bar; -1 for a payload without a bar.
        fixed_finger: y2 of the fixed finger's inner face [m].
    """

    tolerances: Tolerances
    packed: Array
    bars: Indices
    fixed_finger: float

    def solids(self, k: int) -> Indices | None:
        """Return row k of `bars`; None if the payload has no bar."""
        solids: Indices = self.bars[k]
        return None if solids[0] < 0 else solids

    def measured(self, placed: Array, k: int) -> Array | None:
        """Return the measures (9,) of `acquire` for payload k, with all solids at `placed`; None without a bar."""
        if (solids := self.solids(k)) is None:
            return None
        found = np.empty(MEASURED)
        acquire(placed, solids, self.packed, found)
        return found


@dataclass(frozen=True, eq=False)
class Snares:
    """Constants of capture by snares about a grapple fixture's pin.

    Attributes:
        envelope: capture envelope of the pin.
        times: travel times of snares and carriage, and time to rigidize.
        fixtures: for each payload, (12,) pose of its fixture in the payload's axes; None if the payload has no fixture.
    """

    envelope: CaptureEnvelope
    times: SnareTimes
    fixtures: tuple[Array | None, ...]

    def fixture(self, k: int) -> Array:
        """Return the pose (12,) of the fixture of payload k, which must have a fixture."""
        fixture = self.fixtures[k]
        assert fixture is not None, "a captured payload has a fixture"
        return fixture


def bar_of(model: ArmModel, worksite: Worksite, cargo: tuple[Cargo, ...], parts: Sequence[str]) -> Bar | None:
    """Return the constants of capture by a prong; None if the arm has no prong, or the worksite has no rules for it.

    Args:
        model: the arm.
        worksite: the worksite.
        cargo: the payloads.
        parts: for each solid of the layout, the name of its part.
    """
    rule, prong = worksite.acquisition, model.equipment.prong
    if prong is None or not isinstance(rule, BarAcquisition):
        return None
    spacing = rule.prong_spacing + prong.fixed_finger
    tolerances = Tolerances(spacing, rule.window, rule.front, rule.rear, rule.fingers_within)
    bars = np.full((len(cargo), len(HEXES) + 1), -1, dtype=np.int64)
    for row, payload in zip(bars, cargo, strict=True):
        if payload.receptacle is not None:
            row[:] = [parts.index(name) for name in (*HEXES, part_of(payload.name, "receptacle"))]
    return Bar(tolerances, tolerances.packed(), bars, prong.fixed_finger)


def snares_of(worksite: Worksite, cargo: tuple[Cargo, ...]) -> Snares | None:
    """Return the constants of capture by snares; None if the worksite has no rules for snares."""
    rule = worksite.acquisition
    if not isinstance(rule, SnareCapture):
        return None
    return Snares(
        CaptureEnvelope(rule.radial, rule.nearest, rule.farthest, rule.pitch, rule.yaw, rule.roll),
        SnareTimes(rule.ring, rule.carriage, rule.tension),
        tuple(None if payload.grapple is None else row_of(payload.grapple) for payload in cargo),
    )
