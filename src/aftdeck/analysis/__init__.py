"""Dynamics of an arm about a pose: mass matrix, natural modes, and linear models with servos or brakes."""
