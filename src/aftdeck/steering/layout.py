"""Where the numbers stand in the arrays that the steering laws take.

The laws are called with few, packed arrays of float64, which is what a call from Python costs least. `rules`
holds what a mode has to keep to, `command` what the operator asks, `state` how the arm moves, `report` what
the step did. Vectors are in L, angles in radians.
"""

from __future__ import annotations

from aftdeck.kinematics.linkage import LINKS

# rules: the arm's links come first, so that every law of kinematics takes `rules` as its arm
DT = LINKS
"""Control period [s]."""
STRICT = DT + 1
"""1: the source's own behaviour, without the corrections."""
GUARDED = STRICT + 1
"""1: computed modes slow the arm before its stops and singularities; the source does not know them."""
AS_FLOWN = GUARDED + 1
"""1: a joint past its soft stop stops all joints in computed modes."""
SPEED, TURN = AS_FLOWN + 1, AS_FLOWN + 2
"""V_L [m/s] and omega_L [rad/s]: greatest speed and angular rate of the point of resolution."""
SPEED_UP, TURN_UP = TURN + 1, TURN + 2
"""Its greatest acceleration [m/s2] and angular acceleration [rad/s2]."""
RATE = TURN_UP + 1
"""(6,) joint rate limits in force [rad/s]."""
RATE_UP = RATE + 6
"""(6,) joint accelerations [rad/s2]: of mode 8 and MASTER, and of the slowing before a stop."""
MOST_UP = RATE_UP + 6
"""(6,) greatest joint accelerations [rad/s2], watched in modes 1 to 7."""
LOW, HIGH = MOST_UP + 6, MOST_UP + 12
"""(6,) stops in force [rad]: soft ones in computed modes, hard ones in mode 8 and DIRECT."""
MOUNT = HIGH + 6
"""(9,) rotation from orbiter to L, row by row: T_LB."""
HAND = MOUNT + 9
"""Cosine and sine of the end effector's roll against frame 7."""
HELD = HAND + 2
"""(9,) rotation from payload axes to frame 7, row by row: T_78."""
OFFSET = HELD + 9
"""(3,) from the tip to the point of resolution, in frame 7 [m]; zero where the tip is that point."""
NEAR, NEAR_TURN = OFFSET + 3, OFFSET + 4
"""End sphere of the automatic modes [m], [rad]."""
RULES = NEAR_TURN + 1

# command
LAW = 0
"""The report's mode number; `DIRECT_LAW`, `MASTER_LAW` and `NO_LAW` besides."""
STICKS = 1
"""(6,) sticks in [-1, 1]: about axes 1 to 3, then along them."""
JOINT = STICKS + 6
"""Selected joint, 0 to 5."""
DRIVE = JOINT + 1
"""SINGLE/DIRECT DRIVE in [-1, 1]."""
GO = DRIVE + 1
"""1 while an automatic mode is under way; 0 while it still brings the arm to rest, from where its plan begins."""
TARGET = GO + 1
"""(12,) final tip position, then rotation row by row."""
PLAN = TARGET + 12
"""(11,) what modes 1 and 3 work out once, where they set off; until then mode 1's final angles; see there."""
MASTER = PLAN + 11
"""(6,) the master arm's joint angles [rad]."""
KEPT = MASTER + 6
"""(6,) theta_0: where mode 8 holds the joints that are not selected [rad]."""
COMMAND = KEPT + 6

NO_LAW = 0.0
"""TEST: the arm comes to rest and stays."""
DIRECT_LAW = 9.0
"""DIRECT: one joint, no steering."""
MASTER_LAW = 10.0
"""MASTER: all joints follow the master arm's."""

# state
ANGLES = 0
"""(6,) joint angles, as measured [rad]."""
RATES = 6
"""(6,) joint rates commanded by the last step [rad/s]."""
TWIST = 12
"""(6,) twist commanded by the last step: angular, translational of the point that POINT names."""
POINT = 18
"""Whose velocity TWIST holds: 0 the tip's, 1 the payload's point of resolution."""
CLOCK = 19
"""Phase time TP of modes 1 and 3 [s]."""
PACE = 20
"""How much of the last step's demand was flown, 0 to 1: the speed of that clock."""
RISE = 21
"""How much higher the shoulder is than in `rules` (L1), as measured [m]: the telescope's extension."""
MEASURED = 22
"""(6,) joint rates, as measured [rad/s]."""
STATE = 28

# report
DEMAND = 0
"""(6,) twist that the mode asked for, before every limit."""
RATIO = 6
"""What RATLMT left of the commanded rates, 0 to 1."""
CAUSE = 7
"""Which limit RATLMT met: a number of `limiters.CAUSES`."""
CULPRIT = 8
"""The joint (or singularity) that it names; -1 none."""
POR_CAUSE = 9
"""Which limits AVCLMT met, as `limiters.avclmt` numbers them."""
DISTANCE, ANGLE = 10, 11
"""What is left to the target [m], [rad]."""
REMAINING = 12
"""Estimated time to the end of an automatic mode [s]: ETA - TP."""
ARRIVED = 13
"""1: an automatic mode has come to its end, or every joint to its master's angle."""
TURN_REMAINING = 14
"""Estimated time to the end of the rotation alone in modes 2 and 3 [s]: ETAP - TP."""
REPORT = 15
