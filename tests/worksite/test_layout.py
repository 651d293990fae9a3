"""Monitored pairs of parts: their selection, their packed arrays, and queries."""

from __future__ import annotations

import numpy as np
import pytest

from aftdeck.bodies.hexahedron import BODY, unpack
from aftdeck.bodies.solid import Solid
from aftdeck.errors import InputError
from aftdeck.worksite.watch.groups import CENTRE, RADIUS, Layout, layout_of
from aftdeck.worksite.watch.pairs import among, counting, part_pairs
from tests.bodies.shapes import CUBE
from tests.worksite.scenes import scene

CHAIN = ("arm.base", "arm.upper", "arm.empty", "arm.lower", "arm.hand", "arm.prong")
FRAMES = (*CHAIN, "orbiter", "space", "can", "box")
HOME = {
    "wall": "orbiter",
    "floor": "orbiter",
    "station": "space",
    "can": "can",
    "bar": "can",
    "box": "box",
    "mount": "arm.base",
    "upper boom": "arm.upper",
    "lower boom": "arm.lower",
    "palm": "arm.hand",
    "prong": "arm.prong",
}
SOLIDS = [Solid(part, frame, CUBE) for part, frame in HOME.items()]


def worksite() -> Layout:
    return layout_of(FRAMES, SOLIDS, part_pairs(SOLIDS, CHAIN, apart=[("wall", "mount"), ("mount", "floor")]))


def test_all_parts_are_paired_once_except_joined_and_excluded_ones() -> None:
    pairs = part_pairs(SOLIDS, CHAIN, apart=[("wall", "mount"), ("mount", "floor")])
    found = {frozenset(pair) for pair in pairs}
    assert len(found) == len(pairs)
    missing = {frozenset((a, b)) for a in HOME for b in HOME if a < b} - found
    assert missing == {
        frozenset(pair)
        for pair in [
            ("wall", "floor"),
            ("can", "bar"),
            ("mount", "upper boom"),
            ("upper boom", "lower boom"),  # the frame between the two booms has no solids
            ("lower boom", "palm"),
            ("palm", "prong"),
            ("wall", "mount"),
            ("mount", "floor"),
        ]
    }


def test_parts_that_can_move_relative_to_each_other_are_paired() -> None:
    pairs = part_pairs(SOLIDS, CHAIN)
    for pair in [("lower boom", "wall"), ("palm", "bar"), ("can", "wall"), ("can", "station"), ("station", "wall")]:
        assert pair in pairs


def test_solid_pairs_are_complete_and_sorted_by_monitored_pair() -> None:
    made, layout = scene(np.random.default_rng(1))
    assert layout.begins[0] == 0
    assert layout.begins[-1] == len(layout.pairs)
    for g in range(len(layout.groups)):
        a, b = layout.named(g)
        pairs = layout.pairs[layout.begins[g] : layout.begins[g + 1]].tolist()
        expected = [[i, j] for i, p in enumerate(made) for j, q in enumerate(made) if p.part == a and q.part == b]
        assert sorted(pairs) == expected


def test_packed_solids_keep_their_vertices_and_bounding_spheres() -> None:
    made, layout = scene(np.random.default_rng(2))
    for solid, row, frame in zip(made, layout.solids, layout.frame, strict=True):
        assert np.array_equal(unpack(row[:BODY]), solid.vertices)
        assert layout.frames[frame] == solid.frame
        away = np.linalg.norm(solid.vertices - row[CENTRE:RADIUS], axis=1)
        assert away.max() <= row[RADIUS] <= 1.5 * np.linalg.norm(np.ptp(solid.vertices, axis=0))
    assert not layout.solids.flags.writeable


def test_held_or_berthed_parts_are_not_monitored_against_their_holder() -> None:
    layout = worksite()
    active = counting(layout, ("palm", "prong"), ("can", "bar"), {"box": ("floor",)})
    off = {frozenset(layout.named(g)) for g in np.flatnonzero(active == 0).tolist()}
    held = {frozenset((a, b)) for a in ("palm", "prong") for b in ("can", "bar")}
    assert off == held | {frozenset(("box", "floor"))}
    assert counting(layout).all()


def test_monitored_pairs_are_found_by_name_and_by_frame() -> None:
    layout = worksite()
    named = [layout.named(g) for g in np.flatnonzero(among(layout, [("bar", "prong"), ("can", "bar")])).tolist()]
    assert named == [("prong", "bar")]
    carried = layout.carried(["can"])
    for g in range(len(layout.groups)):
        assert carried[g] == bool({"can", "bar"} & set(layout.named(g)))
    assert layout.parts_in("can") == ("can", "bar")


@pytest.mark.parametrize(
    ("solids", "pairs", "pattern"),
    [
        ([Solid("a", "moon", CUBE)], [], r"a: .*'moon'.* arm\.base, "),
        (
            [Solid("a", "can", CUBE), Solid("a", "box", CUBE)],
            [],
            "a .*can.*box",
        ),
        (SOLIDS, [("can", "tin")], "can – tin: .*'tin'.* wall, floor, "),
        (SOLIDS, [("can", "bar")], "can – bar: .* can "),
        (SOLIDS, [("can", "box"), ("box", "can")], "box – can: .*twice"),
        ([Solid("a", "can", CUBE[::-1])], [], "a: vertex 2 "),
    ],
)
def test_invalid_layout_is_rejected_with_its_names(
    solids: list[Solid], pairs: list[tuple[str, str]], pattern: str
) -> None:
    with pytest.raises(InputError, match=f"^{pattern}"):
        layout_of(FRAMES, solids, pairs)


def test_unknown_part_or_frame_is_rejected_with_valid_names() -> None:
    layout = worksite()
    with pytest.raises(InputError, match=r"'tin'.* wall, "):
        among(layout, [("tin", "can")])
    with pytest.raises(InputError, match=r"'moon'.* arm\.base, "):
        layout.carried(["moon"])
    with pytest.raises(InputError, match=r"pair to leave out.*'tin'.* wall, "):
        part_pairs(SOLIDS, CHAIN, apart=[("tin", "can")])
