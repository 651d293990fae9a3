"""Construction of a scenario from its decoded file, with the checks that types cannot make."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from aftdeck.arms.masses import check_masses
from aftdeck.errors import ArmError, ScenarioError
from aftdeck.files import Problem, Where
from aftdeck.kinematics.arm import Arm
from aftdeck.kinematics.payload import HeldPayload
from aftdeck.plant.usual_payload import PAYLOAD_MASS
from aftdeck.scenario.all_cameras import present_cameras
from aftdeck.scenario.attached import Grasp
from aftdeck.scenario.camera_settings import camera_settings
from aftdeck.scenario.chosen_payloads import present_payloads
from aftdeck.scenario.disturbance import Disturbable, payload_names, planned
from aftdeck.scenario.fit import misfits
from aftdeck.scenario.light import lamps_of, lighting
from aftdeck.scenario.limits import check_por, limited_arm, por_with
from aftdeck.scenario.model import PhasePlan, Scenario
from aftdeck.scenario.modes import Chosen, check_mode, chosen_mode
from aftdeck.scenario.payload import held_payload
from aftdeck.scenario.phases import script
from aftdeck.scenario.places import TargetReferences
from aftdeck.scenario.planned_changes import planned_changes
from aftdeck.scenario.problems import Problems
from aftdeck.scenario.schema import ScenarioFile
from aftdeck.scenario.sequences import stored_points
from aftdeck.scenario.sources import Sources
from aftdeck.scenario.starts import parts, start
from aftdeck.scenario.steps import task_steps
from aftdeck.scenario.target import AtBerth
from aftdeck.steering.mode import MODES
from aftdeck.worksite.file.load import worksite_of
from aftdeck.worksite.model import OrbiterMotion, Worksite
from aftdeck.worksite.payload import Payload

BUILT_IN = Path(__file__).parent / "builtin"
"""Folder of the scenarios that come with Aftdeck."""
END_SPHERE = {"kinematic": (1e-4, 2e-5), "rigid": (2e-3, 3.5e-4), "flexible": (2e-3, 3.5e-4)}
"""Radius [m] and angle [rad] of the end sphere on each plant, if the scenario does not give them.

