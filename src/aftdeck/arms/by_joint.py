"""Check of a list that has to have one value for each joint of an arm."""

from __future__ import annotations

from collections.abc import Sequence, Sized


def misfit(joints: Sequence[str], given: Sized) -> str:
    """Return why a list does not fit an arm with these joints; "" if it has one value for each of them."""
    if len(given) == len(joints):
        return ""
    return f"expected {len(joints)} values, one for each joint ({', '.join(joints)}); got {len(given)}"
