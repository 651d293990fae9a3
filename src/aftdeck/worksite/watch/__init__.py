"""The dynamic collision program: clearances, contacts, and the effect of a motion on the contacts."""
