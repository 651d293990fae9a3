"""`Simulation`, which its caller advances step by step, and `run`, which runs a whole scenario headless."""

from __future__ import annotations

import hashlib
import math
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Literal, cast

import msgspec

from aftdeck.errors import InputError, SimulationError
from aftdeck.plant.readings import Readings
from aftdeck.scenario.changes import parse_key
from aftdeck.scenario.in_flight import MOST_CHANGES, merged
from aftdeck.scenario.load import load_scenario
from aftdeck.scenario.model import Scenario, Start
from aftdeck.simulation.begin import initial_state
from aftdeck.simulation.constants.flight import Flight, run_constants
from aftdeck.simulation.frame import Event, Frame, Level
from aftdeck.simulation.in_flight import Made, check_fit, constants_with, go_on, resumed
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.observe.look import frame_of
from aftdeck.simulation.observe.look_ahead import Ahead, Axis, look_ahead
from aftdeck.simulation.observe.look_work import all_near
from aftdeck.simulation.payloads.disturbances import check_disturbances
from aftdeck.simulation.plain import only_moves, plain_inputs, whole
from aftdeck.simulation.series.series import Series
from aftdeck.simulation.state import State
from aftdeck.simulation.step import step, take_over
from aftdeck.simulation.summary import Summary, Tally
from aftdeck.state_part import digest, encoded
from aftdeck.table import Table
from aftdeck.units import short
from aftdeck.worksite.report import Near

MOST_READY = 4
"""Greatest number of prepared changes that a simulation keeps."""


class SavedSimulation(msgspec.Struct, frozen=True):
    """State of a simulation at one time, with the scenario's digest and the seed."""

    scenario: str
    """SHA-256 of the scenario's text, its changes, the arm's constants, and the worksite's text."""
    seed: int
    state: bytes
    """Bytes made by `aftdeck.state_part.encoded`."""


