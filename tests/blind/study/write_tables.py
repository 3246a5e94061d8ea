# SPDX-License-Identifier: GPL-3.0-or-later
"""write_tables.py <rows.csv> <results folder> <out.md>: docs/blind_trials.md from what scripts/study
ran, and <results folder>/rates.csv for its picture. A row whose trials are not all there is an error."""
import collections
import csv
import json
import pathlib
import sys

FAMILIES = {0: "nothing", 1: "one", 2: "two", 3: "three", 4: "outside", 5: "inseparable"}
PLANTS = {"drives": "drives", "arms": "arms of two and three joints", "long": "arms of five and six joints",
          "joints": "lone joints in closed loop", "levers": "levers and tendons", "wrists": "wrists",
          "fingers": "fingers with tendons and motors", "pairs": "drives"}


def table(head, body):
    lines = [head, ["---"] * len(head)] + body
    return "\n".join("| " + " | ".join(str(cell) for cell in line) + " |" for line in lines) + "\n"


class Row:
    """Trials of one line of rows.csv."""

    def __init__(self, line, folder):
        self.name, self.study = line["row"], line["study"]
        self.family, self.size = FAMILIES[int(line["family"])], int(line["size"]) / 100
        self.first, self.count = int(line["first_seed"]), int(line["trials"])
        self.trials = {}
        for file in sorted((folder / self.name).glob("*.jsonl")):
            for text in file.read_text(encoding="utf-8").splitlines():
                trial = json.loads(text)
                self.trials[trial["seed"]] = trial
        missing = [s for s in range(self.first, self.first + self.count) if s not in self.trials]
        if missing:
            sys.exit(f"{folder / self.name}: {len(missing)} trials are missing, the first has seed "
                     f"{missing[0]}; run scripts/study again, it goes on from there")
        self.trials = [self.trials[s] for s in range(self.first, self.first + self.count)]

    @property
    def plant(self):
        return PLANTS[self.name.split("_")[0]]

    @property
    def seeds(self):
        return f"{self.first}–{self.first + self.count - 1}"

    def number(self, key):
        return sum(bool(trial[key]) for trial in self.trials)

    def false_trials(self):
        return sum(trial["false_names"] > 0 for trial in self.trials)

    def told_as_set(self):
        """Trials told as a set of several that holds what is hidden."""
        return [trial for trial in self.trials
                if trial["inside"] and any(len(told["members"]) > 1 for told in trial["told"])]

    def mean_set(self):
        sets = [told for trial in self.trials for told in trial["told"]]
        return sum(len(told["members"]) for told in sets) / len(sets) if sets else 0.0


def share(part, whole):
    return f"{part} of {whole}"


class Study:
    def __init__(self, rows_file, folder):
        with open(rows_file, encoding="utf-8", newline="") as lines:
            listed = list(csv.DictReader(line for line in lines if not line.startswith("#")))
        self.rows = [Row(line, folder) for line in listed]
        self.speed = json.loads((folder / "speed.json").read_text(encoding="utf-8"))
        self.faults = self.lines(folder / "faults.jsonl")
        self.measured = {line["log"]: line for line in self.lines(folder / "measured.jsonl")}

    @staticmethod
    def lines(file):
        if not file.exists():
            return []
        return [json.loads(text) for text in file.read_text(encoding="utf-8").splitlines()]

    def of(self, family, plant=None):
        return [row for row in self.rows
                if row.family == family and (plant is None or row.plant == plant)]

    def row(self, name):
        return next((row for row in self.rows if row.name == name), None)

    def sets(self):
        """Of trials that hide what the library has."""
        return [told for row in self.rows if row.family in ("one", "two", "three", "inseparable")
                for trial in row.trials for told in trial["told"]]


def one_cause_table(study):
    body = []
    for row in study.of("one"):
        body.append([row.plant, f"{row.size:.1f}", row.seeds, share(row.number("detected"), row.count),
                     row.number("inside"), row.number("right"), row.false_trials(),
                     f"{row.mean_set():.2f}"])
    return table(["one cause", "size", "seeds", "detected", "in the set", "right", "with a false name",
                  "mean set"], body)


