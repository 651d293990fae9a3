"""Rate law for callers in Python: RMSRAT and RATLMT in one call with arrays."""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.kinematics.jacobian import of_array
from aftdeck.kinematics.rates import FLOOR
from aftdeck.kinematics.solver import posture, rates_of
from aftdeck.law import law
from aftdeck.steering.layout import RATE
from aftdeck.steering.views import twist_at


@law
def limited_rates(rules: Array, numbers: Array, out: Array) -> None:
    """Compute the joint rates for a tip twist (RMSRAT), and reduce them by one ratio to the rate limits (RATLMT).

    Args:
        rules: rules of a mode, as `steering.rules` returns them.
        numbers: (n + 6,) joint angles [rad], then the tip's twist in L [rad/s], [m/s].
        out: (n,) receives the joint rates [rad/s].
    """
    n = out.shape[0]
    a = posture(rules, of_array(numbers[:n]))
    twist = twist_at(numbers, n)
    rates = rates_of(rules, a, twist, FLOOR)
    ratio = 1.0
    for i in range(n):
        ratio = min(ratio, rules[RATE + i] / max(abs(rates[i]), rules[RATE + i]))
    for i in range(n):
        out[i] = ratio * rates[i]
