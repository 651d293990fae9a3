"""What only a run at the station has: devices, late steps."""

from __future__ import annotations

from collections.abc import Iterator

from aftdeck.recording.delays import Delays
from aftdeck.recording.records import ControllerRecord
from aftdeck.report.metric import Found, Metric, Value

CONTROLLERS = Metric("controllers", "Controllers", "words", "Devices that moved the sticks.")
LOST = Metric(
    "lost_time",
    "Time lost",
    "seconds",
    "Time by which the simulation fell behind the wall clock: late steps that were not made up.",
)

METRICS = (LOST, CONTROLLERS)


class Desk:
    """What only a run at the station has."""

    def __init__(self) -> None:
        self._used: dict[str, ControllerRecord] = {}

    def use(self, controllers: tuple[ControllerRecord, ...]) -> None:
        """Add the devices that move the sticks from the next frame on."""
        self._used |= {used.kind: used for used in controllers}

    def found(self, delays: Delays | None) -> Iterator[Found]:
        """Yield what the run has.

        Args:
            delays: delays of the steps; None if they are not known.
        """
        if delays is not None:
            yield LOST, Value(delays.lost_s, detail=delays.text(), level="caution" if delays.lost_s else "info")
        if self._used:
            settings = "; ".join(_text(used) for used in self._used.values())
            yield CONTROLLERS, Value(None, ", ".join(self._used), f"last settings: {settings}")


def _text(used: ControllerRecord) -> str:
    """Return a device's name and settings: ``Test pad, deadband 8 %, expo 0.3``; for a keyboard only the name."""
    set_to = "" if used.kind == "keyboard" else f", deadband {used.deadband:.0%}, expo {used.expo:g}".replace("%", " %")
    return f"{used.name}{set_to}"
