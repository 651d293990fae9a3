"""Where is the tip, how does it move, and which joint angles bring it back?"""

import numpy as np

import aftdeck

arm = aftdeck.load_arm("srms")
angles = np.radians([0.0, 25.0, -25.0, 5.0, 0.0, 0.0])  # pre-cradle; SRMS joint angles, base to tip

pose = arm.forward(angles)  # frame 7 in L, metres
inches, degrees = arm.panel(pose)  # in panel components; the attitude is that of the end effector's axes (E)
print("tip in L      ", pose.position.round(3), "m")
print("on the panel  ", [round(x, 1) for x in inches], "in;", [round(a, 1) for a in degrees], "deg")

up = np.array([0.0, 0.0, 0.0, 0.0, 0.0, -0.1])  # a twist in L: no rotation, 0.1 m/s along −z
print("to lift it    ", np.degrees(arm.joint_rates(angles, up)).round(3), "deg/s")

for solution in arm.inverse(pose, near=angles):
    print("reached by    ", np.degrees(solution).round(2), "deg")

many = np.random.default_rng(0).uniform(arm.limits.soft[:, 0], arm.limits.soft[:, 1], (100_000, 6))
reach = np.linalg.norm(arm.forward(many).position, axis=-1)
print("100 000 poses: the tip is at most", reach.max().round(2), "m from the shoulder")
