"""Line numbers in TOML texts, against generated documents with known lines."""

from __future__ import annotations

import json
import tomllib
from typing import Any

from hypothesis import given, settings
from hypothesis import strategies as st

from aftdeck.files import Where, line_of

KEYS = st.sampled_from(["a", "b", "phase", "9", "x-y", "two words", "with.dot", "[[phase]]", 'qu"ote', "é"])
DISGUISED = st.sampled_from(
    [
        "",
        "#",
        "[[phase]]",
        "[a]",
        "mode = 4",
        "x = [",
        "]",
        '"',
        "'",
        "\\",
        'a = """',
        "\n[[phase]]\nmode = 4\n",
        "\n\n",
    ]
)
"""Texts that look like lines of a TOML file."""


class Writer:
    """A TOML text under construction, with the line of each location."""

    def __init__(self) -> None:
        self.text, self.lines = "", dict[Where, int]()

    @property
    def line(self) -> int:
        return self.text.count("\n") + 1

    def note(self, where: Where) -> None:
        self.lines.setdefault(where, self.line)


def key_text(key: str) -> str:
    return key if all(c.isascii() and (c.isalnum() or c in "-_") for c in key) else json.dumps(key, ensure_ascii=False)


def write_value(out: Writer, data: st.DataObject, where: Where, depth: int) -> None:
    kind = data.draw(
        st.sampled_from(["number", "text", "raw", "long", "long raw", "list", "table"][: 7 if depth else 5])
    )
    if kind == "number":
        out.text += data.draw(st.sampled_from(["1", "-2.5e3", "true", "inf", "1979-05-27 07:32:00", "0x1F"]))
    elif kind == "text":
        out.text += json.dumps(data.draw(DISGUISED), ensure_ascii=False)
    elif kind == "raw":
        out.text += "'" + data.draw(DISGUISED).replace("'", "").replace("\n", " ") + "'"
    elif kind == "long":
        inner = data.draw(DISGUISED).replace("\\", "\\\\").replace('"', '\\"')
        out.text += '"""' + inner + data.draw(st.sampled_from(["", '"', '""'])) + '"""'
    elif kind == "long raw":
        out.text += "'''" + data.draw(DISGUISED).replace("'", "") + data.draw(st.sampled_from(["", "'", "''"])) + "'''"
    elif kind == "list":
        gap = st.sampled_from(["", " ", "\n", "\n  # [[phase]]\n  "])
        out.text += "[" + data.draw(gap)
        for k in range(data.draw(st.integers(0, 3))):
            out.note((*where, k))
            write_value(out, data, (*where, k), depth - 1)
            out.text += data.draw(gap) + "," + data.draw(gap)
        out.text += "]"
    else:
        out.text += "{ "
        for k, key in enumerate(data.draw(st.lists(KEYS, max_size=3, unique=True))):
            out.text += ", " if k else ""
            write_pair(out, data, where, key, depth - 1)
        out.text += " }"


def write_pair(out: Writer, data: st.DataObject, where: Where, key: str, depth: int) -> None:
    out.note((*where, key))
    out.text += f"{key_text(key)} = "
    write_value(out, data, (*where, key), depth)


def write_table(out: Writer, data: st.DataObject, where: Where, names: tuple[str, ...], depth: int) -> None:
    """Write a table's own keys, then its tables and lists of tables."""
    keys = data.draw(st.lists(KEYS, max_size=5, unique=True))
    own = data.draw(st.integers(0, len(keys)))
    for key in keys[:own]:
        write_pair(out, data, where, key, 2)
        out.text += data.draw(st.sampled_from(["\n", "  # [a]\n", "\n\n"]))
    for key in keys[own:] if depth else ():
        header = ".".join(map(key_text, (*names, key)))
        if data.draw(st.booleans()):
            out.note((*where, key))
            out.text += f"[{header}]\n"
            write_table(out, data, (*where, key), (*names, key), depth - 1)
            continue
        for k in range(data.draw(st.integers(1, 3))):
            out.note((*where, key))
            out.note((*where, key, k))
            out.text += f"[[{header}]] # {k}\n"
            write_table(out, data, (*where, key, k), (*names, key), depth - 1)


def places(value: Any, where: Where = ()) -> set[Where]:
    """Return all locations in decoded contents."""
    inner = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    return {where}.union(*(places(item, (*where, key)) for key, item in inner))


@settings(max_examples=60)
@given(st.data())
def test_every_location_in_a_file_is_found_on_its_line(data: st.DataObject) -> None:
    out = Writer()
    write_table(out, data, (), (), 3)
    written = tomllib.loads(out.text)
    assert places(written) == {(), *out.lines}
    for where, line in out.lines.items():
        assert line_of(where, out.text) == line, (where, out.text)
        assert line_of((*where, "missing"), out.text) == line
