# SPDX-License-Identifier: GPL-3.0-or-later
"""What a verdict is worth, the seal being open: no files, no program, rules alone."""
import itertools
import re

from names import hidden_key, key

WANTED = {"null": 0, "fault": 0, "drives": 0, "one": 1, "outside": 1, "pair": 1, "two": 2}
FIRST_ROW = 2  # of a log's values
APART = 0.3  # of the noise: what more than this is left of a cause, a log tells


class BrokenTrial(Exception):
    """The trial is not what its row says, so nothing may be counted."""


def check_seal(seal, family, size):
    """A seal holds as many causes as its row asks for, each of the size asked for, or says which of them
    could not be reached: a cause that was dropped or replaced by an easier one is no trial."""
    hidden = seal["hidden"]
    if seal["family"] != family or len(hidden) != WANTED[family]:
        raise BrokenTrial(f"a trial of family {family} hides {len(hidden)} causes")
    keys = {hidden_key(h) for h in hidden}
    if len(keys) != len(hidden):
        raise BrokenTrial("one cause is hidden twice at one place")
    if family == "fault" and "fault" not in seal:
        raise BrokenTrial("no fault was planted")
    unreachable = [h for h in [*hidden, seal.get("fault", {})] if "unreachable" in h]
    if bool(unreachable) == seal["reachable"]:
        raise BrokenTrial("what could not be reached is not said, or the other way round")
    for h in hidden:
        if "unreachable" not in h and abs(h["excess"] / size - 1.0) > 0.05:
            raise BrokenTrial(f"{h['cause']} has the size {h['excess']:.2f}, asked for {size}")
    if (family == "drives") != bool(seal.get("drives")):
        raise BrokenTrial("a model without drives does not say which it lacks, or another one does")
    if family == "pair":
        check_pair(seal, hidden[0])


def check_pair(seal, hidden):
    """A pair is one where the truth is among several, and the motion does not tell it from the others."""
    keys = {hidden_key(h) for h in seal.get("admissible", [])}
    if seal["reachable"] and (len(keys) < 2 or hidden_key(hidden) not in keys):
        raise BrokenTrial("a pair's truth has no others that the log could take it for")
    if seal["reachable"] and not seal["apart"] < APART:
        raise BrokenTrial(f"{hidden['cause']} is told from the others by {seal['apart']:.2f} of the noise")


def matched(hidden, sets, accepts):
    """The most hidden causes that can have a set of their own each."""
    best = 0
    for order in itertools.permutations(range(len(sets)), min(len(sets), len(hidden))):
        for chosen in itertools.permutations(range(len(hidden)), len(order)):
            best = max(best, sum(accepts(hidden[h], sets[s]) for h, s in zip(chosen, order)))
    return best


def score(seal, findings):
    """Of a program that ended with findings. right: a set for each hidden cause, its first member of the
    right name, place and order, and no other set. inside: the same for any member. false_names: sets that
    hold no hidden cause, or one that another set has already."""
    verdict = findings["verdict"]
    told = [[key(m["name"], m["place"]) for m in cause["members"]] for cause in verdict["causes"]]
    hidden = [hidden_key(h) for h in seal["hidden"]] if seal["family"] in ("one", "two", "pair") else []
    # More sets than this are told by no program that works; matching all of them would take for ever.
    sets = told[:6]
    any_member = matched(hidden, sets, lambda h, s: h in s)
    first = matched(hidden, sets, lambda h, s: h == s[0])
    none = verdict["unexplained"]["none_of_the_known"]
    return {
        "detected": verdict["outcome"] != "nothing beyond noise",
        "right": bool(hidden) and first == len(hidden) == len(told),
        "inside": bool(hidden) and any_member == len(hidden) == len(told),
        "false_names": len(told) - any_member,
        "none_of_the_known": none,
        "sets": [["@".join([k[0] + (f" {k[1]}" if k[1] else ""), k[2]]) for k in s] for s in told],
        "confidence": [cause["confidence"] for cause in verdict["causes"]],
        "holds": [any(h in s for h in hidden) for s in told],
        "outcome": verdict["outcome"],
        "adopted": findings["extension"]["adopted"],
        "alarms": len(faults_told(findings)),
        "seconds": findings["seconds"],
    }


