"""Latency, monitors and lighting that the page in control reports, and their recording."""

from __future__ import annotations

from aftdeck.recording.session_recorder import SessionRecorder
from aftdeck.scenario.light import Lighting
from aftdeck.simulation.frame import Frame
from aftdeck.station.messages import kinds

QUIET_S = 1.0
"""Time after an announcement in which others are ignored [s]."""


class Reported:
    """Newest values from the page in control, and the values that are already recorded.

    Attributes:
        latency_ms: latency measured by the page [ms]; None if not measured.
        monitors: cameras on the monitors of the page.
        announced: who has announced a clearance problem since the last step; empty if nobody has.
        lighting: lighting set by the page.
        lit: lighting of the newest step; None before the first one.
    """

    def __init__(self, lighting: Lighting) -> None:
        self.latency_ms: float | None = None
        self.monitors: tuple[kinds.Monitor, ...] = ()
        self.announced = ""
        self.begin_run(lighting)

    def begin_run(self, lighting: Lighting) -> None:
        """Set the scenario's lighting, for a new run with a new recording."""
        self.lighting = lighting
        self.lit: Lighting | None = None
        self._quiet_until_s = 0.0
        self._monitors_recorded: tuple[kinds.Monitor, ...] = ()

    def announcement(self, frame: Frame) -> str:
        """Return the text of an announced clearance problem, once; empty if there is none."""
        by, self.announced = self.announced, ""
        if not by or frame.time_s < self._quiet_until_s:
            return ""
        self._quiet_until_s = frame.time_s + QUIET_S
        near = frame.work.nearest
        where = "" if near is None else f": {near.a} to {near.b} {near.clearance:.2f} m"
        return f"clearance problem announced by the {by}{where}"

    def record(self, recorder: SessionRecorder, time_s: float) -> str:
        """Record monitors and lighting, if they have changed.

        Args:
            recorder: recorder of the run.
            time_s: simulated time from which the values apply [s].

        Returns:
            Text for the log if the light condition or the lamps have changed during the run; else empty.
        """
        if self.monitors != self._monitors_recorded:
            self._monitors_recorded = self.monitors
            recorder.shown(time_s, self._monitors_recorded)
        lighting, before = self.lighting, self.lit
        if lighting == before:
            return ""
        self.lit = lighting
        recorder.light(time_s, lighting)
        if before is None or (lighting.condition, lighting.lamps) == (before.condition, before.lamps):
            return ""
        return f"light: {lighting.condition}; lamps lit: {', '.join(lighting.lamps) or 'none'}"
