# SPDX-License-Identifier: GPL-3.0-or-later
"""What was adopted, judged by physics: the held-out gain recomputed from the emitted C, the simulation
before and after, and whether bodies and mass matrix can be."""
import csv
import json
import math
import random
import subprocess
import tomllib

import rigs
from emitted import Emitted
from filters import convolved, kernel

BAND, MASKED = 60.0, 0.006  # Hz, s to each side of a reversal at that band, as `sinew diagnose` documents


def read_log(file):
    with open(file, encoding="utf-8") as lines:
        rows = csv.reader(lines)
        header = next(rows)
        columns = list(zip(*[[float(x) for x in row] for row in rows]))
    return {name.split(" [")[0]: column for name, column in zip(header, columns)}


def slope(x, step):
    inner = [(b - a) / (2 * step) for a, b in zip(x, x[2:])]
    return [inner[0], *inner, inner[-1]]


def forces_of(log):
    return [log[n] for n in (f"force_{i}" for i in range(1, 100)) if n in log]


def smoothed_tension(force, step):
    """As terms of a measured force take it: to 5 Hz, the ends held."""
    half = math.ceil(1.2 / (5.0 * step))
    held = [force[0]] * half + list(force) + [force[-1]] * half
    return convolved(held, kernel(step, 1.25 * 5.0, half))


def torques_of_tendons(c, log, joints):
    """Of every joint, -P^T f with the emitted coupling matrix."""
    forces, call, n = forces_of(log), c.caller("coupling_matrix"), len(joints)
    torques = [[] for _ in joints]
    for row in zip(*(log[j] for j in joints), *forces):
        arms = call(row[:n])
        for j, torque in enumerate(torques):
            torque.append(-sum(arms[i * n + j] * f for i, f in enumerate(row[n:])))
    return torques


class Judge:
    """One log through two models of driven joints."""

    def __init__(self, log, names, step, below):
        """below: where noise of a position cuts the comparison [Hz], or None."""
        self.step = step
        cutoff = min(BAND, 0.1 / step, below or BAND)
        half = math.ceil(1.2 / (cutoff * step))
        self.half = half
        weights = kernel(step, 1.25 * cutoff, half)
        self.q = [convolved(log[q], weights) for q, _ in names]
        self.v = [slope(q, step) for q in self.q]
        self.a = [slope(v, step) for v in self.v]
        cut = slice(half, len(log[names[0][0]]) - half)
        self.tau = [log[tau][cut] for _, tau in names]
        self.load = log["load"][cut] if "load" in log else None
        self.tension = list(zip(*(smoothed_tension(f, step)[cut] for f in forces_of(log))))
        self.band = cutoff

    def residual(self, effort):
        """effort: from q, v, a, load of a row to a list of efforts; called row by row."""
        rows = range(len(self.tau[0]))
        said = [effort([q[k] for q in self.q], [v[k] for v in self.v], [a[k] for a in self.a],
                       self.load[k] if self.load else 0.0, *self.tension[k:k + 1]) for k in rows]
        half = math.ceil(3.3 / (self.band * self.step) / 2)
        every = max(1, int(1.0 / (2.5 * self.band * self.step)))
        weights = kernel(self.step, 1.25 * self.band, half)
        result = []
        for j, tau in enumerate(self.tau):
            left = convolved([t - s[j] for t, s in zip(tau, said)], weights, every)
            moving = self.moving(j)[half:len(tau) - half:every]
            result.append([x for x, m in zip(left, moving) if m] or left)
        return result

    def moving(self, j):
        v = self.v[j]
        slow, reach = 0.01 * max(abs(x) for x in v), math.ceil(MASKED * BAND / self.band / self.step)
        moves = [True] * len(v)
        for k in range(len(v)):
            if abs(v[k]) <= slow or (k and v[k] * v[k - 1] <= 0):
                for i in range(max(0, k - reach), min(len(v), k + reach + 1)):
                    moves[i] = False
        return moves


def driven(folder):
    """Joints that follow no other one."""
    mechanism = tomllib.loads((folder / "mechanism.toml").read_text())
    follow = {c["dependent"] for c in mechanism.get("coupling", [])}
    return [j for j in mechanism["joint"] if j["name"] not in follow]


