"""Learning environments for Gymnasium: tasks of the arm, flown with the hand controllers that a person uses."""
