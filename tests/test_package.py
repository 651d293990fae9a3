"""The public names of the package, and the libraries that its import loads."""

from __future__ import annotations

import json
import subprocess
import sys

import pytest

import aftdeck


@pytest.mark.parametrize("name", aftdeck.__all__)
def test_every_public_name_exists(name: str) -> None:
    assert getattr(aftdeck, name) is not None
    assert name in dir(aftdeck)


def test_unknown_name_raises_attribute_error() -> None:
    with pytest.raises(AttributeError, match=r"'aftdeck' .*'teleport'"):
        _ = aftdeck.teleport


def loaded(statement: str) -> set[str]:
    """Return the top-level packages that are loaded after a statement in a new interpreter."""
    code = f"{statement}\nimport sys, json\nprint(json.dumps(sorted({{m.split('.')[0] for m in sys.modules}})))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=300)
    return set(json.loads(done.stdout))


def test_importing_the_package_loads_no_library() -> None:
    assert not loaded("import aftdeck") & {"numba", "numpy", "msgspec", "starlette", "rich", "typer", "jinja2"}


def test_reading_the_version_loads_no_library() -> None:
    assert not loaded("import aftdeck; aftdeck.__version__") & {"numba", "numpy", "msgspec"}
