"""Fixtures of the kinematics tests."""

from __future__ import annotations

import pytest

import aftdeck


@pytest.fixture(scope="session")
def arm() -> aftdeck.Arm:
    return aftdeck.load_arm("srms")


@pytest.fixture(scope="session", params=["srms", "concept-1972"])
def any_arm(request: pytest.FixtureRequest) -> aftdeck.Arm:
    """An arm of each family."""
    return aftdeck.load_arm(request.param)
