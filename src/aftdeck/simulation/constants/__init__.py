"""Constants of a run: arm and worksite in the form in which the step needs them."""
