"""Berths of payloads: docking, berthing and latches."""
