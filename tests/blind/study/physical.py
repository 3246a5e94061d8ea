# SPDX-License-Identifier: GPL-3.0-or-later
"""What was adopted, judged by physics: the held-out gain recomputed from the emitted C, the simulation
before and after, and whether bodies and mass matrix can be."""
import csv
import json
import math
import random
import shutil
import subprocess
import tomllib

import gains
import rigs
from emitted import Emitted


def read_log(file):
    with open(file, encoding="utf-8") as lines:
        rows = csv.reader(lines)
        header = next(rows)
        columns = list(zip(*[[float(x) for x in row] for row in rows]))
    return {name.split(" [")[0]: column for name, column in zip(header, columns)}


def held_out_log(folder, before):
    """Columns by their channels' names."""
    log = read_log(folder / "holdout.csv")
    names_file = before / "channels.toml"
    if not names_file.exists():
        return log
    columns = tomllib.loads(names_file.read_text())["channels"]
    return {**log, **{a: log[b.split(" [")[0]] for a, b in columns.items()}}


def together(was, now):
    """Of several channels each counts in units of what is left of it at best, as findings.md says."""
    before = after = 0.0
    for a, b in zip(was, now):
        squares = [sum(x * x for x in a), sum(x * x for x in b)]
        unit = max(min(squares), 1e-300)
        before, after = before + squares[0] / unit, after + squares[1] / unit
    return 1 - after / before


def gain(tools, folder, findings, c):
    """The held-out gain by the runner's own means, and the one that is told."""
    log = held_out_log(folder, folder.with_name(folder.name + "_before"))
    if "observation" in c.functions:
        was, now = rigs.residuals(log, [gains.before(tools, folder), c])
    elif "effort" in c.functions:
        was, now = gains.residuals(tools, folder, log, findings, c)
    else:
        return None
    return {"recomputed": together(was, now), "told": findings["verdict"]["held_out"]["share"]}


def positive_definite(m, n):
    """Cholesky of a row-major n x n matrix."""
    low = [[0.0] * n for _ in range(n)]
    for i in range(n):
        for j in range(i + 1):
            s = m[i * n + j] - sum(low[i][k] * low[j][k] for k in range(j))
            if i == j:
                if s <= 0:
                    return False
                low[i][i] = math.sqrt(s)
            else:
                low[i][j] = s / low[j][j]
    return True


def mass_matrix_is_possible(c, extra):
    if "mass_matrix" not in c.functions:
        return None
    ranges, call = c.ranges("mass_matrix", "q"), c.caller("mass_matrix")
    n, draw = len(ranges), random.Random(1)
    for _ in range(64):
        m = call([draw.uniform(a, b) for a, b in ranges])
        for j in range(n):
            m[j * n + j] += extra[j] if j < len(extra) else 0.0
        if not positive_definite(m, n):
            return False
    return True


def pseudo_inertia(mass, first, moments):
    """Row-major 4 x 4 of mass, first moments and the inertia xx yy zz xy xz yz about the origin."""
    xx, yy, zz, xy, xz, yz = moments
    t = 0.5 * (xx + yy + zz)
    return [t - xx, -xy, -xz, first[0], -xy, t - yy, -yz, first[1], -xz, -yz, t - zz, first[2],
            first[0], first[1], first[2], mass]


def cad_body(row):
    mass = float(row["mass [kg]"])
    c = [float(row[f"com_{a} [m]"]) for a in "xyz"]
    i = {k: float(row[f"i{k} [kg*m^2]"]) for k in ("xx", "yy", "zz", "xy", "xz", "yz")}
    square = sum(x * x for x in c)
    moments = [i["xx"] + mass * (square - c[0] ** 2), i["yy"] + mass * (square - c[1] ** 2),
               i["zz"] + mass * (square - c[2] ** 2), i["xy"] - mass * c[0] * c[1],
               i["xz"] - mass * c[0] * c[2], i["yz"] - mass * c[1] * c[2]]
    return mass, [mass * x for x in c], moments


