# SPDX-License-Identifier: GPL-3.0-or-later
"""The study's page and its picture."""
import collections
import html
import math

from results import by, calibration, cause_of, counted, of, rate, said, status

PLANTS = {"drive": "drives", "mujoco_drive": "drives (MuJoCo)", "joint": "lone joints", "arm": "arms, 2–7 joints",
          "mujoco_arm": "arms (MuJoCo)", "mujoco_bare_arm": "seven joints, no drives in the model (MuJoCo)",
          "mujoco_bare_slide": "three joints, one slides, no drives in the model (MuJoCo)", "finger": "fingers on tendons",
          "mujoco_finger": "fingers (MuJoCo)", "hand": "hands, palm held", "lever": "levers", "wrist": "wrists"}
TEN = 10  # trials of a cause at least
# right at 1.0 and at 0.5 of the noise
GOALS = {"drive": (0.97, 0.90), "joint": (0.97, 0.90), "arm": (0.97, 0.90), "finger": (0.90, 0.75),
         "hand": (0.90, 0.75), "lever": (0.90, 0.75), "wrist": (0.90, 0.75)}


def table(header, rows):
    if not rows:
        return "None was run.\n"
    lines = ["| " + " | ".join(header) + " |", "|" + " --- |" * len(header)]
    return "\n".join(lines + ["| " + " | ".join(str(c) for c in row) + " |" for row in rows]) + "\n"


def with_mechanics(lines, plant):
    """A plant's trials, MuJoCo's with them."""
    return [line for line in lines if line["plant"] in (plant, "mujoco_" + plant)]


def ended(lines):
    return [status(lines, "unreachable"), status(lines, "refused"), status(lines, "crashed")]


def met(r, goal, at_most=False):
    if r.trials == 0:
        return "not run"
    good = r.share <= goal if at_most else r.share >= goal
    open_ = r.low < goal < r.high
    return ("met" if good else "missed") + (", within its interval" if open_ else "")


