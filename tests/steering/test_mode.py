"""Rows of the MODE rotary against the report, and the documentation's table against the rows."""

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from aftdeck.steering.mode import MODES, NUMBERED, position_of

DOCUMENT = Path(__file__).parents[2] / "docs" / "steering.md"


def documented() -> Iterator[tuple[str, set[int]]]:
    """Yield the positions in the first table of docs/steering.md, each with the report's modes that the table lists."""
    numbers: set[int] = set()
    for line in DOCUMENT.read_text(encoding="utf-8").partition("| position | mode |")[2].splitlines()[2:]:
        if not line.startswith("|"):
            return
        position, modes = (cell.strip() for cell in line.split("|")[1:3])
        if modes != "the same":
            numbers = {int(digit) for digit in re.findall(r"\d", modes)}
        slots = re.fullmatch(r"AUTO (\d)–(\d)", position)
        names = [f"AUTO {k}" for k in range(int(slots[1]), int(slots[2]) + 1)] if slots else [position]
        yield from ((name, numbers) for name in names)


def test_document_lists_every_position_with_its_modes() -> None:
    rows = {position: set(mode.laws) & set(NUMBERED) for position, mode in MODES.items()}
    assert dict(documented()) == rows


@pytest.mark.parametrize("number", NUMBERED)
def test_every_mode_of_the_report_has_a_position(number: int) -> None:
    found = position_of(number)
    assert found is not None
    assert number in MODES[found[0]].laws


def test_orb_ld_and_pl_are_the_only_positions_for_a_payload() -> None:
    assert {position for position, mode in MODES.items() if mode.loaded} == {"ORB LD", "PL"}


def test_only_the_position_of_modes_4_and_7_has_payload_axes() -> None:
    assert [mode.laws for mode in MODES.values() if mode.has_payload_axes] == [(4, 7)]
