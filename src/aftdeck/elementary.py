"""Elementary functions for laws and files: sine and cosine, arc tangent, arc sine and cosine, rounding.

Processors, C libraries and versions of Python differ in the last digits of these functions. The functions below use
only additions, multiplications, divisions and square roots, which IEEE 754 defines to the last bit. Therefore they give
the same result everywhere, compiled or as plain Python. The errors stated are those against the exact function.
"""

from __future__ import annotations

import math

from aftdeck.law import elementary_law

_TWO_BY_PI = 0.6366197723675814
_ROUNDER = 6755399441055744.0
"""1.5 * 2**52. Near this value, every float is a whole number; near twice this value, every float is even."""
_HALF_PI_1 = 1.5707963267923333
"""First 36 bits of pi/2. Its products with whole numbers up to 2**17 are exact."""
_HALF_PI_2 = 2.563344151594519e-12
"""Remainder of pi/2 after `_HALF_PI_1`."""
_TAN_EIGHTH_PI = 0.41421356237309503


@elementary_law
def nearest(value: float) -> float:
    """Return the nearest whole number, for |value| < 2**51, without a library call or a branch.

    If two whole numbers are equally near, the even one is returned.
    """
    return (value + _ROUNDER) - _ROUNDER


@elementary_law
def _oddness(value: float) -> float:
    """Return the sine of a whole number of quarter turns: 0, 1 or -1, without a branch.

    The result is the value minus the nearest even number; of two equally near numbers, the multiple of 4 is used.
    """
    return value - ((value + 2.0 * _ROUNDER) - 2.0 * _ROUNDER)


@elementary_law
def reduced(angle: float) -> tuple[float, float]:
    """Subtract the nearest whole number of quarter turns from an angle [rad]; return the rest [rad] and that number.

    Method of Cody and Waite: pi/2 is subtracted in two parts.
    """
    quarters = nearest(angle * _TWO_BY_PI)
    return (angle - quarters * _HALF_PI_1) - quarters * _HALF_PI_2, quarters


@elementary_law
def sincos_near_zero(x: float) -> tuple[float, float]:
    """Return sine and cosine of an angle [rad] of at most an eighth of a turn.

    The polynomials are the minimax polynomials of the standard C library. Their terms are grouped in pairs, which the
    processor can compute at the same time.
    """
    z = x * x
    w = z * z
    s = x + (x * z) * (
        (-1.66666666666666324348e-01 + z * 8.33333333332248946124e-03)
        + w
        * (
            (-1.98412698298579493134e-04 + z * 2.75573137070700676789e-06)
            + w * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)
        )
    )
    c = (1.0 - 0.5 * z) + w * (
        (4.16666666666666019037e-02 + z * -1.38888888888741095749e-03)
        + w
        * (
            (2.48015872894767294178e-05 + z * -2.75573143513906633035e-07)
            + w * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11)
        )
    )
    return s, c


@elementary_law
def turned_on(s: float, c: float, quarters: float) -> tuple[float, float]:
    """Return sine and cosine of an angle plus whole quarter turns, from the angle's sine `s` and cosine `c`.

    Both sums are exact, because each has a term that is 0.
    """
    sq, cq = _oddness(quarters), _oddness(quarters + 1.0)
    return s * cq + c * sq, c * cq - s * sq


@elementary_law
def sincos(angle: float) -> tuple[float, float]:
    """Return sine and cosine of an angle [rad] without a branch or a library call, so that loops vectorise.

    Error below 2e-16 for |angle| < 1e5.
    """
    x, quarters = reduced(angle)
    s, c = sincos_near_zero(x)
    return turned_on(s, c, quarters)


@elementary_law
def ceiling(value: float) -> float:
    """Return the smallest whole number that is not less than `value`, for |value| < 2**51."""
    whole = nearest(value)
    return whole + 1.0 if whole < value else whole


@elementary_law
def atan2(y: float, x: float) -> float:
    """Return the angle [rad] of the point (x, y), in [-pi, pi], with the signs of `math.atan2` at zeros.

    The angle is a multiple of pi/4 plus a rest of at most pi/8, whose tangent is `ratio`. The polynomial for the rest
    is the minimax polynomial of the standard C library. Error below 3e-16, and below 3 units in the last place.
    """
    across, along = abs(y), abs(x)
    low, high = min(across, along), max(across, along)
    ratio, eighths = low / high if high > 0.0 else 0.0, 0.0
    if ratio > _TAN_EIGHTH_PI:
        ratio, eighths = (low - high) / (low + high), 1.0
    if across > along:
        ratio, eighths = -ratio, 2.0 - eighths
    if math.copysign(1.0, x) < 0.0:
        ratio, eighths = -ratio, 4.0 - eighths
    z = ratio * ratio
    w = z * z
    odd = 3.33333333333329318027e-01 + w * (
        1.42857142725034663711e-01
        + w
        * (
            9.09088713343650656196e-02
            + w * (6.66107313738753120669e-02 + w * (4.97687799461593236017e-02 + w * 1.62858201153657823623e-02))
        )
    )
    even = -1.99999999998764832476e-01 + w * (
        -1.11111104054623557880e-01
        + w * (-7.69187620504482999495e-02 + w * (-5.83357013379057348645e-02 + w * -3.65315727442169155270e-02))
    )
    rest = ratio - ratio * (z * odd + w * even)
    return math.copysign(eighths * (0.5 * _HALF_PI_1) + (eighths * (0.5 * _HALF_PI_2) + rest), y)


@elementary_law
def acos(cosine: float) -> float:
    """Return the arc cosine [rad], in [0, pi], of a number in [-1, 1]; error below 4e-16."""
    return atan2(math.sqrt((1.0 - cosine) * (1.0 + cosine)), cosine)


@elementary_law
def asin(sine: float) -> float:
    """Return the arc sine [rad], in [-pi/2, pi/2], of a number in [-1, 1]; error below 3e-16."""
    return atan2(sine, math.sqrt((1.0 - sine) * (1.0 + sine)))
