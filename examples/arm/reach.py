# SPDX-License-Identifier: BSD-2-Clause
"""How high the arm reaches, and what holds it there."""
import numpy as np
import sinew_six_joint_arm as arm

print("joints:", ", ".join(arm.JOINTS))

# One call for all postures: the leading axis counts them.
postures = np.random.default_rng(7).uniform(arm.LOW, arm.HIGH, (200_000, len(arm.JOINTS)))
height = arm.forward_kinematics(postures)[:, 2, 3]
highest = postures[np.argmax(height)]
print(f"highest of {len(postures)} postures: the tool at {height.max():.3f} m")

# At rest, inverse dynamics is gravity alone.
still = np.zeros(len(arm.JOINTS))
difference = np.abs(arm.gravity(highest) - arm.inverse_dynamics(highest, still, still)).max()
print(f"gravity and inverse dynamics agree to {difference:.1g} N m")