def null_table(study):
    body = [[row.plant, row.seeds, share(row.number("false_names"), row.count),
             row.number("none_of_the_known")] for row in study.of("nothing")]
    return table(["nothing hidden", "seeds", "a name", "“none of the known”"], body)


def several_table(study):
    body = []
    for row in study.of("two") + study.of("three"):
        body.append([row.plant, row.family, f"{row.size:.1f}", row.seeds,
                     share(row.number("right"), row.count), row.number("inside")])
    return table(["several causes", "at once", "size", "seeds", "exactly right", "in the sets"], body)


def outside_table(study):
    body = [[row.plant, f"{row.size:.1f}", row.seeds, share(row.number("none_of_the_known"), row.count),
             row.false_trials()] for row in study.of("outside")]
    return table(["a cause that the library does not have", "size", "seeds", "“none of the known causes”",
                  "with a wrong name"], body)


def pairs_table(study):
    body = []
    for row in study.of("inseparable"):
        as_set = row.told_as_set()
        body.append([row.seeds, share(len(as_set), row.count),
                     share(sum(t.get("settled", False) for t in as_set), len(as_set)),
                     sum(t.get("alone", False) for t in as_set)])
    return table(["one of an inseparable pair, seeds", "told as a set that holds it",
                  "settled by the motion asked for", "alone then"], body)


def plain(name):
    """Without its place."""
    return name.split("@")[0]


def set_text(told):
    members = [plain(member) for member in told["members"]]
    return members[0] if len(members) == 1 else "{" + ", ".join(members) + "}"


def verdict_text(trial):
    if not trial["told"]:
        return "none of the known causes" if trial["none_of_the_known"] else "nothing"
    return " + ".join(set_text(told) for told in trial["told"])


def confusion_table(study):
    """A cause a line: what came first in the set that should hold it, over all plants at 1.0 and more."""
    told = collections.defaultdict(collections.Counter)
    for row in study.of("one"):
        if row.size < 1.0:
            continue
        for trial in row.trials:
            cause = plain(trial["hidden"][0])
            told[cause]["hidden"] += 1
            told[cause]["right" if trial["right"] else verdict_text(trial)] += 1
    body = []
    for cause in sorted(told):
        counts = told[cause]
        other = ", ".join(f"{name.replace('_', ' ')} ({n})" for name, n in counts.most_common()
                          if name not in ("hidden", "right"))
        body.append([cause.replace("_", " "), counts["hidden"], counts["right"], other])
    return table(["hidden, 1.0 and more of the noise", "trials", "right", "told instead"], body), len(told)


def calibration(study):
    """Bins of the confidence told, the share that holds the truth, and the mean distance of the two."""
    bins = collections.defaultdict(list)
    for told in study.sets():
        bins[min(int(told["confidence"] * 10), 9)].append(told)
    everything = sum(len(told) for told in bins.values())
    body, error = [], 0.0
    for key in sorted(bins):
        sets = bins[key]
        said = sum(told["confidence"] for told in sets) / len(sets)
        true = sum(told["holds_truth"] for told in sets) / len(sets)
        error += len(sets) / everything * abs(said - true)
        body.append([f"{key / 10:.1f}–{(key + 1) / 10:.1f}", len(sets), f"{said:.2f}", f"{true:.2f}"])
    return table(["confidence told", "sets", "mean", "hold the truth"], body), error


def goal(found, limit, least=True, digits=1, unit=" %"):
    if found is None:
        return ["not run", ""]
    met = found >= limit if least else found <= limit
    return [f"{found:.{digits}f}{unit}", "met" if met else "missed"]


def rate(row, key):
    return None if row is None else 100.0 * row.number(key) / row.count


