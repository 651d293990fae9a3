"""Lamps that a frame lights."""

from __future__ import annotations

import msgspec
import pytest

from aftdeck.report.lamps import lit_lamps
from aftdeck.simulation.frame import AT_HARD, FREE, PAST_REACH, PAST_SOFT
from aftdeck.simulation.log import joint_label
from aftdeck.simulation.run import Simulation
from tests.loaded import scenario


@pytest.mark.parametrize("zone", [FREE, PAST_REACH, PAST_SOFT, AT_HARD])
def test_lamps_of_the_limits_name_the_joints_in_their_zone_and_beyond_it(zone: int) -> None:
    loaded = scenario("first-flight")
    frame = Simulation(loaded).look()
    for number, joint in enumerate(loaded.arm.joints):
        zones = tuple(zone if k == number else FREE for k in range(len(frame.zones)))
        lit = {lamp.name: lamp.text for lamp in lit_lamps(loaded, msgspec.structs.replace(frame, zones=zones))}
        expected = [name for name, least in (("REACH LIM", PAST_REACH), ("SOFT STOP", PAST_SOFT)) if zone >= least]
        assert {name: lit.get(name) for name in ("REACH LIM", "SOFT STOP") if name in lit} == dict.fromkeys(
            expected, joint_label(joint)
        )
