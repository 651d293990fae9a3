"""Benchmarks of the project's promised figures: ``python -m benchmarks [--json] [NAME...]``."""
