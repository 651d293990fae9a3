"""Vector from the empty snares to the nearest grapple fixture."""

from __future__ import annotations

import math

import numpy as np

from aftdeck.arrays import Array
from aftdeck.scenario.model import Scenario
from aftdeck.worksite.report import Work


class Fixtures:
    """Grapple fixtures of a scenario's payloads."""

    def __init__(self, scenario: Scenario) -> None:
        self._panel_axes = scenario.arm.model.mount.rotation
        self._fixtures = {cargo.name: cargo.grapple.position for cargo in scenario.cargo if cargo.grapple is not None}

    def nearest(self, work: Work, tip: Array) -> Array | None:
        """Return the (3,) vector from the empty snares to the nearest fixture, in panel components [m].

        Returns:
            The vector; None if the arm has no snares, a payload is held, or no payload has a grapple fixture.
        """
        if work.hand.carriage is None or any(cargo.held for cargo in work.cargo):
            return None
        vectors = (
            np.array(cargo.position) + np.array(cargo.orientation) @ self._fixtures[cargo.name] - tip
            for cargo in work.cargo
            if cargo.name in self._fixtures
        )
        nearest = min(vectors, key=lambda vector: math.hypot(*vector.tolist()), default=None)
        return None if nearest is None else self._panel_axes @ nearest
