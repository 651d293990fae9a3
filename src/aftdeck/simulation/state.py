"""State of the simulation: everything that the next step depends on."""

from __future__ import annotations

from functools import cached_property
from typing import Literal

import msgspec
import numpy as np

from aftdeck.arrays import Array
from aftdeck.kinematics.arm import Arm
from aftdeck.kinematics.observe import SEEN
from aftdeck.plant.state import PlantState, new_plant_state
from aftdeck.scenario.target import Target
from aftdeck.simulation.camera_drives import Views
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.frame import Check, Event, Level, Sequence, WayOut, Wrench
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.log import Log
from aftdeck.simulation.parts.carried import SteeringSetup
from aftdeck.simulation.parts.checking import Checking, Premises
from aftdeck.simulation.parts.standing import Standing
from aftdeck.simulation.parts.worksite_state import WorksiteState, new_worksite_state
from aftdeck.simulation.row.row import Row, RowArrays, row_of
from aftdeck.state_part import StatePart, copied
from aftdeck.steering.layout import COMMAND, MOTION_ACTIVE, REPORT, STATE
from aftdeck.steering.mode import AUTOMATIC_LAWS, MODES, ORB_UNL, LawChoice
from aftdeck.steering.msteer import measured
from aftdeck.steering.rules import Rate
from aftdeck.tuples import Six

Ending = Literal["", "reached", "missed", "given up"]


class Panel(StatePart):
    """Positions of the panel's switches, state of an automatic motion, and lamp states that have been logged."""

    mode: str
    joint: int
    rate: Rate
    law: LawChoice = "closed loop"
    """Steering law of OPR CMD and AUTO 1-4."""
    payload_axes: bool = False
    """True if ORB LD rotates in payload axes."""
    rate_hold_sticks: Six | None = None
    """Stick deflections (rotation, translation) that RATE HOLD keeps; None if RATE HOLD is off."""
    position_hold: bool = False
    """POSITION HOLD switch."""
    brakes: bool = False
    """BRAKES switch: stops all joints."""
    safing: bool = False
    """SAFING: zero joint rates are commanded."""
    position_hold_target: Target | None = None
    """Pose that POSITION HOLD keeps; None if it keeps no pose, for example while a stick is deflected."""
    keyed: Target | None = None
    """OPR CMD's keyed-in pose."""
    target: Target | None = None
    """Next target of the present automatic mode, or the keyed-in target."""
    point: int = 0
    """AUTO 1-4: index, from 0, of the next point."""
    check: Check | None = None
    """Verdict of CMD CK on the motion to the target; None before the verdict."""
    premises: Premises | None = None
    """Values on which the verdict in `check` depends."""
    proceeding: bool = False
    """True if PROCEED was pressed, and the motion has not started. The motion starts if CMD CK is GOOD."""
    sequence: Sequence = "idle"
    motion_began: int = 0
    """Tick from which TP counts: the start of a motion, a mode or a phase of the script."""
    ending: Ending = ""
    """Result of an automatic motion that ended in this step; "" if none ended."""
    final_error: str = ""
    """Final error of the motion that ended in this step, as text; "" if the target was reached or no motion ended."""
    blocked: int = 0
    """Number of steps for which an automatic motion has been at a standstill."""
    zones: tuple[int, ...] = ()
    singular: tuple[str, ...] = ()
    clearance: Level = "info"
    """Alarm level of the minimum clearance."""
    camera: str = ""
    """Camera that was commanded last (RMS-VS: station point); "" if no camera has a drive."""
    advice: dict[str, int] = msgspec.field(default_factory=dict)
    """Stick direction, 0 to 11, that was displayed last for each cause of an escape direction."""

    @property
    def flown(self) -> int:
        """Number of the steering law that the switches select."""
        mode = MODES[self.mode]
        if mode.kind == "automatic":
            return AUTOMATIC_LAWS[self.law]
        return mode.laws[-1] if self.payload_axes else mode.laws[0]

    @property
    def stick_law(self) -> int:
        """Number of the law for which stick directions are evaluated: of a manual mode, or else of ORB UNL."""
        return self.flown if MODES[self.mode].kind == "manual" else ORB_UNL


class Script(StatePart):
    """Progress of the scenario's script."""

    phase: int = 0
    """Index of the present phase; after the end of the last phase, the number of phases."""
    began: int = -1
    """Tick at which the present phase began; -1 before it begins."""
    limits: int = -1
    """Index of the phase whose rate limits are in force; -1 if the scenario's rate limits are in force."""
    attached: int = 0
    """Number, from 1, of the scenario's own payload that is attached to the end effector; 0 if none is."""
    ended: Literal["", "completed", "time", "fault"] = ""


