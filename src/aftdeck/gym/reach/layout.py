"""Indices of the values in the arrays of Reach's compiled functions.

A block holds `LANES` environments, row by row (`steering/blocks.py`); its first rows are those of
`gym/reach/stick_blocks.py`. Vectors are in L unless another frame is named.
"""

from __future__ import annotations

from aftdeck.gym.reach.stick_blocks import DEMANDED, STICK_ROWS, STICK_WORK

# rows of a block
GOAL = STICK_ROWS
"""(12,) pose of the tip that has to be reached: position [m], then rotation row by row."""
DISTANCE, CHORD = GOAL + 12, GOAL + 13
"""Remaining distance [m], and remaining rotation: twice the sine of half its angle [1]."""
STEPS = GOAL + 14
"""Number of steps of the episode."""
EPISODE = GOAL + 15
"""Number of the next episode, from 0; the counter of its random numbers."""
KEY_LOW, KEY_HIGH = GOAL + 16, GOAL + 17
"""Key of the random numbers: two words of 32 bits."""
ENDED = GOAL + 18
"""1 if the episode has ended, and has to be reset."""
ROWS = GOAL + 19

# rows of the work array, after the steering; its sines and cosines (rows 0 to 11) are still needed
OBSERVED = DEMANDED
"""(24,) observation: distance (3) and rotation (3) left, velocity (3) and angular rate (3) of the tip, all in the
orbiter's axes; joint angles (6) and rates (6). Normalised by `MIDDLE` and `SCALE`."""
OBSERVATIONS = 24
REWARD, REACHED, OUT_OF_TIME = OBSERVED + 24, OBSERVED + 25, OBSERVED + 26
"""Reward of the step; 1 if the goal is reached; 1 if the episode has reached its greatest number of steps."""
WORK = max(OBSERVED + 27, STICK_WORK)

# constants of the task
START_LOW, START_SPAN = 0, 6
"""(6,) least joint angles at the start, and ranges of these angles [rad]."""
GOAL_LOW, GOAL_SPAN = 12, 18
"""The same of the joint angles of the goal."""
APART = 24
"""Least distance of start and goal [m]."""
NEAR, NEAR_CHORD = 25, 26
"""Distance [m] and rotation (twice the sine of half the angle) up to which the goal counts as reached."""
PER_METRE, PER_CHORD, PER_STEP, SUCCESS = 27, 28, 29, 30
"""Weights of the reward: progress of distance [1/m] and of rotation [1]; cost of a step; success."""
MOST_STEPS = 31
"""Greatest number of steps of an episode."""
MIDDLE, SCALE = 32, 32 + OBSERVATIONS
"""(24,) value of each observation that is normalised to 0, and factor that normalises it."""
TASK = SCALE + OBSERVATIONS

REJECTED = -1
"""Result of a step whose sticks are outside [-1, 1]; nothing has changed."""
