"""Command line, called in this process."""

from __future__ import annotations

import json
import sys
from typing import Any

import pytest

from aftdeck import cli

Output = tuple[int, str, str]
"""Exit code, standard output, standard error."""


class Run:
    """Calls the command line in this process, as if on a terminal of 80 columns."""

    def __init__(self, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
        self.capsys, self.monkeypatch = capsys, monkeypatch
        monkeypatch.setenv("COLUMNS", "80")

    def __call__(self, *arguments: str) -> Output:
        self.monkeypatch.setattr(sys, "argv", ["aftdeck", *arguments])
        with pytest.raises(SystemExit) as ended:
            cli.main()
            raise SystemExit(0)
        out, err = self.capsys.readouterr()
        code = ended.value.code
        return (code if isinstance(code, int) else 0), out, err

    def json(self, *arguments: str) -> dict[str, Any]:
        code, out, err = self(*arguments, "--json")
        assert (code, err) == (0, ""), f"exit code {code}: {err}"
        found = json.loads(out)
        assert isinstance(found, dict)
        return found
