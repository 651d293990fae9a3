"""Sliding of a held payload along walls."""
