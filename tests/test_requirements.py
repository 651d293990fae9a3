"""Versions pinned in ``requirements/``: pyproject.toml allows them, and each has a hash.

No file of ``requirements/`` contains a download address. Every extra is installed for its tests, by
``requirements/dev.txt`` or by a script. A version has an upper bound only with a reason.
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
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
EXTRAS: dict[str, list[str]] = PROJECT["project"]["optional-dependencies"]
SCRIPTS = {"lerobot": "test-lerobot"}
"""Scripts that install an extra and run its tests, for those that are too large for ``requirements/dev.txt``."""


def pins(path: Path) -> Iterator[Requirement]:
    """Yield the requirements in a file that ``uv pip compile`` wrote."""
    for line in path.read_text(encoding="utf-8").splitlines():
        if re.match(r"[a-z0-9]", line):
            yield Requirement(line.removesuffix("\\"))


def required(groups: tuple[str, ...]) -> Iterator[Requirement]:
    """Yield the requirements of the package and of these dependency groups in pyproject.toml."""
    lists = [PROJECT["project"]["dependencies"], *(PROJECT["dependency-groups"][name] for name in groups)]
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


@pytest.mark.parametrize("extra", EXTRAS)
def test_every_extra_is_installed_for_its_tests(extra: str) -> None:
    if extra in SCRIPTS:
        script = (ROOT / "scripts" / SCRIPTS[extra]).read_text(encoding="utf-8")
        assert re.search(rf"uv pip install .*--extra {extra}\b", script)
        assert re.search(r"-m pytest .*tests/", script)
    else:
        pinned = {canonicalize_name(pin.name) for pin in pins(ROOT / "requirements" / "dev.txt")}
        assert {canonicalize_name(Requirement(each).name) for each in EXTRAS[extra]} <= pinned


def test_every_upper_bound_has_its_reason_in_the_line_above() -> None:
    lines = [line.strip() for line in (ROOT / "pyproject.toml").read_text(encoding="utf-8").splitlines()]
    lists = [PROJECT["project"]["dependencies"], *EXTRAS.values(), *PROJECT["dependency-groups"].values()]
    entries = {entry for entries in lists for entry in entries if isinstance(entry, str)}
    bounded = [
        each for each in entries if any(part.operator not in {">=", ">"} for part in Requirement(each).specifier)
    ]
    assert bounded
    assert [each for each in bounded if not lines[lines.index(f'"{each}",') - 1].startswith("# ")] == []