A servo with friction cannot follow the small rates that the last tenth of a millimetre takes.
"""
WHOLE = 1e-6
"""Greatest deviation of a duration from a whole number of control periods [1]."""


def build(
    problems: Problems,
    spec: ScenarioFile,
    name: str,
    text: str,
    changes: tuple[str, ...],
    sources: Sources,
    begun: Scenario | None = None,
) -> Scenario | None:
    """Return the scenario of a decoded file; None if the file has errors, which are then in `problems`.

    Args:
        problems: collects the problems found.
        spec: the decoded file.
        name: name of the scenario.
        text: text of the file.
        changes: changes of the text before it was decoded, each as KEY=VALUE.
        sources: origin of the arm and the worksite.
        begun: scenario with which a run has begun that goes on with this one; its start, targets and task stay, and
            need not be possible with the new values. None: no run has begun.
    """
    _check_times(problems, spec)
    near, near_turn = _end_sphere(problems, spec)
    mode = chosen_mode(problems, spec.mode, ("mode",)) or Chosen("ORB UNL")
    arm = limited_arm(problems, spec.arm, spec.limits, sources)
    if arm is None:
        return None
    if spec.strict and not arm.closed_form:
        what = f"flies the laws as published, which are closed forms; {arm.name} has a chain of joints without one"
        problems.add(("strict",), what)
    worksite = _worksite(problems, spec, sources)
    payload = held_payload(problems, spec.payload)
    check_por(problems, spec.limits.por, por_with(arm.model, payload.mass if payload else 0.0, spec.limits.por))
    payloads = present_payloads(problems, worksite, spec.cargo)
    references = TargetReferences(payloads, worksite, spec.strict)
    initial_state = begun.start if begun else start(problems, arm, spec.initial, references, ("initial",))
    part_states = begun.parts if begun else parts(problems, arm, spec.initialise, initial_state, references)
    sequences = begun.sequences if begun else stored_points(problems, arm, spec.sequence)
    check_mode(problems, mode.position, bool(payload or payloads), sequences, ("mode",))
    if payload and payloads:
        problems.add(("payload",), "is never released: in a scenario with [[cargo]], give initial.grasped instead")
    elif payloads and initial_state is not None and initial_state.grasped is None and MODES[mode.position].loaded:
        problems.add(
            ("mode",), f"{mode.position} moves a payload, but the end effector holds none: give initial.grasped"
        )
    grasp = Grasp(payload, takes_others=bool(payloads))
    of_script = Problems() if begun else problems
    phases = script(of_script, arm, spec.phase, grasp, spec.limits.por, sequences, references)
    if begun:
        for problem in of_script.in_tables("limits"):
            problems.add(problem.where, problem.what)
        phases = [
            replace(old, limits=new.limits if new else None) for new, old in zip(phases, begun.phases, strict=True)
        ]
    if spec.next is not None and not (BUILT_IN / f"{spec.next}.toml").is_file():
        problems.add(("next",), f"no built-in scenario {spec.next!r}")
    steps = begun.steps if begun else task_steps(problems, arm, spec.step, references)
    _check_plant(problems, spec, arm, worksite, payloads, grasp.payloads)
    orbiter = spec.dynamics.orbiter or _usual_motion(worksite)
    names = payload_names([one.name for one in payloads], own=bool(grasp.payloads))
    disturbances = planned(problems, spec, Disturbable(spec.plant, orbiter, names))
    changes_in_flight = planned_changes(problems, spec)
    _check_clearance(problems, spec)
    lamps = lamps_of(worksite, arm.model, payload, payloads) if worksite else ()
    light = lighting(problems, spec.light, lamps)
    cameras = present_cameras(arm.model, worksite, payloads) if worksite and spec.cameras else ()
    settings = camera_settings(problems, spec.cameras, cameras) if worksite else {}
    cautions: list[Problem] = []
    if not problems and worksite is not None:
        states = [state for state in (initial_state, *part_states.values()) if state is not None]
        held = [{state.grasped.payload} if state.grasped else set() for state in states]
        always = frozenset(set.intersection(*held)) if held else frozenset()
        cautions = _check_fit(problems, arm, worksite, payloads, phases, always)
    if problems or initial_state is None or worksite is None:
        return None
    return Scenario(
        name=name,
        title=spec.title,
        description=spec.text,
        group=spec.group,
        minutes=spec.minutes,
        arm=arm,
        worksite=worksite,
        seed=spec.seed,
        plant=spec.plant,
        orbiter=orbiter,
        inhibit=spec.dynamics.inhibit,
        duration=float(spec.duration),
        ticks=round(spec.duration / spec.control_period),
        control_period=float(spec.control_period),
        delay=round(spec.command_delay / spec.control_period),
        telemetry_delay=float(spec.telemetry_delay),
        camera_delay=float(spec.camera_delay),
        start=initial_state,
        parts=part_states,
        payloads=payloads,
        docking_axes="y" if spec.docking == "y axis" else "all",
        free_contact=spec.free_contact,
        caution=float(spec.clearance.caution),
        warning=float(spec.clearance.warning),
        lamps=lamps,
        lighting=light,
        camera_settings=settings,
        mode=mode.position,
        rate=spec.rate,
        as_flown=spec.soft_stops == "as-flown",
        strict=spec.strict,
        guarded=not spec.strict if spec.guards is None else spec.guards,
        near=near,
        near_turn=near_turn,
        fly_by=float(spec.fly_by_within),
        fly_by_turn=float(spec.fly_by_angle),
        law=mode.law or spec.law,
        payload_axes=mode.payload_axes is True,
        position_hold=spec.position_hold,
        sequences=sequences,
        por=spec.limits.por,
        own_payloads=tuple(grasp.payloads),
        payload=payload,
        disturbances=disturbances,
        planned_changes=changes_in_flight,
        phases=tuple(phase for phase in phases if phase is not None),
        steps=tuple(steps),
        next=spec.next or "",
        text=text,
        changes=changes,
        cautions=tuple(cautions),
    )


def _check_fit(
    problems: Problems,
    arm: Arm,
    worksite: Worksite,
    payloads: tuple[Payload, ...],
    phases: Sequence[PhasePlan | None],
    held: frozenset[int],
) -> list[Problem]:
    """Add to `problems` the misfits that make every run meaningless, and return the other misfits."""
    used = frozenset(phase.target.berth for phase in phases if phase and isinstance(phase.target, AtBerth))
    errors: dict[Where, list[str]] = {}
    cautions = []
    for misfit in misfits(arm.model, worksite, payloads, used, held):
        if misfit.senseless:
            errors.setdefault(misfit.problem.where, []).append(misfit.problem.what)
        else:
            cautions.append(misfit.problem)
    for where, texts in errors.items():
        problems.add(where, "; ".join(texts))
    return cautions


def _worksite(problems: Problems, spec: ScenarioFile, sources: Sources) -> Worksite | None:
    """Return the worksite, with the scenario's dimensions; None if it cannot be loaded."""
    try:
        return worksite_of(sources.worksite(spec.worksite), spec.dimensions)
    except ScenarioError as error:
        for problem in error.problems:
            problems.add(("worksite",), problem)
        return None


