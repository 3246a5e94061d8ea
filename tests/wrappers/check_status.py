# SPDX-License-Identifier: GPL-3.0-or-later
"""check_status.py: the installed package sinew_lever gives a status over many states as state by state."""
import numpy as np
import sinew_lever as lever

theta = np.linspace(-4.0, 4.0, 1001)
many = lever.status(theta)
single = [lever.status(each) for each in theta]
assert many.dtype == np.intc and many.shape == theta.shape, (many.dtype, many.shape)
assert np.array_equal(many, single), "another value"
assert len(set(many.tolist())) > 1, "all states are alike"
