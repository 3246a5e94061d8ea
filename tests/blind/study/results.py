# SPDX-License-Identifier: GPL-3.0-or-later
"""Counts: rates with their numbers and 95 % intervals, per plant, per size and per cause."""
import collections
import json
import math


def read(file):
    """The last line of each trial; half a line at the end of a study that was stopped is left out."""
    lines = {}
    if file.exists():
        for text in file.read_text(encoding="utf-8").splitlines():
            try:
                line = json.loads(text)
            except ValueError:
                continue
            lines[line["trial"]] = line
    return list(lines.values())


def wilson(hits, trials, z=1.96):
    """Wilson's 95 % interval of a rate."""
    if trials == 0:
        return 0.0, 1.0
    rate, share = hits / trials, z * z / trials
    middle = (rate + share / 2) / (1 + share)
    half = z / (1 + share) * math.sqrt(rate * (1 - rate) / trials + share / (4 * trials))
    return max(0.0, middle - half), min(1.0, middle + half)


class Rate:
    def __init__(self, hits, trials):
        self.hits, self.trials = hits, trials
        self.low, self.high = wilson(hits, trials)

    @property
    def share(self):
        return self.hits / self.trials if self.trials else math.nan

    def __str__(self):
        if self.trials == 0:
            return "–"
        return f"{self.hits} of {self.trials}: {100 * self.share:.0f} % ({100 * self.low:.0f}–{100 * self.high:.0f})"


def rate(lines, what):
    return Rate(sum(bool(what(line)) for line in lines), len(lines))


def said(field):
    """False as well where a program refused or crashed: a trial that was run is never left out."""
    return lambda line: line.get(field, False)


def counted(lines):
    """Those that were reachable: the others have a column of their own."""
    return [line for line in lines if line["status"] != "unreachable"]


def status(lines, name):
    return sum(line["status"] == name for line in lines)


def of(lines, **wanted):
    return [line for line in lines if all(line[k] == v for k, v in wanted.items())]


def by(lines, what):
    groups = collections.defaultdict(list)
    for line in lines:
        groups[what(line)].append(line)
    return dict(sorted(groups.items()))


def cause_of(line):
    h = line["seal"]["hidden"][0]
    return h["cause"] + (f" {h['order']}" if "order" in h else "")


def calibration(lines):
    """(confidence told, share that holds the truth, sets) by tenths, and the mean distance."""
    told = [(c, held) for line in lines for c, held in zip(line.get("confidence", []), line.get("holds", []))]
    table = []
    for low in range(10):
        some = [(c, h) for c, h in told if low / 10 <= c < (low + 1) / 10 or (low == 9 and c >= 1)]
        if some:
            table.append((sum(c for c, _ in some) / len(some), sum(h for _, h in some) / len(some), len(some)))
    distance = sum(n * abs(c - h) for c, h, n in table) / max(1, len(told))
    return table, distance
