"""Linear model of a controlled arm in discrete time: its poles, its frequency response, and its answers."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from aftdeck.analysis.coordinates import finite
from aftdeck.arrays import Array
from aftdeck.errors import InputError

STAYS, GONE = 1e-7, 1e-12
"""Distance from 1 within which a pole z counts as 1, and least size of a pole [1]: rounding of A (derived)."""

Complex = NDArray[np.complex128]


class Poles(NamedTuple):
    """Poles of a linear model, slowest first.

    Attributes:
        z: (n,) eigenvalues of A: factors by which the motions change in one control period.
        s: (n,) log(z) / period: the same in continuous time [1/s]; 0 for a motion that neither grows nor decays.
        frequencies: (n,) natural frequencies: size of s, divided by 2 pi [Hz].
        damping: (n,) damping ratios: -Re(s), divided by the size of s [1]; NaN where s is 0.
    """

    z: Complex
    s: Complex
    frequencies: Array
    damping: Array


class Bode(NamedTuple):
    """Frequency response from one input to one output.

    Attributes:
        frequencies: (k,) frequencies [Hz].
        gain: (k,) amplitude of the output divided by that of the input, in their units.
        phase: (k,) phase of the output after that of the input [rad], without jumps.
    """

    frequencies: Array
    gain: Array
    phase: Array


@dataclass(frozen=True, eq=False)
class LinearModel:
    """Linear model of a controlled arm at rest in a pose, in discrete time.

    x[k + 1] = A x[k] + B u[k] and y[k] = C x[k] + D u[k], with all values as differences from the pose. Sample k is the
    time k * `period`. The inputs u[k] act for the whole period that begins there, as the steering's commands do.
    All units are SI units: rad, m, rad/s, m/s, N, N m. Arrays are read-only.

    Attributes:
        A: (n, n) states to states.
        B: (n, m) inputs to states.
        C: (p, n) states to outputs.
        D: (p, m) inputs to outputs.
        states: (n,) names of the states.
        inputs: (m,) names of the inputs.
        outputs: (p,) names of the outputs.
        period: control period [s].
    """

    A: Array
    B: Array
    C: Array
    D: Array
    states: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    period: float

    def poles(self) -> Poles:
        """Return the poles.

        A motion that has decayed within a period has a z near 0, and its s tells no more than that. A vibration faster
        than half the rate of control appears as a slower one; a model of a shorter period shows which these are.
        """
        z: Complex = np.linalg.eigvals(self.A).astype(np.complex128)
        z[np.abs(z - 1.0) < STAYS] = 1.0
        z[np.abs(z) < GONE] = GONE
        s: Complex = np.asarray(np.log(z) / self.period, np.complex128)
        order = np.argsort(np.abs(s), kind="stable")
        z, s = z[order], s[order]
        size = np.abs(s)
        damping = np.divide(-s.real, size, out=np.full(len(s), np.nan), where=size > 0.0)
        return Poles(z, s, size / (2.0 * math.pi), damping)

    def bode(self, given: str, measured: str, frequencies: ArrayLike) -> Bode:
        """Return the frequency response from an input to an output: C (exp(i w period) I - A)^-1 B + D.

        Args:
            given: name of the input, such as ``rate.shoulder_pitch``.
            measured: name of the output.
            frequencies: (k,) frequencies in ascending order [Hz], above 0 and at most half the rate of control.

        Raises:
            InputError: there is no such input or output, or a frequency is out of range.
        """
        column, row = _place(given, self.inputs, "input"), _place(measured, self.outputs, "output")
        found, most = finite(frequencies, "frequencies"), 0.5 / self.period
        if found.ndim != 1 or not (np.diff(found) > 0.0).all():
            raise InputError(f"frequencies: expected a row (k,) of ascending numbers, got the shape {found.shape}")
        if len(found) and not (found[0] > 0.0 and found[-1] <= most * (1.0 + 1e-12)):
            raise InputError(
                f"frequencies: expected more than 0 and at most {most:g} Hz, half the rate of control, got "
                f"{found[0]:g} to {found[-1]:g} Hz"
            )
        turns = np.exp(2j * math.pi * self.period * found)
        resolvents = turns[:, None, None] * np.eye(len(self.A)) - self.A
        inner = np.linalg.solve(resolvents, np.broadcast_to(self.B[:, [column]], (len(found), len(self.A), 1)))
        answer = inner[..., 0] @ self.C[row] + self.D[row, column]
        return Bode(found, np.abs(answer), np.unwrap(np.angle(answer)))

    def response(self, inputs: ArrayLike, state: ArrayLike | None = None) -> Array:
        """Return the outputs (k, p) for inputs (k, m), from a state (n,) or, without one, from rest in the pose.

        Raises:
            InputError: the inputs or the state have another shape, or are not finite.
        """
        u = finite(inputs, "inputs")
        x = np.zeros(len(self.A)) if state is None else finite(state, "state")
        if u.ndim != 2 or u.shape[1] != len(self.inputs):  # noqa: PLR2004  (rows and columns)
            raise InputError(f"inputs: expected shape (k, {len(self.inputs)}), got {u.shape}")
        if x.shape != (len(self.A),):
            raise InputError(f"state: expected shape ({len(self.A)},), got {x.shape}")
        y = np.empty((len(u), len(self.outputs)))
        for k, row in enumerate(u):
            y[k] = self.C @ x + self.D @ row
            x = self.A @ x + self.B @ row
        return y


def _place(name: str, names: tuple[str, ...], what: str) -> int:
    if name not in names:
        raise InputError(f"no {what} {name!r}; the {what}s are {', '.join(names)}")
    return names.index(name)
