# SPDX-License-Identifier: GPL-3.0-or-later
"""Which samples of a log count, and how much: standstill, as docs/diagnosis_rules.md states it."""
import math

STILL, UNDER_WAY = 5e-4, 1e-2  # of the largest speed
SHORTEST, LONGEST_WAY, FLANK = 0.04, 0.1, 0.02  # s
MOST = 0.7  # of a log: reversals beyond it stay


def way_out(speed, at, direction, longest, fast):
    way = 0
    while way < longest and 0 <= at + direction * way < len(speed) and speed[at + direction * way] < fast:
        way += 1
    return way


def reversing(velocity, step, cutoff):
    """Samples within the smoother's reach of a change of sign, and until the joint is under way."""
    periods = min(1.2, 0.36 * math.sqrt(60.0 / min(cutoff, 60.0)))
    reach, longest = math.ceil(periods / (cutoff * step)), int(LONGEST_WAY / step)
    speed = [abs(v) for v in velocity]
    fast, near = UNDER_WAY * max(speed), [False] * len(speed)
    for k in range(1, len(speed)):
        if (velocity[k] > 0) == (velocity[k - 1] > 0):
            continue
        start = max(0, k - reach - way_out(speed, k - 1, -1, longest, fast))
        end = min(len(speed), k + reach + way_out(speed, k, 1, longest, fast))
        near[start:end] = [True] * (end - start)
    return near


def resting(velocity, step, cutoff, still):
    """Samples of rest, slower than `still`, too, with the ways into and out of it."""
    speed = [abs(v) for v in velocity]
    fastest, rest = max(speed), [False] * len(speed)
    longest, smoothing = int(LONGEST_WAY / step), math.ceil(1.2 / (cutoff * step))
    k = 0
    while k < len(speed):
        end = k
        while end < len(speed) and speed[end] <= max(STILL * fastest, still):
            end += 1
        if end - k >= math.ceil(SHORTEST / step):
            fast = max(UNDER_WAY * fastest, still)
            start = max(0, k - smoothing - way_out(speed, k, -1, longest, fast))
            stop = min(len(speed), end + smoothing + way_out(speed, end - 1, 1, longest, fast))
            rest[start:stop] = [True] * (stop - start)
        k = end + 1
    return rest


def stretches(flags):
    found = []
    for k, flag in enumerate(flags):
        if flag and (k == 0 or not flags[k - 1]):
            found.append([k, k])
        if flag:
            found[-1][1] = k
    return found


def either(one, other):
    return [a or b for a, b in zip(one, other)]


def stillness(velocities, step, cutoff, still=0.0):
    """Flags of rests in any of the velocities, and of reversals in the first."""
    rests = [any(flags) for flags in zip(*(resting(v, step, cutoff, still) for v in velocities))]
    return rests, reversing(velocities[0], step, cutoff)


def standstills(parts):
    """Stretches of samples [from, to] that count for nothing: all rests of the parts that act on a joint, and the
    reversals of each, unless they are too much of the log."""
    still = [any(flags) for flags in zip(*(rests for rests, _ in parts))]
    for _, reversals in parts:
        both = either(still, reversals)
        if sum(both) <= MOST * len(both):
            still = both
    return stretches(still)


def weights(still, instants, step):
    """1 in motion, 0 at standstill, flanks of a cosine between."""
    result = []
    for k in instants:
        weight = 1.0
        for start, end in still:
            away = max(start - k, k - end) * step / FLANK
            if away < 1:
                weight *= 0.0 if away <= 0 else 0.5 - 0.5 * math.cos(math.pi * away)
        result.append(weight)
    return result