def _check_times(problems: Problems, spec: ScenarioFile) -> None:
    """Check that the duration and the delay of commands are whole numbers of control periods."""
    period, duration, delay = spec.control_period, spec.duration, spec.command_delay
    if duration <= 0.0:
        problems.add(("duration",), f"has to be above 0, got {duration:g} s")
    elif duration < 0.5 * period or abs(duration / period - round(duration / period)) > WHOLE:
        problems.add(
            ("duration",),
            f"has to be a whole number of control periods: {duration:g} s is {duration / period:g} of {period:g} s",
        )
    if abs(delay / period - round(delay / period)) > WHOLE:
        problems.add(
            ("command_delay",),
            f"has to be a whole number of control periods: {delay:g} s is {delay / period:g} of {period:g} s",
        )


def _check_plant(
    problems: Problems,
    spec: ScenarioFile,
    arm: Arm,
    worksite: Worksite | None,
    present: tuple[Payload, ...],
    payloads: Sequence[HeldPayload],
) -> None:
    """Check that the plant can move the arm and all payloads."""
    if spec.plant == "kinematic":
        return
    try:
        check_masses(arm.model, flexible=spec.plant == "flexible")
    except ArmError as error:
        problems.add(("plant",), str(error))
    _check_orbiter(problems, spec, worksite)
    masses = [(f"payload {n}", payload.mass) for n, payload in enumerate(payloads, 1)]
    masses += [(payload.title, payload.mass) for payload in present]
    for name, mass in masses:
        if why := PAYLOAD_MASS.problem(mass, ""):
            problems.add(("plant",), f"{spec.plant!r} cannot move {name}, because of its mass: {why}")


def _usual_motion(worksite: Worksite | None) -> OrbiterMotion:
    """Return the motion of a worksite's orbiter, unless the scenario gives another."""
    return "fixed" if worksite is None or worksite.orbiter is None else worksite.orbiter.motion


def _check_orbiter(problems: Problems, spec: ScenarioFile, worksite: Worksite | None) -> None:
    """Check that the worksite has what the orbiter's motion needs."""
    if worksite is None or spec.dynamics.orbiter not in ("free", "held"):
        return
    lacking = "table [orbiter]" if worksite.orbiter is None else ""
    if worksite.orbiter is not None and worksite.orbiter.jets is None and spec.dynamics.orbiter == "held":
        lacking = "table [orbiter.jets]"
    if lacking:
        problems.add(
            ("dynamics", "orbiter"),
            f"{spec.dynamics.orbiter!r} needs the {lacking}; the worksite {worksite.name!r} does not have it",
        )


def _check_clearance(problems: Problems, spec: ScenarioFile) -> None:
    """Check the clearances for caution and warning."""
    caution, warning = spec.clearance.caution, spec.clearance.warning
    if warning <= 0.0:
        problems.add(("clearance", "warning"), f"has to be above 0, got {warning:g} m")
    if not warning < caution:
        problems.add(("clearance", "caution"), f"has to be above the warning at {warning:g} m, got {caution:g} m")


def _end_sphere(problems: Problems, spec: ScenarioFile) -> tuple[float, float]:
    """Return radius [m] and angle [rad] of the end sphere of the automatic modes."""
    near, near_turn = END_SPHERE[spec.plant]
    if spec.arrive_within is not None:
        near = float(spec.arrive_within)
    if spec.arrive_within_angle is not None:
        near_turn = float(spec.arrive_within_angle)
    if near <= 0.0:
        problems.add(("arrive_within",), f"has to be above 0, got {near:g} m")
    if near_turn <= 0.0:
        problems.add(("arrive_within_angle",), f"has to be above 0, got {near_turn:g} rad")
    return near, near_turn
