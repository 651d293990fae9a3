"""Locations in error messages: the index and the line of an item.

The index is the item's position among all items of its list in the file; the line is the line of the item.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Union, get_args, get_origin, get_type_hints

import msgspec
import pytest
import tomlkit
from hypothesis import given, settings
from hypothesis import strategies as st

from aftdeck.arms import shapes as arm_shapes
from aftdeck.arms.model import ArmFile
from aftdeck.errors import ScenarioError
from aftdeck.files import Text, examine, place
from aftdeck.scenario import light
from aftdeck.scenario.changes import parse_change
from aftdeck.scenario.load import parse_scenario
from aftdeck.scenario.schema import ScenarioFile
from aftdeck.worksite import load_worksite
from aftdeck.worksite.file import load as worksite_file
from aftdeck.worksite.file.schema import WorksiteFile

FILES: tuple[type[msgspec.Struct], ...] = (
    ScenarioFile,
    WorksiteFile,
    ArmFile,
    arm_shapes.ShapesFile,
    light.LightFile,
)
DEEPEST = 4
"""Maximum depth of the tested lists of tables. Without it, groups of shapes in groups of shapes would never end."""


def structs(kind: Any) -> list[type[msgspec.Struct]]:
    """Return the structs among the types of a field's value."""
    if get_origin(kind) is Union or type(kind).__name__ == "UnionType":
        return [struct for member in get_args(kind) for struct in structs(member)]
    if getattr(kind, "__metadata__", None):
        return structs(get_args(kind)[0])
    return [kind] if isinstance(kind, type) and issubclass(kind, msgspec.Struct) else []


def lists_of_tables(kind: type[msgspec.Struct], depth: int = DEEPEST) -> Iterator[tuple[str | None, ...]]:
    """Yield the path of each list of tables in a type: a tuple of keys, in which None follows the key of each list."""
    for name, hint in get_type_hints(kind, include_extras=False).items():
        member = next((k for k in (hint, *get_args(hint)) if get_origin(k) is tuple), None)
        listed = get_args(member)[0] if member is not None and get_args(member)[1:] == (...,) else None
        for inner in structs(listed if listed is not None else hint):
            path: tuple[str | None, ...] = (name, None) if listed is not None else (name,)
            if listed is not None:
                yield path
            if depth > len(path):
                yield from ((*path, *rest) for rest in lists_of_tables(inner, depth - len(path)))


PATHS = sorted({(kind, path) for kind in FILES for path in lists_of_tables(kind)}, key=str)


def test_lists_of_tables_are_found() -> None:
    found = {(kind.__name__, place(tuple(0 if part is None else part for part in path))) for kind, path in PATHS}
    assert {("ScenarioFile", "phase[0]"), ("ScenarioFile", "sequence[0].point[0]")} <= found
    assert {("WorksiteFile", "body[0].solids[0]"), ("ArmFile", "por[0]"), ("ShapesFile", "camera[0]")} <= found
    assert len(found) > 20


@pytest.mark.parametrize(("kind", "path"), PATHS, ids=lambda value: getattr(value, "__name__", None) or str(value))
@settings(max_examples=8)
@given(data=st.data())
def test_unknown_field_is_reported_with_its_index_and_line(
    kind: type[msgspec.Struct], path: tuple[str | None, ...], data: st.DataObject
) -> None:
    """Write tables `[[a]]`, each with some `[[a.b]]`, and an unknown field in some of the innermost tables."""
    lines: list[str] = []
    expected: dict[str, int] = {}

    def write(depth: int, header: list[str], where: tuple[str | int, ...]) -> None:
        if depth == len(path):
            if data.draw(st.booleans()):
                lines.append("nonsense = 1")
                expected[place((*where, "nonsense"))] = len(lines)
            return
        part = path[depth]
        assert part is not None
        if depth + 1 < len(path) and path[depth + 1] is None:
            for k in range(data.draw(st.integers(1, 3))):
                lines.append(f"[[{'.'.join((*header, part))}]]")
                write(depth + 2, [*header, part], (*where, part, k))
        else:
            write(depth + 1, [*header, part], (*where, part))

    write(0, [], ())
    _, problems = examine(kind, Text("f.toml", "\n".join(lines)))
    sentences = [problem.sentence("f.toml", "\n".join(lines)) for problem in problems]
    found = {m[2]: int(m[1]) for m in (re.match(r"f\.toml:(\d+): (\S*nonsense): ", one) for one in sentences) if m}
    if any("nonsense" in one for one in sentences):  # a table without the field that selects its type gives one error
        assert found == expected


