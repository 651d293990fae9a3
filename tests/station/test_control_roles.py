"""Control roles without a server: letters represent pages, and the test sets the time."""

from __future__ import annotations

import pytest

from aftdeck.errors import CommandError, InputError
from aftdeck.station.core.roles import ANSWER_WITHIN, MAX_NAME_LENGTH, ControlRoles


class Clock:
    now = 0.0

    def __call__(self) -> float:
        return self.now


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def roles(clock: Clock) -> ControlRoles[str]:
    """Roles of three pages; `a` joined first."""
    roles: ControlRoles[str] = ControlRoles(clock)
    for page in "abc":
        roles.join(page)
    return roles


def test_first_page_takes_control_and_the_next_page_follows_it(roles: ControlRoles[str]) -> None:
    assert roles.operator == "a" and [roles.number(page) for page in "abc"] == [1, 2, 3]
    roles.leave("a")
    assert roles.operator == "b" and len(roles) == 2
    roles.join("d")
    assert roles.number("d") == 1 and roles.operator == "b"


def test_page_takes_control_after_all_pages_have_left(roles: ControlRoles[str]) -> None:
    for page in "abc":
        roles.leave(page)
    assert len(roles) == 0
    roles.join("d")
    assert roles.operator == "d"


def test_sticks_are_given_to_the_page_that_asks_and_back(roles: ControlRoles[str]) -> None:
    roles.ask("c")
    assert (roles.operator, roles.asking) == ("a", "c")
    roles.answer(gives=True)
    assert (roles.operator, roles.asking) == ("c", None)
    roles.ask("a")
    roles.answer(gives=True)
    assert (roles.operator, roles.asking) == ("a", None)


def test_sticks_that_were_kept_may_be_requested_again(roles: ControlRoles[str]) -> None:
    roles.ask("b")
    roles.answer(gives=False)
    assert roles.operator == "a" and roles.asking is None
    roles.ask("c")
    assert roles.asking == "c"


def test_request_expires(roles: ControlRoles[str], clock: Clock) -> None:
    roles.ask("b")
    clock.now = 0.99 * ANSWER_WITHIN
    with pytest.raises(CommandError, match="page 2"):
        roles.ask("c")
    clock.now = ANSWER_WITHIN
    assert roles.asking is None
    with pytest.raises(CommandError):
        roles.answer(gives=True)
    roles.ask("c")
    assert roles.asking == "c"


def test_display_name_is_the_name_or_the_number_of_the_page(roles: ControlRoles[str]) -> None:
    roles.give_name("b", "Ben")
    assert [roles.display_name(page) for page in "abc"] == ["page 1", "Ben", "page 3"]
    roles.ask("b")
    with pytest.raises(CommandError, match="Ben"):
        roles.ask("c")
    roles.give_name("b", "")
    assert roles.display_name("b") == "page 2" and roles.named() == []


def test_equal_names_have_the_page_number_appended(roles: ControlRoles[str]) -> None:
    roles.give_name("a", "Anna")
    roles.give_name("c", "Anna")
    assert [roles.display_name(page) for page in "abc"] == ["Anna 1", "page 2", "Anna 3"]
    assert roles.name("c") == "Anna"
    roles.leave("c")
    assert roles.display_name("a") == "Anna"


def test_reused_number_has_no_name(roles: ControlRoles[str]) -> None:
    roles.give_name("b", "Ben")
    roles.leave("b")
    roles.join("d")
    assert (roles.number("d"), roles.display_name("d")) == (2, "page 2")


def test_rejected_name_keeps_the_name_before(roles: ControlRoles[str]) -> None:
    roles.give_name("a", "Anna")
    with pytest.raises(InputError, match="24"):
        roles.give_name("a", "A" * (MAX_NAME_LENGTH + 1))
    assert roles.display_name("a") == "Anna"
    roles.give_name("a", "A" * MAX_NAME_LENGTH)
    assert roles.name("a") == "A" * MAX_NAME_LENGTH


def test_page_in_control_cannot_ask_for_the_sticks(roles: ControlRoles[str]) -> None:
    with pytest.raises(CommandError):
        roles.ask("a")
    assert roles.asking is None


@pytest.mark.parametrize("page", ["a", "b"])
def test_request_ends_when_one_of_its_pages_leaves(roles: ControlRoles[str], page: str) -> None:
    roles.ask("b")
    roles.leave(page)
    assert roles.asking is None
    assert roles.operator == ("b" if page == "a" else "a")


def test_display_names_are_unique(roles: ControlRoles[str]) -> None:
    for page, name in zip("abc", ("Anna", "Anna", "Anna 1"), strict=True):
        roles.give_name(page, name)
    assert len({name for _, name in roles.named()}) == 3
    with pytest.raises(InputError, match="'Page 2'"):
        roles.give_name("a", "Page 2")
