"""The console: every line has an answer, legal changes act and are recorded, and others are refused with a reason."""

from __future__ import annotations

import random
import string
from collections.abc import Iterator
from pathlib import Path

import pytest

from aftdeck import Inputs
from aftdeck.errors import InputError
from aftdeck.historical.typewriter import addresses, read_word, write_word
from aftdeck.recording.bundle import opening
from aftdeck.recording.replay import verify
from aftdeck.scenario.key_list import key_list
from aftdeck.scenario.load import load_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.run import Simulation
from aftdeck.station.core.direct import Direct, DirectPage, DirectRecording
from aftdeck.station.core.typewriter import MOST_LINES, MOST_WORDS
from aftdeck.station.messages import from_page, to_page
from tests.each import each, number, seeds
from tests.legal_changes import changing, random_change

CONCEPT = "concept-1972"


class Typist:
    """Page that types on the console of a session."""

    def __init__(self, scenario: Scenario, recording: DirectRecording | None = None) -> None:
        self.session = Direct(scenario, recording=recording)
        self.page: DirectPage = self.session.join()
        self._seq = 0

    def enter(self, line: str, page: DirectPage | None = None) -> to_page.Typed:
        """Return the answer to a line."""
        (answer,) = self._answers(from_page.TypeLine, line, page or self.page)
        assert isinstance(answer, to_page.Typed)
        return answer

    def complete(self, line: str) -> tuple[str, ...]:
        """Return the words that complete a line."""
        (answer,) = self._answers(from_page.CompleteLine, line, self.page)
        assert isinstance(answer, to_page.Completed)
        return answer.words

    def _answers(
        self, kind: type[from_page.TypeLine | from_page.CompleteLine], line: str, page: DirectPage
    ) -> list[to_page.FromServer]:
        self._seq += 1
        page.send(kind(self._seq, line))
        return [one for one in page.receive() if isinstance(one, to_page.Typed | to_page.Completed)]


def test_changed_value_acts_in_the_next_step_and_is_told() -> None:
    typist = Typist(load_scenario(CONCEPT))
    before = typist.session.step().frame
    assert typist.enter("set limits.por.translation = 0.3 m/s; clearance.caution = 0.9") == to_page.Typed(
        1, ("limits.por.translation = 0.3 m/s", "clearance.caution = 0.9"), refused=False
    )
    after = typist.session.step().frame
    assert before.por_limits[0] == pytest.approx(0.6096)
    assert after.por_limits[0] == 0.3
    assert [event.text for event in after.events][:2] == ["limits.por.translation = 0.3 m/s", "clearance.caution = 0.9"]
    changed = [one for one in typist.page.receive() if isinstance(one, to_page.Changed)]
    assert [one.work.caution for one in changed] == [0.9]
    assert typist.enter("changes").lines == ("limits.por.translation = 0.3 m/s", "clearance.caution = 0.9")
    assert "source: changed" in typist.enter("print clearance.caution").lines[0]


def test_restart_ends_the_changes_for_pages_too() -> None:
    typist = Typist(load_scenario(CONCEPT))
    typist.session.step()
    typist.enter("set clearance.caution = 0.9")
    typist.session.step()
    typist.page.receive()
    typist.page.send(from_page.Restart(99))
    assert typist.session.step().frame.changes == ()
    told = [one for one in typist.page.receive() if isinstance(one, to_page.Changed)]
    assert [one.work.caution for one in told] == [0.5]


def test_observer_prints_but_does_not_set() -> None:
    typist = Typist(load_scenario(CONCEPT))
    observer = typist.session.join()
    typist.session.step()
    assert not typist.enter("print clearance", observer).refused
    refused = typist.enter("set clearance.caution = 0.9", observer)
    assert refused.refused and "observes" in refused.lines[0]
    assert typist.session.step().frame.changes == ()


def test_page_that_comes_later_receives_the_changes() -> None:
    typist = Typist(load_scenario(CONCEPT))
    typist.session.step()
    typist.enter("set clearance.caution = 0.9")
    typist.session.step()
    late = typist.session.join()
    assert [one.work.caution for one in late.receive() if isinstance(one, to_page.Changed)] == [0.9]


def test_change_leaves_the_script_in_command() -> None:
    session = Direct(load_scenario("concept-1972-script"), demo=True)
    page = session.join()
    for _ in range(3):
        session.step()
    page.send(from_page.TypeLine(1, "set clearance.caution = 0.9"))
    step = session.step()
    assert step.autopilot == "script" and step.frame.by == "script" and len(step.frame.changes) == 1
    assert session.step().autopilot == "script"


