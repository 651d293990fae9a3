"""Changes of a scenario as KEY=VALUE: any value can be written and read again, and no text is an unknown error."""

from __future__ import annotations

import datetime
from typing import Any

import hypothesis.strategies as st
import pytest
from hypothesis import given

import aftdeck
from aftdeck.errors import InputError, ScenarioError
from aftdeck.files import place
from aftdeck.scenario.changes import change_text, located, parse_change, parse_key


@pytest.mark.parametrize(
    ("text", "where", "value"),
    [
        ("rate=vernier", ("rate",), "vernier"),
        (" rate = vernier ", ("rate",), "vernier"),
        ("command_delay=0.5", ("command_delay",), 0.5),
        ("duration=10 min", ("duration",), "10 min"),
        ("duration='10 min'", ("duration",), "10 min"),
        ("seed=7", ("seed",), 7),
        ("strict=true", ("strict",), True),
        ("limits.por.translation=1 ft/s", ("limits", "por", "translation"), "1 ft/s"),
        ("phase[0].rate=coarse", ("phase", 0, "rate"), "coarse"),
        ("sequence[1].point[12].pause=false", ("sequence", 1, "point", 12, "pause"), False),
        ("initial.joints=[0, 1]", ("initial", "joints"), [0, 1]),
        ("title=a = b", ("title",), "a = b"),
        ("title=", ("title",), ""),
        ("title=x\ny = 3", ("title",), "x\ny = 3"),
        ("seed=1\ny = 3", ("seed",), "1\ny = 3"),
        ("title=# no", ("title",), "# no"),
    ],
)
def test_value_of_a_change_is_read_as_toml_if_valid(text: str, where: tuple[str | int, ...], value: object) -> None:
    assert parse_change(text) == (where, value)


@given(st.text())
def test_any_text_is_a_change_or_an_input_error(text: str) -> None:
    try:
        where, _ = parse_change(text)
    except InputError as error:
        assert repr(text.partition("=")[0].strip()) in str(error) or repr(text) in str(error)
    else:
        assert where and "=" in text


PLAIN = st.recursive(
    st.one_of(
        st.booleans(),
        st.integers(-(2**63), 2**63 - 1),
        st.floats(allow_nan=False),
        st.text(st.characters(exclude_categories=["Cs"])),
        st.dates(datetime.date(1, 1, 1)),
    ),
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.dictionaries(st.text(st.characters(exclude_categories=["Cs"])), inner, max_size=3)
    ),
    max_leaves=8,
)


@given(PLAIN, st.sampled_from([("plant",), ("phase", 2, "rate"), ("limits", "por", "translation")]))
def test_every_value_of_a_file_is_read_again_from_its_text(value: object, where: tuple[str | int, ...]) -> None:
    assert parse_change(change_text(where, value)) == (where, value)


def test_changed_scenario_tells_its_changes_and_accepts_no_state_of_another() -> None:
    changes: dict[str | tuple[str | int, ...], object] = {
        ("clearance", "caution"): "1 ft",
        ("limits", "por", "translation"): 0.2,
    }
    slow, usual = aftdeck.load_scenario("tutorial", changes), aftdeck.load_scenario("tutorial")
    assert dict(map(parse_change, slow.changes)) == changes
    assert usual.changes == ()
    saved = aftdeck.Simulation(slow).save()
    with pytest.raises(InputError, match="digest"):
        aftdeck.Simulation(usual).restore(saved)
    aftdeck.Simulation(aftdeck.load_scenario("tutorial", changes)).restore(saved)


def test_keys_of_changes_are_texts_or_tuples() -> None:
    tuples: dict[str | tuple[str | int, ...], object] = {("plant",): "rigid", ("phase", 0, "rate"): "vernier"}
    texts: dict[str | tuple[str | int, ...], object] = {"plant": "rigid", "phase[0].rate": "vernier"}
    by_tuples, by_texts = (aftdeck.load_scenario("first-flight", changes) for changes in (tuples, texts))
    assert by_tuples.changes == by_texts.changes == ("plant=rigid", "phase[0].rate=vernier")
    assert by_tuples.plant == by_texts.plant == "rigid"


KEYS = st.text(max_size=6) | st.lists(st.text(max_size=3) | st.integers(-3, 3) | st.booleans() | st.none()).map(tuple)


@given(KEYS)
def test_any_other_key_is_an_input_error(key: Any) -> None:
    try:
        (where,) = located({key: 1})
    except InputError as error:
        assert str(error)
    else:
        assert where == (parse_key(key) if isinstance(key, str) else key) == parse_key(place(where))


def test_two_values_for_one_key_are_an_input_error() -> None:
    with pytest.raises(InputError, match="plant"):
        aftdeck.load_scenario("tutorial", {"plant": "rigid", ("plant",): "flexible"})


def test_change_with_a_wrong_value_is_an_error_of_the_scenario() -> None:
    with pytest.raises(ScenarioError, match="plant"):
        aftdeck.load_scenario("tutorial", {("plant",): "wooden"})
