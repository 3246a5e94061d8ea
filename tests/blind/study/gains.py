# SPDX-License-Identifier: GPL-3.0-or-later
"""The held-out gain of driven joints, arms, fingers and hands, from the emitted C of the extended model and of the
model as it was: filter, standstill and channels as docs/diagnosis_rules.md and docs/findings.md state them."""
import re
import shutil
import subprocess
import tomllib

import compared
from emitted import Emitted
from filters import Comparison, smoothed

EDGE, SLOW_FORCE = 0.25, 5.0  # s left away at both ends; Hz
IN_GUIDE = 3e-4  # m/s: slower a tendon rests
LAWS = {"direction"}  # what was learnt of how friction turns has no coefficient


def lowest_below(step, cutoff):
    return min(cutoff, 0.1 / step)


def without_what_was_learnt(text):
    """identified.toml with every coefficient at zero and no law of its own: its C says what the model said before."""
    parts = text.split("[[effect]]\n")
    kept = [p for p in parts[1:] if re.match(r'effect = "([^"]*)"', p)[1] not in LAWS]
    return re.sub(r"(\[\[effect\.coefficient\]\]\nname = \"[^\"]*\"\nvalue = )\S+", r"\g<1>0.0",
                  "[[effect]]\n".join([parts[0], *kept]))


def before(tools, folder):
    """The emitted C of the model as it was: a folder beside the model, since a hand's parts stand beside it."""
    model = folder / "unlearnt"
    shutil.rmtree(model, ignore_errors=True)
    shutil.copytree(folder / "model", model)
    file = model / "identified.toml"
    file.write_text(without_what_was_learnt(file.read_text(encoding="utf-8")), encoding="utf-8")
    subprocess.run([tools["sinew"], "generate", model, "--out", model / "generated"], check=True,
                   capture_output=True)
    return Emitted(next((model / "generated").rglob("*_catalogue.c")).parent, tools["runtime"])


def numbered(log, name):
    return [log[n] for n in (f"{name}_{i}" for i in range(1, 100)) if n in log]


def driven(folder):
    """Joints that follow no other one."""
    mechanism = tomllib.loads((folder / "mechanism.toml").read_text())
    follow = {c["dependent"] for c in mechanism.get("coupling", [])}
    return [j["name"] for j in mechanism["joint"] if j["name"] not in follow]


def joints_of(model, log):
    """Columns of the positions and of the efforts, "" where tendons make it."""
    if (model / "part.toml").exists():
        return [("theta", "tau_m")]
    if (model / "hand.toml").exists():
        fingers = tomllib.loads((model / "hand.toml").read_text())["finger"]
        places = [(model / f["model"]) for f in fingers]
        return [(f"{p.name}.{j}", "") for p in places for j in driven(p)]
    if "x" in log:
        return [("x", "f")]
    names = driven(model)
    if numbered(log, "force"):
        return [(n if n in log else f"q_{n}", "") for n in names]
    return [(f"q_{n}", f"tau_{n}") for n in names]


