"""No lens is ever inside a solid: not in any scripted mission, and not in a task that an operator flies."""

from __future__ import annotations

from itertools import product
from pathlib import Path

import numpy as np
import pytest

from aftdeck.bodies.cameras import Camera, Setting, setting, view
from aftdeck.operators.pilot import pilot
from aftdeck.operators.spec import OperatorSpec
from aftdeck.scenario.all_cameras import cameras_of
from aftdeck.scenario.load import built_in, load_scenario
from aftdeck.simulation.constants.site import all_solids, site_of
from aftdeck.simulation.run import Simulation
from aftdeck.simulation.survey.lenses import Lenses, lenses_along, lenses_in_script, without_housing
from aftdeck.worksite import load_worksite
from aftdeck.worksite.file.check import distance
from tests import loaded
from tests.scenario.missions import SCRIPTED, but_very_long

MISSION = "concept-1972-script"
LONGEST = {
    ("dimensions", "payload_length"): "60 ft",
    ("dimensions", "payload_width"): "15 ft",
    ("dimensions", "bay_length"): "62 ft",
    ("dimensions", "bay_width"): "17 ft",
}
"""The report's largest payload, in a bay that holds it."""
OUTSIDE = 0.02
"""Greatest distance of a lens from the solid that contains it by design [m]; the lenses of the Shuttle
arm's cameras are a little ahead of the covers."""


@pytest.mark.slow
@pytest.mark.parametrize("name", but_very_long(SCRIPTED))
def test_no_lens_is_inside_a_solid_while_a_script_runs(name: str) -> None:
    assert lenses_along(Simulation(name, digests=False)) == ()


@pytest.mark.slow
def test_no_lens_is_inside_a_solid_with_the_largest_payload() -> None:
    sim = Simulation(load_scenario(MISSION, LONGEST), digests=False)
    assert lenses_along(sim) == ()
    assert sim.ended == "completed"


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["perfect", "human"])
@pytest.mark.parametrize("name", ["concept-1972", "free-flyer"])
def test_no_lens_is_inside_a_solid_while_an_operator_flies(name: str, kind: str) -> None:
    scenario = loaded.scenario(name)
    operator = pilot(scenario, OperatorSpec(kind), 1)  # type: ignore[arg-type]
    assert lenses_along(Simulation(scenario, digests=False), operator) == ()


@pytest.mark.parametrize("name", built_in())
def test_every_camera_is_in_a_housing_that_collides(name: str) -> None:
    scenario = loaded.scenario(name)
    assert not list(without_housing(scenario))
    frames, bodies = site_of(scenario).layout.frames, {body.name: body for body in scenario.worksite.bodies}
    for camera in cameras_of(scenario):
        if camera.kind == "engineering":
            continue
        body = bodies.get(camera.body)
        own = [solid for solid in all_solids(scenario) if solid.part == camera.housing]
        assert {solid.frame for solid in own} == {body.fixed_to if body else camera.body} <= set(frames)
        for at in ends(camera) if not camera.inside else [setting(camera)]:
            lens = np.array(view(camera, at).position)
            lens = body.pose.rotation @ lens + body.pose.position if body else lens
            away = min(distance(lens, solid.vertices) for solid in own)
            assert away <= (OUTSIDE if camera.inside else 0.0), (camera.name, at)


def ends(camera: Camera) -> list[Setting]:
    """Return settings all over the travels of a camera's pan and tilt."""
    first = setting(camera)
    if camera.drive is None:
        return [first]
    pans, tilts = (
        [at] if travel is None else list(np.linspace(travel.least, travel.greatest, 13))
        for travel, at in ((camera.drive.pan, first.pan), (camera.drive.tilt, first.tilt))
    )
    return [Setting(pan, tilt, first.zoom) for pan, tilt in product(pans, tilts)]


def test_a_lens_in_the_way_of_a_payload_is_found(tmp_path: Path) -> None:
    """Camera B, without a housing and as high as the payload's middle, on the way to the port."""
    text = load_worksite("concept-1972").text
    was = '"= -bay_side - wall / 2", "0.45 ft"]'
    assert text.count(was) == 1
    text = text.replace(was, '"= -bay_side - wall / 2", "9 ft"]').replace('"camera B"', '"B"')
    begin = text.index('[[camera]]\nname = "B"')
    text = text[:begin] + text[begin:].replace('drive = "station"\n', "", 1)
    (tmp_path / "site.toml").write_text(text)
    mission = loaded.scenario(MISSION).text.replace('worksite = "concept-1972"', 'worksite = "site.toml"')
    (tmp_path / "mission.toml").write_text(mission)
    scenario = load_scenario(tmp_path / "mission.toml")
    found = lenses_along(Simulation(scenario, digests=False))
    assert {(inside.camera, inside.part) for inside in found} == {("B", "payload")}
    assert found[0].seconds > 4.0 and found[0].depth > 0.03
    assert len(list(lenses_in_script(scenario))) == 1
    assert ["camera B" in problem.what for problem in without_housing(scenario)] == [True]


def test_depths_are_those_of_points_in_hexahedra() -> None:
    """A lens moved into the middle of each solid is inside it, by no more than half of its least extent."""
    scenario = loaded.scenario(MISSION)
    sim = Simulation(scenario, digests=False)
    frame, lenses = sim.step(), Lenses(scenario)
    depths = lenses.depths(sim._state.worksite.frames, frame.views, attached=False)
    names = [camera.name for camera in lenses.cameras]
    assert depths.shape == (len(names), len(lenses.parts))
    own = [lenses.parts.index(camera.housing) for camera in lenses.cameras]
    assert np.isneginf(depths[np.arange(len(own)), own]).all()
    floor = lenses.parts.index("cabin")
    assert depths[names.index("A"), floor] == pytest.approx(-0.45 * 0.3048)
