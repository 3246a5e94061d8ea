# SPDX-License-Identifier: GPL-3.0-or-later
"""long_log.py <sinew> <folder>: how long `sinew diagnose models/index` takes for a log of 60 s at 3 kHz
and how much memory for logs of several lengths; JSON to stdout. The finger is simulated by sinew itself,
its sensors read wrongly afterwards: this is about time, not about what is found."""
import csv
import json
import os
import pathlib
import subprocess
import sys
import time

CHANNELS = [(f"theta_{i + 1}_ref", 0.25 + 0.03 * i, 0.31 + 0.17 * i) for i in range(8)]
NOISE = {"q": (2e-5, "rad"), "theta": (2e-5, "rad"), "tau": (0.01, "N*m"), "force": (0.2, "N")}
# What is hidden, as factors on columns.
WRONG = {"nothing hidden": {}, "one cause": {"force_3": 1.08},
         "six causes": {"force_1": 0.93, "force_3": 1.08, "force_5": 1.06, "force_6": 0.92, "tau_2": 1.1,
                        "tau_7": 0.9}}


def scenario(seconds):
    text = [f"[scenario]\nduration = {{ value = {seconds}, unit = \"s\" }}\n"
            "output_rate = { value = 3000, unit = \"Hz\" }\n",
            "[drive]\nmode = \"servo\"\ngain = { value = 60, unit = \"N*m\" }\n"
            "rate_gain = { value = 2, unit = \"N*m*s/rad\" }\ncompensation = true\n"
            "pretension = { value = 15, unit = \"N\" }\n",
            "[noise]\nseed = { value = 7, unit = \"1\" }\n" + "".join(f"{name} = {{ value = {value}, unit = \"{unit}\" }}\n"
                                            for name, (value, unit) in NOISE.items())]
    for number, (channel, amplitude, frequency) in enumerate(CHANNELS):
        # Antagonists in turn: one lets go what the other takes.
        signed = amplitude if number % 2 == 0 else -CHANNELS[number - 1][1]
        same = CHANNELS[number - number % 2][2]
        text.append(f"[[command]]\nchannel = \"{channel}\"\nshape = \"sine\"\n"
                    f"amplitude = {{ value = {signed}, unit = \"rad\" }}\n"
                    f"frequency = {{ value = {same}, unit = \"Hz\" }}\n")
    return "".join(text)


def simulated(sinew, folder, seconds):
    described = folder / f"scenario_{seconds}.toml"
    described.write_text(scenario(seconds), encoding="utf-8")
    log = folder / f"log_{seconds}.csv"
    subprocess.run([sinew, "simulate", "models/index", "--scenario", described, "--out", log], check=True,
                   stdout=subprocess.DEVNULL)
    return log


def spoilt(log, factors, file):
    with open(log, encoding="utf-8", newline="") as lines, \
            open(file, "w", encoding="utf-8", newline="") as out:
        reader, writer = csv.reader(lines), csv.writer(out)
        header = next(reader)
        writer.writerow(header)
        at = [(i, factors[name.split(" ")[0]]) for i, name in enumerate(header)
              if name.split(" ")[0] in factors]
        for row in reader:
            for i, factor in at:
                row[i] = f"{factor * float(row[i]):.9g}"
            writer.writerow(row)
    return file


def diagnosed(sinew, log):
    """Seconds, MB and how many causes were told."""
    start = time.monotonic()
    process = subprocess.Popen([sinew, "diagnose", "models/index", "--log", log, "--dry-run", "--json",
                                "--out", log.parent / "found"], stdout=subprocess.PIPE, text=True)
    text = process.stdout.read()
    _, status, used = os.wait4(process.pid, 0)
    if os.waitstatus_to_exitcode(status) not in (0, 1):
        sys.exit(f"{log}: diagnose ended with {os.waitstatus_to_exitcode(status)}")
    return time.monotonic() - start, used.ru_maxrss / 1024, len(json.loads(text)["verdict"]["causes"])


def main():
    sinew, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    found = {"logs": [], "memory_MB": {}}
    log = simulated(sinew, folder, 60)
    for hidden, factors in WRONG.items():
        seconds, memory, told = diagnosed(sinew, spoilt(log, factors, folder / "spoilt.csv"))
        found["logs"].append({"hidden": hidden, "seconds_of_log": 60, "seconds": seconds, "told": told})
        if not factors:
            found["memory_MB"]["60"] = memory
    for seconds in (120, 240):
        found["memory_MB"][str(seconds)] = diagnosed(sinew, simulated(sinew, folder, seconds))[1]
    print(json.dumps(found, indent=2))


main()
