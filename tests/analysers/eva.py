# SPDX-License-Identifier: GPL-3.0-or-later
"""Eva, Frama-C's analyser of intervals, over the emitted C: eva.py [--work <folder>] [<model>...]

Two questions for every function of every model under generated/, its inputs anywhere in their ranges:
run-time errors, with the runtime as it is (indices, shifts, conversions, values that were never set), of
which there must be none; and results that might not be finite, with the runtime's functions as their
contracts (contracts/sinew_math.h). Intervals know no relation between two values: that a pivot of the mass
matrix is not zero, say, they cannot tell. Functions with such places are in unproven.txt, and no others may
join them. The runtime itself is called with any bits. Status 1 where something is found."""
import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
EVA = ["frama-c", "-machdep", "x86_64", "-eva", "-eva-auto-loop-unroll", "256", "-eva-no-show-progress",
       "-eva-msg-key=-initial-state,-final-states"]
PLANTED = ("out of bounds index", "RHS operand for shift", "uninitialized left-value", "overflow in conversion")


def interval(argument, element):
    return f"Frama_C_double_interval({argument['low'][element]!r}, {argument['high'][element]!r})"


def calls_of(function, index, model):
    """A C function that calls one emitted function, through the catalogue, with all its inputs drawn."""
    size = [sum(a["rows"] * a["cols"] for a in function[side]) for side in ("inputs", "outputs")]
    draws = [interval(a, e) for a in function["inputs"] for e in range(a["rows"] * a["cols"])]
    return "\n".join([f"static void at_{function['name']}(void)", "{",
                      f"    static double in[{max(size[0], 1)}], out[{max(size[1], 1)}];",
                      *(f"    in[{k}] = {draw};" for k, draw in enumerate(draws)),
                      f"    {model}_catalogue.functions[{index}].call(in, out);", "}"])


def driver(manifest):
    model, functions = manifest["model"], manifest["functions"]
    return "\n".join(["#include \"__fc_builtin.h\"", "#include \"sinew_catalogue.h\"",
                      f"extern const sinew_catalogue {model}_catalogue;",
                      *(calls_of(f, i, model) for i, f in enumerate(functions)), "int main(void)", "{",
                      *(f"    at_{f['name']}();" for f in functions), "    return 0;", "}", ""])


def alarms(sources, includes, special):
    """A list of (file, line, what) that Eva tells of them."""
    flags = " ".join(f"-I{i}" for i in includes)
    done = subprocess.run([*EVA, f"-cpp-extra-args={flags} -U__SSE2__", "-warn-special-float", special, *sources],
                          capture_output=True, text=True, check=False)
    if done.returncode != 0 or "statements reached" not in done.stdout:
        raise RuntimeError(f"Eva ended with {done.returncode} on {sources[0]}: {(done.stderr or done.stdout)[-800:]}")
    return [(pathlib.Path(f).name, int(line), " ".join(what.split()))
            for f, line, what in re.findall(r"\[eva:alarm\] (\S+?):(\d+): Warning:\s*(.*?)\n(?=\[|  ---)",
                                            done.stdout + "\n[", re.S)]


def function_at(file, line):
    """Of emitted C, where a function's name stands at the beginning of a line."""
    name = ""
    for text in file.read_text(encoding="utf-8").splitlines()[:line]:
        found = re.match(r"(?:static )?\w[\w ]*?\b(\w+)\(", text)
        name = found[1] if found else name
    return name


def judge_model(folder, work, unproven):
    """What is wrong with a model's C, as lines; and the functions that are not proved finite."""
    manifest = json.loads((folder / "manifest.json").read_text(encoding="utf-8"))
    model = manifest["model"]
    start = work / f"eva_{model}.c"
    start.write_text(driver(manifest), encoding="utf-8")
    sources = [start, folder / f"{model}.c", folder / f"{model}_catalogue.c"]
    errors = alarms(sources, [ROOT / "runtime", folder], "none")
    wrong = [f"{model}: {f}:{line}: {what}" for f, line, what in errors]
    open_ = alarms(sources, [HERE / "contracts", ROOT / "runtime", folder], "non-finite")
    functions = sorted({function_at(folder / f, line) for f, line, _ in open_ if f == f"{model}.c"})
    wrong += [f"{model}: {f}:{line}: {what}" for f, line, what in open_ if f != f"{model}.c"]
    wrong += [f"{model}: {name} may be infinite or NaN, and is not in unproven.txt"
              for name in functions if name not in unproven]
    print(f"{model}: {len(manifest['functions'])} functions, {len(errors)} run-time errors; finite: all but "
          f"{len(functions)} of their bodies", flush=True)
    return wrong, functions


def judge_file(name):
    return [f"{f}:{line}: {what}" for f, line, what in alarms([HERE / name], [ROOT / "runtime"], "none")]


def main():
    parser = argparse.ArgumentParser(prog="eva.py", description=__doc__.splitlines()[0])
    parser.add_argument("models", nargs="*")
    chosen = parser.parse_args()
    if not shutil.which("frama-c"):
        sys.exit("eva.py: frama-c is not there; install frama-c-base")
    unproven = set((HERE / "unproven.txt").read_text(encoding="utf-8").split())
    wrong, seen = [], set()
    planted = " ".join(judge_file("planted_errors.c"))
    wrong += [f"a planted error is not found: {kind}" for kind in PLANTED if kind not in planted]
    if not chosen.models:
        wrong += judge_file("runtime_with_any_bits.c")
    with tempfile.TemporaryDirectory() as work:
        for manifest in sorted((ROOT / "generated").glob("*/manifest.json")):
            if chosen.models and manifest.parent.name not in chosen.models:
                continue
            found, functions = judge_model(manifest.parent, pathlib.Path(work), unproven)
            wrong += found
            seen |= set(functions)
    if not chosen.models:
        wrong += [f"{name} is proved now: take it out of unproven.txt" for name in sorted(unproven - seen)]
    print("\n".join(wrong) or "nothing is wrong")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
