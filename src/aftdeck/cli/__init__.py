"""The command line: `app` with a module for each group of commands, and `main`, which runs it."""

from __future__ import annotations

import io
import os
import sys

from aftdeck.cli import arm as _arm
from aftdeck.cli import flights as _flights
from aftdeck.cli import recordings as _recordings
from aftdeck.cli.app import app
from aftdeck.errors import AftdeckError

__all__ = ["app", "main"]

COMMANDS = (_flights, _arm, _recordings)
"""Modules whose commands `app` has once they are imported, in the order of its help."""

READER_GONE = 141
"""Exit code where the reader of a pipe has gone: a shell's for SIGPIPE."""


def main() -> None:
    """Run the command line; bad input ends with a sentence and exit code 2.

    A terminal that cannot show a sign gets a question mark for it. A reader that goes before the end (``| head``)
    ends the program quietly.
    """
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")
    try:
        try:
            app(prog_name="aftdeck")
        finally:
            sys.stdout.flush()
    except AftdeckError as error:
        print(f"aftdeck: {error}", file=sys.stderr)
        raise SystemExit(2) from None
    except (BrokenPipeError, SystemExit) as error:
        if not isinstance(error, BrokenPipeError) and not isinstance(error.__context__, BrokenPipeError):
            raise
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # for the interpreter's own last flush
        raise SystemExit(READER_GONE) from None
    except KeyboardInterrupt:
        raise SystemExit(130) from None
