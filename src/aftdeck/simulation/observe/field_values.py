"""Arguments of `Frame(...)` in `look.py` and `Work(...)` in `look_work.py`, written from the fields' declarations.

``python -m aftdeck.simulation.observe.field_values`` writes them; with ``--check`` it reports files that differ. The
arguments are positional: with 48 keywords, the call would take 2 us more.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any, get_type_hints

import msgspec

from aftdeck.simulation.frame import Frame
from aftdeck.worksite.report import Work

FILES: dict[type[msgspec.Struct], str] = {Frame: "look.py", Work: "look_work.py"}
"""For each struct, the file in this folder whose call of it is written."""


def arguments(struct: type[msgspec.Struct]) -> Iterator[str]:
    """Yield the expression of each field: `value` of its declaration, or else the local variable of the same name."""
    hints: dict[str, Any] = get_type_hints(struct, include_extras=True)
    for name in struct.__struct_fields__:
        yield hints[name].__metadata__[0].extra["value"] or name


def written(struct: type[msgspec.Struct], source: str) -> str:
    """Return the source of a file with the arguments of its ``return Struct(...)`` replaced.

    Raises:
        ValueError: the source contains no such call, or more than one.
    """
    lines = "".join(f"        {argument},\n" for argument in arguments(struct))
    call = rf"(?<=    return {struct.__name__}\(  # written by `make generate`\n).*?(?=    \)\n)"
    new, count = re.subn(call, lambda _: lines, source, flags=re.DOTALL)
    if count != 1:
        raise ValueError(f"expected one call 'return {struct.__name__}(  # written by `make generate`', found {count}")
    return new


def main(check: bool) -> int:
    """Write or check all files; return the number of files that differ from their declarations."""
    differing = 0
    for struct, name in FILES.items():
        path = Path(__file__).with_name(name)
        source = path.read_text(encoding="utf-8")
        new = written(struct, source)
        if new != source:
            differing += 1
            print(f"{path}: the arguments of {struct.__name__} differ from its declaration; run `make generate`")
            if not check:
                path.write_text(new, encoding="utf-8")
    return differing


if __name__ == "__main__":
    different = main("--check" in sys.argv)
    sys.exit(1 if different and "--check" in sys.argv else 0)
