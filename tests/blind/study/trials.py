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
import time

import physical
import score

ENGINE = ("symbolic", "generator", "identification", "simulation", "runtime", "cli")
SUFFIXES = {".cpp", ".h", ".c", ".txt"}
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


def rows(file, times):
    with open(file, encoding="utf-8") as lines:
        table = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    return [(r["plant"], r["family"], float(r["size"]), int(r["trials"]) * times, r["cause"], int(r["logs"] or 1))
            for r in table]


def seed_of(digest, plant, family, size, number, cause="", logs=1):
    text = f"{digest}/{plant}/{family}/{size:g}/{number}/{cause}" + (f"/{logs}" if logs > 1 else "")
    return FIRST_SEED + int(hashlib.sha256(text.encode()).hexdigest()[:12], 16)


def listed(digest, table):
    """All trials, mixed so that a study that is stopped has some of every row."""
    trials = [(number / count, plant, family, size, number, cause, logs)
              for plant, family, size, count, cause, logs in table for number in range(count)]
    trials.sort()
    return [{"plant": p, "family": f, "size": s, "number": n, "cause": c, "logs": m,
             "seed": seed_of(digest, p, f, s, n, c, m)} for _, p, f, s, n, c, m in trials]


def name_of(trial):
    logs = f"/{trial['logs']} logs" if trial["logs"] > 1 else ""
    return f"{trial['plant']}/{trial['family']}/{trial['size']:g}/{trial['cause'] or 'drawn'}/{trial['number']}{logs}"


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


def drawn(drawer, trial, folder):
    done = subprocess.run(
        [drawer, "draw", "--plant", trial["plant"], "--family", trial["family"], "--size",
         str(trial["size"]), "--seed", str(trial["seed"]), "--folder", folder, "--cause", trial["cause"],
         "--logs", str(trial["logs"])],
        capture_output=True, text=True, check=False)
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
    """The exit status (None: it took longer than the limit), findings or None, standard error."""
    command = [program, "diagnose", "model", *training_logs(folder, logs), "--holdout", "holdout.csv", "--out",
               "found", "--json"]
    environment = {k: os.environ[k] for k in ("PATH", "HOME", "TMPDIR", "LANG") if k in os.environ}
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
    return done.returncode, findings, done.stderr


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
        line["bands_told"] = findings["verdict"].get("compared_below_hz")
        if line["adopted"] and tools["physical"] and trial["family"] != "fault":
            line["physical"] = physical.judged(tools, folder, findings)
        return line
    finally:
        shutil.rmtree(folder, ignore_errors=True)
        shutil.rmtree(folder.with_name(folder.name + "_before"), ignore_errors=True)
