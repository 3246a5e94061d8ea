# SPDX-License-Identifier: GPL-3.0-or-later
"""run_page.py <program> <source folder> <working folder> <page>: does what a page tells its reader.
run_page.py --unrun <page>...: looks only for commands that no block runs.

Every fenced block of the language `sh` is run in the order of the text, in one folder that holds
copies of what a clone has; a block that fails ends the test. Comments right above a block, which a
reader does not see, say more:

    <!-- file: models/finger/mechanism.toml -->   the block is the content of that file
    <!-- says -->                                 the block is part of what the last commands said;
                                                  a line `...` stands for any lines, and `~` within
                                                  a line for any text
    <!-- status: 1 -->                            the last command of the block ends with 1
    <!-- not run: why -->                         the block is not run, for that reason

A block without such a comment that shows a command and is not run is a mistake of the page.
"""
import os
import re
import shutil
import subprocess
import sys

program, source, work, page = (sys.argv[1:] + ["", "", ""])[:4]
COMMAND = re.compile(r"^\s*(?:\$ )?(sinew|cmake|ctest|cpack|scripts/|python3?|pip|octave|doxygen) ?",
                     re.M)
FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.M | re.S)
NOTE = re.compile(r"<!-- (file: \S+|says|status: \d+|not run: (?:(?!-->).)+?) -->\s*$", re.S)


def fail(line, what):
    sys.exit(f"{page}:{line}: {what}")


def place():
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work + "/bin")
    clone = work + "/clone"
    os.makedirs(clone)
    for folder in ("models", "generated", "runtime", "examples", "cmake", "docs"):
        if os.path.isdir(f"{source}/{folder}"):
            shutil.copytree(f"{source}/{folder}", f"{clone}/{folder}", symlinks=True)
    os.symlink(program, work + "/bin/sinew")
    os.symlink("/usr/bin/python3", work + "/bin/python3")
    return clone


def run(script, clone, line, status):
    environment = dict(os.environ, PATH=work + "/bin:" + os.environ["PATH"], PIP_NO_INDEX="1",
                       PIP_CONFIG_FILE="/dev/null", PIP_DISABLE_PIP_VERSION_CHECK="1",
                       PYTHONDONTWRITEBYTECODE="1", LC_ALL="C.UTF-8")
    # The folder and the variables of one block are those of the next.
    state = work + "/state"
    begin = f". {state}\n" if os.path.exists(state) else ""
    ended = subprocess.run(
        ["bash", "-c", f"set -e\n{begin}trap 's=$?; {{ echo cd \"$PWD\"; export -p; }} > {state}; "
         f"exit $s' EXIT\n{script}"], cwd=clone, env=environment, stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT, text=True)
    print(f"$ {script}{ended.stdout}")
    if ended.returncode != status:
        fail(line, f"ended with {ended.returncode}; expected {status}:\n{script}\n{ended.stdout}")
    return ended.stdout


def contains(said, block):
    pattern = ""
    for text in block.rstrip("\n").split("\n"):
        if text.strip() == "...":
            pattern += r"(?:.*\n)*?"
        else:
            pattern += r"[ \t]*" + ".*?".join(re.escape(p.strip()) if i == 0 else re.escape(p)
                                              for i, p in enumerate(text.strip().split("~"))) + r"\s*?\n"
    return re.search(pattern, said + "\n")


def unrun(text):
    """Lines of indented text that show a command, which no block runs."""
    outside = FENCE.sub(lambda m: "\n" * m.group().count("\n"), text)
    for number, line in enumerate(outside.split("\n"), 1):
        if re.match(r"    (sinew|scripts/\w+|cmake|ctest) ?", line):
            fail(number, "a command that is not run; put it into a block of the language sh")


def main():
    text = open(page, encoding="utf-8").read()
    unrun(text)
    clone = place()
    said, ran, left = "", 0, 0
    for block in FENCE.finditer(text):
        line = text.count("\n", 0, block.start()) + 1
        language, content = block.groups()
        found = NOTE.search(text[:block.start()])
        note = found.group(1) if found else ""
        if note.startswith("not run: "):
            left += 1
        elif note.startswith("file: "):
            path = os.path.join(clone, note[6:])
            os.makedirs(os.path.dirname(path), exist_ok=True)
            open(path, "w", encoding="utf-8").write(content)
        elif note == "says":
            if not contains(said, content):
                fail(line, f"the commands say something else:\n{said}\nexpected\n{content}")
        elif language == "sh":
            said = run(content, clone, line, int(note[8:]) if note else 0)
            ran += 1
        elif COMMAND.search(content) and language in ("", "bash", "shell", "console"):
            fail(line, "a command that is not run; mark the block sh, or say why not")
    print(f"{page}: {ran} blocks run, {left} left out")


if program == "--unrun":
    for page in sys.argv[2:]:
        unrun(open(page, encoding="utf-8").read())
else:
    main()
