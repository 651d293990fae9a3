"""Who flies, as a law of its own: pages are letters here, and time is what the test says."""

from __future__ import annotations

import pytest

from aftdeck.errors import CommandError, InputError
from aftdeck.station.server.control_roles import ANSWER_WITHIN, MOST_OF_A_NAME, ControlRoles


class Clock:
    now = 0.0

    def __call__(self) -> float:
        return self.now


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def seats(clock: Clock) -> ControlRoles[str]:
    """Three pages, of which `a` came first."""
    seats: ControlRoles[str] = ControlRoles(clock)
    for page in "abc":
        seats.join(page)
    return seats


def test_the_first_flies_and_the_one_longest_here_takes_over(seats: ControlRoles[str]) -> None:
    assert seats.operator == "a" and [seats.number(page) for page in "abc"] == [1, 2, 3]
    seats.leave("a")
    assert seats.operator == "b" and len(seats) == 2
    seats.join("d")
    assert seats.number("d") == 1 and seats.operator == "b"


def test_the_last_one_leaves_nobody_flying_and_the_next_one_flies(seats: ControlRoles[str]) -> None:
    for page in "abc":
        seats.leave(page)
    assert len(seats) == 0
    seats.join("d")
    assert seats.operator == "d"


def test_the_sticks_are_given_to_who_asks_and_back(seats: ControlRoles[str]) -> None:
    seats.ask("c")
    assert (seats.operator, seats.asking) == ("a", "c")
    seats.answer(gives=True)
    assert (seats.operator, seats.asking) == ("c", None)
    seats.ask("a")
    seats.answer(gives=True)
    assert (seats.operator, seats.asking) == ("a", None)


def test_kept_sticks_stay_and_may_be_asked_for_again(seats: ControlRoles[str]) -> None:
    seats.ask("b")
    seats.answer(gives=False)
    assert seats.operator == "a" and seats.asking is None
    seats.ask("c")
    assert seats.asking == "c"


def test_a_question_is_over_after_its_time(seats: ControlRoles[str], clock: Clock) -> None:
    seats.ask("b")
    clock.now = 0.99 * ANSWER_WITHIN
    with pytest.raises(CommandError, match="page 2 has asked for the sticks already"):
        seats.ask("c")
    clock.now = ANSWER_WITHIN
    assert seats.asking is None
    with pytest.raises(CommandError, match="nobody asks for the sticks, or no longer"):
        seats.answer(gives=True)
    seats.ask("c")
    assert seats.asking == "c"


def test_a_page_is_called_by_its_name_and_without_one_by_its_number(seats: ControlRoles[str]) -> None:
    seats.give_name("b", "Ben")
    assert [seats.display_name(page) for page in "abc"] == ["page 1", "Ben", "page 3"]
    seats.ask("b")
    with pytest.raises(CommandError, match="Ben has asked for the sticks already"):
        seats.ask("c")
    seats.give_name("b", "")
    assert seats.display_name("b") == "page 2" and seats.named() == []


def test_two_of_one_name_are_told_apart_while_both_are_there(seats: ControlRoles[str]) -> None:
    seats.give_name("a", "Anna")
    seats.give_name("c", "Anna")
    assert [seats.display_name(page) for page in "abc"] == ["Anna 1", "page 2", "Anna 3"]
    assert seats.name("c") == "Anna"
    seats.leave("c")
    assert seats.display_name("a") == "Anna"


def test_whoever_takes_a_free_number_has_not_the_name_that_went_with_it(seats: ControlRoles[str]) -> None:
    seats.give_name("b", "Ben")
    seats.leave("b")
    seats.join("d")
    assert (seats.number("d"), seats.display_name("d")) == (2, "page 2")


def test_a_name_that_was_refused_leaves_the_one_before(seats: ControlRoles[str]) -> None:
    seats.give_name("a", "Anna")
    with pytest.raises(InputError, match="a name has 24 characters at most"):
        seats.give_name("a", "A" * (MOST_OF_A_NAME + 1))
    assert seats.display_name("a") == "Anna"
    seats.give_name("a", "A" * MOST_OF_A_NAME)
    assert seats.name("a") == "A" * MOST_OF_A_NAME


def test_who_flies_asks_nobody(seats: ControlRoles[str]) -> None:
    with pytest.raises(CommandError, match="you fly"):
        seats.ask("a")


@pytest.mark.parametrize("page", ["a", "b"])
def test_a_question_ends_when_who_asked_or_who_was_asked_leaves(seats: ControlRoles[str], page: str) -> None:
    seats.ask("b")
    seats.leave(page)
    assert seats.asking is None
    assert seats.operator == ("b" if page == "a" else "a")


def test_no_two_pages_are_called_alike(seats: ControlRoles[str]) -> None:
    for page, name in zip("abc", ("Anna", "Anna", "Anna 1"), strict=True):
        seats.give_name(page, name)
    assert len({name for _, name in seats.named()}) == 3
    with pytest.raises(InputError, match="what a page without a name is called"):
        seats.give_name("a", "Page 2")
