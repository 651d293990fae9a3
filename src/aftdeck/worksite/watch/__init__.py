"""The dynamic collision program: clearances, contacts, and what a motion does to them."""
