"""Everything that the next step depends on."""

from __future__ import annotations

from copy import deepcopy
from typing import Literal

import msgspec
import numpy as np

from aftdeck.arrays import Array
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
from aftdeck.simulation.checking import Checking, Premises, Tried, Way
from aftdeck.simulation.frame import Check, Event, Level, Sequence, Six, WayOut
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.site import Site
from aftdeck.simulation.things import SavedThings, Things
from aftdeck.steering.layout import COMMAND, GO, KEPT, MASTER, REPORT, STATE
from aftdeck.steering.mode import AUTOMATIC_LAWS, MODES, LawChoice
from aftdeck.steering.msteer import measured
from aftdeck.steering.rules import Rate

Ending = Literal["", "reached", "missed", "given up"]


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
    premises: Premises | None = None
    """What that verdict rests on."""
    proceeding: bool = False
    """PROCEED was pressed: the motion begins once CMD CK is GOOD."""
    sequence: Sequence = "idle"
    began: int = 0
    """Tick after which the report's phase began: a motion that set off, a phase of the script, a mode entered."""
    ending: Ending = ""
    """How an automatic motion ended in this step."""
    beside: str = ""
    """By how much it ended beside its target, for people; empty where it reached it."""
    blocked: int = 0
    """Steps for which an automatic motion has been held at a standstill."""
    zones: tuple[int, int, int, int, int, int] = (0, 0, 0, 0, 0, 0)
    singular: tuple[str, ...] = ()
    clearance: Level = "info"
    """What the least clearance calls for."""
    camera: str = ""
    """The camera that was addressed last, the report's station point; empty: none can be turned."""
    advice: dict[str, int] = msgspec.field(default_factory=dict)
    """The stick that was named last as the way out, by its cause."""

    @property
    def flown(self) -> int:
        """The number of the steering law that the switches choose."""
        mode = MODES[self.mode]
        if mode.kind == "automatic":
            return AUTOMATIC_LAWS[self.law]
        return mode.laws[-1] if self.payload_axes else mode.laws[0]


class Script(msgspec.Struct):
    """Where the scenario's script stands."""

    phase: int = 0
    """Index of the phase; the number of phases once the last has ended."""
    began: int = -1
    """Tick at which the phase began; -1 before that."""
    limits: int = -1
    """Index of the phase whose limits hold; -1: the scenario's do."""
    attached: int = 0
    """Which of the scenario's own payloads is in the grasp, from 1; 0: none of them."""
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
        flown: the inputs of the last step as they acted: the script's, or a person's after the command delay. No step
            depends on them.
        steering: measured angles and rise, commanded rates, commanded twist.
        command: what the steering laws are told in this step.
        report: what they said of it.
        by_script: whether the script flew the last step.
        phase: its phase then.
        seen: (21,) what an observer sees of the arm, of `kinematics.observe`.
        checking: CMD CK under way; None: none is.
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
        self.script = Script(attached=0 if scenario.payload is None else 1)
        self.under_way = [Inputs()] * scenario.delay
        self.carried = carried
        self.plant = KinematicPlant(
            scenario.initial_angles, scenario.initial_rates, stand_of(scenario.arm.model), scenario.arm.limits.hard
        )
        self._arm = scenario.arm
        self._height = float(scenario.arm.model.links[L1])
        self.site = Things(scenario, site)
        self.cameras = Cameras(scenario)
        self.panel.camera = self.cameras.first
        self.flown = Inputs()
        self.steering = np.zeros(STATE)
        self.command = np.zeros(COMMAND)
        self.command[MASTER : MASTER + 6] = self.command[KEPT : KEPT + 6] = scenario.initial_angles
        self.report = np.zeros(REPORT)
        self.by_script, self.phase = False, ""
        self.seen = np.zeros(OBSERVED)
        self.ways_out: tuple[WayOut, ...] = ()
        self.checking: Checking | None = None
        self.events: list[Event] = []
        self._constants = (scenario, scenario.arm, scenario.arm.model, scenario.worksite, site, site.layout)

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
            None if self.checking is None else _saved_checking(self.checking),
        )

    def fork(self) -> State:
        """Return a copy on which to fly ahead: nothing that is done to it changes this state."""
        memo: dict[int, object] = {id(one): one for one in (*self._constants, self.carried, self._arm)}
        memo[id(self.checking)] = None
        return deepcopy(self, memo)

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
        self.checking = None  # `simulation.begin.resume` takes it up again
        self.events.clear()

    def become(self, other: State) -> None:
        """Take over another state of the same flight; keep the tick, the script, the log and the delayed inputs."""
        self.panel, self.carried, self.plant, self.site = other.panel, other.carried, other.plant, other.site
        self.steering, self.cameras = other.steering, other.cameras
        self.command, self.report = other.command, other.report
        self.checking = other.checking

    def measure(self) -> None:
        """Take over the plant's measured angles and rates: what steering, plans and checks start from."""
        measured(self.plant.angles, self.plant.rates, self.rise, self.steering)

    @property
    def rules(self) -> Array:
        """The rules in force: before an automatic motion sets off, the arm comes to rest by those of mode 2."""
        return self.rules_while(under_way=bool(self.command[GO]))

    def rules_while(self, *, under_way: bool) -> Array:
        """The steering's rules while an automatic motion is under way, or not."""
        panel, law = self.panel, self.panel.flown
        if law == AUTOMATIC_LAWS["position"] and not under_way:
            law = AUTOMATIC_LAWS["closed loop"]
        return self.carried.rules[panel.mode, panel.rate, law]

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
    checking: SavedChecking | None = None


class SavedChecking(msgspec.Struct, frozen=True):
    """CMD CK under way, as plain values."""

    target: Target
    start: Saved | None
    ways: tuple[Way, ...]
    tried: tuple[Tried, ...]
    steps: int
    """How much of the first of `ways` has been rehearsed, from `start`; -1: that has not begun."""


def _saved_checking(checking: Checking) -> SavedChecking:
    return SavedChecking(
        checking.target,
        None if checking.start is None else checking.start.save(),
        tuple(checking.ways),
        tuple(checking.tried),
        -1 if checking.rehearsal is None else checking.rehearsal.steps,
    )
