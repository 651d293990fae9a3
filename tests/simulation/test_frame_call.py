"""The call that makes a frame gives its values in the order of the fields."""

from __future__ import annotations

import ast
import inspect

from aftdeck.simulation.frame import Frame
from aftdeck.simulation.observe import look


def test_variables_stand_in_the_places_of_the_fields_with_their_names() -> None:
    calls = [node for node in ast.walk(ast.parse(inspect.getsource(look.frame_of))) if isinstance(node, ast.Call)]
    (call,) = [one for one in calls if isinstance(one.func, ast.Name) and one.func.id == "Frame"]
    assert not call.keywords and len(call.args) == len(Frame.__struct_fields__)
    variables = {place: one.id for place, one in enumerate(call.args) if isinstance(one, ast.Name)}
    assert variables == {place: Frame.__struct_fields__[place] for place in variables}
    assert len(variables) > len(call.args) // 3
