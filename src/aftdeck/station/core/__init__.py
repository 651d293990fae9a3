"""Core of a station's session: what pages ask for, the run, and what is new for the pages; no thread, clock or file."""
