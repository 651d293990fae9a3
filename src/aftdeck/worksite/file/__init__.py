"""Worksite files: types, checks, and construction of the bodies, berths, payloads and cameras that a file describes."""
