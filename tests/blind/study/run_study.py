# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the sealed trials and writes the page; scripts/study builds what it needs and calls it."""
import argparse
import concurrent.futures
import datetime
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import threading

import page
import results
import trials

ROOT = pathlib.Path(__file__).resolve().parents[3]


def options():
    parser = argparse.ArgumentParser(prog="scripts/study", description=__doc__)
    parser.add_argument("--program", default="build/release/cli/sinew",
                        help="any program with the command line of `sinew diagnose`")
    parser.add_argument("--rows", default="tests/blind/study/rows.csv", help="list of trials")
    parser.add_argument("--full", action="store_true", help="ten times as many trials")
    parser.add_argument("--share", type=float, default=1.0, help="of the trials, the first of every row")
    parser.add_argument("--plant", action="append", help="this plant alone (repeatable)")
    parser.add_argument("--out", default="docs/blind_rates.md", help="the page; its picture beside it")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--limit", type=float, default=600.0, help="seconds for one diagnosis")
    parser.add_argument("--seeds", help="seed list: a hash that another study printed, or a word; the same "
                        "trials for two programs")
    parser.add_argument("--no-physical", action="store_true", help="names alone: adopted models are not judged")
    parser.add_argument("--only-page", action="store_true", help="write the page from what has been run")
    return parser.parse_args()


def wanted(chosen, digest):
    table = trials.rows(ROOT / chosen.rows, 10 if chosen.full else 1)
    if chosen.plant:
        table = [r for r in table if r[0] in chosen.plant]
    table = trials.in_turn(table, trials.causes_of(ROOT / "tests/blind/study/causes.csv"))
    return shortened(trials.listed(digest, table), chosen.share)


def shortened(everything, share):
    """The first of every row as listed, so many of them; one at least of each."""
    rows = {}
    for trial in everything:
        rows.setdefault((trial["plant"], trial["family"], trial["size"], trial["logs"],
                         trials.EACH if trial["each"] else trial["cause"]), []).append(trial)
    kept = {id(t) for row in rows.values() for t in row[:max(1, round(share * len(row)))]}
    return [t for t in everything if id(t) in kept]


def run(chosen, tools, todo, file, done, total):
    """Trials in parallel; each is a line that is written whole before the next."""
    lock, number = threading.Lock(), [done]
    work = pathlib.Path(tempfile.mkdtemp(prefix="sinew-study-"))

    def one(numbered):
        index, trial = numbered
        line = trials.run_trial(tools, trial, work / f"{index:06d}")
        with lock:
            with open(file, "a", encoding="utf-8") as out:
                out.write(json.dumps(line) + "\n")
            number[0] += 1
            print(f"{number[0]} of {total}: {line['trial']} {line['status']}", flush=True)

    try:
        with concurrent.futures.ThreadPoolExecutor(chosen.jobs) as pool:
            for finished in concurrent.futures.as_completed([pool.submit(one, t) for t in enumerate(todo)]):
                if finished.exception():
                    pool.shutdown(cancel_futures=True)
                    raise finished.exception()
    finally:
        shutil.rmtree(work, ignore_errors=True)


def main():
    chosen = options()
    os.chdir(ROOT)
    engine = trials.engine_hash(ROOT)
    digest = chosen.seeds or engine
    program = pathlib.Path(shutil.which(chosen.program) or chosen.program).resolve()
    program_hash = hashlib.sha256(program.read_bytes()).hexdigest()
    folder = ROOT / "build" / "study" / digest[:16] / program_hash[:16]
    folder.mkdir(parents=True, exist_ok=True)
    # Programs that are built anew while the study runs do not get into it.
    for name, source in (("program", program), ("sinew_trials", ROOT / "build/release/tests/blind/truth/sinew_trials"),
                         ("sinew", ROOT / "build/release/cli/sinew")):
        if not (folder / name).exists():
            shutil.copy2(source, folder / name)
    tools = {"program": folder / "program", "drawer": folder / "sinew_trials", "sinew": folder / "sinew",
             "runtime": ROOT / "runtime", "limit": chosen.limit, "physical": not chosen.no_physical}
    file = folder / "results.jsonl"
    everything = wanted(chosen, digest)
    there = {line["trial"] for line in results.read(file)}
    todo = [t for t in everything if trials.name_of(t) not in there]
    if not chosen.only_page:
        run(chosen, tools, todo, file, len(everything) - len(todo), len(everything))
    names = {trials.name_of(t) for t in everything}
    lines = [line for line in results.read(file) if line["trial"] in names]
    limits = subprocess.run([tools["drawer"], "limits"], capture_output=True, text=True, check=True).stdout
    facts = {"engine": engine + ("" if digest == engine else f"`, seeds of `{digest}"), "program": program_hash[:16],
             "date": datetime.date.today().isoformat(), "wanted": len(everything),
             "command": " ".join(["scripts/study", *sys.argv[1:]])}
    out = pathlib.Path(chosen.out)
    if lines and all(line["family"] == "drives" for line in lines):
        out.write_text(page.of_bare_arms(lines, facts), encoding="utf-8")
        return
    own = "blind_causes" if out.stem == "blind_rates" else out.stem + "_causes"
    facts |= {"rates": out.with_suffix(".svg").name, "causes": own + ".svg"}
    out.write_text(page.written(lines, facts, limits), encoding="utf-8")
    out.with_name(facts["rates"]).write_text(page.picture(lines), encoding="utf-8")
    out.with_name(facts["causes"]).write_text(page.picture_of_causes(lines), encoding="utf-8")
    print(f"{len(lines)} of {len(everything)} trials: {out}")


if __name__ == "__main__":
    main()
