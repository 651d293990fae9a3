"""Put your own servos and your own integrator around the report's steering, in all eight modes."""

import numpy as np

import aftdeck
from aftdeck import jsc12628

arm = aftdeck.load_arm("srms")
start = np.radians([10.0, 50.0, -70.0, -10.0, 15.0, 20.0])
DT = 0.08  # control period [s]
SUBSTEPS = 16  # steps of the integrator in a control period
LAG = 0.05  # time constant of each servo [s]
limits = {"V_L": 2.0, "omega_L": 0.083, "V_L_dot": 0.5, "omega_L_dot": 0.02, "DT": DT, "units": "ft"}
limits["theta_dot_L"] = np.radians([2.3, 2.3, 3.2, 4.8, 4.8, 4.8])


def moved(theta, theta_dot, commanded):
    """Return angles and rates one control period later: each servo follows its command with a lag (Heun's method)."""
    h = DT / SUBSTEPS
    for _ in range(SUBSTEPS):
        first = (commanded - theta_dot) / LAG
        second = (commanded - (theta_dot + h * first)) / LAG
        theta = theta + h * theta_dot + 0.5 * h * h * first
        theta_dot = theta_dot + 0.5 * h * (first + second)
    return theta, theta_dot


here = jsc12628.lnkage(arm, start, units="ft")
goal = here.r_6B + np.array([4.0, 2.0, -3.0])
turned = np.add(jsc12628.oriend(here.T_B7), np.radians([10.0, 0.0, 15.0]))
pose = {"r_6BF": goal, "xi_F": turned}  # Euler angles, as with the report's S_I = 1
sticks = {"V_C": [0.5, 0.0, 0.0], "omega_C": [0.0, 0.0, 0.02], "T_78": jsc12628.endori(0.0, 0.0, 0.5), "ETA": 10.0}
one_joint = {"joint": 3, "theta_dot_C": 0.02, "ETA": 10.0}  # modes 4 to 8 end at the ETA that is given
inputs = {**dict.fromkeys((1, 2, 3), pose), **dict.fromkeys((4, 5, 6, 7), sticks), 8: one_joint}

for mode, given in inputs.items():
    phase = jsc12628.operin(arm, mode, start, **limits, **given)  # interface 2: the operator's inputs
    theta, theta_dot = start, np.zeros(6)  # interface 1: the arm at the start
    while not (step := jsc12628.msteer(phase, theta, theta_dot)).done:  # interface 3: joint rates
        theta, theta_dot = moved(theta, theta_dot, step.theta_dot_C)
    tip = jsc12628.lnkage(arm, theta, units="ft").r_6B
    way = f"{np.linalg.norm(tip - here.r_6B):5.2f} ft away"
    if given is pose:
        way += f", {np.linalg.norm(tip - goal):.3f} ft from the goal"
    print(f"mode {mode}: ended at {step.ETA:5.2f} s, {way}")  # interface 4: the end of the phase