def goals(lines):
    rows = []
    for plant, (one, half) in GOALS.items():
        mine = with_mechanics(lines, plant)
        null = rate(counted(of(mine, family="null")), lambda x: x.get("false_names", 0) > 0)
        rows.append([PLANTS[plant], "nothing hidden: a false name", "≤ 1 %", null, met(null, 0.01, True)])
        for size, goal in ((1.0, one), (0.5, half)):
            r = rate(counted(of(mine, family="one", size=size)), said("right"))
            rows.append([PLANTS[plant], f"one cause at {size:g}: right", f"≥ {100 * goal:.0f} %", r, met(r, goal)])
        two = rate(counted(of(mine, family="two")), said("right"))
        rows.append([PLANTS[plant], "two causes at 1: right", "≥ 90 %", two, met(two, 0.9)])
        out = counted(of(mine, family="outside"))
        wrong, none = rate(out, lambda x: x.get("false_names", 0) > 0), rate(out, said("none_of_the_known"))
        rows.append([PLANTS[plant], "outside the library: a wrong name", "≤ 5 %", wrong, met(wrong, 0.05, True)])
        rows.append([PLANTS[plant], "outside: “none of the known causes”", "≥ 80 %", none, met(none, 0.8)])
        fault = rate(of(mine, family="fault"), said("fault_found"))
        rows.append([PLANTS[plant], "fault of the data: found, channel named", "≥ 95 %", fault, met(fault, 0.95)])
    some = [x for x in counted(of(lines, family="one")) if x["size"] >= 1 and x.get("detected")]
    inside = rate(some, said("inside"))
    rows.append(["all", "sets at 1 and more: the truth inside, of what was detected", "≥ 99 %", inside, met(inside, 0.99)])
    # A pair is to be told as a set: it makes none of those that ought to be one name.
    separable = [x for x in lines if x["family"] != "pair"]
    members = [len(s) for x in counted(separable) for s in x.get("sets", [])]
    if members:
        mean = sum(members) / len(members)
        rows.append(["all", "mean size of a set", "≤ 1.3", f"{mean:.2f}", "met" if mean <= 1.3 else "missed"])
    parameters = [p for x in separable for p in x.get("parameters", [])]
    r = rate(parameters, lambda p: p["holds"])
    rows.append(["all", "95 % intervals that hold the truth", "93–97 %", r, "met" if r.trials and 0.93 <= r.share <= 0.97 else "missed" if r.trials else "not run"])
    judged = [x["physical"] for x in lines if x.get("physical")]
    gains = rate([p["gain"] for p in judged if p.get("gain")], lambda g: abs(g["recomputed"] - g["told"]) <= 0.02)
    rows.append(["all", "held-out gain told and recomputed: within 2 points", "100 %", gains, met(gains, 1.0)])
    bodies = rate([p for p in judged if p["bodies"] is not None], lambda p: p["bodies"])
    matrix = rate([p for p in judged if p["mass_matrix"] is not None], lambda p: p["mass_matrix"])
    better = rate([b <= 1.02 * a for p in judged if p["simulation"] for a, b in p["simulation"].values()], bool)
    rows.append(["all", "adopted models: every body possible", "100 %", bodies, met(bodies, 1.0)])
    rows.append(["all", "adopted models: mass matrix positive definite", "100 %", matrix, met(matrix, 1.0)])
    rows.append(["all", "simulation after adoption: a channel no worse", "100 %", better, met(better, 1.0)])
    for plant in ("drive", "joint"):
        pairs = counted(of(lines, plant=plant, family="pair"))
        if not pairs:
            continue
        told = rate(pairs, pair("told"))
        rows.append([PLANTS[plant], "a pair that the log cannot tell apart: told as one", "≥ 95 %", told, met(told, 0.95)])
        left = rate([x for x in pairs if pair("told")(x)], pair("settled"))
        rows.append([PLANTS[plant], "pairs told: after the proposed motion the right one alone", "≥ 90 %", left, met(left, 0.9)])
    alarms = rate(counted(of(lines, family="null")), lambda x: x.get("alarms", 0) > 0)
    rows.append(["all", "nothing hidden: a fault of the data told", "≤ 1 %", alarms, met(alarms, 0.01, True)])
    faults = of(lines, family="fault")
    adopted = rate(faults, said("adopted"))
    rows.append(["all", "fault of the data: adopted as a model", "0 %", adopted, met(adopted, 0.0, True)])
    return table(["plant", "", "goal", "measured (95 % interval)", ""], rows)


def pair(what):
    return lambda x: x.get("pair", {}).get(what, False)


def pairs(lines):
    rows = []
    for plant, name in PLANTS.items():
        for motion, some in by(of(lines, plant=plant, family="pair"), lambda x: x["seal"]["traits"]["motion"]).items():
            n = counted(some)
            told = [x for x in n if pair("told")(x)]
            after = sorted({"{" + ", ".join(s) + "}" for x in told if not pair("settled")(x)
                            for s in x["pair"].get("after", []) if not isinstance(s, str)})
            rows.append([name, motion, len(n), rate(n, said("inside")), rate(n, pair("told")), rate(told, pair("proposed")),
                         rate(told, pair("settled")), *ended(some), html.escape("; ".join(after[:3]))])
    return table(["plant", "motion", "trials", "in the set", "told as a pair", "a motion proposed", "then the right one alone",
                  "unreachable", "refused", "crashed", "left instead"], rows)


def singles(lines):
    rows = []
    for plant, name in PLANTS.items():
        for size, some in by(of(lines, plant=plant, family="one"), lambda x: x["size"]).items():
            n = counted(some)
            rows.append([name, f"{size:g}", len(n), rate(n, said("detected")), rate(n, said("inside")),
                         rate(n, said("right")), rate(n, lambda x: x.get("false_names", 0) > 0), *ended(some)])
    return table(["one cause", "size", "trials", "detected", "in the set", "right", "with a false name",
                  "unreachable", "refused", "crashed"], rows)


NATS = (0, 12, 25, 50, 100, 400, float("inf"))


