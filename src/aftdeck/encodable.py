"""Text that UTF-8, JSON, HTML and databases can contain.

On Linux the name of a file is any bytes. Python shows a byte that is not UTF-8 as a lone surrogate (PEP 383), which no
encoder accepts.
"""

from __future__ import annotations

from pathlib import Path


def encodable(text: str | Path) -> str:
    r"""Return a text, or a path as text, with an escape such as ``\udcff`` for each lone surrogate.

    The result names the file for people. To open the file, keep the path itself.
    """
    return str(text).encode("utf-8", "backslashreplace").decode()
