# SPDX-License-Identifier: GPL-3.0-or-later
"""check_links.py <folder>: every link of every page below the folder leads to a file that is there,
and to a heading of it."""
import itertools
import os
import re
import subprocess
import sys

folder = sys.argv[1]
LINK = re.compile(r"(?<!\\)\[(?:[^\[\]]|\[[^\]]*\])*\]\(([^()\s]+)\)")
PICTURE = re.compile(r"!\[[^\]]*\]\(([^()\s]+)\)")  # inside a link it is none of LINK's


def heading_names(path):
    names, fenced = set(), False
    for line in open(path, encoding="utf-8"):
        fenced ^= line.startswith("```")
        if line.startswith("#") and not fenced:
            title = re.sub(r"[`*]|\[([^\]]*)\]\([^)]*\)", r"\1", line.lstrip("#").strip()).lower()
            names.add(re.sub(r"[^\w\- ]", "", title).replace(" ", "-"))
    return names


def pages():
    listed = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard", "*.md"],
                            cwd=folder, capture_output=True, text=True)
    if listed.returncode == 0 and listed.stdout:
        return listed.stdout.split("\n")[:-1]
    return [os.path.relpath(os.path.join(at, name), folder)
            for at, _, names in os.walk(folder) for name in names if name.endswith(".md")]


wrong, checked = [], 0
for page in pages():
    text = open(os.path.join(folder, page), encoding="utf-8").read()
    text = re.sub(r"^```.*?^```$", lambda m: "\n" * m.group().count("\n"), text, flags=re.M | re.S)
    for link in itertools.chain(LINK.finditer(text), PICTURE.finditer(text)):
        target = link.group(1)
        if re.match(r"[a-z]+:", target):
            continue
        checked += 1
        line = text.count("\n", 0, link.start()) + 1
        file, _, heading = target.partition("#")
        path = os.path.normpath(os.path.join(os.path.dirname(page), file)) if file else page
        if not os.path.exists(os.path.join(folder, path)):
            wrong.append(f"{page}:{line}: {target}: there is no {path}")
        elif heading and heading not in heading_names(os.path.join(folder, path)):
            wrong.append(f"{page}:{line}: {target}: there is no such heading")
print("\n".join(wrong))
print(f"{checked} links, {len(wrong)} wrong")
sys.exit(1 if wrong else 0)