def links_of(model):
    """Rows of the mass properties by link; of a hand those of its fingers, which stand beside it."""
    tables = {"": model / "mass_properties.csv"}
    if (model / "hand.toml").exists():
        fingers = tomllib.loads((model / "hand.toml").read_text())["finger"]
        tables = {(model / f["model"]).name + "_": model / f["model"] / "mass_properties.csv" for f in fingers}
    rows = {}
    for before, table in tables.items():
        if table.exists():
            with open(table, encoding="utf-8") as lines:
                rows.update({before + row["link"]: row for row in csv.DictReader(lines)})
    return rows


def bodies_are_possible(model, effects):
    rows = links_of(model)
    if not rows:
        return None
    for effect in effects:
        link = effect["place"].removeprefix("link ")
        if effect["effect"] not in ("payload", "inertial_parameters") or link not in rows:
            continue
        mass, first, moments = cad_body(rows[link])
        change = {c["name"]: c["value"] for c in effect["coefficient"]}
        if not any(name.startswith("moment_") for name in change):
            # docs/model_files.md: the link keeps its shape, a payload is a point.
            if mass + change["mass"] <= 0.0 or (effect["effect"] == "payload" and change["mass"] < 0.0):
                return False
            continue
        mass += change["mass"]
        first = [f + change.get(f"first_moment_{a}", 0.0) for f, a in zip(first, "xyz")]
        moments = [m + change.get(f"moment_{a}", 0.0)
                   for m, a in zip(moments, ("xx", "yy", "zz", "xy", "xz", "yz"))]
        j = pseudo_inertia(mass, first, moments)
        margin = 1e-9 * (j[0] + j[5] + j[10] + j[15])
        if not positive_definite([x + (margin if k % 5 == 0 else 0.0) for k, x in enumerate(j)], 4):
            return False
    return True


def simulated(tools, folder, model):
    """rms deviations of the whole held-out log played again, by channel; empty where it cannot be. By its first
    seconds alone the truth itself is worse than the model without it, now and then: a friction that drifts differs
    from the model's late, and a motion that happens to show little of a cause has its noise decide."""
    done = subprocess.run([tools["sinew"], "simulate", model, "--log", folder / "holdout.csv", "--out",
                           folder / "again.csv", "--json"], capture_output=True, text=True, check=False,
                          timeout=tools["limit"])
    if done.returncode != 0:
        return {}
    return {d["channel"]: d.get("window", d.get("sensor", d.get("open_loop")))
            for d in json.loads(done.stdout)["deviations"]}


def judged(tools, folder, findings):
    """A dictionary for the results' line; what could not be judged is None and says why."""
    result = {"gain": None, "bodies": None, "mass_matrix": None, "simulation": None}
    try:
        model, before = folder / "model", folder.with_name(folder.name + "_before")
        effects = tomllib.loads((model / "identified.toml").read_text()).get("effect", [])
        result["bodies"] = bodies_are_possible(model, effects)
        c = Emitted(next((folder / "found" / "generated").rglob("*_catalogue.c")).parent, tools["runtime"])
        if (model / "mechanism.toml").exists():
            joints = tomllib.loads((model / "mechanism.toml").read_text())["joint"]
            extra = [j.get("armature", {"value": 0.0})["value"] for j in joints]
            for k, joint in enumerate(joints):
                extra[k] += sum(e["coefficient"][0]["value"] for e in effects
                                if e["effect"] == "inertia" and e["place"] == joint["name"])
            result["mass_matrix"] = mass_matrix_is_possible(c, extra)
        # A ripple's phase is an incremental encoder's, and another one in every log.
        if any("ripple" in effect["effect"] for effect in effects):
            return {**result, "phase_of_a_log": True}
        result["gain"] = gain(tools, folder, findings, c)
        # A hand's fingers stand beside it.
        nominal = folder / "nominal"
        shutil.copytree(before, nominal, dirs_exist_ok=True)
        was, now = simulated(tools, folder, nominal), simulated(tools, folder, model)
        result["simulation"] = {n: [was[n], now[n]] for n in was if n in now and was[n] is not None}
    except Exception as error:  # a trial is never lost to its judging
        result["not_judged"] = f"{type(error).__name__}: {error}"[:300]
    return result
