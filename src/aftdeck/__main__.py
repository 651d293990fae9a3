"""``python -m aftdeck``: the command line."""

from aftdeck.cli import main

main()
