"""Policies: inference, and policy files with their errors. The networks are made by hand."""

from __future__ import annotations

import contextlib
import random
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from aftdeck.errors import InputError
from aftdeck.gym.policy import SIZES, Activation, Layer, Policy
from aftdeck.gym.policy_file import load_policy, save_policy
from tests.each import each, seeds

REACH = "aftdeck/Reach-v0"


def made(environment: str = REACH, activation: Activation = "tanh", inputs: int = 24, **changes: Any) -> Policy:
    """Return a policy with one hidden layer of 5 and random weights."""
    random = np.random.Generator(np.random.PCG64(1))
    outputs = SIZES[environment].actions
    layers = (
        Layer(random.standard_normal((5, inputs)), random.standard_normal(5)),
        Layer(0.1 * random.standard_normal((outputs, 5)), np.zeros(outputs)),
    )
    fields = {"mean": np.full(inputs, 0.5), "std": np.full(inputs, 2.0), "layers": layers, "keywords": {}}
    return Policy(environment, activation, **{**fields, **changes})


def test_policy_gives_the_numbers_of_a_network_computed_by_hand() -> None:
    hidden = np.zeros((2, 24))
    hidden[0, 0], hidden[1, 1] = 1.0, -1.0
    last = np.zeros((6, 2))
    last[0, 0], last[1, 1], last[2, 0] = 0.5, 1.0, 100.0
    layers = (Layer(hidden, np.array([0.0, 1.0])), Layer(last, np.array([0.1, 0.0, 0.0, 0.0, 0.0, -3.0])))
    observation = np.zeros(24, dtype=np.float32)
    observation[:2] = 3.0, 1.0
    # (observation - 1) / 2 begins with 1, 0: the hidden layer gets 1 and 1
    policy = Policy(REACH, "relu", np.ones(24), np.full(24, 2.0), layers)
    assert policy.act(observation).tolist() == pytest.approx([0.6, 1.0, 1.0, 0.0, 0.0, -1.0])
    tanh = float(np.tanh(1.0))
    policy = Policy(REACH, "tanh", np.ones(24), np.full(24, 2.0), layers)
    assert policy.act(observation)[:2].tolist() == pytest.approx([0.1 + 0.5 * tanh, tanh])


def test_policy_acts_on_rows_as_on_single_observations() -> None:
    policy, seen = made(), np.linspace(-1.0, 1.0, 48, dtype=np.float32).reshape(2, 24)
    assert policy.act(seen) == pytest.approx(np.stack([policy.act(row) for row in seen]), abs=1e-7)


@pytest.mark.parametrize(
    ("environment", "inputs"), [(name, n) for name, size in SIZES.items() for n in size.observations]
)
def test_saved_policy_acts_as_before(environment: str, inputs: int, tmp_path: Path) -> None:
    policy, path = made(environment, inputs=inputs, keywords={"plant": "rigid"}), tmp_path / "policy"
    save_policy(policy, path)
    loaded, seen = load_policy(path), np.ones(inputs, dtype=np.float32)
    assert loaded.act(seen) == pytest.approx(policy.act(seen), abs=1e-6)
    assert (loaded.environment, loaded.activation, dict(loaded.keywords)) == (environment, "tanh", {"plant": "rigid"})


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        pytest.param({"mean": np.zeros(3)}, r"mean has shape \(3,\), expected \(24,\)", id="mean"),
        pytest.param({"std": np.zeros(24)}, "std has the value 0, expected numbers above 0", id="std"),
        pytest.param({"layers": ()}, "got 0 layers, expected 1 to 32", id="no layers"),
        pytest.param(
            {"layers": (Layer(np.zeros((6, 5)), np.zeros(6)),)}, r"weight_0 has shape \(6, 5\)", id="first layer"
        ),
        pytest.param(
            {"layers": (Layer(np.zeros((4, 24)), np.zeros(4)),)},
            "the last layer gives 4 numbers, expected 6",
            id="last layer",
        ),
        pytest.param({"keywords": {"colour": "red"}}, "keyword: got 'colour', expected 'plant'", id="keyword"),
        pytest.param({"activation": "sine"}, "activation: got 'sine', expected 'tanh', 'relu'", id="activation"),
        pytest.param({"environment": "CartPole"}, "environment: got 'CartPole', expected", id="environment"),
    ],
)
def test_policy_that_does_not_fit_is_rejected(changes: dict[str, Any], message: str, tmp_path: Path) -> None:
    policy = made()
    fields = {name: getattr(policy, name) for name in ("environment", "activation", "mean", "std", "layers")}
    with pytest.raises(InputError, match=f"policy.npz: {message}"):
        save_policy(Policy(**{**fields, **changes}), tmp_path / "policy.npz")
    assert not list(tmp_path.iterdir())


def test_policy_of_a_mission_needs_the_observations_of_some_arm(tmp_path: Path) -> None:
    name, sizes = "aftdeck/Capture-v0", SIZES["aftdeck/Capture-v0"].observations
    for inputs in range(min(sizes) - 1, max(sizes) + 2):
        allowed = contextlib.nullcontext() if inputs in sizes else pytest.raises(InputError, match="mean has shape")
        with allowed:
            save_policy(made(name, inputs=inputs), tmp_path / "policy.npz")
    with pytest.raises(InputError, match="std has shape"):
        save_policy(made(name, inputs=sizes[0], std=np.ones(sizes[1])), tmp_path / "policy.npz")


