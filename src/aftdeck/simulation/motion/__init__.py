"""Limits, contacts and switches that block the arm's motion, and escape directions."""
