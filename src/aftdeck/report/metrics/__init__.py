"""Metrics by subject; each module has the definitions of its metrics and the class that computes them."""
