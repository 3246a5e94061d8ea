# SPDX-License-Identifier: GPL-3.0-or-later
"""The zero-phase filters that docs/diagnosis_rules.md states, written a second time."""
import array
import ctypes
import functools
import math
import pathlib
import subprocess
import tempfile

BLACKMAN, KAISER = "blackman", "kaiser"


@functools.cache
def loops():
    """loops.c, compiled once in a process."""
    source = pathlib.Path(__file__).with_name("loops.c")
    with tempfile.TemporaryDirectory() as folder:
        library = pathlib.Path(folder) / "loops.so"
        subprocess.run(["cc", "-std=c11", "-O2", "-shared", "-fPIC", source, "-o", library], check=True)
        made = ctypes.CDLL(str(library))
    many, number = ctypes.POINTER(ctypes.c_double), ctypes.c_long
    made.convolved.argtypes = [many, many, number, number, number, many]
    made.played.argtypes = [ctypes.c_void_p, number, many, number, many, number, number, number, number]
    return made


def pointer(x):
    return (ctypes.c_double * len(x)).from_buffer(x)


def bessel(x):
    """Modified Bessel function of order zero."""
    total = term = 1.0
    for k in range(1, 40):
        term *= 0.25 * x * x / (k * k)
        total += term
    return total


def windowed_sinc(x, cutoff, half, window):
    """cutoff in cycles a sample, x in samples from the middle."""
    u = x / (half + 1)
    if abs(u) >= 1:
        return 0.0
    shape = (0.42 + 0.5 * math.cos(math.pi * u) + 0.08 * math.cos(2 * math.pi * u) if window == BLACKMAN
             else bessel(5.65 * math.sqrt(1 - u * u)))
    angle = 2 * math.pi * cutoff * x
    return shape * (1.0 if abs(angle) < 1e-9 else math.sin(angle) / angle)


@functools.cache
def kernel(cutoff, half, window, derivative=0):
    """Weights of a value (sum one), of its rate (exact on straight lines) or of its second derivative (exact
    on parabolas, by what a fitted parabola's weights add), by the sample."""
    at = range(-half, half + 1)
    values = [windowed_sinc(x, cutoff, half, window) for x in at]
    total = sum(values)
    if derivative == 0:
        return array.array("d", [v / total for v in values])
    h = 1e-3
    ends = [(windowed_sinc(x - h, cutoff, half, window), windowed_sinc(x + h, cutoff, half, window)) for x in at]
    if derivative == 1:
        weights = [(a - b) / (2 * h) for a, b in ends]
        mean = sum(weights) / len(weights)
        slope = sum((w - mean) * x for w, x in zip(weights, at))
        return array.array("d", [(w - mean) / slope for w in weights])
    weights = [(a - 2 * v + b) / (h * h) / total for v, (a, b) in zip(values, ends)]
    mean, square = sum(weights) / len(weights), sum(x * x for x in at) / len(weights)
    weights, parabola = [w - mean for w in weights], [x * x - square for x in at]
    lacking = 1 - 0.5 * sum(w * x * x for w, x in zip(weights, at))
    scale = lacking / (0.5 * sum(p * x * x for p, x in zip(parabola, at)))
    return array.array("d", [w + scale * p for w, p in zip(weights, parabola)])


def convolved(x, weights, every=1):
    """Where the weights fit."""
    if not isinstance(x, array.array):
        x = array.array("d", x)
    count = max(0, (len(x) - len(weights)) // every + 1)
    y = array.array("d", bytes(8 * count))
    if count:
        loops().convolved(pointer(x), pointer(weights), len(weights), every, count, pointer(y))
    return y


def longer(x, half):
    """Continued at both ends by point reflection."""
    return array.array("d", [*(2 * x[0] - x[j] for j in range(half, 0, -1)), *x,
                             *(2 * x[-1] - x[-1 - j] for j in range(1, half + 1))])


def smoothed(x, step, cutoff, derivative=0):
    """A measured signal or its derivative below a cutoff [Hz], as long as it was."""
    share = min(0.5, 1.25 * cutoff * step)
    half = max(4, math.ceil(5.0 / share))
    y = convolved(longer(x, half), kernel(share, half, BLACKMAN, derivative))
    return array.array("d", [v / step**derivative for v in y]) if derivative else y


def quick_to_transform(count):
    """The next lower even number without a prime factor above 5."""
    while count > 1:
        rest = count
        for prime in (2, 3, 5):
            while rest % prime == 0:
                rest //= prime
        if rest == 1 and count % 2 == 0:
            break
        count -= 1
    return count


class Comparison:
    """What efforts are compared behind: flat to the band, one of so many samples kept, as many as are quick to
    transform."""

    def __init__(self, step, band):
        self.every = max(1, math.floor(0.4 / (band * step)))
        self.half = 9 * self.every
        self.weights = kernel(0.5 / self.every, self.half, KAISER)

    def __call__(self, x):
        return convolved(x, self.weights, self.every)[:len(self.instants(len(x)))]

    def instants(self, rows):
        """Samples on which what is kept is centred."""
        at = range(self.half, rows - self.half, self.every)
        return at[:quick_to_transform(len(at))]
