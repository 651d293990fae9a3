"""CMD CK: rehearsal of a motion before the arm makes it."""
