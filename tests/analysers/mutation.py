# SPDX-License-Identifier: GPL-3.0-or-later
"""Do the tests of the runtime's parts see a mistake in them?  mutation.py [--jobs <n>] [<part>...]

Makes one small mistake at a time in a header of runtime/ (another comparison, another sign, another constant, a
statement less) and asks tests/runtime/parts.cpp. What it does not see is a survivor. survivors.txt names those that
change nothing that a caller can see, each with why. Status 1 where a survivor is not named there, or a named one is
seen; 2 where a header is not there. The kernels of the trigonometry are not asked for: their accuracy is measured."""
import argparse
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
HEADERS = ("channel", "checksum", "iterate", "limits", "polynomial", "ring", "solve")
TESTS = ROOT / "tests/runtime/parts.cpp"
USUAL = ["-O0", "-w", "-ffp-contract=off", "-fno-math-errno"]

SWAPS = [(r"(?<![<>=\-])<(?![<=])", "<="), (r"<=", "<"), (r"(?<![>\-<])>(?![>=])", ">="), (r">=", ">"), (r"==", "!="),
         (r"!=", "=="), (r"&&", "||"), (r"\|\|", "&&"), (r" \+ ", " - "), (r" - ", " + "), (r" \* ", " / "),
         (r" / ", " * "), (r" & ", " | "), (r" \| ", " & "), (r"<<", ">>"), (r">>", "<<"), (r" \^ ", " & "),
         (r"!(?=[\w(])", ""), (r"\+=", "-="), (r"-=", "+="), (r"\+\+(?=\w)", "--")]
NUMBER = re.compile(r"(?<![\w.])(0x[0-9a-fA-F]+|\d+\.\d+(?:e[+-]?\d+)?|\d+)(?=[uUfFlL]*\b)")


def other_number(text):
    if text.startswith("0x"):
        return hex(int(text, 16) + 1)
    return repr(float(text) + 1.0) if "." in text else str(int(text) + 1)


def code_lines(text):
    """(number from 0, line) without comments, preprocessor and what only declares."""
    bare = re.sub(r"/\*.*?\*/", lambda m: re.sub(r"[^\n]", " ", m.group()), text, flags=re.S)
    depth, inside = 0, bare.splitlines()
    for number, line in enumerate(inside):
        at_start = depth
        depth += line.count("{") - line.count("}")
        if line.lstrip().startswith("#") or at_start == 0 or "extern" in line or line.rstrip().endswith("\\"):
            continue
        yield number, line


def changes(line):
    """(new line, what was done)."""
    for pattern, new in SWAPS:
        for m in re.finditer(pattern, line):
            yield line[:m.start()] + new + line[m.end():], f"{m.group().strip()} -> {new.strip() or 'nothing'}"
    for m in NUMBER.finditer(line):
        new = other_number(m.group())
        yield line[:m.start()] + new + line[m.end():], f"{m.group()} -> {new}"
    if re.fullmatch(r"\s+[\w.>\[\]+*-]+ [-+*/&|^]?= [^;]+;", line) and not re.match(r"\s+(const )?\w+ \*?\w+ =", line):
        yield "", "left out"


def mutants(header):
    text = (ROOT / "runtime" / header).read_text(encoding="utf-8")
    whole = text.splitlines()
    for number, line in code_lines(text):
        for new, what in changes(line):
            yield {"header": header, "line": number + 1, "text": " ".join(line.split()), "what": what,
                   "source": "\n".join(whole[:number] + [new] + whole[number + 1:]) + "\n"}


def run(command, **options):
    try:
        return subprocess.run(command, capture_output=True, check=False, **options).returncode
    except subprocess.TimeoutExpired:
        return -1


class Bench:
    """What all mutants share: the libraries' headers, compiled once."""

    def __init__(self, work):
        self.work = work
        (work / "libraries.h").write_text("#define CATCH_CONFIG_FAST_COMPILE\n#include <catch2/catch.hpp>\n"
                                          "#include <Eigen/Cholesky>\n#include <random>\n#include <thread>\n",
                                          encoding="utf-8")
        (work / "main.cpp").write_text("#define CATCH_CONFIG_MAIN\n#include <catch2/catch.hpp>\n", encoding="utf-8")
        subprocess.run(["clang++", "-std=c++20", *USUAL, "-isystem", "/usr/include/eigen3", "-x", "c++-header",
                        work / "libraries.h", "-o", work / "libraries.pch"], check=True)
        subprocess.run(["clang++", "-std=c++20", *USUAL, "-O1", "-c", work / "main.cpp", "-o", work / "main.o"],
                       check=True)

    def fate(self, mutant):
        """seen, survived, or nothing: it is no C."""
        with tempfile.TemporaryDirectory(dir=self.work) as folder:
            place = pathlib.Path(folder)
            shutil.copytree(ROOT / "runtime", place / "runtime")
            if mutant:
                (place / "runtime" / mutant["header"]).write_text(mutant["source"], encoding="utf-8")
            if run(["clang++", "-std=c++20", *USUAL, "-isystem", "/usr/include/eigen3", f"-I{place / 'runtime'}",
                    "-include-pch", self.work / "libraries.pch", TESTS, self.work / "main.o", "-o", place / "unit"]):
                return "no C"
            return "seen" if run([place / "unit"], timeout=60) else "survived"


def named():
    lines = (HERE / "survivors.txt").read_text(encoding="utf-8").splitlines()
    return {tuple(part.strip() for part in line.split(" | ")[:3]): line for line in lines
            if line.strip() and not line.startswith("#")}


def main():
    parser = argparse.ArgumentParser(description="asks the runtime's tests for small mistakes")
    parser.add_argument("headers", nargs="*")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    given = parser.parse_args()
    headers = [f"sinew_{h}.h" for h in given.headers or HEADERS]
    missing = [h for h in headers if not (ROOT / "runtime" / h).exists()]
    if missing:
        print(f"no runtime/{missing[0]}; expected one of: {', '.join(HEADERS)}", file=sys.stderr)
        return 2
    all_mutants = [m for h in headers for m in mutants(h)]
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(pathlib.Path(folder))
        if bench.fate(None) != "survived":
            print("the tests do not pass on the runtime as it is")
            return 1
        with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
            fates = list(pool.map(bench.fate, all_mutants))
    known, survivors = named(), {}
    for mutant, fate in zip(all_mutants, fates):
        if fate == "survived":
            survivors[(mutant["header"], mutant["text"], mutant["what"])] = mutant
    seen = fates.count("seen")
    real = seen + fates.count("survived")
    for header in headers:
        own = [f for m, f in zip(all_mutants, fates) if m["header"] == header and f != "no C"]
        print(f"{header}: {own.count('seen')} of {len(own)} seen")
    unexplained = [k for k in survivors if k not in known]
    stale = [k for k in known if k[0] in headers and k not in survivors]
    for key in unexplained:
        print(f"survived, and not explained: {key[0]}:{survivors[key]['line']} | {key[1]} | {key[2]}")
    for key in stale:
        print(f"explained, but seen now: {' | '.join(key)}")
    print(f"{seen} of {real} mistakes seen ({100.0 * seen / max(real, 1):.1f} %), "
          f"{len(survivors) - len(unexplained)} others explained")
    return 1 if unexplained or stale else 0


if __name__ == "__main__":
    sys.exit(main())