def fault_rates(study):
    planted = [line for line in study.faults if line["what"] == "planted"]
    clean = [line for line in study.faults if line["what"] == "clean"]

    def share_of(lines, key):
        return 100.0 * sum(line[key] for line in lines) / sum(line["of"] for line in lines) if lines else None

    return share_of(planted, "found"), share_of(clean, "suspected")


def measured_goals(study):
    emps, cable = study.measured.get("positioning drive"), study.measured.get("cable joint")
    body = []
    if emps is None:
        body.append(["measured positioning drive", "", "the log is not there", ""])
    else:
        wanted = {"viscous asymmetry", "delay", "friction concave in speed", "ripple once per motor turn"}
        refused = {"Stribeck friction", "ripple off every order of the motor"}
        named = wanted <= set(emps["named"]) and refused <= set(emps["ruled_out"])
        body.append(["measured positioning drive: viscous asymmetry, delay, concave friction and the "
                     "ripple named, Stribeck and the ripple off order ruled out", "all six",
                     ", ".join(emps["named"]), "met" if named else "missed"])
        body.append(["its delay", "near 0.8 ms", ", ".join(f"{1e3 * d:.2f} ms" for d in emps["delays"]), ""])
        body.append(["its training error", "≤ 1.9 %"] + goal(100 * emps["error"], 1.9, False, 2))
    if cable is None:
        body.append(["measured joint with a cable", "", "the log is not there", ""])
    else:
        named = "position-dependent cable torque" in cable["named"]
        body.append(["measured joint with a cable: position-dependent cable torque", "named",
                     ", ".join(cable["named"]), "met" if named else "missed"])
        body.append(["its residual over its standard deviation", "≤ 7 %"]
                    + goal(100 * cable["error"], 7.0, False))
    return body


def goal_table(study):
    null, half, full = study.row("drives_null"), study.row("drives_50"), study.row("drives_100")
    sets = [told for row in study.of("one") if row.size >= 1.0 for t in row.trials for told in t["told"]]
    inside = [t["inside"] for row in study.of("one") if row.size >= 1.0 for t in row.trials if t["detected"]]
    pairs = study.row("pairs")
    as_set = settled = None
    if pairs:
        good = pairs.told_as_set()
        as_set = 100.0 * len(good) / pairs.count
        settled = 100.0 * sum(t.get("settled", False) for t in good) / max(1, len(good))
    outside = study.row("drives_outside")
    found, alarms = fault_rates(study)
    kinds = confusion_table(study)[1]
    body = [
        [f"nothing hidden, {null.count if null else 0} drives: a false name", "≤ 1 %"]
        + goal(rate(null, "false_names"), 1.0, False),
        ["one cause, drives, 0.3 of the noise: detected", "≥ 80 %"] + goal(rate(study.row("drives_30"), "detected"), 80),
        ["the same, 0.5: right name", "≥ 95 %"] + goal(rate(half, "right"), 95),
        ["the same, 1.0: right name", "≥ 99 %"] + goal(rate(full, "right"), 99),
        ["kinds of causes hidden, all plants", "≥ 24"] + goal(kinds, 24, True, 0, ""),
        ["sets, all plants, 1.0 and more: the truth inside, of what was detected", "≥ 99 %"]
        + goal(100.0 * sum(inside) / max(1, len(inside)), 99),
        ["the same: mean size", "≤ 1.2"]
        + goal(sum(len(s["members"]) for s in sets) / max(1, len(sets)), 1.2, False, 2, ""),
        ["two causes, drives, 1.0: exactly right", "≥ 90 %"] + goal(rate(study.row("drives_two"), "right"), 90),
        ["three causes, drives, 1.0: exactly right", "≥ 75 %"] + goal(rate(study.row("drives_three"), "right"), 75),
        ["outside the library, drives, 1.0: a wrong name", "≤ 5 %"]
        + goal(None if outside is None else 100.0 * outside.false_trials() / outside.count, 5, False),
        ["the same: “none of the known causes”", "≥ 80 %"] + goal(rate(outside, "none_of_the_known"), 80),
        ["inseparable pairs: told as a set", "≥ 95 %"] + goal(as_set, 95),
        ["the same: settled by the motion asked for", "≥ 95 %"] + goal(settled, 95),
        ["confidence: mean distance from what held the truth", "≤ 0.05"]
        + goal(calibration(study)[1], 0.05, False, 3, ""),
        ["planted data faults found, with row and column", "≥ 95 %"] + goal(found, 95),
        ["clean logs suspected", "≤ 1 %"] + goal(alarms, 1, False),
    ]
    body += measured_goals(study)
    for log in study.speed["logs"]:
        body.append([f"a finger's log of {log['seconds_of_log']:.0f} s at 3 kHz, {log['hidden']}", "≤ 10 s"]
                    + goal(log["seconds"], 10, False, 1, " s"))
    memory = study.speed["memory_MB"]
    used = list(memory.values())
    body.append(["memory for a finger's log of " + ", ".join(memory) + " s", "flat",
                 ", ".join(f"{m:.0f} MB" for m in used),
                 "flat from the second on" if used[-1] < 1.1 * used[-2] else "missed"])
    return table(["", "goal", "measured", ""], body)


