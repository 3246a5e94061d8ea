# SPDX-License-Identifier: GPL-3.0-or-later
"""Zero-phase filters over lists of numbers."""
import math


def kernel(step, cutoff, half):
    """Windowed sinc, zero phase, sum one."""
    weights = []
    for i in range(-half, half + 1):
        angle = 2 * math.pi * cutoff * step * i
        window = 0.42 + 0.5 * math.cos(math.pi * i / (half + 1)) + 0.08 * math.cos(2 * math.pi * i / (half + 1))
        weights.append(window * (1.0 if i == 0 else math.sin(angle) / angle))
    total = sum(weights)
    return [w / total for w in weights]


def convolved(x, weights, every=1):
    """Where the kernel fits."""
    n = len(weights)
    return [math.sumprod(x[k:k + n], weights) if hasattr(math, "sumprod")
            else sum(a * b for a, b in zip(x[k:k + n], weights)) for k in range(0, len(x) - n + 1, every)]
