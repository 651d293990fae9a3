"""CMD CK: the rehearsal of a motion before it is flown."""
