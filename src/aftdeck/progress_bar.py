"""Progress bar in a terminal."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import TYPE_CHECKING

from aftdeck.lines import visible

if TYPE_CHECKING:
    from rich.progress import Progress as Bar


class ProgressBar:
    """Progress bar; it is shown only if standard error is a terminal."""

    def __init__(self, title: str) -> None:
        self._title = title
        self._bar: Bar | None = None

    def __enter__(self) -> Callable[[float], None] | None:
        if not sys.stderr.isatty():
            return None
        from rich.console import Console  # noqa: PLC0415  (takes 0.1 s)
        from rich.markup import escape  # noqa: PLC0415
        from rich.progress import Progress as Bar  # noqa: PLC0415

        bar = self._bar = Bar(console=Console(stderr=True), transient=True)
        bar.start()
        task = bar.add_task(escape(visible(self._title)), total=1.0)

        def update(share: float) -> None:
            bar.update(task, completed=share)

        return update

    def __exit__(self, *_: object) -> None:
        if self._bar is not None:
            self._bar.stop()
