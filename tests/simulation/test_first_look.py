"""Frame before the first step: it shows the arm where the first step shows it."""

from __future__ import annotations

import msgspec
import numpy as np
import pytest

import aftdeck
from aftdeck.scenario.load import built_in

PLACES = ("position", "orientation", "resolution", "angles", "singularity")
"""Fields of a frame that a first step without inputs changes by less than MOST."""
MOST = 0.02
"""Greatest change in a control period [m, 1, rad]: the arm's parts move by less than 1 m/s."""


@pytest.mark.parametrize("name", built_in())
def test_frame_before_the_first_step_shows_the_arm_where_the_step_finds_it(name: str) -> None:
    sim = aftdeck.Simulation(name)
    before, after = sim.look(), sim.step(aftdeck.Inputs())
    fields = {field.name for field in msgspec.structs.fields(type(after))}
    for place in PLACES:
        assert place in fields
        np.testing.assert_allclose(getattr(before, place), getattr(after, place), atol=MOST, err_msg=place)
