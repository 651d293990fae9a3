"""Attacks on Aftdeck with generated files, inputs, recordings and messages: ``python -m fuzz``."""
