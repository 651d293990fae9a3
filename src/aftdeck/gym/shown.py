"""Single environment that shows its episodes: in pictures, or in pages of the station."""

from __future__ import annotations

from abc import abstractmethod
from typing import TYPE_CHECKING

import gymnasium

from aftdeck.export.pictures import Pixels
from aftdeck.gym.choices import not_rendered, rendered
from aftdeck.gym.picture import MODES
from aftdeck.gym.terms import Floats32

if TYPE_CHECKING:
    from aftdeck.gym.live import LiveStation


class ShownEnv(gymnasium.Env[Floats32, Floats32]):
    """Environment with the render modes ``rgb_array`` and ``human``.

    Attributes:
        station: station that shows the episodes; None unless the mode is ``human``.
    """

    def __init__(self, render_mode: str | None) -> None:
        """Set the render mode.

        Raises:
            InputError: the mode is not allowed.
        """
        self.render_mode = rendered(render_mode, MODES)
        self.station: LiveStation | None = None
        if self.render_mode == "human":
            from aftdeck.gym.live import LiveStation  # noqa: PLC0415  (a web server, which no other mode needs)

            self.station = LiveStation()

    @abstractmethod
    def _picture(self) -> Pixels:
        """Return the picture (height, width, 3) of the present state, in the mode ``rgb_array``."""

    def render(self) -> Pixels | None:
        """Return the picture (height, width, 3) of the camera; None if the mode is ``human``.

        Raises:
            InputError: the environment was made without pictures.
        """
        if self.render_mode is None:
            raise not_rendered()
        return self._picture() if self.render_mode == "rgb_array" else None

    def close(self) -> None:
        """End the station, if there is one."""
        if self.station is not None:
            self.station.close()
