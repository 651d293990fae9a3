"""Tables of an arm file, and a constant with its source: the base of all types in `arms.model` and `arms.drives`."""

from __future__ import annotations

from typing import Annotated, Generic, Literal, TypeVar

import msgspec

_T = TypeVar("_T")

Confidence = Literal["firm", "single", "derived", "assumed"]
Text = Annotated[str, msgspec.Meta(min_length=1)]


class Part(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Table of an arm file; unknown fields are rejected."""


class Cited(Part, frozen=True):
    """Source and confidence of a quantity that several tables have."""

    source: Text
    confidence: Confidence


class Constant(Part, Generic[_T], frozen=True):
    """Value with its source and its confidence."""

    value: _T
    source: Text
    confidence: Confidence
