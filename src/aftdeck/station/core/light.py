"""Lines of the log about the light of a run."""

from __future__ import annotations

from aftdeck.scenario.light import Lighting


class Lights:
    """Lighting of the newest step of a run."""

    def __init__(self) -> None:
        self._lit: Lighting | None = None

    def change(self, lighting: Lighting) -> str:
        """Take the lighting of a step; return a line if condition or lamps have changed during the run, else empty."""
        before, self._lit = self._lit, lighting
        if before is None or (lighting.condition, lighting.lamps) == (before.condition, before.lamps):
            return ""
        return f"light: {lighting.condition}; lamps lit: {', '.join(lighting.lamps) or 'none'}"
