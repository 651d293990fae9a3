"""Everything that the next step depends on."""

from __future__ import annotations

from typing import Literal

import msgspec
import numpy as np
from numpy.typing import NDArray

from aftdeck.bodies.cameras import Setting
from aftdeck.kinematics.arm import Arm
from aftdeck.kinematics.linkage import L1
from aftdeck.kinematics.observe import OBSERVED
from aftdeck.plant.kinematic import KinematicPlant
from aftdeck.plant.slide import stand_of
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.target import Target
from aftdeck.simulation.cameras import Cameras
from aftdeck.simulation.carried import Carried
from aftdeck.simulation.frame import Check, Event, Level, Sequence, Six, WayOut
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.site import Site
from aftdeck.simulation.things import SavedThings, Things
from aftdeck.steering.layout import COMMAND, MASTER, REPORT, STATE
from aftdeck.steering.mode import LawChoice
from aftdeck.steering.msteer import measured
from aftdeck.steering.rules import Rate

Array = NDArray[np.float64]


class Panel(msgspec.Struct):
    """How the panel's switches stand, and the lamps that the log has already told of."""

    mode: str
    joint: int
    rate: Rate
    law: LawChoice = "closed loop"
    """What OPR CMD and AUTO 1-4 fly."""
    payload_axes: bool = False
    """ORB LD rotates in payload axes."""
    held: Six | None = None
    """Sticks (rotation, translation) that RATE HOLD keeps."""
    position_hold: bool = False
    """POSITION HOLD switch."""
    brakes: bool = False
    """BRAKES switch: the joints stand."""
    safing: bool = False
    """SAFING: zero joint rates are commanded."""
    holding: Target | None = None
    """The pose that POSITION HOLD keeps; None while sticks move."""
    keyed: Target | None = None
    """OPR CMD's keyed-in pose."""
    target: Target | None = None
    """Where the present automatic mode goes next."""
    point: int = 0
    """AUTO 1-4: the point, from 0, that comes next."""
    check: Check | None = None
    """CMD CK: whether the way to the target is clear."""
    sequence: Sequence = "idle"
    blocked: int = 0
    """Steps for which an automatic motion has been held at a standstill."""
    zones: tuple[int, int, int, int, int, int] = (0, 0, 0, 0, 0, 0)
    singular: tuple[str, ...] = ()
    clearance: Level = "info"
    """What the least clearance calls for."""
    advice: dict[str, int] = msgspec.field(default_factory=dict)
    """The stick that was named last as the way out, by its cause."""


class Script(msgspec.Struct):
    """Where the scenario's script stands."""

    phase: int = 0
    """Index of the phase; the number of phases once the last has ended."""
    began: int = -1
    """Tick at which the phase began; -1 before that."""
    ended: Literal["", "completed", "time", "fault"] = ""


class State:
    """The simulation's whole state. Arrays are those of `steering.layout`.

    Attributes:
        tick: control steps done, with the one under way.
        panel: switches.
        script: where the script stands.
        under_way: a person's inputs that the command delay holds back, oldest first.
        carried: what the arm holds, and its rules with it.
        plant: what moves.
        site: the worksite.
        cameras: their drives.
        steering: measured angles and rise, commanded rates, commanded twist.
        command: what the steering laws are told in this step.
        report: what they said of it.
        by_script: whether the script flew the last step.
        phase: its phase then.
        seen: (21,) what an observer sees of the arm, of `kinematics.observe`.
        ways_out: what leads away from singularities that are near, and back from limits passed.
        events: of the step under way.
    """

    def __init__(self, scenario: Scenario, site: Site, carried: Carried) -> None:
        self.tick = 0
        self.panel = Panel(
            scenario.mode,
            0,
            scenario.rate,
            law=scenario.law,
            payload_axes=scenario.payload_axes,
            position_hold=scenario.position_hold,
        )
        self.script = Script()
        self.under_way = [Inputs()] * scenario.delay
        self.carried = carried
        self.plant = KinematicPlant(scenario.initial_angles, scenario.initial_rates, stand_of(scenario.arm.model))
        self._arm = scenario.arm
        self._height = float(scenario.arm.model.links[L1])
        self.site = Things(scenario, site)
        self.cameras = Cameras(scenario)
        self.steering = np.zeros(STATE)
        self.command = np.zeros(COMMAND)
        self.command[MASTER : MASTER + 6] = scenario.initial_angles
        self.report = np.zeros(REPORT)
        self.by_script, self.phase = False, ""
        self.seen = np.zeros(OBSERVED)
        self.ways_out: tuple[WayOut, ...] = ()
        self.events: list[Event] = []

    def save(self) -> Saved:
        """A copy that nothing changes."""
        return Saved(
            self.tick,
            msgspec.structs.replace(self.panel, advice=dict(self.panel.advice)),
            msgspec.structs.replace(self.script),
            tuple(self.under_way),
            self.plant.save(),
            self.site.save(),
            self.steering.tolist(),
            self.command.tolist(),
            self.report.tolist(),
            self.cameras.save(),
        )

    def restore(self, saved: Saved) -> None:
        """Go on from what `save` gave."""
        self.tick = saved.tick
        self.panel = msgspec.structs.replace(saved.panel, advice=dict(saved.panel.advice))
        self.script = msgspec.structs.replace(saved.script)
        self.under_way = list(saved.under_way)
        self.plant.restore(saved.plant)
        self.site.restore(saved.site)
        self.steering[:] = saved.steering
        self.command[:] = saved.command
        self.report[:] = saved.report
        self.cameras.restore(saved.cameras)
        self.events.clear()

    def become(self, other: State) -> None:
        """Be as another state of the same flight, but for the tick, script, log, cameras and inputs under way."""
        self.panel, self.carried, self.plant, self.site = other.panel, other.carried, other.plant, other.site
        self.steering = other.steering
        self.command, self.report = other.command, other.report

    def measure(self) -> None:
        """Take up where the arm is: what steering, plans and checks start from."""
        measured(self.plant.angles, self.rise, self.steering)

    @property
    def rise(self) -> float:
        """How much higher the shoulder stands than the steering's rules have it [m]."""
        return self.plant.stand.position - self._height

    @property
    def arm(self) -> Arm:
        """The arm as it stands: with its telescope at its present length."""
        if self._arm.model.links[L1] != self.plant.stand.position:
            self._arm = self._arm.at(stand=self.plant.stand.position)
        return self._arm


class Saved(msgspec.Struct, frozen=True):
    """A state as plain values; `simulation.run.Simulation` wraps it with the scenario it belongs to."""

    tick: int
    panel: Panel
    script: Script
    under_way: tuple[Inputs, ...]
    plant: tuple[list[float], ...]
    site: SavedThings
    steering: list[float]
    command: list[float]
    report: list[float]
    cameras: tuple[Setting, ...]
