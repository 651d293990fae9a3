"""How long tests wait for something that comes in a moment on a quiet machine."""

WAIT_S = 300.0
"""Longest wait for a condition, or for a process [s].

Other tests may use all processors meanwhile, and a process may compile laws first: a longer wait means a fault.
"""
