"""Laws of a command: plain Python at first, and compiled as soon as another process has compiled them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from typing import TYPE_CHECKING, Any

from aftdeck.progress_bar import ProgressBar

if TYPE_CHECKING:
    from aftdeck.law_change import Progress


@contextmanager
def compiled_meanwhile(call: Callable[..., None], *given: Any, bar: bool = True) -> Iterator[None]:
    """Let the laws that a call needs be compiled while the command goes on.

    Args:
        call: function of a module that calls these laws.
        given: its arguments.
        bar: whether a terminal shows the progress; the command itself must then show none.
    """
    from aftdeck.law_change import Laws

    with ExitStack() as shown:
        update = shown.enter_context(ProgressBar("Compiling the laws")) if bar else None

        def tell(progress: Progress | None) -> None:
            if progress is None:
                shown.close()
            elif update is not None:
                update(progress.share)

        laws = Laws(background=False, tell=tell)
        laws.want(call, *given)
        try:
            yield
        finally:
            laws.close()


def pictures_compiled_meanwhile(*, bar: bool = True) -> ExitStack:
    """Let the laws of pictures be compiled while the command goes on; use it in a ``with`` statement."""
    from aftdeck.visual.warm import warm_up

    stack = ExitStack()
    stack.enter_context(compiled_meanwhile(warm_up, bar=bar))
    return stack
