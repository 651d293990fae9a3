"""Attack on the station's messages: any text is decoded to a message, or rejected by an error of the decoder."""

from __future__ import annotations

import functools
import json
import random

import msgspec

from aftdeck.station.messages import from_page

_DECODERS: tuple[msgspec.json.Decoder[object], ...] = (
    msgspec.json.Decoder(from_page.Hello),
    msgspec.json.Decoder(from_page.FromPage),
)
_REJECTIONS = (msgspec.MsgspecError, RecursionError)
"""Errors after which `station.server.page` answers that a message is invalid. Invalid UTF-8 never reaches it."""
_VALUES = (
    "null", "true", "0", "-1", "1e999", "-1e999", "1e308", "9" * 5000, "0.5", '""', '"\\u0000"', '"\\ud800"', "[]",
    "{}", "[0, 0, 0]", "[" * 3000 + "]" * 3000, '{"a":' * 3000 + "1" + "}" * 3000, '"' + "x" * 20_000 + '"', "NaN",
    "Infinity", "-", "1e", '"coarse"', "[1e999, 0, 0]", "9007199254740993",
)  # fmt: skip


@functools.cache
def _tags() -> tuple[tuple[str, tuple[str, ...]], ...]:
    kinds: tuple[type[msgspec.Struct], ...] = (from_page.Hello, *from_page.FromPage.__args__)
    return tuple((str(kind.__struct_config__.tag), kind.__struct_encode_fields__) for kind in kinds)


def attack(seed: int) -> str:
    """Decode a random text as each message of a page; return whether a decoder accepted it.

    Raises:
        Exception: a decoder raised something that the station does not catch.
    """
    rng = random.Random(seed)
    text = _text(rng)
    accepted = False
    for decoder in _DECODERS:
        try:
            message = decoder.decode(text)
        except _REJECTIONS as error:
            str(error).encode()
        else:
            msgspec.json.encode(message)
            accepted = True
    return "accepted" if accepted else "rejected"


def _text(rng: random.Random) -> str:
    """Return a message with random fields, with one or more characters changed in every other text."""
    tag, fields = rng.choice(_tags())
    pairs = [f'"type": "{tag}"', *(f'"{name}": {_value(rng)}' for name in fields if rng.random() < 0.9)]
    rng.shuffle(pairs)
    text = "{" + ", ".join(pairs) + "}"
    if rng.random() < 0.5:
        at = rng.randrange(len(text))
        text = text[:at] + "".join(rng.choices('{}[]",:0e-\\\u2028\x00é', k=rng.randrange(4))) + text[at + 1 :]
    return text


def _value(rng: random.Random) -> str:
    numbers = [rng.uniform(-1.5, 1.5) for _ in range(rng.choice((1, 3, 3, 3, 6)))]
    return rng.choice((json.dumps(numbers), json.dumps(numbers[0]), str(rng.randrange(10)), rng.choice(_VALUES)))
