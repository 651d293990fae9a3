"""TypeScript that is generated from the messages."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

import msgspec
import pytest

from aftdeck.station.messages import from_page, kinds, to_page
from aftdeck.station.messages.typescript import _Writer, typescript

GENERATED = Path(__file__).parents[2] / "web" / "src" / "link" / "protocol.ts"


class Sample(msgspec.Struct, tag_field="kind", tag="sample"):
    """A sample."""

    pairs: tuple[tuple[float, str], ...]
    """Length [m], name."""
    level: Literal["low", "high"] | None = None


def test_committed_file_is_the_generated_one() -> None:
    assert GENERATED.read_text(encoding="utf-8") == typescript(), "run `make generate`"


def test_every_message_becomes_an_interface_with_its_type() -> None:
    text = typescript()
    for union in (from_page.FromPage, to_page.FromServer):
        for message in union.__args__:
            tag = message.__struct_config__.tag
            assert f"export interface {message.__name__} {{\n  readonly type: '{tag}';" in text


def test_hello_becomes_an_interface() -> None:
    assert "export interface Hello {\n  readonly type: 'hello';" in typescript()


def test_version_of_the_protocol_is_generated() -> None:
    assert f"export const PROTOCOL = {kinds.PROTOCOL};" in typescript()


def test_struct_keeps_its_tag_its_fields_in_order_and_comments() -> None:
    assert _Writer().interface(Sample) == (
        "/** A sample. */\n"
        "export interface Sample {\n"
        "  readonly kind: 'sample';\n"
        "  /** Length [m], name. */\n"
        "  readonly pairs: readonly (readonly [number, string])[];\n"
        "  readonly level: 'low' | 'high' | null;\n"
        "}\n"
    )


def test_type_without_a_json_form_is_rejected() -> None:
    with pytest.raises(TypeError, match="complex"):
        _Writer().structure(complex)


def test_two_structs_of_one_name_are_rejected() -> None:
    writer = _Writer()
    writer.structure(Sample)
    with pytest.raises(TypeError, match="Sample"):
        writer.structure(msgspec.defstruct("Sample", []))
