"""The page's sources import each other without cycles, including type imports."""

from __future__ import annotations

import re
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

SOURCES = Path(__file__).parents[1] / "web" / "src"
FROM = re.compile(r"^(?:import|export)\b[^;]*?\bfrom '(\.[^']+)'", re.MULTILINE)


def imports() -> dict[Path, set[Path]]:
    """Return the page's own sources that each source imports."""
    found = {}
    for file in SOURCES.rglob("*.ts"):
        named = [(file.parent / path).resolve() for path in FROM.findall(file.read_text(encoding="utf-8"))]
        found[file] = {
            one for path in named for one in (path.with_name(f"{path.name}.ts"), path / "index.ts") if one.is_file()
        }
    return found


def test_page_sources_have_no_import_cycle() -> None:
    found = imports()
    assert len(found) > 150 and SOURCES / "link" / "live.ts" in found[SOURCES / "main.ts"]
    try:
        TopologicalSorter(found).prepare()
    except CycleError as error:
        pytest.fail(" -> ".join(str(file.relative_to(SOURCES)) for file in error.args[1]))
