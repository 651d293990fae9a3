"""Error for a damaged file."""

from __future__ import annotations


class DamageError(Exception):
    """Damage in the file; the message describes it."""
