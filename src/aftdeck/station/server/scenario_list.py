"""Scenarios that a station can run: the built-in scenarios, and the file with which the user started the station."""

from __future__ import annotations

from aftdeck.errors import CommandError
from aftdeck.files import Where
from aftdeck.recording.bundle import opening, scenario_of
from aftdeck.scenario.load import about, built_in, load_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.schema import Plant
from aftdeck.station.messages import to_page


class ScenarioList:
    """List of scenarios from which the operator chooses.

    Attributes:
        scenarios: entries of the list.
        flown: number of the scenario that is running.
        plant: plant of the present run.
        coming: number of the scenario that is being prepared; None if no scenario is being prepared.
    """

    def __init__(self, given: Scenario) -> None:
        names = _in_order()
        infos = [_info(name) for name in names]
        own = given.name in names and about(given.name).file == given.text and not given.changes
        self._given = None if own else given
        if not own:
            infos.insert(0, _own_info(given))
        self.scenarios = tuple(infos)
        self.flown = names.index(given.name) if own else 0
        self.plant = given.plant
        self.coming: int | None = None

    def message(self) -> to_page.Scenarios:
        """Return the message with the list, for the pages."""
        return to_page.Scenarios(self.scenarios, self.flown, self.coming)

    def choose(self, number: int, plant: Plant | None = None, *, demo: bool = False) -> None:
        """Choose the scenario to prepare and run next; `demo`: whether its script flies.

        Raises:
            CommandError: the scenario is running already on this plant and its script was not asked for, it has no
                script, its number does not exist, or another is being prepared.
        """
        if number >= len(self.scenarios):
            raise CommandError(f"scenarios are numbered 0 to {len(self.scenarios) - 1}, got {number}")
        if self.coming is not None:
            raise CommandError(f"{self.scenarios[self.coming].title!r} is being prepared: wait until it runs")
        if demo and not self.scenarios[number].scripted:
            raise CommandError(f"{self.scenarios[number].title!r} has no script that could fly it")
        if number == self.flown and plant in (None, self.plant) and not demo:
            raise CommandError(
                f"{self.scenarios[number].title!r} is running already: press Restart to run it from the beginning"
            )
        self.coming = number

    def load(self, number: int, plant: Plant | None = None) -> Scenario:
        """Load a scenario of the list, and return it.

        Args:
            number: number of the scenario.
            plant: the plant; None for that of the scenario's file.

        Raises:
            ScenarioError: the scenario cannot be read, or cannot have this plant.
        """
        info = self.scenarios[number]
        changes: dict[Where, object] = {} if plant is None else {("plant",): plant}
        if not info.given or self._given is None:
            return load_scenario(info.name, changes)
        return scenario_of(opening(self._given, 0, 0), changes) if changes else self._given


def _in_order() -> list[str]:
    """Return the names of the built-in scenarios: each before the one that it proposes next, the others at the end.

    Scenarios without such an order are in that of their names.
    """
    following = {name: about(name).next for name in built_in()}
    proposed = set(following.values())
    ordered: list[str] = []
    for first in sorted(set(following) - proposed, key=lambda name: (following[name] is None, name)):
        name: str | None = first
        while name is not None and name not in ordered:
            ordered.append(name)
            name = following[name]
    return ordered


def _info(name: str) -> to_page.ScenarioInfo:
    """Return the entry of a built-in scenario."""
    found = about(name)
    return to_page.ScenarioInfo(name, found.title, found.text, found.group, found.minutes, False, found.scripted)


def _own_info(own: Scenario) -> to_page.ScenarioInfo:
    """Return the entry of the user's own scenario."""
    scripted = len(own.phases) > 0
    return to_page.ScenarioInfo(own.name, own.title, own.description, own.group, own.minutes, True, scripted)