def rates_file(study, file):
    with open(file, "w", encoding="utf-8", newline="") as out:
        writer = csv.writer(out)
        writer.writerow(["size", "detected", "in the set", "right"])
        for row in sorted(study.of("one", "drives"), key=lambda r: r.size):
            writer.writerow([row.size] + [f"{rate(row, key):.2f}" for key in ("detected", "inside", "right")])


def page(study):
    notes = (pathlib.Path(__file__).parent / "notes.md").read_text(encoding="utf-8")
    planted = [line for line in study.faults if line["what"] == "planted"]
    faults = [[line["kind"], share(line["found"], line["of"])]
              for line in planted if line["found"] < line["of"]]
    always = "; ".join(line["kind"] for line in planted if line["found"] == line["of"])
    bins, error = calibration(study)
    seconds = sum(t["seconds"] for row in study.rows for t in row.trials)
    trials = sum(row.count for row in study.rows)
    parts = [
        "<!-- SPDX-License-Identifier: GPL-3.0-or-later -->\n# Blind trials\n",
        "A seed draws a plant, its motion, its noise and what is hidden; the program gets the nominal "
        "model and the logs alone; the seal is opened after the verdict. The simulators in "
        "`tests/blind/truth` share no code with the models, the effects or the engine (their friction is "
        "LuGre or Bouc–Wen, their integrator their own). The size of a cause is the rms of what it leaves "
        "over, orthogonal to the model's own terms, divided by the noise's. “Right”: a set for each "
        "hidden cause with the right name first, and no other set.\n",
        "Everything but the remarks is run and written by one command "
        f"({trials} trials, {seconds / 3600:.1f} hours of the program's time; what was not run in one go is in "
        "the remarks):\n\n    scripts/study\n",
        "## Goals\n", goal_table(study),
        "## One cause\n", "![rates over the size of a cause](blind_rates.svg)\n", one_cause_table(study),
        "What was told, by cause (a set in braces):\n", confusion_table(study)[0],
        "## Nothing hidden\n", null_table(study),
        "## Several causes, causes outside the library, inseparable pairs\n",
        several_table(study), outside_table(study), pairs_table(study),
        "## Confidence\n",
        f"Sets of all trials that hide what the library has; mean distance {error:.3f}.\n", bins,
        "## Data faults\n", f"Always found, with row and column: {always}.\n",
        table(["planted", "found, with row and column"], faults),
        notes]
    return "\n".join(parts)


def main():
    rows_file, folder, out = (pathlib.Path(argument) for argument in sys.argv[1:4])
    study = Study(rows_file, folder)
    rates_file(study, folder / "rates.csv")
    part = out.with_suffix(".part")
    part.write_text(page(study), encoding="utf-8")
    part.replace(out)


main()
