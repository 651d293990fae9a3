"""The scenarios that a station can fly: those built in, and the file that it was given."""

from __future__ import annotations

from aftdeck.errors import CommandError
from aftdeck.scenario.load import about, built_in, load_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.station import to_page

FIRST = ("tutorial", "first-flight")
"""Where a newcomer begins stands first; the others follow by name."""


class Choice:
    """The list that whoever flies chooses from.

    Attributes:
        scenarios: as pages are told of them.
        flown: number of the one that is flown.
        coming: number of the one that is made ready to be flown next.
    """

    def __init__(self, given: Scenario) -> None:
        names = sorted(built_in(), key=lambda name: (name not in FIRST, FIRST.index(name) if name in FIRST else 0))
        told = [to_page.ScenarioInfo(name, *about(name)[:2], given=False) for name in names]
        own = given.name in names and about(given.name).file == given.text
        self._given = None if own else given
        if not own:
            told.insert(0, to_page.ScenarioInfo(given.name, given.title, given.description, given=True))
        self.scenarios = tuple(told)
        self.flown = names.index(given.name) if own else 0
        self.coming: int | None = None

    def message(self) -> to_page.Scenarios:
        """What pages are told."""
        return to_page.Scenarios(self.scenarios, self.flown, self.coming)

    def choose(self, number: int) -> None:
        """One of them shall be made ready.

        Raises:
            CommandError: it is flown already, there is none such, or another is being made ready.
        """
        if number >= len(self.scenarios):
            raise CommandError(f"scenarios are numbered 0 to {len(self.scenarios) - 1}, got {number}")
        if self.coming is not None:
            raise CommandError(f"{self.scenarios[self.coming].title!r} is being made ready: wait until it flies")
        if number == self.flown:
            raise CommandError(f"{self.scenarios[number].title!r} is flown already: Restart puts it back")
        self.coming = number

    def load(self, number: int) -> Scenario:
        """The scenario itself.

        Raises:
            ScenarioError: it cannot be read.
        """
        info = self.scenarios[number]
        return self._given if info.given and self._given is not None else load_scenario(info.name)
