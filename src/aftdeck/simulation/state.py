"""Everything that the next step depends on."""

from __future__ import annotations

from typing import Literal

import msgspec
import numpy as np

from aftdeck.arrays import Array
from aftdeck.kinematics.arm import Arm
from aftdeck.kinematics.linkage import L1
from aftdeck.kinematics.observe import OBSERVED
from aftdeck.plant.kinematic import KinematicPlant
from aftdeck.plant.slide import Slide
from aftdeck.scenario.target import Target
from aftdeck.simulation.cameras import Views
from aftdeck.simulation.carried import Carried
from aftdeck.simulation.checking import Checking, Premises
from aftdeck.simulation.flight import Flight
from aftdeck.simulation.frame import Check, Event, Level, Sequence, Six, WayOut
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.standing import Standing
from aftdeck.simulation.things import Things, new_things
from aftdeck.state_part import StatePart, copied
from aftdeck.steering.layout import COMMAND, GO, KEPT, MASTER, REPORT, STATE
from aftdeck.steering.mode import AUTOMATIC_LAWS, MODES, LawChoice
from aftdeck.steering.msteer import measured
from aftdeck.steering.rules import Rate

Ending = Literal["", "reached", "missed", "given up"]


class Panel(StatePart):
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


class Script(StatePart):
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


class State(StatePart):
    """The simulation's whole state. Arrays are those of `steering.layout`.

    Attributes:
        panel: switches.
        script: where the script stands.
        under_way: a person's inputs that the command delay holds back, oldest first.
        plant: what moves.
        site: the worksite.
        views: where the drives of the cameras stand.
        steering: measured angles and rise, commanded rates, commanded twist.
        command: what the steering laws are told in this step.
        report: what they said of it.
        seen: (21,) what an observer sees of the arm, of `kinematics.observe`.
        carried: what the arm holds, and its rules with it.
        standing: the arm on its telescope.
        tick: control steps done, with the one under way.
        by_script: whether the script flew the last step.
        phase: its phase then.
        checking: CMD CK under way; None: none is.
        ways_out: what leads away from singularities that are near, and back from limits passed.
        events: of the step under way.
    """

    panel: Panel
    script: Script
    under_way: list[Inputs]
    plant: KinematicPlant
    site: Things
    views: Views
    steering: Array
    command: Array
    report: Array
    seen: Array
    carried: Carried
    standing: Standing
    tick: int = 0
    by_script: bool = False
    phase: str = ""
    checking: Checking | None = None
    ways_out: tuple[WayOut, ...] = ()
    events: list[Event] = msgspec.field(default_factory=list)

    def fork(self) -> State:
        """Return a copy on which to fly ahead, without CMD CK: nothing that is done to it changes this state."""
        copy = copied(self)
        copy.checking = None
        return copy

    def become(self, other: State) -> None:
        """Take over another state of the same flight; keep the tick, the script, the log and the delayed inputs."""
        for name in ("panel", "carried", "plant", "site", "steering", "views", "command", "report", "checking"):
            setattr(self, name, getattr(other, name))

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
        return self.plant.stand.position - self.standing.height

    @property
    def arm(self) -> Arm:
        """The arm as it stands: with its telescope at its present length."""
        return self.standing.at(self.plant.stand.position)


def new_state(flight: Flight, carried: Carried) -> State:
    """A state in which nothing has been put into its place yet."""
    scenario, views, height = flight.scenario, flight.cameras.first, float(flight.scenario.arm.model.links[L1])
    command = np.zeros(COMMAND)
    command[MASTER : MASTER + 6] = command[KEPT : KEPT + 6] = scenario.initial_angles
    panel = Panel(
        scenario.mode,
        0,
        scenario.rate,
        law=scenario.law,
        payload_axes=scenario.payload_axes,
        position_hold=scenario.position_hold,
        camera=flight.cameras.names[0] if views else "",
    )
    angles, rates = scenario.initial_angles, scenario.initial_rates
    return State(
        panel=panel,
        script=Script(attached=0 if scenario.payload is None else 1),
        under_way=[Inputs()] * scenario.delay,
        plant=KinematicPlant(angles.copy(), rates.copy(), angles.copy(), Slide(height)),
        site=new_things(flight.site, flight.prong),
        views=views,
        steering=np.zeros(STATE),
        command=command,
        report=np.zeros(REPORT),
        seen=np.zeros(OBSERVED),
        carried=carried,
        standing=Standing(scenario.arm),
    )
