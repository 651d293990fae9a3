"""Latency, monitors and lighting that the page in control reports, and their records."""

from __future__ import annotations

from aftdeck.recording.tape import SessionRecorder
from aftdeck.scenario.light import Lighting
from aftdeck.station.messages import kinds


class Reported:
    """Newest values from the page in control, and those that the present recording has already.

    Attributes:
        latency_ms: latency that the page measures [ms]; None if it has measured none.
        monitors: cameras on its monitors.
        lighting: lighting that it has set.
        lit: lighting of the newest step; None before the first one.
    """

    def __init__(self, lighting: Lighting) -> None:
        self.latency_ms: float | None = None
        self.monitors: tuple[kinds.Monitor, ...] = ()
        self.begin_run(lighting)

    def begin_run(self, lighting: Lighting) -> None:
        """Set the scenario's lighting, and regard nothing as recorded."""
        self.lighting = lighting
        self.lit: Lighting | None = None
        self._monitors_recorded: tuple[kinds.Monitor, ...] = ()

    def record(self, tape: SessionRecorder, time_s: float) -> str:
        """Record monitors and lighting from a step on, if they have changed.

        Args:
            tape: recording of the run.
            time_s: time of the step [s].

        Returns:
            Text for the log if light condition or lamps have changed during the run; else an empty text.
        """
        if self.monitors != self._monitors_recorded:
            self._monitors_recorded = self.monitors
            tape.shown(time_s, self._monitors_recorded)
        lighting, before = self.lighting, self.lit
        if lighting == before:
            return ""
        self.lit = lighting
        tape.light(time_s, lighting)
        if before is None or (lighting.condition, lighting.lamps) == (before.condition, before.lamps):
            return ""
        return f"light: {lighting.condition}; lamps lit: {', '.join(lighting.lamps) or 'none'}"
