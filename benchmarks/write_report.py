# SPDX-License-Identifier: GPL-3.0-or-later
"""write_report.py <results folder> <out.md>: docs/performance.md from what scripts/benchmark measured."""
import csv
import json
import os
import pathlib
import platform
import subprocess
import sys

QUANTITIES = {"inverse_dynamics": "inverse dynamics", "bias": "bias", "mass_matrix": "mass matrix",
              "both": "mass matrix and bias", "forward_dynamics": "forward dynamics"}
MAKERS = ["sinew", "SymPy, Newton-Euler", "SymPy, Lagrange", "MuJoCo", "Orocos KDL"]
ROBOTS = ["finger", "panda"]
# The fastest published C for these two robots' structures was written by hand-guided symbolic tools
# that Debian does not have. Their times are known on another machine, with the time of libm's sincos
# beside them: that is what they are scaled by. {robot: (peer, best prototype, sincos)} in ns.
ELSEWHERE = {"finger": (85.0, 72.0, 50.0), "panda": (137.0, 131.0, 87.0)}


def rows(file):
    with open(file, encoding="utf-8", newline="") as lines:
        return list(csv.reader(lines))


def table(head, body):
    lines = [head, ["---"] * len(head)] + body
    return "\n".join("| " + " | ".join(str(cell) for cell in line) + " |" for line in lines) + "\n"


def output_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def version_of(package):
    return output_of("dpkg-query", "-W", "-f", "${Version}", package).split("-")[0]


def program_flags(built):
    """How the program whose generator is timed was compiled."""
    cache = dict(line.split("=", 1) for line in (built / "CMakeCache.txt").read_text(
        encoding="utf-8").splitlines() if "=" in line and not line.startswith(("#", "//")))
    kind = cache["CMAKE_BUILD_TYPE:STRING"]
    return f"{kind}, {cache[f'CMAKE_CXX_FLAGS_{kind.upper()}:STRING']}"


class Measured:
    def __init__(self, folder):
        self.folder = folder
        self.flags = program_flags(folder.parent)
        self.ns, self.instructions, self.operations, self.error = {}, {}, {}, {}
        for run in json.loads((folder / "times.json").read_text(encoding="utf-8"))["benchmarks"]:
            if run["aggregate_name"] == "median":
                self.ns[run["run_name"]] = 1e9 / run["items_per_second"]
        for name, count in rows(folder / "instructions.csv"):
            self.instructions[name] = int(count)
        for robot, quantity, maker, multiply, add, negate, divide, trig in rows(
                folder / "operations.csv"):
            self.operations[f"{robot}/{quantity}/{maker}"] = int(multiply) + int(add)
        for name, error in rows(folder / "errors.csv"):
            self.error[name] = error
        self.text = {what: (int(code), int(data))
                     for what, code, data in rows(folder / "text.csv")}
        self.growth = [[float(cell) for cell in row] for row in rows(folder / "growth.csv")[1:]]
        self.hand = {model: float(seconds) for model, seconds in rows(folder / "hand.csv")}
        self.board = rows(folder / "zynq_a9.csv")[1:]

    def instructions_of(self, name):
        """One call, less the loop around it."""
        if name not in self.instructions:
            return None
        robot = name.split("/")[0]
        empty = self.instructions[f"{robot}/inverse_dynamics/empty call"]
        return (self.instructions[name] - empty) / 128

    def elsewhere(self, robot):
        """Times of the best peer and the prototype, scaled to this machine [ns]."""
        peer, prototype, sincos = ELSEWHERE[robot]
        scale = self.ns[f"{robot}/inverse_dynamics/sincos of libm"] / sincos
        return peer * scale, prototype * scale


def show(value, digits=0):
    return "–" if value is None else f"{value:,.{digits}f}"