def evidence(lines):
    """One cause, by what there is to be seen of it."""
    known = [x for x in counted(of(lines, family="one")) if "nats" in (x["seal"].get("hidden") or [{}])[0]]
    rows = []
    for low, high in zip(NATS, NATS[1:]):
        some = [x for x in known if low <= x["seal"]["hidden"][0]["nats"] < high]
        missed = collections.Counter(cause_of(x) for x in some if not x.get("right"))
        rows.append([f"{low} to {high}" if math.isfinite(high) else f"{low} and more", len(some), rate(some, said("detected")),
                     rate(some, said("inside")), rate(some, said("right")),
                     ", ".join(f"{cause} ({n})" for cause, n in missed.most_common(6))])
    return table(["nats", "trials", "detected", "in the set", "right", "not right, most often"], rows)


def families(lines):
    rows = []
    words = {"null": "nothing", "two": "two causes", "outside": "outside the library", "fault": "a fault of the data"}
    for family, word in words.items():
        for plant, name in PLANTS.items():
            some = of(lines, plant=plant, family=family)
            n = counted(some)
            if not some:
                continue
            rows.append([word, name, len(n), rate(n, said("right")) if family == "two" else "",
                         rate(n, lambda x: x.get("false_names", 0) > 0), rate(n, said("none_of_the_known")),
                         rate(n, said("fault_found")) if family == "fault" else "", *ended(some)])
    return table(["hidden", "plant", "trials", "right", "with a false name", "“none of the known causes”",
                  "fault found", "unreachable", "refused", "crashed"], rows)


def drives(lines):
    """Arms without drives in their models: rotors and friction of every joint are to be learnt."""
    rows = []
    for plant, name in PLANTS.items():
        some = of(lines, plant=plant, family="drives")
        n = [x for x in some if x.get("drives")]
        if not some:
            continue
        judged = [x.get("physical") or {} for x in n if x["adopted"]]
        errors = [e for x in n for e in x["drives"]["errors"].values()]
        rotors = [r for x in n for r in x["drives"]["rotors"].values()]
        left = sorted(100 * after for _, after in errors)
        rows.append([name, len(some), rate(some, lambda x: x["status"] == "ran"), rate(n, said("adopted")),
                     rate(judged, lambda p: p.get("bodies") is True and p.get("mass_matrix") is True),
                     rate(errors, lambda e: e[1] <= e[0]),
                     f"{left[len(left) // 2]:.2g} %, at most {left[-1]:.2g} %" if left else "",
                     rate(rotors, lambda r: r is not None and abs(r - 1) <= 0.05),
                     rate(n, lambda x: any(s[0].startswith("payload@") for s in x["sets"])),
                     f"{sum(x['took'] for x in n) / len(n):.0f} s" if n else "", *ended(some)])
    return table(["plant", "trials", "a report", "adopted", "bodies and mass matrix possible", "joints no worse",
                  "left of a joint's standard deviation", "rotors within 5 %", "told a payload; none carries one", "took", "unreachable", "refused",
                  "crashed"], rows)


def causes(lines):
    rows = []
    for plant, name in PLANTS.items():
        for cause, some in by(of(lines, plant=plant, family="one"), cause_of).items():
            n = counted(some)
            told = by([x for x in n if not x.get("right")],
                      lambda x: "; ".join("{" + ", ".join(s) + "}" for s in x.get("sets", []))
                      or ("nothing" if not x.get("none_of_the_known") else "none of the known") if x["status"] == "ran" else x["status"])
            sizes = [f"{sum(bool(x.get('right')) for x in v)}/{len(v)}" for v in
                     (of(n, size=s) for s in (0.3, 0.5, 1.0, 2.0))]
            rows.append([name, cause, *sizes, rate(n, said("right")), status(some, "unreachable"),
                         "; ".join(f"{html.escape(k)} ({len(v)})" for k, v in list(told.items())[:4])])
    return table(["plant", "cause", "right at 0.3", "0.5", "1", "2", "all", "unreachable", "told instead"], rows)


