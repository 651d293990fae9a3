"""Indices of the values in the arrays that the steering laws take.

Each law takes a few arrays of float64 that hold many values, because Python calls a compiled law fastest in this form.
`rules` holds the limits and constants of a mode, `command` the operator's command, `state` the arm's motion, and
`report` the results of the step. Vectors are in L, angles in radians. Each list of joints has room for `MOST_JOINTS`,
(8,); an arm with fewer joints uses the first ones.
"""

from __future__ import annotations

from aftdeck.kinematics.linkage import LINKS
from aftdeck.tuples import MOST_JOINTS

# rules: the arm's links come first, and its packed chain, if it has one, is the end, so that the laws of kinematics
# accept `rules` in place of the links
JOINTS = LINKS
"""Number of the arm's joints."""
DT = JOINTS + 1
"""Control period [s]."""
STRICT = DT + 1
"""1 if the steering laws run as published, without the corrections."""
GUARDED = STRICT + 1
"""1 if computed modes slow the arm before its singularities and, unless AS_FLOWN is 1, before its stops.

The source does not do this.
"""
AS_FLOWN = GUARDED + 1
"""1 if in computed modes no joint moves while one joint is past its soft stop."""
TOGETHER = AS_FLOWN + 1
"""1 if before a stop of one joint no joint brakes beyond its acceleration limit, as in modes 4 to 7.

In modes 1 to 3 the arm stays on its path, and a path that only touches a stop does not end there.
"""
SPEED, TURN = TOGETHER + 1, TOGETHER + 2
"""V_L [m/s] and omega_L [rad/s]: maximum speed and angular rate of the point of resolution."""
SPEED_UP, TURN_UP = TURN + 1, TURN + 2
"""Maximum acceleration [m/s2] and angular acceleration [rad/s2] of the point of resolution."""
RATE = TURN_UP + 1
"""(8,) joint rate limits in force [rad/s]."""
RATE_UP = RATE + MOST_JOINTS
"""(8,) joint accelerations in mode 8 and MASTER, and decelerations before a stop [rad/s2]."""
MOST_UP = RATE_UP + MOST_JOINTS
"""(8,) joint acceleration limits of modes 1 to 7 [rad/s2]; infinite for a joint that the arm does not have."""
LOW, HIGH = MOST_UP + MOST_JOINTS, MOST_UP + 2 * MOST_JOINTS
"""(8,) stops in force [rad]: hard stops in mode 8 and DIRECT, soft stops in all other modes."""
MOUNT = HIGH + MOST_JOINTS
"""(9,) rotation from orbiter to L, row by row: T_LB."""
HAND_COSINE, HAND_SINE = MOUNT + 9, MOUNT + 10
"""Cosine and sine of the end effector's roll relative to frame 7."""
HELD = HAND_SINE + 1
"""(9,) rotation from payload axes to frame 7, row by row: T_78."""
OFFSET = HELD + 9
"""(3,) vector from the tip to the point of resolution, in frame 7 [m]; zero if the tip is the point of resolution."""
NEAR, NEAR_TURN = OFFSET + 3, OFFSET + 4
"""Radius of the end sphere of the automatic modes [m], [rad]."""
RULES = NEAR_TURN + 1

# command
LAW = 0
"""The report's mode number, or `DIRECT_LAW`, `MASTER_LAW` or `NO_LAW`."""
STICKS = 1
"""(6,) sticks in [-1, 1]: rotation about axes 1 to 3, then translation along axes 1 to 3."""
JOINT = STICKS + 6
"""Selected joint, from 0."""
DRIVE = JOINT + 1
"""SINGLE/DIRECT DRIVE in [-1, 1]."""
MOTION_ACTIVE = DRIVE + 1
"""1 while an automatic motion is in progress; 0 before it, while the arm comes to rest."""
TARGET = MOTION_ACTIVE + 1
"""(12,) final tip position, then rotation row by row."""
PLAN = TARGET + 12
"""(13,) plan of mode 1 or 3, computed once at the start of the motion; the modules of the two modes define the values.

In mode 1, until the plan is computed, its first elements contain the joints' final angles [rad].
"""
PLANNED_END = PLAN + MOST_JOINTS
"""The report's ETA in modes 1 and 3: phase time at which the planned motion ends [s]."""
MASTER = PLANNED_END + 5
"""(8,) the master arm's joint angles [rad]."""
KEPT = MASTER + MOST_JOINTS
"""(8,) theta_0: angles at which mode 8 holds the joints that are not selected [rad]."""
COMMAND = KEPT + MOST_JOINTS

NO_LAW = 0.0
"""Law of TEST: the arm comes to rest and stays at rest."""
DIRECT_LAW = 9.0
"""Law of DIRECT: one joint moves, without steering."""
MASTER_LAW = 10.0
"""Law of MASTER: all joints follow the master arm's joints."""

# state
ANGLES = 0
"""(8,) joint angles, as measured [rad]."""
RATES = ANGLES + MOST_JOINTS
"""(8,) joint rates commanded by the last step [rad/s]."""
TWIST = RATES + MOST_JOINTS
"""(6,) twist commanded by the last step: angular velocity, then velocity of the point that POINT selects."""
POINT = TWIST + 6
"""Point whose velocity is in TWIST: 0 the tip, 1 the payload's point of resolution."""
CLOCK = POINT + 1
"""Phase time TP of modes 1 and 3 [s]."""
CLOCK_RATE = CLOCK + 1
"""Share of the last step's demand that was commanded, 0 to 1.

In modes 2 to 7, CLOCK advances by this share of the control period; under `strict` the share is set to 1. For mode 1,
see `position.clock_after`.
"""
SHOULDER_OFFSET = CLOCK_RATE + 1
"""Measured height of the shoulder minus its height in `rules` (L1) [m]: the telescope's extension."""
MEASURED = SHOULDER_OFFSET + 1
"""(8,) joint rates, as measured [rad/s]."""
AIMS = MEASURED + MOST_JOINTS
"""(8,) angles to which servos turn the joints; the measured angle of a joint that no servo turns to an angle [rad].

Mode 8 and MASTER steer from these angles. Steered from the angles that the encoders of a flexible arm measure, a joint
that arrives would reverse its rate with every swing of the arm, and keep it swinging.
"""
STATE = AIMS + MOST_JOINTS

# report
DEMAND = 0
"""(6,) twist that the mode demanded, before any limit."""
RATIO = 6
"""Share of the joint rates that RATLMT allowed, 0 to 1."""
CAUSE = 7
"""Limit that acted in RATLMT: an index in `limiters.CAUSES`."""
LIMITING_JOINT = 8
"""Joint or singularity of the limit in CAUSE; -1 if no limit acted."""
POR_CAUSE = 9
"""Limits that acted in AVCLMT, as `limiters.avclmt` numbers them."""
DISTANCE, ANGLE = 10, 11
"""Remaining distance [m] and angle [rad] to the target."""
REMAINING = 12
"""Estimated time to the end of an automatic mode [s]: ETA - TP."""
ARRIVED = 13
"""1 if an automatic mode has ended, or if every joint has reached its angle in MASTER."""
TURN_REMAINING = 14
"""Estimated time to the end of the rotation alone in modes 2 and 3 [s]: ETAP - TP."""
BEFORE = 15
"""(8,) joint rates that the step before commanded [rad/s]."""
REPORT = BEFORE + MOST_JOINTS
