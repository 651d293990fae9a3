"""Messages whose attitudes are converted when they are read, beside those that are converted at once."""

from __future__ import annotations

import pickle

import msgspec
import pytest

from aftdeck.recording.codec import LIMIT, decode, encode
from aftdeck.recording.on_demand import decode as decode_on_demand
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import CHANNELS, FrameRecord, Opening
from aftdeck.recording.run import record
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation


@pytest.fixture(scope="module", params=["kinematic", "rigid"])
def recording(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Recording:
    """Recording of a few steps with a held payload, whose inputs key in a target."""
    scenario = load_scenario("loaded", {("plant",): request.param})
    path = tmp_path_factory.mktemp("run") / "run.mcap"

    def inputs(sim: Simulation) -> Inputs | None:
        return None if sim.frame is not None and sim.frame.tick == 20 else Inputs(translation=(0.5, 0.0, 0.0))

    record(scenario, path, inputs=inputs)
    return Recording(path)


def test_messages_have_the_values_of_those_converted_at_once(recording: Recording) -> None:
    frames = 0
    for at_once, on_demand in zip(recording.messages(), Recording(recording.path).messages_on_demand(), strict=True):
        assert isinstance(on_demand, type(at_once))
        if isinstance(at_once, FrameRecord):
            assert isinstance(on_demand, FrameRecord)
            assert on_demand.orientation == at_once.orientation
            assert on_demand.payload == at_once.payload and at_once.payload is not None
            assert on_demand.views == at_once.views
            frames += 1
        sent = pickle.loads(pickle.dumps(on_demand))
        assert type(sent) is type(at_once) and sent == at_once
    assert frames == 20


def test_every_kind_of_message_can_be_decoded(recording: Recording) -> None:
    seen = set()
    for entry in recording.entries():
        if entry.message is not None and not isinstance(entry.message, Opening):
            kind, _ = CHANNELS[entry.channel.topic]
            assert pickle.loads(pickle.dumps(decode_on_demand(kind, entry.data))) == decode(kind, entry.data)
            seen.add(kind)
    assert FrameRecord in seen


@pytest.mark.parametrize(
    "change",
    [{"tick": LIMIT}, {"orientation": [0.0, 0.0, 0.0, 0.0]}, {"orientation": [1.0]}, {"views": [{"pan": 0.0}]}],
)
def test_a_message_that_cannot_be_decoded_at_once_is_rejected(recording: Recording, change: dict[str, object]) -> None:
    frame = next(message for message in recording.messages() if isinstance(message, FrameRecord))
    data = msgspec.json.encode(msgspec.json.decode(encode(frame)) | change)
    for read in (decode, decode_on_demand):
        with pytest.raises(msgspec.MsgspecError):
            read(FrameRecord, data)
