"""Session of a server: the core with a clock, threads, files and processes."""
