"""The user's folders: every command works without a home folder, and says in one line where it keeps its files."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from multiprocessing.connection import Connection
from pathlib import Path

import pytest

from aftdeck import folders
from aftdeck.folders import Kind, user_folder
from aftdeck.law_folder import cache_folder
from aftdeck.processes import Child
from tests.study.studies import SHORT

NAMELESS = """
import os, pwd, sys
def unknown(number):
    raise KeyError(number)
pwd.getpwuid = unknown
from aftdeck.cli import main
main()
"""
"""Program that runs the command line for a user without a name, as in a container with a foreign user number."""
COMMANDS = (
    "arms",
    "scenarios",
    "studies",
    "recordings",
    "arm srms forward 0 0.5 -1 0.2 0.1 0",
    "check first-flight",
    "run uncradle --out run.mcap",
    "replay run.mcap",
    "report run.mcap -o page.html",
    "render uncradle --camera A -o picture.svg",
    "recordings --json",
)


@pytest.fixture
def temporary(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty folder for temporary files."""
    folder = tmp_path / "temporary"
    folder.mkdir()
    monkeypatch.setenv("TMPDIR", str(folder))
    monkeypatch.setattr(tempfile, "tempdir", None)
    folders.say_once.cache_clear()
    return folder


@pytest.fixture
def usual(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder in which the user's folders usually are."""
    folder = tmp_path / "usual"
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(folder / "cache"))
    monkeypatch.setattr("platformdirs.user_data_dir", lambda *_, **__: str(folder / "data"))
    return folder


def ran(code: str, command: str, folder: Path, env: dict[str, str]) -> subprocess.CompletedProcess[str]:
    """Run Python code with the words of a command as arguments, in a folder; it must end without an error."""
    done = subprocess.run(
        [sys.executable, "-c", code, *command.split()],
        cwd=folder,
        env=env,
        capture_output=True,
        text=True,
        check=False,
        timeout=600,
    )
    assert done.returncode == 0, (command, done.stderr)
    return done


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.skipif(not hasattr(os, "getuid"), reason="users without a name are those of Unix")
def test_every_command_works_for_a_user_without_name_and_home(tmp_path: Path, temporary: Path) -> None:
    compiled, own = cache_folder(), temporary / f"aftdeck-{os.getuid()}"
    assert compiled is not None
    for folder in (own, own / "cache"):
        folder.mkdir(mode=0o700)
    shutil.copytree(compiled, own / "cache" / compiled.name)
    env = {"PATH": os.environ["PATH"], "TMPDIR": str(temporary)}
    for command in COMMANDS:
        done = ran(NAMELESS, command, tmp_path, env)
        said = [line for line in done.stderr.splitlines() if not line.startswith("caution: ")]
        assert all(str(own) in line for line in said) and len(said) == len(set(said)) <= 2, (command, said)
        assert said or command in ("arms", "scenarios", "studies"), command
    assert sorted(path.name for path in own.iterdir()) == ["cache", "data"]
    assert not (tmp_path / "~").exists()


@pytest.mark.parametrize("kind", ["cache", "data"])
def test_the_usual_folder_is_used_in_silence(
    kind: Kind, usual: Path, temporary: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert user_folder(kind) == usual / kind and (usual / kind).is_dir()
    assert capsys.readouterr().err == "" and not list(temporary.iterdir())


@pytest.mark.parametrize("kind", ["cache", "data"])
def test_a_folder_for_temporary_files_replaces_one_that_cannot_be_written(
    kind: Kind, usual: Path, temporary: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    usual.touch()
    found = user_folder(kind)
    assert found == user_folder(kind) and found is not None and found.is_relative_to(temporary)
    assert found.parent.stat().st_mode & 0o077 == 0
    (line,) = capsys.readouterr().err.splitlines()
    assert str(usual) in line and str(found) in line


@pytest.mark.parametrize("kind", ["cache", "data"])
def test_what_is_in_the_usual_folder_is_used_even_if_it_cannot_be_written(
    kind: Kind, usual: Path, temporary: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (usual / kind).mkdir(parents=True)
    monkeypatch.setattr(
        folders, "_not_writable", lambda folder: "No space left on device" if usual in folder.parents else None
    )
    assert user_folder(kind, "kept") != usual / kind
    assert len(capsys.readouterr().err.splitlines()) == 1
    (usual / kind / "kept").touch()
    assert user_folder(kind, "kept") == usual / kind
    assert capsys.readouterr().err == ""


@pytest.mark.parametrize("kind", ["cache", "data"])
def test_there_may_be_no_folder_for_temporary_files(
    kind: Kind, usual: Path, temporary: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    usual.touch()

    def nowhere() -> str:
        raise FileNotFoundError(2, "No usable temporary directory found")

    monkeypatch.setattr(tempfile, "gettempdir", nowhere)
    assert user_folder(kind) is None
    (line,) = capsys.readouterr().err.splitlines()
    assert str(usual) in line


def find_folder(pipe: Connection) -> None:
    """Send the folder for compiled code that a process finds."""
    pipe.send(user_folder("cache"))


def test_a_sentence_is_left_to_the_first_process(
    usual: Path, temporary: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    usual.touch()
    children = [Child(find_folder) for _ in range(2)]
    found = {child.pipe.recv() for child in children}
    for child in children:
        child.kill()
    assert found == {user_folder("cache")}
    assert len(capfd.readouterr().err.splitlines()) == 1


@pytest.mark.parametrize("state", ["open to all", "open to read", "its cache is open to all", "a link", "a file"])
def test_a_folder_for_temporary_files_that_others_could_fill_is_not_used(
    state: str, usual: Path, temporary: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    usual.touch()
    found = user_folder("cache")
    assert found is not None
    own = found.parent
    found.rmdir()
    own.rmdir()
    if state.startswith("open"):
        own.mkdir()
        own.chmod(0o777 if state == "open to all" else 0o755)
    elif state == "its cache is open to all":
        own.mkdir(0o700)
        found.mkdir()
        found.chmod(0o777)
    elif state == "a link":
        (tmp_path / "another").mkdir()
        own.symlink_to(tmp_path / "another")
    else:
        own.touch()
    capsys.readouterr()
    assert user_folder("cache") is None
    assert user_folder("cache") is None
    (line,) = capsys.readouterr().err.splitlines()
    assert str(usual) in line and str(own) in line and folders.OWN_CACHE in line


@pytest.mark.slow
def test_commands_work_if_no_folder_can_be_written(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    closed = str(tmp_path / "file")
    code = f"import tempfile; tempfile.tempdir = {closed!r}; from aftdeck.cli import main; main()"
    env = {**os.environ, "NUMBA_CACHE_DIR": closed, "XDG_DATA_HOME": closed}

    def printed(command: str, code: str = code) -> str:
        done = ran(code, command, tmp_path, env)
        assert all(closed in line or "list of recordings" in line for line in done.stderr.splitlines()), done.stderr
        return done.stdout

    arm = "arm srms forward 0 0.5 -1 0.2 0.1 0"
    compiled = subprocess.run(
        [sys.executable, "-m", "aftdeck", *arm.split()], capture_output=True, text=True, check=True, timeout=300
    )
    assert printed(arm) == compiled.stdout
    (tmp_path / "short.toml").write_text(SHORT, encoding="utf-8")
    printed("run short.toml --out run.mcap")
    assert "equal" in printed("replay run.mcap")
