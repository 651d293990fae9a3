"""Arm files of chains without a closed form: what they may say, and the errors for the rest."""

from __future__ import annotations

import re

import numpy as np
import pytest

import aftdeck
from aftdeck import jsc12628
from aftdeck.arms.chain import RANK
from aftdeck.arms.load import ArmModel, model_of
from aftdeck.errors import InputError, ScenarioError
from aftdeck.files import Text
from aftdeck.kinematics.linkage import LINKS
from aftdeck.scenario.load import load_scenario
from aftdeck.tuples import MOST_JOINTS
from tests import loaded
from tests.loaded import CHAINS

SEVEN = (CHAINS / "seven.toml").read_text(encoding="utf-8")
ROLL = SEVEN[SEVEN.index('[[joint]]\nname = "upper_roll"') : SEVEN.index('[[joint]]\nname = "elbow"')]


def model(text: str) -> ArmModel:
    return model_of(Text("arm.toml", text), lambda name: Text(name, ""))


@pytest.mark.parametrize(("name", "rank"), [("five", 5), ("seven", 6)])
def test_chain_has_the_rank_of_its_joints(name: str, rank: int) -> None:
    assert loaded.chain(name).model.links[LINKS + RANK] == rank


def test_parallel_axes_make_the_motions_of_a_plane() -> None:
    flat = re.sub(r"axis = \[.*\]", "axis = [0, 1, 0]", SEVEN)
    assert model(flat).links[LINKS + RANK] == 3


@pytest.mark.parametrize(
    ("old", "new", "place"),
    [
        ('name = "upper_roll"', 'name = "elbow"', "joint[3].name"),
        ('name = "upper_roll"', 'name = "base"', "joint[2].name"),
        ("axis = [0.9962, 0.0, -0.0872]", "axis = [0, 0, 0]", "joint[2].axis"),
        ('kind = "turn"', 'kind = "bend"', "joint[0].kind"),
        ('kind = "turn"', 'kind = "slide"', "joint[0]"),
        ("step = [0.5, 0.0, 0.0]", "step = [0.5, 0.0]", "joint[2].step"),
        ('hard = ["-10 deg", "150 deg"]', 'hard = ["10 deg", "150 deg"]', "joint"),
        ("inertia = [1.2, 1.2, 1.2]", "inertia = [9, 1, 1]", "joint[0].link"),
        ('frame = "arm.elbow"', 'frame = "arm.knee"', "bodies[3].frame"),
        ("torque_limit = { value = [1500, ", "torque_limit = { value = [", "servo.torque_limit"),
    ],
)
def test_error_names_the_place(old: str, new: str, place: str) -> None:
    assert old in SEVEN
    with pytest.raises(ScenarioError, match=re.escape(place)):
        model(SEVEN.replace(old, new, 1))


@pytest.mark.parametrize("count", [0, 9])
def test_chain_has_one_to_eight_joints(count: int) -> None:
    assert MOST_JOINTS == 8
    first = SEVEN.index("[[joint]]")
    rest = SEVEN[SEVEN.index("[[por]]") :]
    joints = "".join(ROLL.replace("upper_roll", f"j{k}") for k in range(count))
    with pytest.raises(ScenarioError, match="joint"):
        model(SEVEN[:first] + joints + rest)


def test_published_laws_refuse_an_arm_without_a_closed_form() -> None:
    arm = loaded.chain("seven")
    with pytest.raises(InputError, match="seven"):
        jsc12628.lnkage(arm, np.zeros(7))
    with pytest.raises(InputError, match="closed form"):
        arm.rmangs(arm.forward(np.zeros(7)))
    with pytest.raises(ScenarioError, match="strict"):
        load_scenario(CHAINS / "fly-seven.toml", {"strict": True})
    assert aftdeck.load_arm("srms").closed_form and not arm.closed_form
