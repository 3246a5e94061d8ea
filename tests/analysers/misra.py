# SPDX-License-Identifier: GPL-3.0-or-later
"""MISRA C:2012 by cppcheck's addon over runtime/, generated/ and firmware/hand/: misra.py

docs/misra.md names each rule that is deviated from, and why. A rule that is broken and not named there is a
finding, and so is one that is named and kept everywhere."""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
ADDONS = [pathlib.Path(p) for p in ("/usr/lib/x86_64-linux-gnu/cppcheck/addons/misra.py",
                                    "/usr/share/cppcheck/addons/misra.py")]
RUNTIME = "#include \"sinew_math.h\"\n#include \"sinew_runtime.h\"\n"


def documented():
    table = (ROOT / "docs/misra.md").read_text(encoding="utf-8")
    return set(re.findall(r"^\| (\d+\.\d+) \|", table, re.M))


def broken_rules(source, work):
    """(rule, file, line) of a source and of the headers that it includes."""
    addon = next(p for p in ADDONS if p.exists())
    copy = work / source.name
    copy.write_text(source.read_text(encoding="utf-8"), encoding="utf-8")
    includes = [f"-I{p}" for p in (source.parent, ROOT / "runtime", ROOT / "firmware/hand",
                                   *sorted((ROOT / "generated").glob("*/")))]
    subprocess.run(["cppcheck", "--dump", "--quiet", "--std=c11", "-U__SSE2__", "-D__GNUC__=12", *includes, copy],
                   capture_output=True, check=True)
    said = subprocess.run([sys.executable, addon, f"{copy}.dump"], capture_output=True, text=True, check=False)
    found = re.findall(r"\[(\S+?):(\d+)\] .*?\[misra-c2012-(\d+\.\d+)\]", said.stdout + said.stderr)
    return [(rule, pathlib.Path(file).name, int(line)) for file, line, rule in found]


def sources(work):
    whole = work / "whole_runtime.c"
    whole.write_text(RUNTIME, encoding="utf-8")
    return [whole, *sorted((ROOT / "generated").glob("*/*.c")), *sorted((ROOT / "firmware/hand").glob("*.c"))]


def main():
    if not shutil.which("cppcheck"):
        sys.exit("misra.py: cppcheck is not there; install cppcheck")
    named, wrong, seen = documented(), [], {}
    with tempfile.TemporaryDirectory() as place:
        work = pathlib.Path(place)
        (work / "in").mkdir()
        planted = {rule for rule, _, _ in broken_rules(HERE / "planted_deviations.c", work)}
        wrong += [f"planted and not found: rule {rule}" for rule in ("15.1", "17.2") if rule not in planted]
        for source in sources(work / "in"):
            for rule, file, line in broken_rules(source, work):
                seen.setdefault(rule, set()).add((file, line))
    for rule in sorted(seen, key=lambda r: [int(x) for x in r.split(".")]):
        file, line = sorted(seen[rule])[0]
        print(f"rule {rule}: {len(seen[rule])} places, {file}:{line} first")
        if rule not in named:
            wrong.append(f"{file}:{line}: rule {rule} is broken, and docs/misra.md does not say why")
    wrong += [f"docs/misra.md: rule {rule} is kept everywhere; take it out" for rule in sorted(named - set(seen))]
    print("\n".join(wrong) or "nothing is wrong")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