def too_few(lines):
    """Which causes have fewer than ten trials that were reachable."""
    rows = []
    for plant, name in PLANTS.items():
        if plant not in GOALS:
            continue
        found = by(of(lines, plant=plant, family="one"), cause_of)
        few = [f"{cause} ({len(counted(some))})" for cause, some in found.items() if len(counted(some)) < TEN]
        if few:
            rows.append(f"- {name}, {len(few)} of {len(found)}: {', '.join(few)}")
    if not rows:
        return "Every cause that a plant offers has ten trials or more.\n"
    return ("Fewer than ten trials, so that a rate says little: where 90 minutes on two cores do not do (`--full` draws "
            "ten times as many), or where the sizes asked for are unreachable.\n\n" + "\n".join(rows) + "\n")


def outside(lines):
    rows = []
    for plant, name in PLANTS.items():
        for cause, some in by(of(lines, plant=plant, family="outside"), cause_of).items():
            n = counted(some)
            rows.append([name, cause, len(n), rate(n, said("none_of_the_known")),
                         rate(n, lambda x: x.get("false_names", 0) > 0), status(some, "unreachable"),
                         "; ".join(sorted({m for x in n for s in x.get("sets", []) for m in s[:1]})[:4])])
    return table(["plant", "hidden", "trials", "“none of the known causes”", "a wrong name", "unreachable", "named"], rows)


def presliding(lines):
    rows = []
    for plant, name in PLANTS.items():
        for how, some in by([x for x in of(lines, plant=plant) if "pre-sliding" in x["seal"]["traits"]],
                            lambda x: x["seal"]["traits"]["pre-sliding"]).items():
            null, one = counted(of(some, family="null")), counted(of(some, family="one"))
            rows.append([name, how, rate(null, lambda x: x.get("false_names", 0) > 0), rate(one, said("right"))])
    return table(["plant", "pre-sliding", "nothing hidden: a false name", "one cause: right"], rows)


def confidence(lines):
    rows = []
    for plant, name in PLANTS.items():
        told, distance = calibration([x for x in counted(of(lines, plant=plant)) if x["family"] in ("one", "two", "null")])
        if told:
            rows.append([name, "; ".join(f"{c:.2f} → {h:.2f} ({n})" for c, h, n in told), f"{distance:.3f}"])
    return table(["plant", "confidence told → share that holds the truth (sets)", "mean distance"], rows)


def physical(lines):
    rows = []
    for plant, name in PLANTS.items():
        judged = [x["physical"] for x in of(lines, plant=plant) if x.get("physical")]
        if not judged:
            continue
        gains = [p["gain"] for p in judged if p.get("gain")]
        moved = [(a, b) for p in judged if p["simulation"] for a, b in p["simulation"].values() if a]
        parameters = [p for x in of(lines, plant=plant) for p in x.get("parameters", [])]
        ratio = sorted(b / a for a, b in moved)
        rows.append([name, len(judged), rate(gains, lambda g: abs(g["recomputed"] - g["told"]) <= 0.02),
                     f"{ratio[len(ratio) // 2]:.2f}" if ratio else "–",
                     rate([b <= 1.02 * a for a, b in moved], bool),
                     rate([p for p in judged if p["bodies"] is not None], lambda p: p["bodies"]),
                     rate([p for p in judged if p["mass_matrix"] is not None], lambda p: p["mass_matrix"]),
                     rate(parameters, lambda p: p["holds"]), sum("not_judged" in p for p in judged)])
    return table(["plant", "adopted", "gain told and recomputed within 2 points", "simulation's error, after over before (median)",
                  "channels no worse", "bodies possible", "mass matrix", "95 % intervals that hold the truth", "not judged"], rows)


def inertias(lines):
    """One cause at one size in light and in heavy joints: the same rate within its interval."""
    rows = []
    for plant, name in (("joint", "light joints"), ("heavy_joint", "the same joints, twenty times as heavy")):
        for cause, some in by([x for x in of(lines, plant=plant) if x["cause"] and not x.get("each")],
                              lambda x: x["cause"]).items():
            n = counted(some)
            rows.append([name, cause, f"{some[0]['size']:g}", rate(n, said("detected")), rate(n, said("right")),
                         status(some, "unreachable")])
    return table(["", "cause", "size", "detected", "right", "unreachable"], rows)


