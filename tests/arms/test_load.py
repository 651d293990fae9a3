"""Arm files: built in, loaded by path, and rejected if invalid."""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np
import pytest

import aftdeck
from aftdeck.arms.constant import Constant
from aftdeck.arms.joints import SourcesFile
from aftdeck.arms.load import HERE, built_in, model_of
from aftdeck.errors import ArmError, ScenarioError
from aftdeck.files import Text, read
from tests.reference.tables import table

LIMITS = table("srms-limits")
MADE_UP = Path(__file__).parent / "made-up.toml"
TEXT = MADE_UP.read_text(encoding="utf-8")
UNSOURCED = re.sub(r"(\[\[joint\]\](?:\n.+)+)\nsource = .*\nconfidence = .*", r"\1", TEXT)
"""The same arm, whose joints have no sources of their own."""


def test_srms_has_the_published_limits_and_rates() -> None:
    arm = aftdeck.load_arm("srms")
    for found, given in ((arm.limits.hard, "hard"), (arm.limits.soft, "soft")):
        assert np.degrees(found) == pytest.approx(np.array(LIMITS[given]))
    inside = np.array(LIMITS["soft"]) + np.array([1, -1]) * LIMITS["reach_inside_soft"]
    assert np.degrees(arm.limits.reach) == pytest.approx(inside)
    for which in ("servo", "coarse", "vernier"):
        assert np.degrees(getattr(arm.rates, which)) == pytest.approx(LIMITS[which])
    assert (arm.rate_limits == arm.rates.servo).all()


def test_srms_has_the_published_length() -> None:
    # 50 ft 3 in from shoulder pitch to tip, stretched out at zero angles
    arm = aftdeck.load_arm("srms")
    assert arm.forward(np.zeros(6)).position == pytest.approx([50.25 * 0.3048, 0.0, -0.3048])


def test_srms_joints_have_their_names_in_order() -> None:
    assert aftdeck.load_arm("srms").joints == (
        "shoulder_yaw", "shoulder_pitch", "elbow_pitch", "wrist_pitch", "wrist_yaw", "wrist_roll",
    )  # fmt: skip


def test_arrays_of_an_arm_are_read_only() -> None:
    arm = aftdeck.load_arm("srms")
    for array in (arm.limits.hard, arm.limits.soft, arm.limits.reach, arm.rate_limits, arm.model.links):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0.0


@pytest.mark.parametrize("name", built_in())
def test_constants_of_a_built_in_arm_have_sources(name: str) -> None:
    """Quantities of joints and links: `test_quantity_without_a_source_is_rejected`."""
    file = aftdeck.load_arm(name).model.source
    tables = [file.mount, file.servo, file.flexibility, *file.switched]
    constants = [getattr(table, field) for table in tables if table is not None for field in table.__struct_fields__]
    constants += [file.tip, file.singular, file.mass]
    found = [constant for constant in constants if isinstance(constant, Constant)]
    assert len(found) > 18 and all(one.source for one in (*found, *file.por, *file.bodies))


@pytest.mark.parametrize("quantity", SourcesFile.__struct_fields__)
def test_quantity_without_a_source_is_rejected(quantity: str) -> None:
    given = {name for name in SourcesFile.__struct_fields__ if f"\n{name} = {{ source" in UNSOURCED}
    with pytest.raises(ScenarioError) as caught:
        model_of(
            Text("bad.toml", re.sub(rf"\n{quantity} = {{ source.*", "", UNSOURCED)), lambda name: read(HERE / name)
        )
    unsourced = {re.search("no source of `(.*?)`", problem)[1] for problem in caught.value.problems}  # type: ignore[index]
    assert unsourced == {"step", "axis"} | ({quantity} & given)


def test_arm_file_loads_by_path_as_str_or_path() -> None:
    for given in (MADE_UP, str(MADE_UP)):
        arm = aftdeck.load_arm(given)
        assert arm.name == "made-up" and arm.joints == ("a", "b", "c", "d", "e", "f")
        assert repr(arm) == "Arm('made-up')"