def written(path: Path, change: Callable[[dict[str, Any]], object]) -> Path:
    """Write a policy file whose arrays `change` has changed."""
    save_policy(made(), path)
    with np.load(path) as file:
        arrays: dict[str, Any] = {name: file[name] for name in file.files}
    change(arrays)
    np.savez(path, **arrays)
    return path


@pytest.mark.parametrize(
    ("change", "message"),
    [
        pytest.param(lambda a: a.pop("version"), "version is missing, expected 1", id="no version"),
        pytest.param(lambda a: a.update(version=np.array(2)), "version is 2, expected 1", id="version"),
        pytest.param(lambda a: a.pop("mean"), "mean is missing, expected finite", id="no mean"),
        pytest.param(lambda a: a.pop("bias_1"), "bias_1 is missing", id="no bias"),
        pytest.param(lambda a: a.update(std=np.full(24, np.nan)), "std is an array of float64", id="not a number"),
        pytest.param(lambda a: a.update(std=np.ones(24, dtype=int)), "std is an array of int64", id="integers"),
        pytest.param(lambda a: a.update(activation=np.array(3)), "activation is an array of int64", id="no text"),
        pytest.param(lambda a: a.update(keywords=np.array("[1]")), "keywords is '\\[1\\]', expected a JSON", id="JSON"),
        pytest.param(lambda a: a.update(extra=np.ones(1)), "unknown arrays \\['extra'\\]", id="unknown array"),
    ],
)
def test_file_with_other_contents_is_rejected(
    change: Callable[[dict[str, Any]], object], message: str, tmp_path: Path
) -> None:
    with pytest.raises(InputError, match=f"policy.npz: .*{message}"):
        load_policy(written(tmp_path / "policy.npz", change))


def test_weights_whose_sums_are_infinite_give_no_action() -> None:
    great = Layer(np.full((64, 24), 1e300), np.zeros(64)), Layer(np.full((6, 64), 1e300), np.zeros(6))
    assert made(activation="relu", layers=great).act(np.ones(24)).tolist() == [1.0] * 6, "infinite: full deflection"
    opposed = np.tile([1e300, -1e300], (6, 32))
    with pytest.raises(InputError, match="not a number"):
        made(activation="relu", layers=(great[0], Layer(opposed, np.zeros(6)))).act(np.ones(24))


@each("seed", seeds(600, 20_000))
def test_a_damaged_policy_file_is_rejected_or_gives_a_policy(seed: int, tmp_path: Path) -> None:
    """Bits of the file are changed, or those of an array before it is packed, which no checksum of the file shows."""
    rng, path = random.Random(seed), tmp_path / "policy.npz"
    save_policy(made(), path)
    if seed % 2:
        with zipfile.ZipFile(path) as archive:
            parts = {name: archive.read(name) for name in archive.namelist()}
        name = rng.choice(sorted(parts))
        parts[name] = flipped(parts[name], rng, 128 if rng.random() < 0.7 else len(parts[name]))
        with zipfile.ZipFile(path, "w") as archive:
            for name, data in parts.items():
                archive.writestr(name, data)
    else:
        path.write_bytes(flipped(path.read_bytes(), rng, path.stat().st_size))
    with contextlib.suppress(InputError):
        load_policy(path).act(np.ones(24))


def flipped(data: bytes, rng: random.Random, within: int) -> bytes:
    """Return data with up to three bits changed among its first `within` bytes."""
    changed = bytearray(data)
    for _ in range(rng.randint(1, 3)):
        changed[rng.randrange(min(within, len(data)))] ^= 1 << rng.randrange(8)
    return bytes(changed)


class Trap:
    """Object that writes a file when it is unpickled."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def __reduce__(self) -> tuple[Any, ...]:
        return Path.write_text, (self.path, "")


def test_pickled_objects_in_a_file_are_never_loaded(tmp_path: Path) -> None:
    trap = np.array([Trap(tmp_path / "ran")], dtype=object)
    path = written(tmp_path / "policy.npz", lambda a: a.update(mean=trap))
    with pytest.raises(InputError, match="is not a policy file, or is damaged: Object arrays cannot be loaded"):
        load_policy(path)
    assert not (tmp_path / "ran").exists()


def test_other_files_are_rejected(tmp_path: Path) -> None:
    (text := tmp_path / "text.npz").write_text("not a policy")
    with pytest.raises(InputError, match=r"text\.npz: is not an \.npz file"):
        load_policy(text)
    with pytest.raises(InputError, match=r"none\.npz: cannot be read: No such file"):
        load_policy(tmp_path / "none.npz")
    cut = written(tmp_path / "cut.npz", lambda _: None)
    with zipfile.ZipFile(cut, "w") as archive:
        archive.writestr("version.npy", b"\x93NUMPY")
    with pytest.raises(InputError, match=r"cut\.npz: is not a policy file"):
        load_policy(cut)
