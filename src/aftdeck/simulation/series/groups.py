"""Groups of the columns of a time history, in the order of a table's columns."""

from __future__ import annotations

from aftdeck.scenario.model import Scenario
from aftdeck.simulation.readings.quantity import UNITS
from aftdeck.simulation.readings.reading import Reading
from aftdeck.simulation.readings.table import readings_of
from aftdeck.table import Column, with_unit

_FIRST = (
    *("time", "phase", "sticks", "angles", "rates", "commanded", "tip", "por", "clearance", "payloads"),
    *("true_tip", "torques", "bends", "orbiter", "jets", "contacts", "holds", "disturbances"),
    *("loads", "orbiter_rates", "payload_rates"),
)
"""Order of the groups; others follow them."""


def columns_of(reading: Reading, scenario: Scenario) -> tuple[Column, ...]:
    """Return the columns of a reading."""
    names = reading.names(reading.column or reading.name, scenario)
    units = [UNITS[quantity] for quantity in reading.quantities(scenario)]
    columns = tuple(
        Column(with_unit(name, unit), unit, reading.definition) for name, unit in zip(names, units, strict=True)
    )
    return tuple(column._replace(kind="text") for column in columns) if reading.quantity == "words" else columns


def in_series(scenario: Scenario) -> list[Reading]:
    """Return the readings that have values in a run of a scenario, group by group."""
    found = [reading for reading in readings_of(scenario) if reading.group]
    groups = list(dict.fromkeys((*_FIRST, *(reading.group for reading in found))))
    return sorted(found, key=lambda reading: groups.index(reading.group))
