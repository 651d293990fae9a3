"""Every attack of `fuzz` finds nothing for its first seeds, and reaches both what is accepted and what is rejected."""

from __future__ import annotations

import random
from collections import Counter

import pytest

from fuzz import files, mutants
from fuzz.__main__ import run
from fuzz.attacks import ATTACKS, Attack
from fuzz.bounded import TooLongError, outcome

SHARDS = 8
"""Number of tests that share the seeds of an attack, so that several processes can run them."""
QUICK = 2
"""Number of these tests that are not long."""


@pytest.mark.slow
@pytest.mark.parametrize("shard", [pytest.param(n, marks=pytest.mark.long) if n >= QUICK else n for n in range(SHARDS)])
@pytest.mark.parametrize("name", ATTACKS)
def test_attack_finds_nothing(name: str, shard: int) -> None:
    found: Counter[str] = Counter()
    for seed in range(shard, ATTACKS[name].tested, SHARDS):
        try:
            found[outcome(ATTACKS[name], seed)] += 1
        except Exception as error:
            error.add_note(f"python -m fuzz {name} --seed {seed}")
            raise
    assert len(found) > 1, "the attack has always the same outcome"
    assert "none accepted" not in found


@pytest.mark.parametrize("kind", sorted({original.kind for original in files.originals()}))
def test_originals_of_each_kind_are_accepted(kind: str) -> None:
    for original in files.originals():
        if original.kind == kind:
            original.load(mutants.without_comments(files.text_of(original.path)))


def test_mutants_of_a_seed_are_the_same() -> None:
    text = files.text_of(files.originals()[0].path)
    one, other = (mutants.mutant(text, random.Random(7)) for _ in range(2))
    assert one == other != mutants.mutant(text, random.Random(8))


def test_attack_that_hangs_is_ended() -> None:
    def endless(seed: int) -> str:
        while True:
            pass

    with pytest.raises(TooLongError):
        outcome(Attack(endless, 1, 1, 0.05), 0)


def test_failing_seed_is_printed(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    def failing(seed: int) -> str:
        if seed == 12:
            raise KeyError("lost")
        return "rejected"

    monkeypatch.setitem(ATTACKS, "wire", Attack(failing, 5, 1, 1.0))
    assert run(["wire"], 10, None) == 1
    out = capsys.readouterr().out
    assert "first seed 10" in out and "python -m fuzz wire --seed 12\n" in out and "KeyError: 'lost'" in out
