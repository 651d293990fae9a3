"""JSON schemas of the channels."""

from __future__ import annotations

from typing import Any

import pytest

from aftdeck.recording.message import Message
from aftdeck.recording.records import CHANNELS
from aftdeck.recording.schema import schema

PLAIN = {"number", "integer", "string", "boolean"}
SHARED = {"type", "description"}


def check(checked: dict[str, Any], where: str) -> None:
    """Check that a schema has only plain values, objects with properties, and lists that contain no lists."""
    kind = checked["type"]
    if kind == "object":
        assert set(checked) <= SHARED | {"title", "properties"}, where
        assert checked["properties"] or where == "/inputs.changes", where  # its names are keys of files
        for name, value in checked["properties"].items():
            check(value, f"{where}.{name}")
    elif kind == "array":
        assert set(checked) <= SHARED | {"items"}, where
        assert checked["items"]["type"] != "array", where
        check(checked["items"], f"{where}[]")
    else:
        assert kind in PLAIN, where
        assert set(checked) <= SHARED | {"enum"}, where


@pytest.mark.parametrize("topic", CHANNELS)
def test_schemas_have_the_simple_form_that_viewers_read(topic: str) -> None:
    kind: type[Message] = CHANNELS[topic][0]
    checked = schema(kind)
    assert checked["type"] == "object"
    assert checked["title"] == f"aftdeck.{kind.__name__}"
    assert set(checked["properties"]) == set(kind.__struct_fields__)
    check(checked, topic)