def nominal(folder, tools):
    """The effort of the model as it was, its friction by the documented law."""
    part = folder / "part.toml"
    if part.exists():
        m = {k: v["value"] for k, v in tomllib.loads(part.read_text())["motor"].items() if isinstance(v, dict)}
        inertia = m["rotor_inertia"] / m["gear_ratio"] ** 2 + m["gearbox_inertia"]
        return lambda q, v, a, load, *_: [inertia * a[0] + m["gamma2"] * math.atan(m["gamma1"] * v[0])
                                      + m["gamma3"] * v[0] + load]
    subprocess.run([tools["sinew"], "generate", folder, "--out", folder / "generated"], check=True,
                   capture_output=True)
    c = Emitted(next((folder / "generated").rglob("*_catalogue.c")).parent, tools["runtime"])
    call = c.caller("inverse_dynamics")
    joints = driven(folder)

    def value(joint, key):
        return joint[key]["value"] if key in joint else 0.0

    def friction(joint, v):
        speed = value(joint, "friction_speed")
        side = 2 / math.pi * math.atan(v / speed) if speed else (v > 0) - (v < 0)
        return value(joint, "friction") * side + value(joint, "damping") * v

    def effort(q, v, a, load, *_):
        return [t + friction(j, w) + value(j, "armature") * b + load
                for t, j, w, b in zip(call([*q, *v, *a]), joints, v, a)]
    return effort


def extended(c, step):
    """The emitted extended effort, with the states that it keeps; None where it takes what a log of
    joints does not have."""
    names = c.inputs("effort")
    if any(n not in ("q", "qd", "qdd", "load", "tension", "step", "memory") for n, _ in names):
        return None
    call = c.caller("effort")
    sizes = dict(names)
    memory = [0.0] * sizes.get("memory", 0)

    def effort(q, v, a, load, tension=()):
        given = {"q": q, "qd": v, "qdd": a, "load": [load] + [0.0] * (sizes.get("load", 1) - 1),
                 "tension": tension, "step": [step], "memory": memory}
        result = call([x for n, _ in names for x in given[n]])
        memory[:] = result[len(q):len(q) + len(memory)]
        return result[:len(q)]
    return effort


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
    before = folder.with_name(folder.name + "_before")
    if (before / "hand.toml").exists():
        return None
    log = held_out_log(folder, before)
    if (before / "part.toml").exists():
        names = [("theta", "tau_m")]
    elif "x" in log:
        names = [("x", "f")]
    else:
        joints = [j["name"] for j in driven(before)]
        # Motors of tendons are channels of their own, and no joints.
        if forces_of(log) and "theta_1" not in log:
            log.update({f"q_{j}": log[j] for j in joints})
            log.update({f"tau_{j}": t for j, t in zip(joints, torques_of_tendons(c, log, joints))})
        names = [(f"q_{j}", f"tau_{j}") for j in joints]
    if any(n not in log for pair in names for n in pair):
        return None
    step = log["time"][1] - log["time"][0]
    after = extended(c, step)
    if after is None:
        return None
    judge = Judge(log, names, step, findings["verdict"]["compared_below_hz"])
    was, now = judge.residual(nominal(before, tools)), judge.residual(after)
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


def bodies_are_possible(model, effects):
    table = model / "mass_properties.csv"
    if not table.exists():
        return None
    with open(table, encoding="utf-8") as lines:
        rows = {row["link"]: row for row in csv.DictReader(lines)}
    for effect in effects:
        link = effect["place"].removeprefix("link ")
        if effect["effect"] not in ("payload", "inertial_parameters") or link not in rows:
            continue
        mass, first, moments = cad_body(rows[link])
        change = {c["name"]: c["value"] for c in effect["coefficient"]}
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
    """rms deviations of the held-out log played again, by channel; empty where it cannot be."""
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
        if "observation" in c.functions:
            log = held_out_log(folder, before)
            result["gain"] = {"recomputed": together(*rigs.residuals(tools, folder, log, c)),
                              "told": findings["verdict"]["held_out"]["share"]}
        elif "effort" in c.functions:
            result["gain"] = gain(tools, folder, findings, c)
        was, now = simulated(tools, folder, before), simulated(tools, folder, model)
        result["simulation"] = {n: [was[n], now[n]] for n in was if n in now and was[n] is not None}
    except Exception as error:  # a trial is never lost to its judging
        result["not_judged"] = f"{type(error).__name__}: {error}"[:300]
    return result
