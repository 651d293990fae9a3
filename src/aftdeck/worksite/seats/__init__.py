"""Seats of payloads: docking, berthing and latches."""