WORKSITE = tomllib.loads((Path(worksite_file.__file__).parents[1] / "concept-1972.toml").read_text())
STILL = [
    i
    for i, camera in enumerate(WORKSITE["camera"])
    if camera["body"] == WORKSITE["body"][0]["name"] and camera.get("kind") != "window"
]
"""Cameras fixed to the orbiter."""


@pytest.mark.slow
@settings(max_examples=8)
@given(st.permutations(STILL), st.integers(1, len(STILL) - 1))
def test_index_of_a_camera_counts_all_cameras(order: list[int], broken: int) -> None:
    """Some cameras have an unknown drive, the others are in a solid: each error has the index of its camera."""
    solid = next(solid for solid in load_worksite("concept-1972").solids if not solid.part.startswith("camera "))
    inside = [float(x) for x in solid.vertices.mean(axis=0)]
    wrong = tomlkit.parse(tomlkit.dumps(WORKSITE)).unwrap()
    for i in order[:broken]:
        wrong["camera"][i]["drive"] = "none such"
    for i in order[broken:]:
        wrong["camera"][i]["position"] = inside
    found = worksite_problems(wrong)
    names = {f"camera[{i}]": WORKSITE["camera"][i]["name"] for i in STILL}
    found_indices = {
        m[1]: m[2] for m in (re.search(r": (camera\[\d+\])\S*: camera ([^ ':]+)", one) for one in found) if m
    }
    assert found_indices == names


@settings(max_examples=6)
@given(st.permutations(range(4)), st.integers(1, 3))
def test_index_of_a_payload_counts_all_payloads(order: list[int], broken: int) -> None:
    """Some payloads start in an unknown berth, one has the name of a part: each error has the index of its payload."""
    wrong = tomlkit.parse(tomlkit.dumps(WORKSITE)).unwrap()
    first = dict(wrong["cargo"][0])
    part = load_worksite("concept-1972").solids[0].part
    names = {cargo["name"] for cargo in wrong["cargo"]}
    wrong["camera"] = [camera for camera in wrong["camera"] if camera["body"] not in names]
    wrong["cargo"] = [{**first, "name": f"cargo {i}"} for i in range(4)]
    for i in order[:broken]:
        wrong["cargo"][i]["start"] = {"seat": "none such"}
    wrong["cargo"][order[broken]]["name"] = part
    found = worksite_problems(wrong)
    found_indices = {int(m[1]) for m in (re.search(r": cargo\[(\d+)\]: ", one) for one in found) if m}
    assert found_indices == set(order[: broken + 1])
    assert [one for one in found if f": cargo[{order[broken]}]: the part {part!r}" in one]


def worksite_problems(raw: dict[str, Any]) -> tuple[str, ...]:
    with pytest.raises(ScenarioError) as caught:
        worksite_file._of_text(Text("w.toml", tomlkit.dumps(raw)), ())
    return caught.value.problems


@settings(max_examples=4)
@given(st.lists(st.booleans(), min_size=1, max_size=5))
def test_phase_without_a_name_is_called_by_its_index(named: list[bool]) -> None:
    phases = "".join(
        '[[phase]]\nmode = "ORB UNL"\nduration = 1\n' + (f'name = "own {k}"\n' if own else "")
        for k, own in enumerate(named)
    )
    text = 'title = "t"\n[initial]\njoints = [0, 1, -1, 0, 0, 0]\n' + phases
    found = parse_scenario(text, "t", "t.toml", Path("."))
    for k, (own, phase) in enumerate(zip(named, found.phases, strict=True)):
        assert phase.name == (f"own {k}" if own else f"ORB UNL, phase[{k}]")
        where, value = parse_change(f"phase[{k}].rate=vernier")
        changed = parse_scenario(text, "t", "t.toml", Path("."), {where: value})
        assert [one.rate for one in changed.phases].index("vernier") == k
