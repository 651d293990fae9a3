from __future__ import annotations

from typing import Any

import pytest

from aftdeck.recording.message import Message
from aftdeck.recording.records import CHANNELS
from aftdeck.recording.schema import schema

PLAIN = {"number", "integer", "string", "boolean"}
SHARED = {"type", "description"}


def check(told: dict[str, Any], where: str) -> None:
    """What viewers take: plain values, objects of properties, lists of one kind that is itself no list."""
    kind = told["type"]
    if kind == "object":
        assert set(told) <= SHARED | {"title", "properties"}, where
        assert told["properties"], where
        for name, value in told["properties"].items():
            check(value, f"{where}.{name}")
    elif kind == "array":
        assert set(told) <= SHARED | {"items"}, where
        assert told["items"]["type"] != "array", where
        check(told["items"], f"{where}[]")
    else:
        assert kind in PLAIN, where
        assert set(told) <= SHARED | {"enum"}, where


@pytest.mark.parametrize("topic", CHANNELS)
def test_schemas_are_of_the_plain_kind_that_viewers_read(topic: str) -> None:
    kind: type[Message] = CHANNELS[topic][0]
    told = schema(kind)
    assert told["type"] == "object"
    assert told["title"] == f"aftdeck.{kind.__name__}"
    assert set(told["properties"]) == set(kind.__struct_fields__)
    check(told, topic)
