"""Errors for a damaged file, and for one with larger parts than are read."""

from __future__ import annotations


class DamageError(Exception):
    """Damage in the file; the message describes it."""


class SizeError(DamageError):
    """Part of the file that may be valid, but is larger than the parts that are read; the message describes it."""
