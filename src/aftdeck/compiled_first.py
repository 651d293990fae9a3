"""Laws for which plain Python is too slow: they are compiled first, and a terminal shows how long that takes."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from typing import Any

from aftdeck.law import are_compiled
from aftdeck.law_cache import here
from aftdeck.law_change import FILES, Laws, Progress
from aftdeck.law_folder import compiled_before
from aftdeck.lines import print_error
from aftdeck.processes import CHILD
from aftdeck.progress_bar import ProgressBar

COMPILING = "Compiling the laws"


def compiled_first(call: Callable[..., None], *given: Any, package: str = "", files: int = FILES) -> None:
    """Wait until another process has compiled the laws that a call needs, unless this was done before.

    A terminal shows a bar with the time left; elsewhere, one line on standard error says what is waited for. A process
    that this program has started compiles by itself.

    Args:
        call: function of a module; it calls the laws.
        given: its arguments.
        package: name of the package whose laws show whether this was done before; empty: any package.
        files: number of files with their machine code, roughly.

    Raises:
        CompilationError: the laws cannot be compiled.
    """
    within = here.only_kept or CHILD in os.environ  # the call itself, here or in the process that compiles
    if within or not are_compiled() or compiled_before(package):
        return
    with compilation_bar(f"{COMPILING}, once for each version of them; this takes a minute or two") as tell:
        Laws(background=False, tell=tell).want(call, *given, files=files)


@contextmanager
def compilation_bar(otherwise: str = "") -> Iterator[Callable[[Progress | None], None]]:
    """Yield a function that shows the progress of a compilation in a terminal, until the compilation ends.

    Args:
        otherwise: line on standard error if that is not a terminal; "" for none.
    """
    with ExitStack() as shown:
        update = shown.enter_context(ProgressBar(COMPILING))
        if update is None and otherwise:
            print_error(otherwise)

        def tell(progress: Progress | None) -> None:
            if progress is None:
                shown.close()
            elif update is not None:
                update(progress.share)

        yield tell
