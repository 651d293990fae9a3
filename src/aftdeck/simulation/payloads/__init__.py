"""Payloads in a step: capture, berths, docking, sliding, free flight."""