def machine(measured):
    with open("/proc/cpuinfo", encoding="utf-8") as lines:
        model = next(line.split(":")[1].strip() for line in lines if line.startswith("model name"))
    compiler = output_of("gcc", "-dumpfullversion").strip()
    return (f"{model}, {platform.machine()}, Linux; gcc {compiler}, glibc {version_of('libc6')}; "
            f"MuJoCo {version_of('libmujoco-dev')}, Orocos KDL {version_of('liborocos-kdl-dev')}, "
            f"SymPy {version_of('python3-sympy')}. Emitted C and SymPy's: `-O3 -march=native "
            "-ffp-contract=off -fno-math-errno -fno-tree-slp-vectorize`, one thread, double. Load of the "
            f"machine's {os.cpu_count()} cores while this was measured: {os.getloadavg()[2]:.1f} (above "
            f"{os.cpu_count()} the times are of a machine that others use as well).\n")


def dynamics_table(measured, robot, quantity):
    body = []
    for maker in MAKERS:
        name = f"{robot}/{quantity}/{maker}"
        if name not in measured.ns:
            continue
        own = measured.ns[f"{robot}/{quantity}/sinew"]
        body.append([maker, show(measured.ns[name], 1), f"{measured.ns[name] / own:.1f}",
                     show(measured.operations.get(name)), show(measured.instructions_of(name)),
                     measured.error[name]])
    if quantity == "inverse_dynamics":
        name = f"{robot}/{quantity}/sincos of libm"
        body.append([f"libm's sincos of {4 if robot == 'finger' else 7} angles",
                     show(measured.ns[name], 1), "", "", show(measured.instructions_of(name)), ""])
    return table(["", "ns", "× sinew", "operations", "instructions", "error"], body)


def batch_table(measured, robot):
    peer, prototype = measured.elsewhere(robot)
    body = []
    for name, ns in measured.ns.items():
        if name.startswith(f"{robot}/batch/"):
            body.append([name.split("/")[2], f"{ns:.1f}", f"{1e3 / ns:.1f}",
                         f"{measured.ns[f'{robot}/inverse_dynamics/sinew'] / ns:.1f}",
                         f"{prototype / ns:.1f}", f"{peer / ns:.1f}"])
    return table(["instruction set", "ns a state", "million states a second", "× own scalar",
                  "× prototype", "× best peer"], body)


def passes_table(measured):
    data = {robot: json.loads((measured.folder / f"passes_{robot}.json").read_text(encoding="utf-8"))
            for robot in ROBOTS}
    body = [["(all passes on)"] + [show(data[robot]["multiply_add"]) for robot in ROBOTS]]
    for i, gain in enumerate(data["finger"]["gains"]):
        body.append([f"without `{gain['pass']}`"]
                    + [f"{data[robot]['gains'][i]['multiply_add']:+d}" for robot in ROBOTS])
    return table(["all functions, multiplications and additions", "finger", "panda"], body)


def goals(measured):
    """(what, goal, measured, unit): met where measured <= goal."""
    found = []
    for robot, limits in {"finger": (200, 140, 80, 190, 235), "panda": (560,)}.items():
        for quantity, limit in zip(["inverse_dynamics", "bias", "mass_matrix", "both",
                                    "forward_dynamics"], limits):
            found.append((f"{robot}, {QUANTITIES[quantity]}", limit,
                          measured.operations[f"{robot}/{quantity}/sinew"], "operations"))
    for robot, limit, share in (("finger", 480, 0.55), ("panda", 1000, 0.6)):
        name = f"{robot}/inverse_dynamics/sinew"
        peer, prototype = measured.elsewhere(robot)
        found.append((f"{robot}, inverse dynamics", limit, measured.instructions_of(name),
                      "instructions"))
        found.append((f"{robot}, inverse dynamics over the best peer's time", share,
                      measured.ns[name] / peer, ""))
        best = prototype / measured.ns[f"{robot}/batch/AVX2 and FMA"]
        found.append((f"{robot}, batch with AVX2: 6 times the prototype's rate (1 is the goal)", 1.0,
                      6.0 / best, ""))
    found.append(("finger, inverse dynamics, code at -O2", 3300,
                  measured.text["x86-64, -O2"][0], "bytes"))
    found.append(("whole hand (`models/hand`) generated, one core", 1.0, measured.hand["hand"], "s"))
    found.append(("chain of 30 joints generated, one core", 5.0, measured.growth[-1][1], "s"))
    return found


