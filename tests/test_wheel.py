"""A built wheel installs and runs on a machine without Node.js and without the source."""

import json
import os
import re
import subprocess
import sys
import tarfile
import time
import urllib.request
import zipfile
from collections.abc import Iterator
from pathlib import Path

import pytest
from cyclonedx.schema import SchemaVersion
from cyclonedx.validation.json import JsonValidator
from uv import find_uv_bin

ROOT = Path(__file__).parents[1]
UV = Path(find_uv_bin())
PAGE = "aftdeck/station/static/index.html"

pytestmark = pytest.mark.slow

WAIT_S = 400.0
"""Maximum time for a program, or for the station's answer [s]. Both may include the compilation of laws."""


@pytest.fixture(scope="module")
def packages(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Build the sdist of this tree and the wheel from that sdist alone; return their folder."""
    folder = tmp_path_factory.mktemp("packages")
    build: list[str | Path] = [UV, "build", "--quiet", "--no-build-isolation", "--python", sys.executable]
    run([*build, "--out-dir", folder, ROOT], dict(os.environ))
    return folder


@pytest.fixture(scope="module")
def wheel(packages: Path) -> Path:
    (found,) = packages.glob("*.whl")
    return found


@pytest.fixture(scope="module")
def bare() -> dict[str, str]:
    """Return an environment with an empty PATH: no Node.js, no npm, no other Python."""
    return {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")} | {"PATH": ""}


@pytest.fixture(scope="module")
def command(wheel: Path, tmp_path_factory: pytest.TempPathFactory, bare: dict[str, str]) -> Path:
    """Install the wheel and its requirements into a clean virtual environment; return its `aftdeck` command."""
    clean = tmp_path_factory.mktemp("clean") / "venv"
    run([UV, "venv", "--quiet", "--python", sys.executable, clean], bare)
    pins = ROOT / "requirements" / "fly.txt"
    run([UV, "pip", "install", "--quiet", "--python", clean, "--constraint", pins, wheel], bare)
    return clean / "bin" / "aftdeck"


def run(arguments: list[str | Path], environment: dict[str, str], cwd: Path | None = None) -> str:
    """Run a command to its end and return its output; if the command fails, fail the test and show that output."""
    ended = subprocess.run(
        arguments, env=environment, cwd=cwd, capture_output=True, text=True, timeout=WAIT_S, check=False
    )
    assert ended.returncode == 0, f"{arguments} ended with {ended.returncode}:\n{ended.stdout}{ended.stderr}"
    return ended.stdout


def test_wheel_contains_the_page_and_no_node_modules(wheel: Path) -> None:
    names = zipfile.ZipFile(wheel).namelist()
    assert PAGE in names
    assert any(name.startswith("aftdeck/station/static/") and name.endswith(".js") for name in names)
    assert not [name for name in names if "node_modules" in name]


def test_wheel_contains_every_template_and_style_of_the_reports(wheel: Path) -> None:
    names = set(zipfile.ZipFile(wheel).namelist())
    files = [path for ending in ("html", "css") for path in (ROOT / "src" / "aftdeck").rglob(f"*.{ending}")]
    templates = {path.relative_to(ROOT / "src").as_posix() for path in files if "static" not in path.parts}
    assert {"aftdeck/report/page/runs.html", "aftdeck/study/report.html"} <= templates <= names


def test_wheel_contains_the_notices_of_every_package_in_the_page(wheel: Path) -> None:
    notices = zipfile.ZipFile(wheel).read("aftdeck/station/static/notices.txt").decode()
    bundled = json.loads((ROOT / "web" / "package.json").read_text(encoding="utf-8"))["dependencies"]
    assert bundled
    for name in bundled:
        installed = json.loads((ROOT / "web" / "node_modules" / name / "package.json").read_text(encoding="utf-8"))
        assert f"## {name} - {installed['version']} ({installed['license']})" in notices
    assert "Permission is hereby granted, free of charge" in notices
    assert "SIL OPEN FONT LICENSE Version 1.1" in notices


@pytest.fixture(scope="module")
def bills(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Folder with the lists of packages that `make package` writes."""
    folder = tmp_path_factory.mktemp("sbom")
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    run([ROOT / "scripts" / "sbom", folder], {**os.environ, "PATH": path})
    return folder


@pytest.mark.parametrize(
    ("name", "version", "contained"),
    [
        ("aftdeck-python", SchemaVersion.V1_6, {"numba", "numpy", "starlette", "mcap"}),
        ("aftdeck-page", SchemaVersion.V1_5, {"three", "@fontsource/barlow-semi-condensed"}),
    ],
)
def test_bill_of_materials_is_valid_and_complete(
    bills: Path, name: str, version: SchemaVersion, contained: set[str]
) -> None:
    text = (bills / f"{name}.cdx.json").read_text(encoding="utf-8")
    assert JsonValidator(version).validate_str(text) is None
    components = {each["name"]: each for each in json.loads(text)["components"]}
    assert contained <= set(components)
    for each in components.values():
        assert each["version"]
        assert "hashes" in json.dumps(each)


def test_sdist_contains_the_page_its_sources_and_no_node_modules(packages: Path) -> None:
    (sdist,) = packages.glob("*.tar.gz")
    with tarfile.open(sdist) as archive:
        names = [name.partition("/")[2] for name in archive.getnames()]
    assert f"src/{PAGE}" in names
    assert {"LICENSE", "README.md", "hatch_build.py", "web/package.json", "web/package-lock.json"} <= set(names)
    assert not [name for name in names if "node_modules" in name]


def test_installed_command_prints_its_help(command: Path, bare: dict[str, str], tmp_path: Path) -> None:
    assert "fly" in run([command, "--help"], bare, tmp_path)


def test_installed_command_runs_a_scenario_headless(command: Path, bare: dict[str, str], tmp_path: Path) -> None:
    summary = json.loads(run([command, "run", "first-flight", "--json"], bare, tmp_path))
    assert summary["scenario"] == "first-flight"
    assert summary["ended"] in ("completed", "time")


@pytest.fixture
def station(command: Path, bare: dict[str, str], tmp_path: Path) -> Iterator[str]:
    """Start a station with the installed command; yield its address."""
    log_file = tmp_path / "output.txt"
    with log_file.open("w") as output:
        server = subprocess.Popen(
            [command, "fly", "--no-browser", "--port", "0"],
            env=bare,
            cwd=tmp_path,
            stdin=subprocess.DEVNULL,
            stdout=output,
            stderr=subprocess.STDOUT,
        )
        try:
            yield address(log_file, server)
        finally:
            server.terminate()
            try:
                server.wait(timeout=60)
            except subprocess.TimeoutExpired:
                server.kill()
                server.wait(timeout=60)


def address(log_file: Path, server: subprocess.Popen[bytes]) -> str:
    """Wait until a station answers at the address in its output; return this address."""
    end = time.monotonic() + WAIT_S
    while time.monotonic() < end and server.poll() is None:
        time.sleep(0.1)
        if found := re.search(r"^Aftdeck station: (http://127\.0\.0\.1:\d+/)$", log_file.read_text(), re.MULTILINE):
            try:
                urllib.request.urlopen(
                    found[1], timeout=WAIT_S
                ).close()  # the station listens before the laws are compiled
            except OSError:
                break
            return found[1]
    pytest.fail(f"no answer from the station:\n{log_file.read_text()}")


def test_installed_station_serves_its_page(station: str) -> None:
    with urllib.request.urlopen(station, timeout=WAIT_S) as answer:
        page = answer.read().decode()
    script = re.search(r'<script type="module"[^>]* src="(?:\./|/)?([^"]+)"', page)
    assert script is not None, page
    with urllib.request.urlopen(station + script[1], timeout=WAIT_S) as answer:
        assert answer.headers.get_content_type() == "text/javascript"