class Simulation:
    """One run of a scenario, stepped by its caller.

    Attributes:
        scenario: the scenario with which the run began; `in_force` has the changes in flight.
        seed: seed of all random values (the kinematic plant has no random values).
    """

    def __init__(
        self, scenario: Scenario | str | Path, seed: int | None = None, *, digests: bool = True, gauged: bool = False
    ) -> None:
        """Prepare a run.

        Args:
            scenario: a scenario, a built-in name or a path.
            seed: seed of the run; None for the scenario's seed.
            digests: whether every frame has the digest of the exact state. Without digests, a step with its frame takes
                about a tenth less time.
            gauged: whether a plant with masses has gauges, for `readings`. The run is the same, and takes longer.
        """
        self.scenario = scenario if isinstance(scenario, Scenario) else load_scenario(scenario)
        self.seed = self.scenario.seed if seed is None else whole(seed, "seed")
        self._frame: Frame | None = None
        self._digests, self._gauged, self._seal = digests, gauged, b""
        self._given: Inputs | None = None
        self._flown = Inputs()
        self._base = self._flight = run_constants(self.scenario, gauged=self._gauged)
        self._ready: dict[tuple[str, ...], Flight] = {}
        self._state = initial_state(self._flight)
        worksite = self.scenario.worksite.text
        constants = f"{self.scenario.text}\n{self.scenario.changes}\n{self.scenario.arm.model.source}\n{worksite}"
        self._stepped = False
        self._digest = hashlib.sha256(constants.encode()).hexdigest()

    def __getstate__(self) -> dict[str, object]:
        """Return the fields for `copy` and `pickle`: the constants of the run are left out, and the state is saved.

        A copy then goes its own way. Making it takes as long as making a simulation; `save` and `restore` are quicker.
        """
        fields = {
            name: value for name, value in vars(self).items() if name not in ("_base", "_flight", "_ready", "_state")
        }
        return fields | {"_frame": self.frame, "_saved": encoded(self._state)}

    def __setstate__(self, fields: dict[str, object]) -> None:
        """Set the fields from those of another simulation, and make the constants of the run."""
        saved = cast("bytes", fields["_saved"])
        vars(self).update((name, value) for name, value in fields.items() if name != "_saved")
        self._base, self._ready = run_constants(self.scenario, gauged=self._gauged), {}
        self._flight, self._state = resumed(self._base, saved, gauged=self._gauged)

    @property
    def parts(self) -> tuple[Flight, State]:
        """Constants of the run and its state, for functions that read the state's row; nothing else changes them."""
        return self._flight, self._state

    def twin(self) -> Simulation:
        """Return a simulation of the same scenario, seed and options at its start, which shares this one's constants.

        Raises:
            InputError: the plant has masses, whose constants have a state.
        """
        if self.scenario.plant != "kinematic":
            raise InputError(f"plant: got {self.scenario.plant!r}, expected 'kinematic'")
        twin = object.__new__(Simulation)
        vars(twin).update(vars(self))
        twin.restart()
        twin._ready = {}
        return twin

    @property
    def in_force(self) -> Scenario:
        """Scenario with the changes in flight that are in force."""
        return self._flight.scenario

    @property
    def ended(self) -> Literal["", "completed", "time", "fault"]:
        """Reason for the end of the scenario's script; "" if it has not ended. Manual inputs never end the script."""
        return self._state.script.ended

    @property
    def frame(self) -> Frame | None:
        """Frame of the last step; None before the first step, and between `restore` and the next step."""
        return self.look() if self._stepped else None

    @property
    def readings(self) -> Readings | None:
        """Readings of the gauges in the last step; None without gauges or masses, and whenever `frame` is None."""
        return self._flight.plant.readings if self._stepped else None

    @property
    def cameras(self) -> tuple[str, ...]:
        """Names of the cameras that have a drive."""
        return self._flight.cameras.names

    @property
    def given(self) -> Inputs | None:
        """Inputs that the caller passed to the last step; None before the first step, or if the caller passed none."""
        return self._given

    @property
    def flown(self) -> Inputs:
        """Inputs that acted in the last step: those of the script, or the caller's after the command delay."""
        return self._flown

    def step(self, inputs: Inputs | None = None) -> Frame:
        """Advance by one control period and return the frame; arguments and errors as for `advance`."""
        self.advance(inputs)
        return self.look()

    def advance(self, inputs: Inputs | None = None) -> None:
        """Advance by one control period.

        Args:
            inputs: sticks and switches; with None the scenario's script supplies them. They are converted to plain
                values, which are checked, flown and recorded.

        Raises:
            InputError: a value has another type, hand controllers and switches cannot produce the inputs, the target is
                not a pose or contradicts its joint angles, the camera has no drive, a disturbance cannot act, or a
                change in flight is not possible. The state is then unchanged.
            SimulationError: the state is no longer finite.
        """
        self._advance(None if inputs is None else self.checked(inputs), 1)

    def hold(self, inputs: Inputs, steps: int) -> None:
        """Advance by several control periods with the same inputs, as that many calls of `advance` do, but quicker.

        Arguments and errors are those of `advance`, for each of the steps.
        """
        last = self._state.tick + whole(steps, "steps")
        inputs = self.checked(inputs)
        while (now := self._state.tick) < last:
            # a step in which the scenario changes something is a call of its own
            planned = (max(at - 1, now + 1) for at in self.scenario.changes_at if at > now)
            self._advance(inputs, min([last, *planned]) - now)

    def _advance(self, inputs: Inputs | None, most: int) -> None:
        """Advance by one to `most` control periods, with inputs that are checked."""
        lines = [*self._change(inputs.changes if inputs is not None else {}), *self._planned_changes()]
        state = self._state
        self._flown = step(self._flight, state, inputs, most)
        state.events[:0] = lines
        self._end_step(inputs)

    def _end_step(self, inputs: Inputs | None) -> None:
        """Forget what belonged to the step before; `inputs` are those that the caller gave."""
        state, self._given = self._state, inputs
        self._stepped, self._frame, self._seal = True, None, b""
        angles = state.plant.angles.tolist()
        if not all(map(math.isfinite, angles)):
            time = state.tick * self.scenario.control_period
            raise SimulationError(f"the arm's state is no longer finite at {time:g} s: {angles}")

    def take_over(self, inputs: Inputs, made: int, reached: int) -> None:
        """Take over control periods that compiled code has made in the state's row; arguments as for `step.take_over`.

        Raises:
            SimulationError: the state is no longer finite.
        """
        take_over(self._flight, self._state, inputs, made, reached)
        self._flown = inputs
        self._end_step(inputs)

    def checked(self, inputs: object) -> Inputs:
        """Return inputs with plain values, which `advance` accepts.

        Raises:
            InputError: as for `advance`.
        """
        if only_moves(inputs):
            return inputs
        plain = plain_inputs(inputs)
        plain.check(self._state.arm)
        if plain.camera is not None:
            self._flight.cameras.check(plain.camera)
        if plain.disturbances:
            check_disturbances(self._flight, self._state, plain.disturbances)
        if plain.changes:
            try:
                self.prepare(plain.changes)
            except InputError as error:
                raise InputError(f"changes: {error}") from None
        return plain

    def prepare(self, changes: Mapping[str, str], made: Made | None = None) -> Scenario:
        """Prepare changes in flight, so that the step in which they act takes milliseconds and not tenths of a second.

        A thread of its own may call this while another one steps.

        Args:
            changes: values by their keys, as in `Inputs.changes`.
            made: constants that another process has made; they are used if they contain exactly the changes that are
                then in force.

        Returns:
            The scenario that will then be in force.

        Raises:
            InputError: a change is not possible now.
        """
        if len(changes) > MOST_CHANGES:
            raise InputError(f"{len(changes)} changes in one step; at most {MOST_CHANGES} are allowed")
        if made is not None:
            self._keep(made)
        flight = self._with(merged(self._state.changes, changes))
        check_fit(self._flight, flight, self._state, [parse_key(key) for key in changes])
        return flight.scenario

    def _with(self, changes: tuple[str, ...]) -> Flight:
        """Return the constants of the run with changes in force, and keep them for the step in which they act."""
        flight = self._ready.get(changes)
        if flight is None:
            flight = constants_with(self._base, changes, gauged=self._gauged)
            self._keep(Made(changes, flight))
        return flight

    def _keep(self, made: Made) -> None:
        """Keep constants for the step in which their changes act."""
        if len(self._ready) >= MOST_READY:
            self._ready.clear()
        self._ready[made.changes] = made.flight

    def _change(self, changes: Mapping[str, str]) -> list[Event]:
        """Change values in flight, and return the lines about it for the log of the next step."""
        if not changes:
            return []
        after = merged(self._state.changes, changes)
        flight = self._with(after)
        self._state = go_on(self._flight, flight, self._state, after, [parse_key(key) for key in changes])
        self._flight = flight
        return [self._line(f"{key} = {value}", "info") for key, value in changes.items()]

    def _planned_changes(self) -> list[Event]:
        """Make the changes that the scenario plans for the next step; one that is not possible now is logged."""
        lines: list[Event] = []
        for planned in self.scenario.changes_at.get(self._state.tick + 1, ()):
            try:
                lines += self._change(planned)
            except InputError as error:
                lines.append(self._line(f"planned change refused: {error}", "caution"))
        return lines

    def _line(self, text: str, level: Level) -> Event:
        """Return a line of the log of the next step."""
        return Event((self._state.tick + 1) * self.scenario.control_period, "change", level, text)

    def seal(self) -> bytes:
        """Return the SHA-256 digest of the exact state after the last step, which is `Frame.sha256`.

        The method returns it for a simulation without digests, too.
        """
        if not self._seal:
            self._seal = digest(self._state)
        return self._seal

    def add_to(self, tally: Tally) -> None:
        """Add the last control step to the values of a summary."""
        tally.take(self._state, self._frame_seal())

    def look(self) -> Frame:
        """Return the frame of the last control step.

        The call does not change the state, and takes about as long as a step.
        """
        if self._frame is None:
            self._frame = frame_of(self._flight, self._state, self._frame_seal())
        return self._frame

    def _frame_seal(self) -> bytes:
        """Return the digest for the frame and the summary; empty without digests."""
        return self.seal() if self._digests else b""

    def ahead(self, seconds: float = 5.0, last: Axis | None = None) -> Ahead:
        """Return a prediction of the arm's motion with the present stick command.

        Args:
            seconds: prediction time, 2 to 20 [s].
            last: axis and sign of the full deflection to assume if the sticks are centred; None for no deflection.

        Raises:
            InputError: `seconds` is outside its range, or `last` is not an axis with a sign.
        """
        return look_ahead(self._flight, self._state, seconds, last)

    def watched(self) -> tuple[Near, ...]:
        """Return clearance, points, plane and closing speed of every monitored pair, the smallest clearance first."""
        return all_near(self._flight.site.layout, self._state.worksite, self.scenario.control_period)

    def save(self) -> SavedSimulation:
        """Return everything that the next step depends on, as plain values that msgspec can encode."""
        return SavedSimulation(self._digest, self.seed, encoded(self._state))

    def restore(self, saved: SavedSimulation) -> None:
        """Replace the state by a saved state of this or another simulation of the same scenario.

        Raises:
            InputError: the saved state belongs to another scenario, or cannot be read. The simulation is then
                unchanged.
        """
        if not isinstance(cast("object", saved), SavedSimulation):
            raise InputError(f"saved: got {short(saved)}, expected a SavedSimulation")
        seed = whole(saved.seed, "saved.seed")
        if saved.scenario != self._digest:
            raise InputError(
                f"the saved state belongs to a scenario with digest {str(saved.scenario)[:12]}; the scenario of this "
                f"simulation is {self.scenario.name!r} with digest {self._digest[:12]}"
            )
        self._flight, self._state = resumed(self._base, saved.state, gauged=self._gauged)
        self.seed = seed
        self._stepped, self._frame, self._given, self._seal = False, None, None, b""

    def restart(self, start: Start | None = None, *, in_place: bool = False) -> None:
        """Begin the run again; this takes milliseconds, a new simulation up to a second.

        A recording contains the scenario and the inputs. Therefore a recording of a run with `start` can be
        re-simulated only if its scenario begins at this start (`aftdeck.gym.record`).

        Args:
            start: initial conditions of the arm that replace those of the scenario; None for those of the scenario.
            in_place: whether the new state is made in the memory of the present one, which takes half the time.

        Raises:
            ScenarioError: `start` gives a held payload that the end effector could not have captured in this pose. The
                simulation is then unchanged; with `in_place`, it has to be restarted.
        """
        used = self._state if in_place and self._flight is self._base else None
        self._state, self._flight = initial_state(self._base, start, used), self._base
        self._flown, self._stepped, self._frame, self._given, self._seal = Inputs(), False, None, None, b""


