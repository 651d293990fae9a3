"""Rate law for callers in Python: RMSRAT and RATLMT in one call with twelve input and six output numbers."""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.kinematics.jacobian import Twist, of_six
from aftdeck.kinematics.rates import FLOOR
from aftdeck.kinematics.solver import posture, rates_of
from aftdeck.law import law
from aftdeck.steering.layout import RATE


@law
def limited_rates(rules: Array, numbers: Array, out: Array) -> None:
    """Compute the joint rates for a tip twist (RMSRAT), and reduce them by one ratio to the rate limits (RATLMT).

    Args:
        rules: rules of a mode, as `steering.rules` returns them.
        numbers: (12,) six joint angles [rad], then the tip's twist in L [rad/s], [m/s].
        out: (6,) receives the joint rates [rad/s].
    """
    a = posture(rules, of_six(numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5]))
    twist = Twist(numbers[6], numbers[7], numbers[8], numbers[9], numbers[10], numbers[11])
    rates = rates_of(rules, a, twist, FLOOR)
    ratio = 1.0
    for i in range(6):
        ratio = min(ratio, rules[RATE + i] / max(abs(rates[i]), rules[RATE + i]))
    for i in range(6):
        out[i] = ratio * rates[i]
