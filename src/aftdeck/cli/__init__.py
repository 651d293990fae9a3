"""Command line: the application `app`, one module for each group of commands, and `main`, which runs `app`."""

from __future__ import annotations

import atexit
import gc
import io
import os
import sys

from aftdeck.cli import arm as _arm
from aftdeck.cli import export as _export
from aftdeck.cli import flights as _flights
from aftdeck.cli import pictures as _pictures
from aftdeck.cli import planes as _planes
from aftdeck.cli import recordings as _recordings
from aftdeck.cli import report as _report
from aftdeck.cli import study as _study
from aftdeck.cli.app import app
from aftdeck.errors import AftdeckError, ScenarioError
from aftdeck.lines import print_error

__all__ = ["app", "main"]

COMMANDS = (_flights, _arm, _recordings, _report, _export, _study, _pictures, _planes)
"""Modules that add their commands to `app` when they are imported, in the order of the help text."""

READER_GONE = 141
"""Exit code after the reader of a pipe has closed the pipe: the code that a shell reports for SIGPIPE."""


def main() -> None:
    """Run the command line; after invalid input, print one sentence and exit with code 2.

    A character that the terminal cannot show is printed as a question mark. If the reader of a pipe closes it early
    (``| head``), the program ends without a message.
    """
    atexit.register(gc.freeze)  # otherwise the interpreter looks for garbage at its end, which takes half a second
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")
    try:
        try:
            app(prog_name="aftdeck")
        finally:
            sys.stdout.flush()
    except AftdeckError as error:
        for text in error.problems if isinstance(error, ScenarioError) else (str(error),):
            print_error(text)
        raise SystemExit(2) from None
    except (BrokenPipeError, SystemExit) as error:
        if not isinstance(error, BrokenPipeError) and not isinstance(error.__context__, BrokenPipeError):
            raise
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # the interpreter flushes stdout once more at exit
        raise SystemExit(READER_GONE) from None
    except KeyboardInterrupt:
        raise SystemExit(130) from None
