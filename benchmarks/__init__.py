"""Benchmarks of the times and sizes that the project promises: ``python -m benchmarks [--json] [NAME...]``."""
