"""Tables of the environments in docs/environments.md: ``python -m aftdeck.gym.document FILE``."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from aftdeck.gym.mission import definition as mission
from aftdeck.gym.reach import definition as reach
from aftdeck.gym.reach.picture import CAMERA
from aftdeck.gym.terms import Control, Observed, Rewarded
from aftdeck.kinematics.arm import load_arm
from aftdeck.made_tables import renew_file


def tables() -> str:
    """Return the tables of all environments."""
    return "\n".join(_lines())


def _lines() -> Iterator[str]:
    yield "### Environments\n"
    yield "| environment | built-in scenario | task | step | time limit | usual camera |\n|---|---|---|---|---|---|"
    task = (
        f"Move the tip within {reach.NEAR * 100.0:.1f} cm and {_degrees(reach.NEAR_ANGLE)} deg of a random pose, in "
        "ORB UNL."
    )
    yield f"| `{reach.ID}` | | {task} | {reach.PERIOD:g} s | {reach.MOST_STEPS} steps | `{CAMERA}` |"
    for one in mission.MISSIONS.values():
        limit = f"{mission.PERIOD:g} s | {one.most_steps} steps | `{one.cameras[0]}`"
        yield f"| `{one.id}` | `{one.scenario}` | {one.task} | {limit} |"
    yield "\n### Reach: actions\n"
    yield from _controls(reach.CONTROLS)
    yield "\n### Reach: observations\n"
    yield from _observations(reach.OBSERVATIONS)
    yield "\n### Reach: rewards\n"
    yield from _rewards(reach.REWARDS)
    yield "\n### Capture, Extract, Dock: actions\n"
    yield from _controls(mission.CAPTURE.controls)
    yield "\n### Capture, Extract, Dock: observations\n"
    yield f"The numbers are those of an arm with {len(load_arm('srms').joints)} joints.\n"
    yield from _observations(mission.observations(len(load_arm("srms").joints)))
    yield "\n### Capture, Extract, Dock: rewards\n"
    yield from _rewards(mission.REWARDS)
    yield "\n### Capture, Extract, Dock: starts\n"
    yield "| environment | before the place of the task | across | rotation about each axis |\n|---|---|---|---|"
    for one in mission.MISSIONS.values():
        s = one.spread
        yield f"| {one.name} | {s.least:.2f} to {s.greatest:.2f} m | ±{s.across:g} m | ±{_degrees(s.turn)} deg |"
    yield ""


def _controls(controls: Sequence[Control]) -> Iterator[str]:
    yield "| number | control | effect |\n|---|---|---|"
    for k, control in enumerate(controls):
        only = " (only Capture)" if control is mission.EFFECTOR else ""
        yield f"| {k} | {control.name}{only} | {control.definition} |"


def _observations(groups: Sequence[Observed]) -> Iterator[str]:
    yield "| numbers | observation | unit | 1 stands for | greatest magnitude |\n|---|---|---|---|---|"
    first = 0
    for group in groups:
        last = first + group.size - 1
        numbers = f"{first}" if group.size == 1 else f"{first} to {last}"
        first = last + 1
        yield (f"| {numbers} | **{group.name}.** {group.definition} | {group.unit} | {group.scale} | {group.limit:g} |")


def _rewards(terms: Sequence[Rewarded]) -> Iterator[str]:
    yield "| term | for each | reward | definition |\n|---|---|---|---|"
    for term in terms:
        unit = "" if term.unit == "1" else term.unit
        yield f"| {term.name} | {unit} | {term.weight:+g} | {term.definition} |"


def _degrees(angle: float) -> str:
    return f"{math.degrees(angle):.3g}"


if __name__ == "__main__":
    renew_file(tables())
