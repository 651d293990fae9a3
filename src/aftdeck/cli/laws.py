"""Laws of a command: plain Python at first, and compiled as soon as another process has compiled them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, ExitStack, contextmanager
from typing import Any


@contextmanager
def compiled_meanwhile(
    call: Callable[..., None], *given: Any, files: int | None = None, bar: bool = True
) -> Iterator[None]:
    """Let the laws that a call needs be compiled while the command goes on.

    Args:
        call: function of a module that calls these laws.
        given: its arguments.
        files: number of files with their machine code, roughly; None: that of a run.
        bar: whether a terminal shows the progress; the command itself must then show none.
    """
    from aftdeck.compiled_first import compilation_bar
    from aftdeck.law_change import FILES, Laws

    with ExitStack() as shown:
        laws = Laws(background=False, tell=shown.enter_context(compilation_bar()) if bar else lambda _: None)
        laws.want(call, *given, files=files or FILES)
        try:
            yield
        finally:
            laws.close()


def pictures_compiled_meanwhile(*, bar: bool = True) -> AbstractContextManager[None]:
    """Let the laws of pictures be compiled while the command goes on; `bar` as for `compiled_meanwhile`."""
    from aftdeck.visual.warm import FILES, warm_up

    return compiled_meanwhile(warm_up, files=FILES, bar=bar)
