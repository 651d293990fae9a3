"""Link between a session and its pages: the steps whose values and pictures the pages show."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple

from aftdeck.station.messages.frame import CameraStep, LinkSteps


class LinkDelays(NamedTuple):
    """Delays of a link [s].

    Attributes:
        telemetry: delay of values, lamps and log.
        camera: delay of the pictures of all cameras without a delay of their own.
        cameras: delays of other cameras, by their names.
    """

    telemetry: float
    camera: float
    cameras: Mapping[str, float] = MappingProxyType({})


class Link:
    """Link of a session, which counts the session's steps.

    Attributes:
        delays: its delays, which may change between two steps; they act as whole control periods.
    """

    def __init__(self, period: float, delays: LinkDelays) -> None:
        """Begin before the first step of a session with this control period [s]."""
        self.delays = delays
        self._period = period
        self._last = LinkSteps(0, -self._periods(delays.telemetry), -self._periods(delays.camera), ())

    def next(self) -> LinkSteps:
        """Count a step, and return the steps that the pages show when it has been made.

        A page never goes back: after a delay has grown, it shows the same step until a newer one arrives.
        """
        last, delays = self._last, self.delays
        step = last.step + 1

        def arrived(shown: int, delay: float) -> int:
            return max(shown, step - self._periods(delay))

        pictures = arrived(last.pictures, delays.camera)
        before = {camera: shown for camera, shown in last.cameras}
        cameras = {
            camera: arrived(before.get(camera, last.pictures), delays.cameras.get(camera, delays.camera))
            for camera in (*before, *delays.cameras)
        }
        own = tuple(CameraStep(camera, shown) for camera, shown in cameras.items() if shown != pictures)
        self._last = LinkSteps(step, arrived(last.telemetry, delays.telemetry), pictures, own)
        return self._last

    def _periods(self, delay: float) -> int:
        return round(delay / self._period)
