# SPDX-License-Identifier: GPL-3.0-or-later
"""Branches and MC/DC of the runtime by its own tests: coverage.py

Every branch of every function in runtime/ is taken both ways, and every condition of a decision is shown to decide
it (MC/DC), by tests/runtime/parts.cpp and special_values.cpp, compiled by clang 19 as one unit: of an inline
function that several units have, each would count for itself. Status 1 and the places where that is not so."""
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
TESTS = ("parts.cpp", "special_values.cpp")
KINDS = {"branches": "branches", "mcdc": "conditions", "functions": "functions", "lines": "lines"}


def compiled(work):
    unit = work / "unit.cpp"
    unit.write_text("#define CATCH_CONFIG_MAIN\n#include <catch2/catch.hpp>\n" +
                    "".join(f'#include "tests/runtime/{t}"\n' for t in TESTS), encoding="utf-8")
    program = work / "unit"
    subprocess.run(["clang++-19", "-std=c++20", "-O0", "-w", "-fprofile-instr-generate", "-fcoverage-mapping",
                    "-fcoverage-mcdc", "-ffp-contract=off", f"-I{ROOT}", f"-I{ROOT / 'runtime'}",
                    f"-I{ROOT / 'tests/runtime'}", "-isystem", "/usr/include/eigen3", unit,
                    ROOT / "tests/runtime/exact_value.cpp", "-lmpfr", "-lgmp", "-o", program], check=True)
    return program


def measured(program, work, runtime):
    raw, data = work / "profraw", work / "profdata"
    subprocess.run([program], check=True, stdout=subprocess.DEVNULL, env={"LLVM_PROFILE_FILE": str(raw)})
    subprocess.run(["llvm-profdata-19", "merge", raw, "-o", data], check=True)
    said = subprocess.run(["llvm-cov-19", "export", "-summary-only", program, "-instr-profile", data, runtime],
                          check=True, capture_output=True, text=True).stdout
    shown = subprocess.run(["llvm-cov-19", "show", program, "-instr-profile", data, "-show-mcdc",
                            "-show-branches=count", runtime], check=True, capture_output=True, text=True).stdout
    return json.loads(said)["data"][0], shown


def misses(files):
    """(file, kind, covered, of) of what is not covered whole."""
    found = []
    for file in files:
        for key, name in KINDS.items():
            count, covered = (file["summary"].get(key, {}).get(k, 0) for k in ("count", "covered"))
            if covered < count:
                found.append((pathlib.Path(file["filename"]).name, name, covered, count))
    return found


def main():
    runtime = ROOT / "runtime"
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        data, shown = measured(compiled(work), work, runtime)
    totals = data["totals"]
    print(", ".join(f"{totals[key]['covered']} of {totals[key]['count']} {name}" for key, name in KINDS.items()))
    found = misses(data["files"])
    for file, name, covered, count in found:
        print(f"{file}: {covered} of {count} {name}")
    if found:
        print("\n".join(line for line in shown.splitlines()
                        if "True: 0" in line or "False: 0]" in line or "not covered" in line))
    if totals["mcdc"]["count"] == 0:
        print("no decision was measured; expected clang 19")
        return 2
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
