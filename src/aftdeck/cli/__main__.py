"""``python -m aftdeck.cli``: the command line."""

from aftdeck.cli import main

main()
