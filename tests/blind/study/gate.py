# SPDX-License-Identifier: GPL-3.0-or-later
"""gate.py <program> <drawer> <plant> <when>: the trials of gates.csv that are of this plant, in scripts/test or in
scripts/verify. Ends with 1 where one of
them is no longer what it was, or where what was adopted is not physical or gains other than it tells."""
import pathlib
import sys
import tempfile

import trials

ROOT = pathlib.Path(__file__).resolve().parents[3]
GAIN_AGREES = 0.02  # told against recomputed from the emitted C


def read_gates(file):
    return [{"plant": r["plant"], "family": r["family"], "size": float(r["size"]), "number": int(r["seed"]),
             "cause": r["cause"], "logs": 1, "seed": int(r["seed"]), "wanted": r["wanted"], "when": r["when"]}
            for r in trials.read_table(file)]


def is_met(wanted, line):
    if wanted == "found":
        return bool(line.get("fault_found"))
    if line["status"] != "ran":
        return False
    if wanted == "right":
        return line["right"]
    if wanted == "surplus":
        return line["false_names"] == 1 and len(line["sets"]) == len(line["seal"]["hidden"]) + 1
    if wanted == "silent":
        return not line["detected"] and not line["alarms"] and not line["adopted"]
    if wanted == "structure":
        return line["none_of_the_known"] and not line["sets"]
    raise ValueError(f"'{wanted}' is nothing that can be wanted of a trial")


def failures(gate, line):
    """What is wrong with a trial's line; empty: nothing."""
    wrong = []
    hidden = [h["cause"] for h in (line.get("seal") or {"hidden": []})["hidden"]]
    # A ripple's order stands behind its name.
    if gate["cause"] and hidden != [gate["cause"].split(" ")[0]]:
        wrong.append(f"hides {hidden}, expected {gate['cause']}")
    if not is_met(gate["wanted"], line):
        wrong.append(f"expected {gate['wanted']}; {line['status']}, {line.get('outcome')}: {line.get('sets')} "
                     f"{line.get('error', '')}")
    physical = line.get("physical") or {}
    for what in ("bodies", "mass_matrix"):
        if physical.get(what) is False:
            wrong.append(f"not physical: {what}")
    if "not_judged" in physical:
        wrong.append(physical["not_judged"])
    gain = physical.get("gain")
    if gain and abs(gain["told"] - gain["recomputed"]) > GAIN_AGREES:
        wrong.append(f"tells a gain of {gain['told']:.3f}, its C gains {gain['recomputed']:.3f}")
    return wrong


def main():
    program, drawer, plant, when = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), *sys.argv[3:]
    tools = {"program": program, "drawer": drawer, "sinew": program, "runtime": ROOT / "runtime", "limit": 300.0,
             "physical": True}
    gates = [g for g in read_gates(pathlib.Path(__file__).with_name("gates.csv"))
             if (g["plant"], g["when"]) == (plant, when)]
    failed = 0
    with tempfile.TemporaryDirectory() as place:
        # A library that was loaded from a path is what that path is to this process from then on.
        for index, gate in enumerate(gates):
            line = trials.run_trial(tools, gate, f"{place}/{index:06d}")
            wrong = failures(gate, line)
            failed += bool(wrong)
            print(f"{trials.name_of(gate)}: {'; '.join(wrong) or gate['wanted']}", flush=True)
    print(f"{len(gates)} trials, {failed} failed")
    sys.exit(1 if failed or not gates else 0)


if __name__ == "__main__":
    main()
