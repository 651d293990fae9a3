"""Building a scenario from its decoded file, with the checks that types cannot make."""

from __future__ import annotations

from pathlib import Path

from aftdeck.errors import ScenarioError
from aftdeck.scenario.cargo import present_cargo
from aftdeck.scenario.light import lamps_of, lighting
from aftdeck.scenario.limits import check_por, limited_arm, por_with
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.modes import Chosen, check_mode, chosen_mode
from aftdeck.scenario.payload import held_payload
from aftdeck.scenario.phases import phase_plan
from aftdeck.scenario.places import Things
from aftdeck.scenario.problems import Problems
from aftdeck.scenario.schema import ScenarioFile
from aftdeck.scenario.sequences import stored_points
from aftdeck.scenario.starts import parts, start
from aftdeck.steering.mode import MODES
from aftdeck.worksite.load import load_worksite
from aftdeck.worksite.model import Worksite

LONGEST_PERIOD = 0.2
"""Longest control period taken [s]; the arm's own computer ran at 0.08 s."""
SHORTEST_PERIOD = 0.001
"""Shortest control period taken [s]."""
WHOLE = 1e-6
"""How far from a whole number of control periods a duration may be [1]."""
LONGEST_DELAY = 30.0
"""Longest delay taken [s]: ten times the way to the Moon and back."""
LONGEST_RUN = 86_400.0
"""Longest duration taken [s]."""


def build(problems: Problems, spec: ScenarioFile, name: str, text: str, folder: Path) -> Scenario | None:
    """The scenario of a decoded file; None where anything is wrong, which `problems` then tells.

    Args:
        problems: gathers what is wrong.
        spec: the file, decoded.
        name: of the scenario.
        text: the file.
        folder: where arm files are sought.
    """
    _check_times(problems, spec)
    _check_arrival(problems, spec)
    mode = chosen_mode(problems, spec.mode, ("mode",)) or Chosen("ORB UNL")
    arm = limited_arm(problems, spec.arm, spec.limits, folder)
    if arm is None:
        return None
    worksite = _worksite(problems, spec.worksite, folder)
    payload = held_payload(problems, spec.payload)
    check_por(problems, por_with(arm.model, payload.mass if payload else 0.0, spec.limits.por))
    cargo = present_cargo(problems, worksite, spec.cargo)
    names = [one.name for one in (cargo if worksite else spec.cargo)]  # what is wrong with a place is told once
    begin = start(problems, arm, spec.initial, names, ("initial",))
    begun = parts(problems, arm, spec.initialise, begin, names)
    sequences = stored_points(problems, arm, spec.sequence)
    check_mode(problems, mode.position, bool(payload or cargo), sequences, ("mode",))
    if payload and cargo:
        problems.wrong(("payload",), "stays in the grasp for good; where there is a [[cargo]], say initial.grasped")
    elif cargo and begin is not None and begin.grasped is None and MODES[mode.position].loaded:
        problems.wrong(("mode",), f"{mode.position} moves a payload, and none is in the grasp: give initial.grasped")
    loads = bool(payload or cargo)
    things = Things(cargo, tuple(seat.name for seat in worksite.seats) if worksite else ())
    phases = [phase_plan(problems, arm, phase, i, loads, sequences, things) for i, phase in enumerate(spec.phase)]
    _check_clearance(problems, spec)
    lamps = lamps_of(worksite, arm.model, payload, cargo) if worksite else ()
    light = lighting(problems, spec.light, lamps)
    if problems or begin is None or worksite is None:
        return None
    return Scenario(
        name=name,
        title=spec.title,
        description=spec.text,
        arm=arm,
        worksite=worksite,
        seed=spec.seed,
        duration=float(spec.duration),
        ticks=round(spec.duration / spec.control_period),
        control_period=float(spec.control_period),
        delay=round(spec.command_delay / spec.control_period),
        telemetry_delay=float(spec.telemetry_delay),
        camera_delay=float(spec.camera_delay),
        start=begin,
        parts=begun,
        cargo=cargo,
        docking_axes="y" if spec.docking == "y axis" else "all",
        caution=float(spec.clearance.caution),
        warning=float(spec.clearance.warning),
        lamps=lamps,
        lighting=light,
        mode=mode.position,
        rate=spec.rate,
        as_flown=spec.soft_stops == "as-flown",
        strict=spec.strict,
        near=float(spec.arrive_within),
        near_turn=float(spec.arrive_within_angle),
        fly_by=float(spec.fly_by_within),
        fly_by_turn=float(spec.fly_by_angle),
        law=mode.law or spec.law,
        payload_axes=mode.payload_axes is True,
        position_hold=spec.position_hold,
        sequences=sequences,
        por=spec.limits.por,
        payload=payload,
        phases=tuple(phase for phase in phases if phase is not None),
        text=text,
    )


def _worksite(problems: Problems, name_or_path: str, folder: Path) -> Worksite | None:
    """The worksite of a built-in name or of a file, sought from `folder`."""
    if name_or_path.endswith(".toml") and not Path(name_or_path).is_absolute():
        name_or_path = str(folder / name_or_path)
    try:
        return load_worksite(name_or_path)
    except ScenarioError as error:
        for problem in error.problems:
            problems.wrong(("worksite",), problem)
        return None


def _check_times(problems: Problems, spec: ScenarioFile) -> None:
    """The control period, and a duration that is a whole number of them."""
    period, duration = spec.control_period, spec.duration
    whole = SHORTEST_PERIOD <= period <= LONGEST_PERIOD
    if not whole:
        problems.wrong(
            ("control_period",), f"lies between {SHORTEST_PERIOD:g} and {LONGEST_PERIOD:g} s, got {period:g} s"
        )
    elif not 0.0 < duration <= LONGEST_RUN:
        problems.wrong(("duration",), f"is above 0 and at most {LONGEST_RUN:g} s, got {duration:g} s")
    elif duration < 0.5 * period or abs(duration / period - round(duration / period)) > WHOLE:
        problems.wrong(
            ("duration",),
            f"is a whole number of control periods: {duration:g} s is {duration / period:g} of {period:g} s",
        )
    delays = {"command_delay": spec.command_delay, "telemetry_delay": spec.telemetry_delay}
    for key, delay in (delays | {"camera_delay": spec.camera_delay}).items():
        if not 0.0 <= delay <= LONGEST_DELAY:
            problems.wrong((key,), f"lies between 0 and {LONGEST_DELAY:g} s, got {delay:g} s")
        elif key == "command_delay" and whole and abs(delay / period - round(delay / period)) > WHOLE:
            problems.wrong(
                (key,), f"is a whole number of control periods: {delay:g} s is {delay / period:g} of {period:g} s"
            )


def _check_clearance(problems: Problems, spec: ScenarioFile) -> None:
    """The clearances that caution and warn."""
    caution, warning = spec.clearance.caution, spec.clearance.warning
    if warning <= 0.0:
        problems.wrong(("clearance", "warning"), f"is above 0, got {warning:g} m")
    if not warning < caution:
        problems.wrong(("clearance", "caution"), f"is above the warning at {warning:g} m, got {caution:g} m")


def _check_arrival(problems: Problems, spec: ScenarioFile) -> None:
    """The end sphere of the automatic modes."""
    if spec.arrive_within <= 0.0:
        problems.wrong(("arrive_within",), f"is above 0, got {spec.arrive_within:g} m")
    if spec.arrive_within_angle <= 0.0:
        problems.wrong(("arrive_within_angle",), f"is above 0, got {spec.arrive_within_angle:g} rad")