def standard(everything):
    """Drawn causes, or all in turn, and one log for training: what every table but its own rests on."""
    return [x for x in everything if (not x["cause"] or x.get("each")) and x.get("logs", 1) == 1]


def several_logs(everything):
    """One cause at one size with one log for training and with several."""
    rows = []
    for plant, name in PLANTS.items():
        ones = [x for x in of(everything, plant=plant, family="one") if not x["cause"] or x.get("each")]
        for size in sorted({x["size"] for x in ones if x.get("logs", 1) > 1}):
            for logs, some in by(of(ones, size=size), lambda x: x.get("logs", 1)).items():
                n = counted(some)
                rows.append([name, f"{size:g}", logs, len(n), rate(n, said("detected")), rate(n, said("inside")),
                             rate(n, said("right")), *ended(some)])
    return table(["one cause", "size", "logs for training", "trials", "detected", "in the set", "right",
                  "unreachable", "refused", "crashed"], rows)


def written(everything, facts, limits):
    lines = standard(everything)
    took, drawing, judging = (sum(x.get(k, 0.0) for x in everything) for k in ("took", "drawn_in", "judged_in"))
    parts = [
        "<!-- SPDX-License-Identifier: GPL-3.0-or-later -->\n# Blind trials\n",
        "What a trial is, how large a cause is, and what counts as right stand in [blind_trials.md](blind_trials.md). "
        "This page is written by the study; nothing on it is edited.\n",
        f"Engine: SHA-256 of its sources `{facts['engine']}`; program `{facts['program']}`; {facts['date']}; "
        f"{len(everything)} trials of {facts['wanted']}; {took / 3600:.1f} hours of the program's time, "
        f"{drawing / 3600:.2f} of drawing, {judging / 3600:.2f} of judging what was adopted; command:\n",
        f"    {facts['command']}\n",
        "## Goals\n", goals(lines), "## One cause\n", f"![rates over the size of a cause]({facts.get('rates', 'blind_rates.svg')})\n", singles(lines),
        "By how many nats its log is likelier with the cause than without, to an observer who knows the cause's own "
        "signal and the noise's spectrum; before the log the odds of one cause are one to 100,000, 12 nats.\n",
        evidence(lines),
        "## Nothing, several, outside the library, faults\n", families(lines),
        "## Pairs that a log cannot tell apart\n", pairs(lines),
        "## Each cause\n", f"![rates of each cause]({facts.get('causes', 'blind_causes.svg')})\n", too_few(lines), causes(lines), "## Outside the library\n", outside(lines),
        "## Friction that the log resolves\n", presliding(lines), "## Confidence\n", confidence(lines),
        "## The same size in light and in heavy joints\n", inertias(everything),
        "## Several logs for training\n", several_logs(everything),
        "## Adopted models\n", physical(lines), "## Physical limits\n",
        "A dose beyond these is not drawn; a size that needs one makes the trial unreachable.\n", limits]
    return "\n".join(parts)


def of_bare_arms(lines, facts):
    """The page of trials of the family drives."""
    return "\n".join([
        "<!-- SPDX-License-Identifier: GPL-3.0-or-later -->", "# Arms without drives in their models\n",
        "What is hidden and what counts stand in [blind_trials.md](blind_trials.md). This page is written by the study; "
        "nothing on it is edited.\n",
        f"Engine: SHA-256 of its sources `{facts['engine']}`; program `{facts['program']}`; {facts['date']}; "
        f"{len(lines)} trials of {facts['wanted']}, written by\n", f"    {facts['command']}\n", drives(lines)])


COLOURS = ["#1b6ca8", "#c0392b", "#2e8b57", "#8e44ad", "#d68910", "#34495e", "#16a085"]


