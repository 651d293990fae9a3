"""Text of what the 1972 report's priority routine makes of a frame, for the command ``planes``."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from aftdeck.mainprior.explain import PlaneTest, RoutineExplained, TreeLine
    from aftdeck.tuples import Vec3


def routine_lines(found: RoutineExplained) -> Iterator[str]:
    """Yield the lines about a frame."""
    yield f"The report's own routine (MAINPRIOR), mode {found.mode}; cluster numbers of the report, from 22 on ours"
    for number, part in found.parts.items():
        yield f"  {number:>3}  {part}"
    yield ""
    yield "Permanent list: TABLE VII, and the list for these shapes"
    yield "  " + "  ".join(found.table_vii)
    yield "  " + "  ".join(found.permanent_list)
    for name, lines in found.trees.items():
        if found.report_trees[name] != lines:
            yield ""
            yield f"Tree {name} in Figure 19: plane (L vector of its test), TRUE and FALSE son"
            yield from map(_tree_line, found.report_trees[name])
        yield ""
        yield f"Tree {name} for these shapes"
        yield from map(_tree_line, lines)
    if found.replaced:
        yield ""
        yield f"Planes of Figure 19 that do not divide these shapes: {', '.join(found.replaced)}"
    yield ""
    yield "Tests of the observer: plane N . P = D in metres; TRUE is the side of N"
    yield from map(_test_line, found.tests)
    yield ""
    yield "L vectors in metres, and P vectors in half widths of the picture"
    for name, vector in (*found.l_vectors.items(), *found.p_vectors.items()):
        yield f"  {name:4s} {_vector(vector)}"
    yield ""
    yield "Priority output table of the routine, highest priority first: L vectors and clusters"
    yield "  " + "  ".join(map(str, found.table))
    if found.table_by_table_vii != found.table:
        yield "With TABLE VII's own list, which was made for other shapes:"
        yield "  " + "  ".join(map(str, found.table_by_table_vii))
    yield ""
    if not found.unseparated:
        yield "The routine's planes separate all clusters of which one can hide the other: the picture is right"
        return
    yield "Planes of the routine that do not separate clusters in this picture, whose order may therefore be wrong:"
    behind: dict[str, list[str]] = {}
    for pair in found.unseparated:
        k, hidden = pair.behind
        behind.setdefault(f"{pair.plane}: before {k} {hidden}", []).append("{} {}".format(*pair.before))
    for where, before in behind.items():
        yield f"  {where}: {', '.join(before)}"


def _tree_line(line: TreeLine) -> str:
    start = "  " + "  " * line.depth + (f"{line.branch}: " if line.branch else "")
    if line.sorted_in:
        return f"{start}special priority of {line.sorted_in}: into the list of"
    if line.plane:
        clusters = ", ".join(map(str, line.clusters))
        return f"{start}plane {line.plane} ({line.system})" + (f", ahead of {clusters} if TRUE" if clusters else "")
    return start + ", ".join(map(str, line.clusters))


def _test_line(test: PlaneTest) -> str:
    if test.normal is None or test.distance is None or test.eye is None:
        return f"  {test.plane:>3s} {test.system}  none received"
    side = "TRUE" if test.eye > 0.0 else "FALSE"
    plane = f"N = ({_vector(test.normal)}), D = {test.distance:.3f}"
    return f"  {test.plane:>3s} {test.system}  {plane}; eye {test.eye:+.3f}, {side}"


def _vector(vector: Vec3 | Sequence[float]) -> str:
    return ", ".join(f"{round(part, 3) + 0.0:.3f}" for part in vector)  # without minus zero