def drives_told(seal, findings):
    """Of an arm whose model knows no drives. rotors: of every joint what was told of it over what it is, None
    where nothing was; errors: of every channel the held-out error over the standard deviation, before and after."""
    told = {}
    for cause in findings["verdict"]["causes"]:
        if key(cause["members"][0]["name"], "")[0] == "inertia" and cause["parameters"]:
            told[cause["members"][0]["place"].removeprefix("joint ")] = cause["parameters"][0]["value"]
    return {"rotors": {d["joint"]: told[d["joint"]] / d["armature"] if d["joint"] in told else None
                       for d in seal["drives"]},
            "errors": {c["name"]: [c["relative_error_before"], c["relative_error_after"]]
                       for c in findings["channels"]}}


def told_keys(findings):
    return [[key(m["name"], m["place"]) for m in cause["members"]] for cause in findings["verdict"]["causes"]]


def pair_told(seal, findings):
    """Of a log that cannot tell: one set, of several members, that holds the truth."""
    told = told_keys(findings)
    return len(told) == 1 and len(told[0]) > 1 and hidden_key(seal["hidden"][0]) in told[0]


def settled(seal, findings):
    """With the log of the proposed motion beside the first one: the truth, and nothing besides."""
    return told_keys(findings) == [[hidden_key(seal["hidden"][0])]]


def without_numbers(text):
    """A message without file, row and column and without its numbers."""
    return re.sub(r"[-+]?\d[\d.]*(e[-+]?\d+)?", "#", re.sub(r"^[^:]*:\d+:\d+: ", "", text))


def row_of(text):
    """Of "file:row:column: what"; 0: of none."""
    found = re.match(r"[^:]*:(\d+):\d+: ", text)
    return int(found[1]) if found else 0


def faults_told(findings):
    """In logs that nothing was done to: false alarms."""
    return [f for log in findings["logs"] for f in log["faults"]]


def fault_found(seal, findings, error, columns):
    """Whether a planted fault was told of its own channel (or of one that it was exchanged with): refused
    with the channel's name, or named among the logs' faults. columns: of channels, as the recorder calls
    them."""
    fault = seal["fault"]
    names = {fault["channel"], fault.get("other", fault["channel"])}
    names |= {columns.get(n, n) for n in names}
    texts = error.splitlines()
    if findings:
        # What is told of the held-out log as well is not what was done to the other one.
        other = {without_numbers(f) for log in findings["logs"] for f in log["faults"] if log["held_out"]}
        texts = [f for log in findings["logs"] for f in log["faults"]
                 if not log["held_out"] and without_numbers(f) not in other]
    # What was planted is wrong with the whole column: what is told of some row in it is something else.
    texts = [t for t in texts if row_of(t) <= FIRST_ROW]
    return any(f"'{n}'" in t or f" {n} " in t or f"'{n} " in t or f'"{n}' in t
               for n in names for t in texts)


def in_interval(seal, findings):
    """For each cause that was told first with its right name, and has a parameter to compare: whether the
    95 % interval holds the truth."""
    result = []
    for hidden in seal["hidden"]:
        if "parameter" not in hidden:
            continue
        for cause in findings["verdict"]["causes"]:
            first = cause["members"][0]
            if key(first["name"], first["place"]) != hidden_key(hidden):
                continue
            for p in cause["parameters"]:
                if p["name"] != hidden["parameter"]["name"] or not p["standard_error"]:
                    continue
                off = (p["value"] - hidden["parameter"]["value"]) / p["standard_error"]
                result.append({"cause": hidden["cause"], "told": p["value"], "hidden": hidden["parameter"]["value"],
                               "off": off, "holds": abs(off) <= 1.96})
    return result
