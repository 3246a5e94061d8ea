# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws sealed trials, runs a program on them and opens the seals: a trial's seal is in this process's
memory alone until the program has ended."""
import csv
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import time

import physical
import score

ENGINE = ("symbolic", "generator", "identification", "simulation", "runtime", "cli")
SUFFIXES = {".cpp", ".h", ".c", ".txt"}
EACH = "each"  # a row of as many trials of every cause
FIRST_SEED = 10**6  # below it is development's
ALLOWED = re.compile(r"(train[23]?|holdout)\.csv|(model|motor|wrist|bar|f\d)/"
                     r"(mechanism\.toml|mass_properties\.csv|part\.toml|hand\.toml|channels\.toml)")


class Leak(Exception):
    """Something that the program can see says what is hidden."""


def engine_hash(root):
    """SHA-256 of the engine's sources, names and contents."""
    total = hashlib.sha256()
    for room in ENGINE:
        for file in sorted((root / room).rglob("*")):
            if file.suffix in SUFFIXES and file.is_file():
                total.update(str(file.relative_to(root)).encode() + b"\0" + file.read_bytes() + b"\0")
    return total.hexdigest()


def read_table(file):
    with open(file, encoding="utf-8") as lines:
        return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def causes_of(file):
    """Of each plant, what it offers."""
    offered = {}
    for r in read_table(file):
        offered.setdefault(r["plant"], []).append(r["cause"])
    return offered


def rows(file, times):
    return [(r["plant"], r["family"], float(r["size"]), int(r["trials"]) * times, r["cause"], int(r["logs"] or 1))
            for r in read_table(file)]


def in_turn(table, offered):
    """A row of every cause is as many rows, each of one; the last two say which of how many."""
    result = []
    for plant, family, size, count, cause, logs in table:
        each = offered[plant] if cause == EACH else [cause]
        result += [(plant, family, size, count, c, logs, i, len(each)) for i, c in enumerate(each)]
    return result


def seed_of(digest, plant, family, size, number, cause="", logs=1):
    text = f"{digest}/{plant}/{family}/{size:g}/{number}/{cause}" + (f"/{logs}" if logs > 1 else "")
    return FIRST_SEED + int(hashlib.sha256(text.encode()).hexdigest()[:12], 16)


def listed(digest, table):
    """All trials of rows in turn, mixed so that a study that is stopped has some of every row."""
    trials = [((number + which / many) / count, plant, family, size, number, cause, logs, many > 1)
              for plant, family, size, count, cause, logs, which, many in table for number in range(count)]
    trials.sort()
    return [{"plant": p, "family": f, "size": s, "number": n, "cause": c, "logs": m, "each": e,
             "seed": seed_of(digest, p, f, s, n, c + (" in turn" if e else ""), m)}
            for _, p, f, s, n, c, m, e in trials]


def name_of(trial):
    logs = f"/{trial['logs']} logs" if trial["logs"] > 1 else ""
    cause = (trial["cause"] or "drawn") + (" in turn" if trial.get("each") else "")
    return f"{trial['plant']}/{trial['family']}/{trial['size']:g}/{cause}/{trial['number']}{logs}"


def check_sealed(folder, seal):
    """The program sees models and logs, and nothing else; neither names nor texts say what is hidden."""
    words = {h["cause"] for h in seal["hidden"]} | {"seal", "hidden", "unreachable"}
    if any(w in part for part in folder.parts[-2:] for w in words):
        raise Leak(f"{folder}: the folder's name tells")
    for file in folder.rglob("*"):
        if file.is_dir():
            continue
        local = file.relative_to(folder).as_posix()
        if not ALLOWED.fullmatch(local):
            raise Leak(f"{file}: no part of a model or a log")
        # What a model's own keys are called says nothing: every model has a gravity.
        head = re.sub(r"^[\w.]+ *=", "", file.read_text(encoding="utf-8"), flags=re.M) if file.suffix == ".toml" else ""
        if file.suffix == ".csv":
            with open(file, encoding="utf-8") as lines:
                head = lines.readline()
        for w in words:
            if re.search(rf"\b{re.escape(w)}\b", head):
                raise Leak(f"{file}: says '{w}'")


def drawing(trial):
    """What a trial is drawn by, as words of the command line."""
    return ["--plant", trial["plant"], "--family", trial["family"], "--size", str(trial["size"]), "--seed",
            str(trial["seed"]), "--cause", trial["cause"], "--logs", str(trial["logs"])]


def drawn(drawer, trial, folder):
    done = subprocess.run([drawer, "draw", *drawing(trial), "--folder", folder], capture_output=True, text=True,
                          check=False)
    if done.returncode != 0:
        raise RuntimeError(f"{name_of(trial)} cannot be drawn: {done.stderr.strip()}")
    return json.loads(done.stdout)


def columns_of(folder):
    """Channel -> the recorder's column."""
    file = folder / "model" / "channels.toml"
    if not file.exists():
        return {}
    return {a: b.split(" ")[0] for a, b in
            re.findall(r'^"([^"]+)" = "([^"]+)"', file.read_text(encoding="utf-8"), re.M)}