class State(StatePart, dict=True):
    """Whole state of the simulation. `steering.layout` defines its arrays.

    Attributes:
        panel: switches.
        script: progress of the script.
        delayed_inputs: an operator's inputs that do not act yet because of the command delay, oldest first.
        plant: joints and telescope as steering measures them, and the bodies of a plant with masses.
        worksite: the worksite's part of the state.
        views: settings of the cameras' drives.
        steering: measured angles and shoulder offset, commanded rates, commanded twist.
        command: input of the steering laws in this step.
        report: output of the steering laws in this step.
        observed: (18 + s,) tip pose, twist and singularity distances of the arm, computed by `kinematics.observe`.
        carried: payload that the arm holds, and the steering's rules with this payload.
        standing: cache of the arm with its shoulder at the present height.
        tick: number of control steps done, the present one included.
        by_script: True if the script supplied the inputs of the last step.
        phase: name of the script's phase in the last step; "" with manual inputs.
        checking: CMD CK in progress; None if no check is in progress.
        disturbances: forces and torques that disturb bodies in this step, on a plant with masses.
        ways_out: escape directions from nearby singularities, from exceeded joint limits and from contacts.
        events: log lines of the present step.
        changes: changes in flight that are in force, each as KEY=VALUE (`scenario.in_flight`).
    """

    panel: Panel
    script: Script
    delayed_inputs: list[Inputs]
    plant: PlantState
    worksite: WorksiteState
    views: Views
    steering: Array
    command: Array
    report: Array
    observed: Array
    carried: SteeringSetup
    standing: Standing
    tick: int = 0
    by_script: bool = False
    phase: str = ""
    checking: Checking | None = None
    disturbances: tuple[Wrench, ...] = ()
    ways_out: tuple[WayOut, ...] = ()
    events: list[Event] = msgspec.field(default_factory=list)
    changes: tuple[str, ...] = ()

    @cached_property
    def row(self) -> Row:
        """Flat arrays that contain most of the state's arrays from the first use on, for compiled code."""
        return row_of(self)

    def renew_row(self, row: Row) -> None:
        """Take the arrays of another state's row for this new state; that state can no longer be used."""
        row.renew(self)
        vars(self)["row"] = row

    def move_row(self, packed: RowArrays) -> None:
        """Move the row, and the state's arrays with it, into the arrays `packed`."""
        vars(self)["row"] = self.row.moved_to(packed, self)

    def fork(self) -> State:
        """Return an independent copy of this state, without CMD CK, for a rehearsal on the kinematic plant."""
        copy = copied(self)
        copy.checking = copy.plant.bodies = None
        return copy

    def replace_with(self, other: State) -> None:
        """Replace the arm, panel and worksite of this state by those of another state of the same run.

        The progress of the run is kept, for example tick, script, events and delayed inputs.
        """
        for name in ("panel", "carried", "plant", "worksite", "steering", "views", "command", "report", "checking"):
            setattr(self, name, getattr(other, name))
        self.row.take(self)

    def measure(self) -> None:
        """Copy the plant's angles and rates to `steering`, before Python code of a step reads them there.

        The compiled part of a step begins with the same copy.
        """
        measured(self.plant.angles, self.plant.reference, self.plant.holds, self.shoulder_offset, self.steering)

    def log(self, period: float) -> Log:
        """Return the log of the present step; `period`: the control period [s]."""
        return Log(self.events, self.tick * period)

    @property
    def rules(self) -> Array:
        """Steering rules in force."""
        under_way, at_rest = self.both_rules()
        return at_rest if self.command[MOTION_ACTIVE] == 0.0 else under_way

    @property
    def stick_rules(self) -> Array:
        """Steering rules for the stick directions: those in force in a manual mode, else those of ORB UNL."""
        panel = self.panel
        return self.rules if MODES[panel.mode].kind == "manual" else self.carried.rules["ORB UNL", panel.rate, ORB_UNL]

    def both_rules(self) -> tuple[Array, Array]:
        """Return the steering's rules of an automatic motion that is in progress or begins, and those without one.

        They differ only for law 1: while no automatic motion is in progress, law 2's rules replace those of law 1.
        """
        panel, rules = self.panel, self.carried.rules
        law = panel.flown
        under_way = rules[panel.mode, panel.rate, law]
        if law != AUTOMATIC_LAWS["position"]:
            return under_way, under_way
        return under_way, rules[panel.mode, panel.rate, AUTOMATIC_LAWS["closed loop"]]

    @property
    def shoulder_offset(self) -> float:
        """Height of the shoulder, minus the height that the steering's rules assume [m]."""
        return self.plant.stand.position - self.standing.height

    @property
    def arm(self) -> Arm:
        """Arm with its telescope at the present length."""
        return self.standing.at(self.plant.stand.position)


def new_state(flight: Flight, carried: SteeringSetup) -> State:
    """Return a new state. `simulation.begin` then sets the start positions of the arm and the worksite."""
    scenario, views = flight.scenario, flight.cameras.first
    panel = Panel(
        scenario.mode,
        0,
        scenario.rate,
        law=scenario.law,
        payload_axes=scenario.payload_axes,
        position_hold=scenario.position_hold,
        zones=(0,) * len(scenario.arm.joints),
        camera=flight.cameras.names[0] if views else "",
    )
    return State(
        panel=panel,
        script=Script(attached=0 if scenario.payload is None else 1),
        delayed_inputs=[Inputs()] * scenario.delay,
        plant=new_plant_state(len(scenario.arm.joints)),
        worksite=new_worksite_state(flight.site, flight.prong),
        views=views,
        steering=np.zeros(STATE),
        command=np.zeros(COMMAND),
        report=np.zeros(REPORT),
        observed=np.zeros(SEEN + len(scenario.arm.model.singularities)),
        carried=carried,
        standing=Standing(scenario.arm),
    )