def picture(everything):
    """Share of right verdicts over the size, a panel a plant, with 95 % intervals."""
    lines = standard(everything)
    width, height, margin = 210, 150, 34
    shown = [p for p in GOALS if of(lines, plant=p, family="one")]
    per_row = 4
    rows = (len(shown) + per_row - 1) // per_row
    svg = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{per_row * width + 10}" height="{rows * height + 10}" '
           'font-family="sans-serif" font-size="10">', "<!-- SPDX-License-Identifier: GPL-3.0-or-later -->",
           '<rect width="100%" height="100%" fill="white"/>']
    sizes = [0.3, 0.5, 1.0, 2.0]
    for i, plant in enumerate(shown):
        left, top = (i % per_row) * width + margin, (i // per_row) * height + 22
        w, h = width - margin - 12, height - 52
        svg.append(f'<text x="{left}" y="{top - 8}" font-weight="bold">{PLANTS[plant]}</text>')
        for share in (0, 0.5, 1):
            y = top + h * (1 - share)
            svg.append(f'<line x1="{left}" x2="{left + w}" y1="{y}" y2="{y}" stroke="#ddd"/>'
                       f'<text x="{left - 4}" y="{y + 3}" text-anchor="end">{share:g}</text>')
        points = []
        for k, size in enumerate(sizes):
            x = left + w * (k + 0.5) / len(sizes)
            svg.append(f'<text x="{x}" y="{top + h + 14}" text-anchor="middle">{size:g}</text>')
            r = rate(counted(of(lines, plant=plant, family="one", size=size)), said("right"))
            if r.trials:
                y, low, high = (top + h * (1 - s) for s in (r.share, r.low, r.high))
                points.append(f"{x},{y}")
                svg.append(f'<line x1="{x}" x2="{x}" y1="{low}" y2="{high}" stroke="{COLOURS[i % 7]}"/>'
                           f'<circle cx="{x}" cy="{y}" r="3" fill="{COLOURS[i % 7]}"/>')
        svg.append(f'<polyline points="{" ".join(points)}" fill="none" stroke="{COLOURS[i % 7]}"/>')
        svg.append(f'<text x="{left + w / 2}" y="{top + h + 26}" text-anchor="middle">size of the cause, of the noise</text>')
    return "\n".join([*svg, "</svg>"]) + "\n"


def picture_of_causes(everything):
    """Share of right verdicts of each cause, all sizes together, with 95 % intervals, a panel a plant."""
    lines = standard(everything)
    groups = [(name, by(of(lines, plant=plant, family="one"), cause_of)) for plant, name in PLANTS.items() if plant in GOALS]
    groups = [(name, found) for name, found in groups if found]
    row, wide, per_row, label = 13, 330, 3, 130
    bands = [groups[i:i + per_row] for i in range(0, len(groups), per_row)]
    heights = [max(len(found) for _, found in band) * row + 44 for band in bands]
    svg = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{per_row * wide + 10}" height="{sum(heights) + 10}" '
           'font-family="sans-serif" font-size="10">', "<!-- SPDX-License-Identifier: GPL-3.0-or-later -->",
           '<rect width="100%" height="100%" fill="white"/>']
    for b, band in enumerate(bands):
        for i, (name, found) in enumerate(band):
            left, top, w = i * wide + label, sum(heights[:b]) + 30, wide - label - 60
            svg.append(f'<text x="{left}" y="{top - 14}" font-weight="bold">{name}: right, of each cause</text>')
            for share in (0, 0.5, 1):
                x = left + w * share
                svg.append(f'<line x1="{x}" x2="{x}" y1="{top - 6}" y2="{top + len(found) * row}" stroke="#ddd"/>'
                           f'<text x="{x}" y="{top - 5}" text-anchor="middle">{share:g}</text>')
            for k, (cause, some) in enumerate(found.items()):
                r, y = rate(counted(some), said("right")), top + k * row + 8
                svg.append(f'<text x="{left - 6}" y="{y + 3}" text-anchor="end">{html.escape(cause)}</text>'
                           f'<text x="{left + w + 6}" y="{y + 3}">{r.hits} of {r.trials}</text>')
                if r.trials:
                    x, low, high = (left + w * s for s in (r.share, r.low, r.high))
                    svg.append(f'<line x1="{low}" x2="{high}" y1="{y}" y2="{y}" stroke="{COLOURS[(b * per_row + i) % 7]}"/>'
                               f'<circle cx="{x}" cy="{y}" r="3" fill="{COLOURS[(b * per_row + i) % 7]}"/>')
    return "\n".join([*svg, "</svg>"]) + "\n"