class Run(msgspec.Struct, frozen=True):
    """Result of a whole run."""

    scenario: Scenario
    frames: tuple[Frame, ...]
    events: tuple[Event, ...]
    summary: Summary
    inputs: tuple[Inputs | None, ...]
    """Inputs that the caller gave to each step; None for a step of the script."""

    def table(self, *columns: str) -> Table:
        """Return the time history of the run, a row for each step.

        If a column needs gauges, or if the run has not kept its frames, the run is repeated, which gives the same
        steps.

        Args:
            columns: names of groups or of columns (docs/series.md); none for all.

        Raises:
            InputError: there is no such group or column.
        """
        series = Series(self.scenario, columns)
        if len(self.frames) == len(self.inputs) and not series.gauged:
            for frame in self.frames:
                series.see(frame, None)
            return series.table()
        sim = Simulation(self.scenario, self.summary.seed, digests=False, gauged=series.gauged)
        for given in self.inputs:
            sim.advance(given)
            series.see(sim.look(), sim.readings)
        return series.table()


def run(
    scenario: Scenario | str | Path,
    seed: int | None = None,
    *,
    inputs: Callable[[Simulation], Inputs | None] | None = None,
    keep_frames: bool = True,
    progress: Callable[[float], None] | None = None,
    seen: Callable[[Frame], None] | None = None,
    stepped: Callable[[Simulation], None] | None = None,
    digests: bool = True,
    gauged: bool = False,
) -> Run:
    """Run a scenario headless to its end, with the inputs of its script or of a function.

    Args:
        scenario: a scenario, a built-in name or a path.
        seed: seed of the run; if None, the scenario's seed.
        inputs: called before every step; returns the inputs of the step, or None to end the run. If `inputs` is None,
            the scenario's script supplies the inputs.
        keep_frames: whether the result contains all frames. False, for long runs, keeps only the last frame.
        progress: called every 256 steps with the elapsed fraction, 0 to 1, of the scenario's duration.
        seen: called with every frame.
        stepped: called with the simulation after every step.
        digests: whether frames and summary have digests, as for `Simulation`.
        gauged: whether a plant with masses has gauges, as for `Simulation`; `stepped` can then read them.

    Raises:
        InputError: `inputs` returned None for the first step, or inputs that hand controllers and switches cannot
            produce.
    """
    sim = Simulation(scenario, seed, digests=digests, gauged=gauged)
    frames: list[Frame] = []
    flown: list[Inputs | None] = []
    tally = Tally()
    while not sim.ended:
        given = None if inputs is None else inputs(sim)
        if given is None and inputs is not None:
            break
        sim.advance(given)
        sim.add_to(tally)
        flown.append(sim.given)
        if keep_frames or seen is not None:
            frame = sim.look()
            if keep_frames:
                frames.append(frame)
            if seen is not None:
                seen(frame)
        if stepped is not None:
            stepped(sim)
        if progress is not None and tally.ticks % 256 == 0:
            progress(tally.ticks / sim.scenario.ticks)
    if tally.ticks == 0:
        raise InputError("inputs: got None for the first step, expected Inputs")
    last = sim.look()
    summary = tally.summary(sim.scenario, sim.seed, sim.ended or "completed", last)
    kept = tuple(frames) if keep_frames else (last,)
    return Run(sim.scenario, kept, tuple(tally.events), summary, tuple(flown))
