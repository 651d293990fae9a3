"""Arguments of the call `Frame(...)` in `look.py`, generated from the declarations of the frame's fields.

``python -m aftdeck.simulation.observe.field_values`` writes the arguments into `look.py`. With ``--check`` the program
reports a difference and writes nothing. The arguments are positional, because keywords would cost 2 us in each call.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any, get_type_hints

from aftdeck.simulation.frame import Frame

LOOK = Path(__file__).with_name("look.py")
BEGIN, END = "    return Frame(  # arguments generated from the declaration of Frame: `make generate`\n", "    )\n"
"""Lines before and after the arguments."""


def arguments() -> list[str]:
    """Return the expression of each field: `value` of its declaration, or the local variable with the field's name."""
    hints: dict[str, Any] = get_type_hints(Frame, include_extras=True)
    return [hints[name].__metadata__[0].extra["value"] or name for name in Frame.__struct_fields__]


def generated(source: str) -> str:
    """Return the source of `look.py` with new arguments."""
    before, begin, rest = source.partition(BEGIN)
    _, end, after = rest.partition(END)
    assert begin and end, f"{LOOK}: the call of Frame is missing"
    return before + begin + "".join(f"        {argument},\n" for argument in arguments()) + end + after


if __name__ == "__main__":
    source = LOOK.read_text(encoding="utf-8")
    if (new := generated(source)) != source:
        if "--check" in sys.argv[1:]:
            sys.exit(f"{LOOK}: the arguments of Frame do not follow from its declaration; run `make generate`")
        LOOK.write_text(new, encoding="utf-8")
