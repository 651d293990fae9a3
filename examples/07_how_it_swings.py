"""How does the arm swing on its brakes (axes of L), and how does a servo answer, without and with 32,000 lb?"""

import numpy as np

import aftdeck

POSE = np.radians([0.0, 60.0, -80.0, -20.0, 0.0, 0.0])  # half stretched, end effector down
SERVO = "rate.shoulder_pitch"

for payload in (None, 14_515.0):  # kg
    arm = aftdeck.dynamics("srms", payload=payload, flexible=True)
    print("no payload" if payload is None else f"{payload:,.0f} kg")

    modes = arm.modes(POSE)
    for frequency, damping, tip in zip(modes.frequencies[:3], modes.damping, modes.tip, strict=False):
        along = tip[:3] / np.linalg.norm(tip[:3])
        print(
            f"  braked: {frequency:.3f} Hz, damping {100 * damping:.2f} %; the tip swings along {along.round(2) + 0.0}"
        )

    hold = arm.linear(POSE, "hold").poles()
    print(f"  on its servos the slowest motion decays with {-hold.s[0].real:.3f} 1/s")

    bode = arm.linear(POSE, "servos").bode(SERVO, SERVO, [0.01, 0.1, 1.0])
    for frequency, gain, phase in zip(bode.frequencies, bode.gain, np.degrees(bode.phase), strict=True):
        print(f"  commanded at {frequency:g} Hz, it turns {gain:.2f} times as fast, phase {phase:.1f}°")
