"""Links of the Shuttle's arm: rods and housings from masses, moments and centres, and arm files of old recordings."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from aftdeck.arms.link_file import RodLink
from aftdeck.arms.links import Link, rods_of
from aftdeck.arms.load import HERE, model_of
from aftdeck.bodies.mass_properties import MassProperties, about, cylinder, joined, sphere
from aftdeck.errors import ScenarioError
from aftdeck.files import Text
from tests.each import each, seeds
from tests.loaded import arm

HOUSINGS = "".join(
    f'\n[housings.{name}]\nvalue = {value}\nsource = "of that time"\nconfidence = "assumed"\n'
    for name, value in (
        ("radius", 0.2),
        ("boom_radius", 0.19),
        ("wrist_yaw_to_roll", "'30 in'"),
        ("wrist_inertia", [[1.5, 3.0], [1.0, 5.0], [2.0, 5.0]]),
    )
)
"""Table of the housings, as arm files had it for plants with masses."""
OLD = Path(__file__).parent / "srms-before-0.2.toml"


def moments(body: MassProperties) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    return np.diagonal(body.inertia + about(body.mass, body.centre)).copy()


@each("seed", lambda: seeds(50, 2000))
def test_boom_is_taken_apart_into_the_rod_and_the_housings_of_which_it_was_made(seed: int) -> None:
    rng = np.random.default_rng(seed)
    length, radius = rng.uniform(1.0, 10.0), rng.uniform(0.05, 0.3)
    rod, begin, end = rng.uniform(5.0, 100.0, 3)
    parts = [
        cylinder(rod, radius, np.zeros(3), np.array([length, 0.0, 0.0])),
        sphere(begin, rng.uniform(0.1, 0.3)),
        MassProperties(end, np.array([length, 0.0, 0.0]), np.zeros((3, 3))),
    ]
    for centred in (True, False):
        body = joined(parts if centred else parts[:2])
        centre = float(body.centre[0]) if centred else None
        made = Link("upper_boom", np.zeros(3), np.array([length, 0.0, 0.0]), body.mass, moments(body), centre, radius)
        assert list(made.problems()) == []
        found = made.shares()
        assert found.rod == pytest.approx(rod, rel=1e-6)
        assert found.beginning.mass == pytest.approx(begin, rel=1e-6)
        assert found.tip.mass == pytest.approx(end if centred else 0.0, abs=1e-6)
        assert made.whole().centre == pytest.approx(body.centre, rel=1e-6)
        assert made.whole().inertia == pytest.approx(body.inertia, rel=1e-6, abs=1e-6)


def test_links_of_the_shuttle_have_the_moments_of_their_file_about_their_joints() -> None:
    file = arm().model.source
    given = [link.moments for link in (file.foot, *(joint.link for joint in file.joint)) if isinstance(link, RodLink)]
    assert len(given) == 7
    for (_, _, link), moments in zip(rods_of(file), given, strict=True):
        body = link.whole()
        whole = body.inertia + about(body.mass, body.centre - link.begin)
        assert np.linalg.eigvalsh(whole) == pytest.approx(sorted(moments))


@pytest.mark.parametrize(
    ("old", "new", "place"),
    [
        ("[1.59, 632.9, 632.51]", "[1.59, 632.9, 2.51]", "joint[2].link.moments"),
        ("0.686", "9.686", "foot.moments"),
        ('[["30 in", 0.0, 0.0], ["56 in", 0.0, 0.0]]', '[["56 in", 0.0, 0.0], ["56 in", 0.0, 0.0]]', "joint[5].link"),
        ('[["30 in", 0.0, 0.0], ["56 in", 0.0, 0.0]]', '[["30 in", 0.0, 0.0], ["56 in", 0.1, 0.0]]', "joint[5].link"),
        ('part = "foot"\n', 'part = "foot"\nradius = 0.1\n', "foot.radius"),
        ("torsion = 2.1e6\n", "", "joint[2].link"),
        ('part = "lower_boom"', 'part = "upper_boom"', "joint[2].link.part"),
        ('part = "lower_boom"', 'part = "base"', "joint[2].link.part"),
        ("mass = 87.42", "mass = 8.742", "mass"),
        ("[sources.moments]", "[sources.inertia]", "foot: no source of `moments`"),
    ],
)
def test_link_that_cannot_be_is_rejected_with_its_place(old: str, new: str, place: str) -> None:
    model = arm().model
    assert old in model.text
    text = model.text.replace(old, new, 1)
    with pytest.raises(ScenarioError, match=re.escape(place)):
        model_of(Text("bad.toml", text), lambda _: model.shapes or Text("", ""))


def test_arm_of_an_old_recording_keeps_its_masses() -> None:
    old, shapes = OLD.read_text(encoding="utf-8"), HERE / "srms.shapes.toml"
    assert "yaw_housing" in old
    plain, full = (
        model_of(Text("old", old + more), lambda _: Text("shapes", shapes.read_text(encoding="utf-8"))).source
        for more in ("", HOUSINGS)
    )
    assert not any(joint.link for joint in plain.joint) and plain.foot is None
    assert plain.mass is not None and full.mass is not None
    links = {link.name: link for _, _, link in rods_of(full)}
    assert sum(link.mass for link in links.values()) == pytest.approx(full.mass.value, rel=1e-3)
    for name, rod, tip in (("upper_boom", 55.0, 32.5), ("lower_boom", 50.0, 20.0)):
        shares = links[name].shares()
        assert (shares.rod, shares.tip.mass) == pytest.approx((rod, tip), rel=1e-3)
    for name, mass, centre in (("wrist_pitch", 40.0, 9.0), ("wrist_yaw", 35.0, 15.0), ("end_effector", 55.5, 43.0)):
        body = links[name].whole()
        assert (body.mass, body.centre[0]) == pytest.approx((mass, centre * 0.0254), rel=1e-6)
    assert np.diagonal(links["wrist_yaw"].whole().inertia) == pytest.approx([1.0, 5.0, 5.0])
