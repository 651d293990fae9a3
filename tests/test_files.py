"""Decoding of TOML files into types: all errors in one exception, each with its line. Hostile files are included."""

from __future__ import annotations

import codecs
import json
import os
import time
from pathlib import Path

import msgspec
import pytest

import aftdeck
from aftdeck.errors import ScenarioError
from aftdeck.files import MOST_BYTES, Text, line_of, parse, read
from aftdeck.historical.input_channels import CHANNELS
from aftdeck.historical.words_file import read_channels
from aftdeck.scenario.build import BUILT_IN
from aftdeck.units import Length


class Inner(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    size: Length
    names: tuple[str, ...] = ()


class Outer(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    title: str
    inner: Inner | None = None
    part: tuple[Inner, ...] = ()
    pair: tuple[Length, Length] = (Length(0.0), Length(0.0))


DEEP_S, MANY_S = 30.0, 3.0
"""Maximum processor time for a deep or long file, and for a file with many errors [s]. Measured: 2 and 0.1 s."""


def problems(text: str) -> list[str]:
    with pytest.raises(ScenarioError) as caught:
        parse(Outer, Text("a.toml", text))
    assert str(caught.value) == "\n".join(caught.value.problems)
    return list(caught.value.problems)


def test_valid_file_becomes_its_type(tmp_path: Path) -> None:
    file = tmp_path / "good.toml"
    file.write_text('title = "é"\npair = ["1 in", 2]\n[inner]\nsize = "1 ft"\n[[part]]\nsize = 3\n', encoding="utf-8")
    found = parse(Outer, read(file))
    assert found.title == "é" and found.pair == pytest.approx((0.0254, 2.0))
    assert found.inner is not None and found.inner.size == pytest.approx(0.3048)
    assert [part.size for part in found.part] == [3.0]


def test_a_byte_order_mark_is_not_part_of_the_text(tmp_path: Path) -> None:
    """Some editors write one. `read` reads all files of text: scenarios, arms, worksites, studies and channels."""
    source, marked = BUILT_IN / "tutorial.toml", tmp_path / "tutorial.toml"
    marked.write_bytes(codecs.BOM_UTF8 + source.read_bytes())
    assert aftdeck.load_scenario(marked).text == aftdeck.load_scenario(source).text
    marked.write_bytes(codecs.BOM_UTF8 + b"titel = 'x'\n")
    with pytest.raises(ScenarioError, match=r"tutorial\.toml:1: titel"):
        aftdeck.load_scenario(marked)
    channels = tmp_path / "channels.jsonl"
    channels.write_bytes(codecs.BOM_UTF8 + json.dumps({"volts": [0.0] * CHANNELS}).encode())
    assert len(read_channels(channels, 0.04).samples) == 1


def test_all_errors_are_reported_with_their_lines() -> None:
    text = "\n".join(
        ["titel = 'x'", "pair = [1]", "[inner]", "size = 'long'", "[[part]]", "size = 1", "[[part]]", "colour = 'red'"]
    )
    found = problems(text)
    assert len(found) == 6
    assert found[1] == "a.toml:1: titel: unknown field; allowed here: title, inner, part, pair"
    assert any(p == "a.toml: the field 'title' is missing" for p in found)
    assert any(p.startswith("a.toml:2: pair: ") and "length 2" in p for p in found)
    assert any(p.startswith("a.toml:4: inner.size: 'long' is not a length") for p in found)
    assert any(p == "a.toml:8: part[1].colour: unknown field; allowed here: size, names" for p in found)
    assert any(p == "a.toml:7: part[1]: the field 'size' is missing" for p in found)


def test_invalid_toml_is_reported_with_its_line() -> None:
    assert problems("title = \n") == ["a.toml: Invalid value (at line 1, column 9)"]
    assert "a.toml: Cannot overwrite a value" in problems("title = 'a'\ntitle = 'b'\n")[0]


@pytest.mark.parametrize(
    ("text", "what"),
    [
        ("inner = 3", "expected a table, got 3"),
        ("inner = [1, 2]", "expected a table, got [1, 2]"),
        ("part = 3", "Expected `array`, got `int`"),
        ("part = [3]", "part[0]: expected a table, got 3"),
        ("title = 7", "Expected `str`, got `int`"),
        ("title = 1979-05-27", "title"),
    ],
)
def test_value_of_the_wrong_type_is_reported_with_the_expected_type(text: str, what: str) -> None:
    head = "" if "title" in text else "title = 'x'\n"
    assert any(what in problem for problem in problems(head + text))


@pytest.mark.parametrize(
    "text",
    [
        "a" + ".a" * 10_000 + " = 1",
        "[inner" + ".a" * 10_000 + "]",
        "[inner.size" + ".a" * 10_000 + "]",
        "inner = [{" + "a." * 10_000 + "a = 1}]",
        "part = " + "[" * 10_000 + "]" * 10_000,
        "title = " + "{a = " * 10_000 + "1" + "}" * 10_000,
        "title = " + "9" * 100_000,
        "pair = [" + "9" * 4000 + ", 1]",
        "title = '''" + "x" * 100_000,
        "\x00",
        "pair = ['" + "1" * 50_000 + "', '1" + " " * 50_000 + "']",
    ],
    ids=["dotted", "header", "in a number", "in a list", "lists", "tables", "int", "ints", "open", "nul", "spaces"],
)
def test_deep_and_long_files_are_rejected_quickly(text: str) -> None:
    began = time.thread_time()
    found = problems(text)
    assert time.thread_time() - began < DEEP_S
    assert all(problem.startswith("a.toml") and "\n" not in problem for problem in found)


def test_thousands_of_errors_are_reported_quickly() -> None:
    began = time.thread_time()
    assert len(problems("title = 'x'\n" + "".join(f"a{i} = 1\n" for i in range(5000)))) == 5000
    assert time.thread_time() - began < MANY_S


def test_missing_file_is_named_with_the_reason(tmp_path: Path) -> None:
    with pytest.raises(ScenarioError, match=r"none\.toml: .*No such file"):
        read(tmp_path / "none.toml")


def test_folder_is_rejected(tmp_path: Path) -> None:
    with pytest.raises(ScenarioError, match=str(tmp_path)):
        read(tmp_path)


def test_impossible_file_name_is_rejected() -> None:
    for name in ("a\0b.toml", "x" * 5000 + ".toml"):
        with pytest.raises(ScenarioError):
            read(Path(name))


def test_huge_file_is_rejected_without_reading(tmp_path: Path) -> None:
    file = tmp_path / "huge.toml"
    with file.open("wb") as handle:
        handle.seek(10_000_000_000)
        handle.write(b"x")
    with pytest.raises(ScenarioError, match=rf"10000000001 bytes.* {MOST_BYTES}\b"):
        read(file)


def test_binary_file_is_rejected_with_the_byte(tmp_path: Path) -> None:
    file = tmp_path / "binary.toml"
    file.write_bytes(b"ok = 1\n" + bytes(range(256)))
    with pytest.raises(ScenarioError, match="byte 135"):
        read(file)


def test_device_is_rejected_without_reading() -> None:
    with pytest.raises(ScenarioError, match="/dev/zero"):
        read(Path("/dev/zero"))


def test_pipe_is_rejected_without_waiting(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe.toml"
    os.mkfifo(pipe)
    with pytest.raises(ScenarioError, match=r"pipe\.toml"):
        read(pipe)


def test_line_of_finds_keys_headers_and_the_nearest_line_above() -> None:
    text = "a = 1\n[t]\nb.c = 2\n[[l]]\nx = 1\n[[l]]\nx = 2\n[l.sub]\ny = 1\n"
    assert line_of(("a",), text) == 1
    assert line_of(("t",), text) == 2
    assert line_of(("t", "b", "c"), text) == 3
    assert line_of(("t", "missing"), text) == 2
    assert line_of(("l", 1, "x"), text) == 7
    assert line_of(("l", 1, "sub", "y"), text) == 9
    assert line_of(("nowhere",), text) is None
    assert line_of((), text) is None