class Played:
    """A held-out log: motion, what is measured, and what counts of it."""

    def __init__(self, log, model, c):
        self.log, self.model, self.c = log, model, c
        self.arms = []  # a tendon, a joint, the rows
        self.step = log["time"][1] - log["time"][0]
        self.joints = joints_of(model, log)
        self.forces = numbered(log, "force")
        positions = [log[q] for q, _ in self.joints]
        if self.forces:
            positions += numbered(log, "theta")
        fast, slow = lowest_below(self.step, 60.0), lowest_below(self.step, 18.0)
        self.q, self.v, self.a = ([smoothed(x, self.step, fast, d) for x in positions] for d in range(3))
        self.slow = [[smoothed(x, self.step, slow, d) for x in positions] for d in range(3)]
        self.signals = {"q": self.q, "qd": self.v, "qdd": self.a, "load": self.load(len(positions)),
                        "time": [[t - log["time"][0] for t in log["time"]]]}
        if self.forces:
            self.signals["tension"] = [smoothed(f, self.step, SLOW_FORCE) for f in self.forces]
        self.derivatives(fast)
        self.tau = self.efforts()
        self.still = self.standstills(fast)

    def load(self, count):
        if "load" in self.log:
            return [self.log["load"]] * count
        rest = [0.0] * len(self.log["time"])
        motors = count - len(self.joints)
        if motors == 0:
            return [rest] * count
        part = self.model.parent / "motor" / "part.toml"
        radius = tomllib.loads(part.read_text())["motor"]["pulley_radius"]["value"]
        return [rest] * len(self.joints) + [[radius * f for f in force] for force in self.forces]

    def derivatives(self, fast):
        """Third and fourth, of the smoothed acceleration smoothed twice more below 35 Hz, or 18 Hz where all above
        is noise of the position; nothing at the ends."""
        jerk, jounce = [], []
        edge = round(EDGE / self.step)
        for q, a, raw, slow in zip(self.q, self.a, self.raw(), self.slow[2]):
            noisy = self.is_noise(raw, q, a, slow)
            cutoff = lowest_below(self.step, 18.0 if noisy else 35.0)
            smooth = smoothed(q, self.step, cutoff, 2)
            for list_, order in ((jerk, 1), (jounce, 2)):
                d = smoothed(smooth, self.step, cutoff, order)
                for k in range(min(edge, len(d))):
                    d[k] = d[-1 - k] = 0.0
                list_.append(d)
        self.signals.update(qddd=jerk, qdddd=jounce)

    def raw(self):
        names = [q for q, _ in self.joints]
        return [self.log[n] for n in names] + (numbered(self.log, "theta") if self.forces else [])

    def is_noise(self, raw, q, a, slow):
        """Whether the acceleration above 18 Hz is no more than what white noise as large as the smoother takes away
        makes of itself."""
        half = max(250, round(0.6 / self.step))
        pulse = [0.0] * (2 * half + 1)
        pulse[half] = 1.0
        of = [smoothed(pulse, self.step, lowest_below(self.step, f), 2) for f in (60.0, 18.0)]
        kept = smoothed(pulse, self.step, lowest_below(self.step, 60.0))
        each = squares(of[0], of[1]) / squares(pulse, kept)
        return squares(a, slow) < 4.0 * each * squares(raw, q)

    def efforts(self):
        if not self.forces:
            return [self.log[tau] for _, tau in self.joints]
        inputs, _ = self.c.offsets("coupling_matrix")
        size, n = inputs["q"][1], len(self.joints)
        rest = [[0.0] * len(self.forces[0])] * (size - n)
        p = self.c.rows("coupling_matrix", {"q": self.q[:n] + rest}, {"q_wrist": 0.0})
        width = self.c.columns("coupling_matrix", "P")
        self.arms = [[p[i * width + j] for j in range(n)] for i in range(len(self.forces))]
        return torques_of(self.arms, self.forces) + numbered(self.log, "tau")

    def standstills(self, cutoff):
        """Of each channel: its own, and where a tendon that passes the joint rests in its guide."""
        parts = [[compared.stillness([v, self.slow[1][j]], self.step, cutoff)] for j, v in enumerate(self.v)]
        for arms in self.arms:
            rates = [moved(arms, speeds) for speeds in (self.v, self.slow[1])]
            in_guide = compared.stillness(rates, self.step, cutoff, IN_GUIDE)
            for part, arm in zip(parts, arms):
                if any(arm):
                    part.append(in_guide)
        return [compared.standstills(part) for part in parts]

    def residuals(self, c, bands, counted):
        """A list a channel. bands: Hz; counted: share of the samples that count, 1 where rests do, too."""
        # What was learnt at the joints alone leaves the motors out: they are as they were.
        known = c.offsets("effort")[0]["q"][1]
        signals = {n: x[:known] if n in ("q", "qd", "qdd", "load", "qddd", "qdddd") else x
                   for n, x in self.signals.items()}
        said = c.rows("effort", signals, {"step": self.step})
        edge, result = round(EDGE / self.step), []
        for j, tau in enumerate(self.tau):
            if j >= known:
                result.append([1.0])
                continue
            behind = Comparison(self.step, bands[j])
            left = [t - s for t, s in zip(tau, said[j])][edge:len(tau) - edge]
            instants = [edge + k for k in behind.instants(len(left))]
            still = self.still[j] if counted[j] < 1.0 else []
            weights = compared.weights(still, instants, self.step)
            result.append([x * w for x, w in zip(behind(left), weights)])
        return result


def torques_of(arms, forces):
    """Of every joint, what the tendons' forces make of it: -P^T f. arms: a tendon, a joint, the rows."""
    torques = []
    for j in range(len(arms[0])):
        total = [0.0] * len(forces[0])
        for arm, force in zip(arms, forces):
            if any(arm[j]):
                total = [t - a * f for t, a, f in zip(total, arm[j], force)]
        torques.append(total)
    return torques


def moved(arms, speeds):
    """How fast the joints move a tendon. arms: a joint, the rows."""
    return [sum(at) for at in zip(*([a * v for a, v in zip(arm, speed)] for arm, speed in zip(arms, speeds)))]


def squares(x, y):
    return sum((a - b) ** 2 for a, b in zip(x, y))


def bands_told(findings, played):
    """Of every channel; of a program that tells one band alone, that."""
    usual = lowest_below(played.step, 60.0)
    one = findings["verdict"].get("compared_below_hz") or usual
    return [c.get("compared_below_hz") or min(one, usual) for c in findings["channels"]]


def residuals(tools, folder, log, findings, c):
    """Before and after."""
    played = Played(log, folder / "model", c)
    bands = bands_told(findings, played)
    counted = [ch.get("compared_share", 0.0) for ch in findings["channels"]]
    return [played.residuals(model, bands, counted) for model in (before(tools, folder), c)]