@pytest.mark.parametrize("name", ["canadarm3", "", "SRMS", "../arms/srms", "srms.shapes"])
def test_unknown_arm_is_rejected_with_the_built_in_names(name: str) -> None:
    with pytest.raises(ArmError, match=rf"{re.escape(repr(name))}.* concept-1972, srms.*\.toml"):
        aftdeck.load_arm(name)


def problems(tmp_path: Path, old: str, new: str) -> list[str]:
    assert old in TEXT
    file = tmp_path / "bad.toml"
    file.write_text(TEXT.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(ScenarioError) as caught:
        aftdeck.load_arm(file)
    return list(caught.value.problems)


@pytest.mark.parametrize(
    ("old", "new", "pattern"),
    [
        ('name = "f"', 'name = "a"', r"joint\[5\]\.name: .*different.*'a'"),
        ('units = "SI"', 'units = "cubits"', "units: .*ft-in, SI.*'cubits'"),
        ("step = [0.0, 0.0, -0.4]", "step = [0.0, 0.0, -400]", r"joint\[1\]\.step\[2\]: .*-400 m.*-200 to 200 m"),
        ("step = [0.0, 0.0, -0.4]", "step = [0.0, 0.0, nan]", r"joint\[1\]\.step\[2\]: .*finite.*nan"),
        ("step = [0.0, 0.0, -0.4]", "step = [0.0, 0.0, '1 kg']", r"joint\[1\]\.step\[2\]: '1 kg'"),
        ("step = [0.0, 0.0, -0.4]", "step = [0.0, -0.4]", r"joint\[1\]\.step: .*`array`.*3.*2"),
        ('source = "made up"', 'source = ""', "source: .*`str`.*1"),
        (
            'confidence = "assumed"',
            'confidence = "sure"',
            "confidence: .*firm, single, derived, assumed.*'sure'",
        ),
        (
            "[singular]\nvalue = 0.1",
            "[singular]\nvalue = 1.5",
            r"singular\.value: .*1\.5; .*0\.001 to 0\.999",
        ),
        ("[singular]\nvalue = 0.1", "[singular]\nvalue = nan", r"singular\.value"),
        ("hard = [-3, 3]", "hard = [-2, 3]", r"joint\[0\]\.hard: a: reach.*soft"),
        ("hard = [-3, 3]", "hard = [3, -3]", r"joint\[0\]\.hard: a: reach.*soft"),
        ("vernier = 0.05", "vernier = 0.5", r"joint\[0\]\.servo: a: .*0.*vernier.*coarse.*servo.*0\.5"),
        ("mass = 0\n", "mass = 1\n", r"por\[0\]\.mass: .*first.*mass 0.*1 kg"),
        ('mass = "10 t"', 'mass = "1 t"', r"por\[2\]\.mass: .*increase.*1000 after 1000 kg"),
        ("reached_in = 2\n", "reached_in = 0\n", r"por\[0\]\.reached_in: .*0 s; .*0\.001 to 3600 s"),
        ("vernier_translation = 0.2", "vernier_translation = 0.7", r"por\[0\]: "),
        ("[mass]\nvalue = 7", "[mass]\nvalue = 10", r"mass: .*sum.*7 kg.*10 kg"),
        ('part = "foot"\nmass = 1', 'part = "foot"\nmass = -1', r"foot\.mass: .*-1 kg"),
        ('confidence = "assumed"\n\n[[joint]]\nname = "b"', '\n[[joint]]\nname = "b"', r"joint\[0\]: .*`confidence`"),
        ("title =", "colour =", "field 'title'"),
        ("[mount]", "[muont]", "field 'mount'"),
        ('units = "SI"', 'units = "SI"\nfamily = "scara"', "family: unknown field"),
    ],
)
def test_invalid_arm_file_is_rejected_with_its_line(tmp_path: Path, old: str, new: str, pattern: str) -> None:
    found = problems(tmp_path, old, new)
    assert any(re.search(pattern, problem) for problem in found), found
    assert all(re.match(r"bad\.toml:\d+: |bad\.toml: the field '\w+' is missing", problem) for problem in found), found


@pytest.mark.parametrize("count", [1, 5, 7, 8])
@pytest.mark.parametrize(
    "place", ["servo.gear_ratio", "servo.holding_torque", "flexibility.gearboxes", "flexibility.friction"]
)
def test_list_of_drives_needs_one_value_for_each_joint(place: str, count: int) -> None:
    text = aftdeck.load_arm("srms").model.text
    changed = re.sub(rf"(\[{re.escape(place)}\]\nvalue = ).*", rf"\1{[2000] * count}", text)
    assert changed != text
    with pytest.raises(ScenarioError) as caught:
        model_of(Text("bad.toml", changed), lambda name: read(HERE / name))
    (problem,) = caught.value.problems
    line = line_of(changed, f"[{place}]") + 1
    assert re.match(rf"bad\.toml:{line}: {re.escape(place)}\.value: .*6 values.*got {count}", problem), problem


def test_all_errors_of_an_arm_file_are_reported_together(tmp_path: Path) -> None:
    """Errors of single values are reported together, and so are contradictions between values."""
    for changes in (
        {
            'units = "SI"': 'units = "cubits"',
            "value = 0.1\n": "value = 7\n",
            "step = [0.0, 0.0, -0.4]": "step = [0.0, 0.0, -400]",
        },
        {'name = "f"': 'name = "a"  ', 'mass = "10 t"': 'mass = "1 t" '},
    ):
        text = TEXT
        for old, new in changes.items():
            text = text.replace(old, new, 1)
        file = tmp_path / "bad.toml"
        file.write_text(text, encoding="utf-8")
        with pytest.raises(ScenarioError) as caught:
            aftdeck.load_arm(file)
        assert [problem.split(": ", 1)[0] for problem in caught.value.problems] == [
            f"bad.toml:{line_of(text, new)}" for new in changes.values()
        ]


def line_of(text: str, what: str) -> int:
    return text[: text.index(what)].count("\n") + 1


def test_masses_of_the_parts_add_up_to_about_the_mass_in_the_crew_s_manual() -> None:
    mass = aftdeck.load_arm("srms").model.source.mass
    assert mass is not None and mass.value == pytest.approx(905 * 0.45359237, rel=0.03)


@pytest.mark.parametrize("name", ["srms", str(MADE_UP)])
def test_por_limits_equal_the_table_at_its_rows(name: str) -> None:
    model = aftdeck.load_arm(name).model
    for row in model.por:
        found = model.por_limits(row.mass)
        assert found.translation == (row.translation, row.vernier_translation)
        assert found.rotation == (row.rotation, row.vernier_rotation)
        assert found.acceleration == pytest.approx(row.translation / row.reached_in, rel=1e-15)
        assert found.angular_acceleration == pytest.approx(row.rotation / row.reached_in, rel=1e-15)


@pytest.mark.parametrize("name", ["srms", str(MADE_UP)])
def test_por_limits_decrease_continuously_between_rows(name: str) -> None:
    model = aftdeck.load_arm(name).model
    masses = np.concatenate([np.linspace(0, 3000, 400), np.geomspace(3000, 60000, 800)])
    rows = np.array([(*f.translation, *f.rotation, f.acceleration) for f in map(model.por_limits, masses.tolist())])
    steps = np.diff(rows, axis=0)
    assert (steps <= 1e-15).all()
    assert np.abs(steps).max(axis=0) == pytest.approx(np.zeros(5), abs=0.05)


def test_por_limits_interpolate_in_the_logarithm_of_the_mass() -> None:
    model = aftdeck.load_arm(MADE_UP).model
    found = model.por_limits(math.sqrt(1000.0 * 10_000.0))
    assert found.translation == pytest.approx((0.2, 0.075)) and found.acceleration == pytest.approx(0.2 / 7.5)
    light = model.por_limits(500.0)
    assert light.translation == pytest.approx((0.4, 0.15)) and light.acceleration == pytest.approx(0.4 / 3.5)


def test_por_limits_stay_constant_beyond_the_heaviest_row() -> None:
    model = aftdeck.load_arm("srms").model
    assert model.por_limits(1e6) == model.por_limits(65_000 * 0.45359237)


def test_por_limits_without_payload_are_the_published_speeds() -> None:
    found = aftdeck.load_arm("srms").model.por_limits(0.0)
    assert np.array(found.translation) / 0.3048 == pytest.approx(LIMITS["por_speed"])
    assert math.degrees(found.rotation[0]) == pytest.approx(LIMITS["por_turn_coarse"])
