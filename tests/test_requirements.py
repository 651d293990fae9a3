"""Versions pinned in ``requirements/``: pyproject.toml allows them, and each has a hash.

No file of ``requirements/`` contains a download address.
"""

import re
import tomllib
from collections.abc import Iterator
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

ROOT = Path(__file__).parents[1]
PINNED = sorted((ROOT / "requirements").glob("*.txt"))


def pins(path: Path) -> Iterator[Requirement]:
    """Yield the requirements in a file that ``uv pip compile`` wrote."""
    for line in path.read_text(encoding="utf-8").splitlines():
        if re.match(r"[a-z0-9]", line):
            yield Requirement(line.removesuffix("\\"))


def required(groups: tuple[str, ...]) -> Iterator[Requirement]:
    """Yield the requirements of the package and of these dependency groups in pyproject.toml."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    lists = [project["project"]["dependencies"], *(project["dependency-groups"][name] for name in groups)]
    for entry in (entry for entries in lists for entry in entries):
        if isinstance(entry, str):
            yield Requirement(entry)


@pytest.mark.parametrize(("name", "groups"), [("fly", ("build",)), ("dev", ("build", "dev"))])
def test_every_requirement_is_pinned_to_an_allowed_version(name: str, groups: tuple[str, ...]) -> None:
    versions: dict[str, list[str]] = {}
    for pin in pins(ROOT / "requirements" / f"{name}.txt"):
        versions.setdefault(canonicalize_name(pin.name), []).append(str(pin.specifier).removeprefix("=="))
    for requirement in required(groups):
        found = versions.get(canonicalize_name(requirement.name), [])
        assert found, f"{requirement.name} is not pinned: run `make requirements`"
        assert all(requirement.specifier.contains(version) for version in found), f"{requirement} against {found}"


@pytest.mark.parametrize("path", PINNED, ids=lambda path: path.stem)
def test_every_pin_has_a_hash(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    blocks = re.split(r"(?m)^(?=[a-z0-9])", text)[1:]
    assert len(blocks) == len(list(pins(path))) > 0
    assert [block.partition(" ")[0] for block in blocks if "--hash=sha256:" not in block] == []


@pytest.mark.parametrize("path", PINNED, ids=lambda path: path.stem)
def test_pins_contain_no_address(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    assert "://" not in text
    assert "index-url" not in text
