# SPDX-License-Identifier: GPL-3.0-or-later
"""What levers and wrists leave over of a held-out log: what their sensors should read by the emitted C, as the
model was and as it was extended."""
import statistics

from filters import Comparison, smoothed

BAND, EDGE = 60.0, 0.25  # Hz, s left away at both ends, as docs/diagnosis_rules.md states
SMOOTHED = {"count": 15.0, "q71": 30.0, "q73": 30.0}  # Hz, below which a reading's speed is told


def white_noise(x):
    """rms, by the median of its third differences."""
    third = [abs(d - 3 * c + 3 * b - a) for a, b, c, d in zip(x, x[1:], x[2:], x[3:])]
    return statistics.median(third) / (0.674489750196 * 20**0.5)


def steady_rate(reading, step, resolution):
    """Of a reading that a play of one step of it and three times its noise is taken from."""
    play, steady, rate = resolution + 3.0 * white_noise(reading), reading[0], [0.0]
    for x in reading[1:]:
        before, steady = steady, min(max(steady, x - play), x + play)
        rate.append((steady - before) / step)
    return rate


def side_of_play(rate):
    """Which end of its play a sensor is at: the way it went last; between the two its motion, from rest where the
    reading stops, makes a way that grows with the square of the time."""
    side, last, start = [0.0] * len(rate), 0.0, 0
    for k, r in enumerate(rate):
        if r == 0.0 and k + 1 < len(rate):
            continue
        now = last if r == 0.0 else 1.0 if r > 0.0 else -1.0
        last = last or now
        for i in range(start, k + 1):
            side[i] = last + (now - last) * ((i - start + 1) / (k - start + 1)) ** 2
        last, start = now, k + 1
    return side


def resolution(name, reading):
    """A count is a step; of an angle the smallest change between two samples, where most are none."""
    changes = [abs(b - a) for a, b in zip(reading, reading[1:])]
    some = [c for c in changes if c > 0.0]
    return 1.0 if name == "count" else min(some, default=0.0) if 2 * len(some) < len(changes) else 0.0


def signal_of(log, name, step):
    """One input of the observation: a channel, or what is made of one."""
    if name.endswith("_rate"):
        name = name.removesuffix("_rate")
        return steady_rate(log[name], step, resolution(name, log[name]))
    if name.endswith("_side"):
        return side_of_play(signal_of(log, name.removesuffix("_side") + "_rate", step))
    if name.endswith("_speed"):
        name = name.removesuffix("_speed")
        return list(smoothed(log[name], step, min(SMOOTHED[name], 0.1 / step), 1))
    return log.get(name, [0.0] * len(log["time"]))


def signals_of(log, names, step):
    """The observation's inputs but its memory and the step."""
    return {name: [signal_of(log, name, step)] for name, _ in names if name not in ("memory", "step")}


def left_over(said_by_model, measured, step, free_zero):
    """Behind the documented filter; a motor that counts from anywhere has its zero taken out."""
    behind, edge, result = Comparison(step, BAND), round(EDGE / step), []
    for told, seen in zip(said_by_model, measured):
        left = behind([a - b for a, b in zip(seen, told)][edge:len(seen) - edge])
        zero = sum(left) / len(left) if free_zero else 0.0
        result.append([x - zero for x in left])
    return result


def residuals(log, models):
    """Of each of the models, a list a channel."""
    step = log["time"][1] - log["time"][0]
    motors = [n for n in (f"theta_{i}" for i in range(1, 100)) if n in log]
    measured = [log[n] for n in motors or ("force", "elongation") if n in log]
    signals = signals_of(log, models[0].inputs("observation"), step)
    return [left_over(c.rows("observation", signals, {"step": step}), measured, step, bool(motors)) for c in models]
