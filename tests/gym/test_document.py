"""The Python lines of docs/environments.md run as they are printed."""

from __future__ import annotations

from typing import Any

import pytest

from tests.pages import ROOT, blocks


def test_python_lines_of_the_document_run_in_their_order(capsys: pytest.CaptureFixture[str]) -> None:
    text = (ROOT / "docs/environments.md").read_text(encoding="utf-8")
    codes = ["\n".join(line for _, line in block) for block in blocks(text)]
    names: dict[str, Any] = {}
    for code in codes:
        exec(code, names)
    assert names["picture"].shape == (240, 320, 3)
    assert names["observations"].shape[0] == 2
    assert "http://127.0.0.1:" in capsys.readouterr().out
