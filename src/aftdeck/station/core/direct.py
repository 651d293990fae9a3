"""Host of a core that steps it when its caller says so: without server, thread, clock or file."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Sequence
from io import BytesIO

import msgspec

from aftdeck.recording.content import Ended
from aftdeck.recording.direct import DirectRecorder
from aftdeck.recording.records import Opening
from aftdeck.scenario.model import Scenario
from aftdeck.station.core.autopilot import Autopilots
from aftdeck.station.core.core import Core
from aftdeck.station.core.entries import Entries
from aftdeck.station.core.news import News
from aftdeck.station.core.step import PUNCTUAL, Begun, Delay, Observer, Step
from aftdeck.station.messages import from_page, to_page

_messages: msgspec.json.Decoder[to_page.FromServer] = msgspec.json.Decoder(to_page.FromServer)


class DirectRecording:
    """Recordings of a session's runs, each as the bytes of a file.

    Attributes:
        files: the recordings; the last one may still grow.
    """

    def __init__(self, start: Callable[[Scenario, int], Opening], began_ns: int) -> None:
        """Record all runs.

        Args:
            start: returns the header of a recording, from the scenario and the seed.
            began_ns: wall time at which the host's clock was 0, since 1970 [ns].
        """
        self.files: list[BytesIO] = []
        self._start, self._began_ns = start, began_ns
        self._recorder: DirectRecorder | None = None
        self._entries = Entries(0.0)

    def begin(self, scenario: Scenario, seed: int, now: float) -> None:
        """Begin a run at the time `now` [s], on the host's clock."""
        self.files.append(BytesIO())
        self._entries = Entries(now)
        self._recorder = DirectRecorder(self.files[-1], self._start(scenario, seed), self._began_ns + round(now * 1e9))

    def see(self, step: Step) -> None:
        """Record a step."""
        if self._recorder is not None:
            for entry in self._entries.of(step):
                self._recorder.put(entry)

    def end(self, ended: Ended, step: Begun | None = None) -> None:
        """End the run, with the step that the simulation has not made."""
        if self._recorder is None:
            return
        for entry in self._entries.before_the_end(step) if step is not None else ():
            self._recorder.put(entry)
        self._recorder.finish(ended)
        self._recorder = None

    @property
    def recorded(self) -> bool:
        """Whether a run is recorded."""
        return self._recorder is not None


class DirectPage:
    """Page of a direct host."""

    def __init__(self, core: Core, *, may_fly: bool, strips: bool) -> None:
        self._core = core
        self._news = News(self, may_fly=may_fly, strips=strips)
        self.answers: deque[to_page.Answers] = deque()

    def send(self, message: from_page.FromPage) -> None:
        """Send a message to the session."""
        for page, answer in self._core.receive(self, message):
            assert isinstance(page, DirectPage), "all pages of a direct host are its own"
            page.answers.append(answer)

    def receive(self) -> list[to_page.FromServer]:
        """Return the messages that are new for the page."""
        messages = [_messages.decode(encoded) for encoded in self._news.of(self._core)]
        messages += self.answers
        self.answers.clear()
        return messages


class Direct:
    """Session whose caller steps it, with a clock that counts the control periods.

    Attributes:
        core: the session.
        now: the host's time [s].
        recording: the recordings; None: runs are not recorded.
    """

    def __init__(
        self,
        scenario: Scenario,
        seed: int | None = None,
        *,
        recording: DirectRecording | None = None,
        observers: Sequence[Observer] = (),
        demo: bool = False,
        autopilots: Autopilots | None = None,
    ) -> None:
        """Begin a run.

        Args:
            scenario: the scenario to run.
            seed: random seed; None selects the scenario's seed.
            recording: records the runs; None: they are not recorded.
            observers: further observers of each step.
            demo: whether the script flies until a page takes over.
            autopilots: returns what flies a scenario in this way, if the script does not; None: nothing.
        """
        self.now, self.recording = 0.0, recording
        self.core = Core(
            scenario,
            seed,
            clock=lambda: self.now,
            recording=recording,
            observers=observers,
            demo=demo,
            autopilots=autopilots,
        )
        self.core.begin()

    def join(self, *, may_fly: bool = True, strips: bool = False) -> DirectPage:
        """Return a new page; the first one that may fly is in control."""
        page = DirectPage(self.core, may_fly=may_fly, strips=strips)
        self.core.desk.join(page, may_fly=may_fly)
        return page

    def leave(self, page: DirectPage) -> None:
        """Remove a page."""
        self.core.desk.leave(page)

    def step(self, delay: Delay = PUNCTUAL) -> Step:
        """Make one control step, and let the clock go on by a control period."""
        step = self.core.advance(self.core.take(), delay)
        self.now += self.core.scenario.control_period
        return step

    def close(self) -> None:
        """End the run and its recording."""
        self.core.close()
