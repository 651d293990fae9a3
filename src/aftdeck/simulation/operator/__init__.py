"""The operator in a step: switches, sticks, targets, sequences and the script."""
