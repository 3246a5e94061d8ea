# SPDX-License-Identifier: GPL-3.0-or-later
"""What a verdict is worth, the seal being open: no files, no program, rules alone."""
import itertools

from names import hidden_key, key

WANTED = {"null": 0, "fault": 0, "one": 1, "outside": 1, "two": 2}


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
    unreachable = [h for h in hidden if "unreachable" in h]
    if bool(unreachable) == seal["reachable"]:
        raise BrokenTrial("what could not be reached is not said, or the other way round")
    for h in hidden:
        if "unreachable" not in h and abs(h["excess"] / size - 1.0) > 0.05:
            raise BrokenTrial(f"{h['cause']} has the size {h['excess']:.2f}, asked for {size}")
    if family == "fault" and "fault" not in seal:
        raise BrokenTrial("no fault was planted")


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
    hidden = [hidden_key(h) for h in seal["hidden"]] if seal["family"] in ("one", "two") else []
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
        "seconds": findings["seconds"],
    }


def fault_found(seal, findings, error, columns):
    """Whether a planted fault was told of its own channel (or of one that it was exchanged with): refused
    with the channel's name, or named among the logs' faults. columns: of channels, as the recorder calls
    them."""
    fault = seal["fault"]
    names = {fault["channel"], fault.get("other", fault["channel"])}
    names |= {columns.get(n, n) for n in names}
    texts = error.splitlines()
    if findings:
        texts = [f for log in findings["logs"] for f in log["faults"] if not log["held_out"]]
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
