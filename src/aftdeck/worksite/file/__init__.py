"""Worksite files: their types, their checks, and what is built from them."""