@each("seed", seeds(1, 4))
def test_flight_with_forty_random_changes_replays_equal(seed: int, tmp_path: Path) -> None:
    rng = random.Random(seed)
    scenario = load_scenario(("concept-1972-script", "uncradle")[seed % 2])
    recording = DirectRecording(lambda of, own: opening(of, own, 0, real_time=True), 0)
    session = Direct(scenario, recording=recording, demo=True)
    page = session.join()
    entries, count = changing(scenario), 0
    ticks = number(1_200, 12_000)
    for tick in range(ticks):
        if tick % (ticks // 40) == 5:
            change = random_change(rng, entries, session.core._sim.prepare)
            (key, value), *_ = change.items()
            page.send(from_page.TypeLine(tick, f"set {key} = {value}"))
            (typed,) = [one for one in page.receive() if isinstance(one, to_page.Typed)]
            assert not typed.refused, typed.lines
            count += 1
        session.step()
    assert count == 40
    session.close()
    path = tmp_path / f"{seed}.mcap"
    path.write_bytes(recording.files[0].getvalue())
    verdict = verify(path)
    assert verdict.equal, verdict


def random_lines(rng: random.Random, scenario: Scenario) -> Iterator[str]:
    """Yield lines: with words, keys, values and addresses that exist, and with some that do not."""
    keys, words = list(key_list(scenario)), ["print", "set", "changes", "read", "write", "help", "PRINT", "", "quit"]
    values = ["1", "0.2 m/s", "5 deg", "[1, 2, 3]", "true", "''", "nan", "1e400", "= bay_aft + 1 ft", "{ a = 1 }", "-3"]
    while True:
        word, key, value = rng.choice(words), rng.choice(keys), rng.choice(values)
        yield rng.choice(
            [
                f"{word} {key}",
                f"set {key} = {value}",
                f"set {key[: rng.randrange(1, 30)]} = {value}",
                f"set {key} = {value}; {rng.choice(keys)} = {rng.choice(values)}",
                f"read {rng.choice(addresses())}",
                f"read {rng.randrange(1 << 20):o}",
                f"write {rng.choice(addresses())} = {rng.randrange(1 << 25):o}",
                f"{word} {''.join(rng.choices(string.printable, k=rng.randrange(40)))}",
                "".join(rng.choices(string.printable, k=rng.randrange(60))),
                f"set {key}",
                f"set = {value}",
            ]
        )


@pytest.mark.slow
def test_every_line_has_an_answer_and_no_step_fails() -> None:
    rng, typist = random.Random(1), Typist(load_scenario(CONCEPT))
    lines = random_lines(rng, typist.session.core.scenario)
    refused = 0
    for n in range(number(1_000, 10_000)):
        line = next(lines)
        typed = typist.enter(line)
        assert 0 < len(typed.lines) <= MOST_LINES + 1, line
        refused += typed.refused
        if n % 5 == 0:
            typist.session.step()
    assert 0 < refused < n


@each(
    "line",
    ["", "p", "set ", "print limits.por.", "set limits.", "read 1600", "foo bar", "print arm.joint[0].", "set x;"],
)
def test_completions_begin_with_what_was_typed(line: str) -> None:
    typist = Typist(load_scenario(CONCEPT))
    words = typist.complete(line)
    last = line.replace(";", " ").replace("=", " ").rpartition(" ")[2]
    assert len(words) <= MOST_WORDS and all(word.startswith(last) for word in words)
    assert words or line in ("foo bar", "set x;", "set limits.")


def test_completions_lead_to_every_key() -> None:
    typist = Typist(load_scenario(CONCEPT))
    for key in random.Random(0).sample(sorted(key_list(typist.session.core.scenario)), 40):
        typed = ""
        while typed != key:
            words = typist.complete(f"print {typed}")
            on = [word for word in words if key.startswith(word) and len(word) > len(typed)]
            typed = max(on, key=len) if on else key[: len(typed) + 1]
        assert typed == key


WRITTEN = {
    "16000": "CAMERA A X", "16032": "CAMERA I Z", "16033": "CAMERA A HEADING", "16054": "CAMERA I PITCH",
    "16122": "PAYLOAD X LOWER", "16104": "TRZL", "16170": "V1Z", "16203": "V1Y", "16306": "PDV", "16214": "PDT",
    "16216": "PDF", "16227": "PDA", "16231": "PDPCX",
}  # fmt: skip


@each("address", list(WRITTEN))
def test_word_of_table_iii_is_read_as_it_was_written(address: str) -> None:
    """A word a little off the present one is read back after the change, to the last bits of its scale."""
    sim = Simulation(load_scenario(CONCEPT))
    frame = sim.step()
    before = read_word(address, sim.in_force, frame)
    assert WRITTEN[address] in before
    word = int(before.split()[2], 8)
    wanted = (word + (2 if "RATE" in before else -4 if "B16" in before else 64)) % (1 << 24)
    try:
        changes = write_word(address, f"{wanted:o}", sim.in_force, frame)
        sim.prepare(changes)
    except InputError as error:
        assert any(words in str(error) for words in ("held", "berth", "seat")), error
        assert address == "16122"
        return
    frame = sim.step(Inputs(changes=changes))
    assert abs(int(read_word(address, sim.in_force, frame).split()[2], 8) - wanted) <= 1


def test_words_are_those_of_the_report() -> None:
    assert len(addresses()) == 27 + 18 + 6 + 6 + 5 + 8 + 2 + 2 + 2 + 2 + 2
    sim = Simulation(load_scenario(CONCEPT))
    for address in addresses():
        assert read_word(address, sim.in_force, None).startswith(f"{address} = ")
    for address, word in (("16121", "1"), ("1", "1"), ("16000", "9"), ("16000", ""), ("16077", "0")):
        with pytest.raises(InputError):
            write_word(address, word, sim.in_force, None)