def goal_table(measured):
    body = []
    for what, goal, value, unit in goals(measured):
        digits = 0 if goal > 20 else 2
        met = "met" if value <= goal else f"missed by {100 * (value / goal - 1):.0f} %"
        body.append([what, f"≤ {show(goal, digits)} {unit}", f"{show(value, digits)} {unit}", met])
    return table(["", "goal", "measured", ""], body)


def growth_table(measured):
    return table(["joints", "s", "inverse dynamics", "mass matrix", "forward dynamics",
                  "Coriolis matrix"],
                 [[int(row[0]), f"{row[1]:.2f}"] + [show(cell) for cell in row[2:]]
                  for row in measured.growth])


def report(measured):
    here = pathlib.Path(__file__).parent
    parts = ["<!-- SPDX-License-Identifier: GPL-3.0-or-later -->\n# Performance\n",
             "Everything here is measured and written by one command, in one run:\n\n"
             "<!-- not run: about ten minutes, on a quiet machine -->\n```sh\nscripts/benchmark\n```\n",
             machine(measured),
             "Times are processor time, the median of 15 interleaved repetitions over 128 random states "
             "(q in ±π). Operations are the multiplications and additions executed; instructions are "
             "callgrind's, in code for x86-64-v3, all libraries included. Before anything is timed, "
             "every result is compared with Newton–Euler in long double (`tests/reference`); `error` "
             "is the largest difference over the largest entry. MuJoCo runs kinematics and what the "
             "quantity needs, nothing else. The robots are `benchmarks/robots`: a finger of four joints "
             "with full inertias under a gravity of arbitrary direction, and the Panda arm.\n",
             "## Goals\n", goal_table(measured), (here / "notes.md").read_text(encoding="utf-8"),
             "## Inverse dynamics\n"]
    for robot in ROBOTS:
        parts += [f"{robot}:\n", dynamics_table(measured, robot, "inverse_dynamics")]
    parts += ["## Other functions\n"]
    for quantity in ("bias", "mass_matrix", "both", "forward_dynamics"):
        for robot in ROBOTS:
            parts += [f"{robot}, {QUANTITIES[quantity]}:\n", dynamics_table(measured, robot, quantity)]
    parts += ["## Batch form\n",
              "Inverse dynamics of 128 states a call, as a structure of arrays. With FMA the compiler may "
              "fuse (`-ffp-contract=fast`), which changes bits; without, the bits are those of the "
              "scalar form. Prototype and best peer (a generator that is not in Debian) were timed "
              "elsewhere and are scaled by libm's sincos.\n"]
    for robot in ROBOTS:
        parts += [f"{robot}:\n", batch_table(measured, robot)]
    parts += ["## Code size\n", "The finger's inverse dynamics alone, trigonometry included [bytes].\n",
              table(["", "code", "constants"],
                    [[what, show(code), show(data)] for what, (code, data) in measured.text.items()]),
              "## What each pass brings\n",
              "`sinew cost <model> --passes`: operations more with that pass left out.\n",
              passes_table(measured),
              "## The generator\n",
              f"Processor seconds of `sinew generate` (program built {measured.flags}), all functions: "
              + ", ".join(f"`{model}` {seconds:.2f}" for model, seconds in measured.hand.items())
              + ". Chains as general as chains come (`benchmarks/chain_growth.py`):\n",
              growth_table(measured), "![growth](generator_growth.svg)\n",
              "## On the board\n",
              "Instructions of one call on the emulated Cortex-A9, index finger of `models/index` "
              "(`scripts/count_instructions zynq_a9 index`).\n",
              table(["function", "instructions"], [[row[1], show(int(row[2]))] for row in measured.board])]
    return "\n".join(parts)


def main():
    text = report(Measured(pathlib.Path(sys.argv[1])))
    pathlib.Path(sys.argv[2]).write_text(text, encoding="utf-8")


main()
