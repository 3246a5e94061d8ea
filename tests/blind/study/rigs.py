# SPDX-License-Identifier: GPL-3.0-or-later
"""What levers and wrists leave over of a held-out log: what their sensors should read by the emitted C, as the
model was and as it was extended."""
import math
import re
import shutil
import subprocess

from emitted import Emitted
from filters import convolved, kernel

BAND = 60.0  # Hz, as `sinew diagnose` documents


def without_what_was_learnt(text):
    """identified.toml with every coefficient at zero: its C says what the model said before."""
    return re.sub(r"(\[\[effect\.coefficient\]\]\nname = \"[^\"]*\"\nvalue = )\S+", r"\g<1>0.0", text)


def before(tools, folder):
    model = folder / "unlearnt"
    shutil.rmtree(model, ignore_errors=True)
    shutil.copytree(folder / "model", model)
    file = model / "identified.toml"
    file.write_text(without_what_was_learnt(file.read_text(encoding="utf-8")), encoding="utf-8")
    subprocess.run([tools["sinew"], "generate", model, "--out", model / "generated"], check=True,
                   capture_output=True)
    return Emitted(next((model / "generated").rglob("*_catalogue.c")).parent, tools["runtime"])


def inputs_of(log, names, step):
    """Rows of the observation's inputs but its memory. A rate is that of its own channel."""
    columns = []
    for name, size in names:
        if name == "memory":
            continue
        if name == "step":
            columns.append([step] * len(log["time"]))
        elif name.endswith("_rate"):
            x = log[name.removesuffix("_rate")]
            columns.append([0.0, *((b - a) / step for a, b in zip(x, x[1:]))])
        else:
            columns.append(log.get(name, [0.0] * len(log["time"])))
        if size != 1:
            raise ValueError(f"observation takes {size} numbers for '{name}'")
    return list(zip(*columns))


def said(c, log, step):
    """The observation at every row, a list a channel, with the states that it keeps."""
    names, call = c.inputs("observation"), c.caller("observation")
    size = dict(names).get("memory", 0)
    memory, rows = [0.0] * size, []
    for given in inputs_of(log, names, step):
        result = call([*given, *memory])
        channels = len(result) - size
        memory = result[channels:]
        rows.append(result[:channels])
    return list(zip(*rows))


def left_over(said_by_model, measured, step, free_zero):
    """Behind the documented filter; a motor that counts from anywhere has its zero taken out."""
    band = min(BAND, 0.1 / step)
    half, every = math.ceil(3.3 / (band * step) / 2), max(1, int(1.0 / (2.5 * band * step)))
    weights, result = kernel(step, 1.25 * band, half), []
    for told, seen in zip(said_by_model, measured):
        left = convolved([a - b for a, b in zip(seen, told)], weights, every)
        zero = sum(left) / len(left) if free_zero else 0.0
        result.append([x - zero for x in left])
    return result


def residuals(tools, folder, log, extended):
    """Before and after, a list a channel each."""
    step = log["time"][1] - log["time"][0]
    motors = [n for n in (f"theta_{i}" for i in range(1, 100)) if n in log]
    measured = [log[n] for n in motors or ("force", "elongation") if n in log]
    return [left_over(said(c, log, step), measured, step, bool(motors)) for c in (before(tools, folder), extended)]