def training_logs(folder, logs):
    """As the command line names them; a trial with fewer or more is none."""
    files = sorted(f.name for f in folder.glob("train*.csv"))
    if len(files) != logs:
        raise score.BrokenTrial(f"{len(files)} logs for training, asked for {logs}")
    return [word for file in files for word in ("--log", file)]


def run_program(program, folder, limit, logs=1):
    """The exit status (None: it took longer than the limit), findings or None, what it says of errors."""
    command = [program, "diagnose", "model", *training_logs(folder, logs), "--holdout", "holdout.csv", "--out",
               "found", "--json"]
    environment = {k: os.environ[k] for k in ("PATH", "HOME", "TMPDIR", "LANG", "SINEW_CACHE_DIR")
                   if k in os.environ}
    try:
        done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True,
                              timeout=limit, check=False)
    except subprocess.TimeoutExpired:
        return None, None, f"took longer than {limit} s"
    findings = None
    if done.returncode in (0, 1):
        try:
            findings = json.loads(done.stdout)
        except ValueError:
            return -1, None, "no findings: " + done.stderr[-500:]
    return done.returncode, findings, done.stderr if findings else errors_told(done.stdout, done.stderr)


def errors_told(output, error):
    """With --json a refusal is on standard output: a line each, "file:row:column: what"."""
    try:
        told = json.loads(output)["errors"]
    except (ValueError, KeyError, TypeError):
        return error
    return "\n".join(":".join(str(e.get(k) or 0) for k in ("file", "line", "column")) + ": " + e["message"]
                     for e in told)


def proposed_motion(findings):
    """The file beside the findings that the program proposes to play; empty: none."""
    return next((c["separating_motion"] for c in findings["verdict"]["causes"] if c.get("separating_motion")), "")


def settle(tools, trial, folder, seal, findings):
    """What became of a pair: told as one; the motion that the program proposes is played by the truth's own plant,
    and the program has its log beside the first one, and the model as it was."""
    motion = proposed_motion(findings)
    result = {"told": score.pair_told(seal, findings), "proposed": bool(motion), "settled": False}
    if not result["told"] or not motion:
        return result
    with tempfile.TemporaryDirectory() as beside:
        played = pathlib.Path(beside) / "motion.csv"
        shutil.copy2(folder / "found" / motion, played)
        for made in ("found", "model"):
            shutil.rmtree(folder / made)
        shutil.copytree(folder.with_name(folder.name + "_before"), folder / "model")
        # A plant is the same whenever its seed is asked for.
        done = subprocess.run([tools["drawer"], "play", *drawing(trial), "--motion", played, "--out",
                               folder / "train2.csv"], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"{name_of(trial)} cannot play what is proposed: {done.stderr.strip()}")
    check_sealed(folder, seal)
    status, second, error = run_program(tools["program"], folder, tools["limit"], 2)
    if second is None:
        return {**result, "after": "refused" if status == 2 else "crashed", "error": error[-600:]}
    return {**result, "settled": score.settled(seal, second), "after": score.score(seal, second)["sets"]}


def run_trial(tools, trial, place):
    """One line of results. tools: drawer, program, limit [s], runtime, physical."""
    folder = pathlib.Path(place)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    line = {"trial": name_of(trial), **trial, "status": "ran"}
    try:
        started = time.monotonic()
        seal = drawn(tools["drawer"], trial, folder)
        line["drawn_in"] = time.monotonic() - started
        score.check_seal(seal, trial["family"], trial["size"])
        if not seal["reachable"]:
            return {**line, "status": "unreachable", "seal": seal}
        check_sealed(folder, seal)
        columns = columns_of(folder)
        shutil.copytree(folder / "model", folder.with_name(folder.name + "_before"))
        started = time.monotonic()
        status, findings, error = run_program(tools["program"], folder, tools["limit"], trial["logs"])
        line["took"] = time.monotonic() - started
        # The verdict is there: the seal may be opened.
        line["seal"] = seal
        if trial["family"] == "fault":
            line["fault_found"] = score.fault_found(seal, findings, error, columns)
        if findings is None:
            line["status"] = "refused" if status == 2 else "crashed"
            line["error"] = error[-600:]
            return line
        line.update(score.score(seal, findings))
        line["parameters"] = score.in_interval(seal, findings)
        if trial["family"] == "drives":
            line["drives"] = score.drives_told(seal, findings)
        line["bands_told"] = findings["verdict"].get("compared_below_hz")
        if trial["family"] == "pair":
            started = time.monotonic()
            line["pair"] = settle(tools, trial, folder, seal, findings)
            line["settled_in"] = time.monotonic() - started
        elif line["adopted"] and tools["physical"] and trial["family"] != "fault":
            started = time.monotonic()
            line["physical"] = physical.judged(tools, folder, findings)
            line["judged_in"] = time.monotonic() - started
        return line
    finally:
        shutil.rmtree(folder, ignore_errors=True)
        shutil.rmtree(folder.with_name(folder.name + "_before"), ignore_errors=True)
