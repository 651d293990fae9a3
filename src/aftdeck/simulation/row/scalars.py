"""Indices of single values in the flat arrays: those of a step, which are in the row, and those of a run."""

from __future__ import annotations

# of a step, before it
TELESCOPE = 0
"""Commanded drive of the telescope, in [-1, 1]; replaced by the drive that berths and switches allow."""
CLOSES = 1
"""Commanded drive of the prong: 1 closes it, -1 opens it, 0 stops it."""
HEIGHT = 2
"""Height of the shoulder that the steering's rules assume [m]."""
STAND, STAND_VELOCITY = 3, 4
"""Height of the shoulder above L's origin [m], and its rate [m/s]; replaced by those after the step."""
PRONG_AT, PRONG_VELOCITY = 5, 6
"""y2 of the prong's inner face [m], and its rate [m/s]; replaced by those after the step."""
HELD = 7
"""Index of the payload in the grasp; -1 if the grasp is empty."""
FIXED = 8
"""1 if the held payload is fixed to a berth, so that the arm cannot move."""
AT_PORT = 9
"""1 if this berth is a port."""
RELEASED = 10
"""1 more than the number of the berth that has just released the held payload, numbered as in `World.berths`; 0 for
none, -1 for one that does not accept it."""
LOCKED = 11
"""1 if BRAKES or SAFING stops the joints."""
AUTOMATIC = 12
"""1 in a mode that flies to a target."""
IN_PROGRESS = 13
"""1 while an automatic motion is in progress or begins."""
SLIDES = 14
"""1 if the held payload slides along walls: in modes 1 to 7, if contacts inhibit motion."""
INHIBITED, STOPPED = 15, 16
"""1 if a contact of the last step inhibits the arm; 1 if one inhibits the prong."""
ORBITS = 17
"""1 if the orbiter can translate."""
WORKS = 18
"""1 if latches move, or if a switch begins a motion of latches or of the end effector; 2 if only the end effector
goes on moving (`capture.effector`)."""
TASK = 19
"""The report's mode, 1 to 4; replaced by the mode after the step, if nothing is captured or fixed in it."""
NEAREST = 20
"""Pair with the minimum clearance; -1 if none counts. Replaced by that after the step."""
ALIGNED = 21
"""Payload with which the end effector is aligned for capture; -1 for none. Replaced by that after the step."""
LEAST_SAME, GREATEST_SAME = 22, 23
"""Minimum clearances from the first to below the second do not change the alarm level [m]."""
FLOWN = 24
"""Number of the law for which stick directions are evaluated: of the present mode if it is manual, else of ORB UNL."""
BY_JOINT = 25
"""1 in a mode that moves single joints."""
SNARE_MODE, CONTR = 26, 27
"""Positions of END EFFECTOR MODE and MAN CONTR (`capture.snare`)."""
ADVISED = 28
"""1 if a motion is known that leads out of the contacts (`WorksiteState.advice`)."""
COMMAND_X = 29
"""First of three commands of the orbiter's translation along its axes, in [-1, 1]."""
LOGGED = 32
"""1 if a contact is in the log that has not ended."""
GIVEN = 33
"""Number of the values above, which are set before a step."""

# of a step, after it
HALT = 33
"""What blocked the commanded motion: 0 nothing, 1 a berth, 2 a switch, 3 a contact."""
BEGAN = 34
"""1 if an automatic motion began in this step."""
TOUCHING, CHANGED = 35, 36
"""1 if a pair is in contact; 1 if a contact began, ended or reached its second step."""
ARM, FINGER = 37, 38
"""1 if a contact inhibits the arm; 1 if one inhibits the prong."""
LEAST = 39
"""Lower bound of the measured clearances [m]."""
LIMITS = 40
"""1 if a joint is past its reach limit or a singularity is near."""
NEW_LIMITS = 41
"""1 if zones or near singularities have changed, or a cause has a way out by a stick that had none."""
MADE = 42
"""Number of control steps that were made."""
HINDERED = 43
"""Pair whose detrimental contact a translation of the orbiter would deepen, `FREELY` or `REJECTED`."""
FREELY, REJECTED = -1, -2
"""Values of `HINDERED`: nothing hinders the orbiter; it cannot translate."""
SCALARS = 44

# constants of a run
PERIOD = 0
"""Control period [s]."""
WITHIN = 1
"""`Flight.within` [m]."""
TELESCOPE_LOW, TELESCOPE_HIGH, TELESCOPE_RATE = 2, 3, 4
PRONG_LOW, PRONG_HIGH, PRONG_RATE = 5, 6, 7
FIXED_FINGER, SPACING = 8, 9
"""y2 of the fixed finger's inner face, and greatest distance of the fingers that hold a bar [m]."""
SINGULAR = 10
"""Distance from a singularity below which it is near [1]."""
KEEPS_CLOCK = 11
"""1 under `strict`, where a stop does not set back the clock of modes 1 and 3."""
INHIBITS = 12
"""1 if a detrimental contact inhibits motion."""
RADIUS = 13
"""Distance of a grapple pin from the end effector's axis above which the two are never aligned [m]; negative for an end
effector without snares."""
ORBITER_SPEED, ORBITER_REACHED_IN = 14, 15
"""Speed of the orbiter's translation [m/s], and the time to reach it from rest [s]; 0 at a worksite without one."""
CONSTANTS = 16

# of a floating payload
POSE_AT, MOTION_AT, REFERENCE_AT, CYCLE_AT, TIME_AT, FLOATS, CONTROLLED = 0, 12, 18, 27, 36, 37, 38
"""Indices in the row of a payload: its `Floating`, then 1 if it floats, and 1 if it has attitude control."""
FLOATING = 39
