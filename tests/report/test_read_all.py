"""Recordings read by several processes: the same results as in one process, and an error for each that fails."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from aftdeck.errors import AftdeckError
from aftdeck.recording.reader import Recording
from aftdeck.recording.run import record
from aftdeck.report import read_all as module
from aftdeck.report.of_recording import recorded_row
from aftdeck.report.page.gather import gathered
from aftdeck.report.read_all import read_all

ROW = "aftdeck.report.of_recording:recorded_row"


def row_unless_named_dies(recording: Recording) -> object:
    """Return a row of the table; end the process for the recording with the name ``dies``."""
    if recording.path.stem == "dies":
        os._exit(9)
    return recorded_row(recording)


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """Two recordings with a damaged file between them."""
    folder = tmp_path_factory.mktemp("runs")
    files = [folder / name for name in ("a.mcap", "damaged.mcap", "dies.mcap")]
    for file in files[::2]:
        record("first-flight", file)
    files[1].write_bytes(b"no recording")
    return files


@pytest.fixture
def processes(monkeypatch: pytest.MonkeyPatch) -> None:
    """Start processes even for small files, and on a machine with one core."""
    monkeypatch.setattr(module, "ENOUGH", 0)
    monkeypatch.setattr(module, "cores", lambda: 2)


@pytest.mark.usefixtures("processes")
def test_processes_give_the_rows_and_errors_of_one_process(files: list[Path], monkeypatch: pytest.MonkeyPatch) -> None:
    calls: list[int] = []
    several = list(read_all(files, ROW, lambda: calls.append(1)))
    monkeypatch.setattr(module, "cores", lambda: 1)
    one = list(read_all(files, ROW, lambda: calls.append(2)))
    assert calls == [1, 2], "called once if other processes read, and once if this one does"
    assert several[::2] == one[::2] and isinstance(one[0], dict)
    assert isinstance(one[1], AftdeckError) and str(several[1]) == str(one[1])


@pytest.mark.usefixtures("processes")
def test_death_of_a_process_is_an_error_of_its_recording_only(files: list[Path]) -> None:
    found = read_all([*files[2:], *files[:1] * 2], f"{__name__}:row_unless_named_dies")
    assert [type(one) for one in found] == [AftdeckError, dict, dict]


@pytest.mark.usefixtures("processes")
def test_reading_that_is_broken_off_ends_its_processes(files: list[Path], monkeypatch: pytest.MonkeyPatch) -> None:
    started: list[module._Reader] = []

    class Reader(module._Reader):
        def __init__(self, file: Path, read: str) -> None:
            super().__init__(file, read)
            started.append(self)

    def interrupt() -> None:
        assert [reader.process.returncode for reader in started] == [None, None]
        raise KeyboardInterrupt

    monkeypatch.setattr(module, "_Reader", Reader)
    with pytest.raises(KeyboardInterrupt):
        list(read_all(files, ROW, interrupt))
    assert None not in [reader.process.returncode for reader in started]


@pytest.mark.usefixtures("processes")
def test_data_of_a_page_travel_between_processes(files: list[Path]) -> None:
    several = list(read_all(files[::2], "aftdeck.report.page.gather:gathered"))
    for file, found in zip(files[::2], several, strict=True):
        here = gathered(Recording(file))
        assert found.metrics == here.metrics and found.events == here.events
        assert found.tip.tobytes() == here.tip.tobytes()


def test_name_that_no_file_can_have_is_an_error() -> None:
    assert [type(found) for found in read_all([Path("x" * 300)], ROW)] == [AftdeckError]
