"""Compiled parts of a control period on the kinematic plant."""
