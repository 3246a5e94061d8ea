# SPDX-License-Identifier: GPL-3.0-or-later
"""check_fmi_rules.py <unit>: whether an FMU for co-simulation keeps the rules of FMI 3.0 for its
description and its files; then whether each of some planted mistakes is found.

Written from the standard's text (fmi-standard.org), as no checker of others is in Debian 12. It knows
the elements that sinew writes, and calls any other one a mistake."""
import copy
import re
import sys
import xml.etree.ElementTree as xml
import zipfile

# Children of each element in the order that the standard gives them.
ORDER = {
    "fmiModelDescription": ["CoSimulation", "UnitDefinitions", "DefaultExperiment", "ModelVariables",
                            "ModelStructure"],
    "UnitDefinitions": ["Unit"], "Unit": ["BaseUnit"], "ModelVariables": ["Float64"],
    "ModelStructure": ["Output", "InitialUnknown"],
}
ONCE = set(ORDER["fmiModelDescription"]) | {"BaseUnit"}
NEEDED = {"fmiModelDescription": ["CoSimulation", "ModelVariables", "ModelStructure"]}
# Attributes: those that have to be there, those that may.
WORD, NUMBER, COUNT, TRUTH = r".+", r"[-+0-9.eE]+", r"\d+", r"true|false|0|1"
ATTRIBUTES = {
    "fmiModelDescription": ({"fmiVersion": r"3\.0(\.\d+)?", "modelName": WORD,
                             "instantiationToken": WORD},
                            {"description": WORD, "generationTool": WORD, "author": WORD,
                             "version": WORD, "license": WORD, "copyright": WORD,
                             "variableNamingConvention": "flat|structured"}),
    "CoSimulation": ({"modelIdentifier": r"[A-Za-z_]\w*"},
                     {"canHandleVariableCommunicationStepSize": TRUTH, "canGetAndSetFMUState": TRUTH,
                      "maxOutputDerivativeOrder": COUNT}),
    "UnitDefinitions": ({}, {}), "Unit": ({"name": WORD}, {}), "ModelVariables": ({}, {}),
    "BaseUnit": ({}, {**{k: r"-?\d+" for k in ("kg", "m", "s", "A", "K", "mol", "cd", "rad")},
                      "factor": NUMBER, "offset": NUMBER}),
    "DefaultExperiment": ({}, {k: NUMBER for k in ("startTime", "stopTime", "tolerance",
                                                   "stepSize")}),
    "Float64": ({"name": WORD, "valueReference": COUNT},
                {"description": WORD, "causality": WORD, "variability": WORD, "initial": WORD,
                 "unit": WORD, "start": NUMBER, "min": NUMBER, "max": NUMBER, "nominal": NUMBER}),
    "ModelStructure": ({}, {}), "Output": ({"valueReference": COUNT}, {}),
    "InitialUnknown": ({"valueReference": COUNT}, {}),
}
# What may go together: causality and variability, and then what `initial` may be.
TOGETHER = {
    ("independent", "continuous"): {None}, ("input", "continuous"): {None, "exact"},
    ("parameter", "fixed"): {None, "exact"}, ("parameter", "tunable"): {None, "exact"},
    ("output", "continuous"): {None, "calculated", "exact", "approx"},
    ("local", "continuous"): {None, "calculated", "exact", "approx"},
}
STRUCTURED = re.compile(r"[A-Za-z_]\w*(\[\d+(,\d+)*\])?(\.[A-Za-z_]\w*(\[\d+(,\d+)*\])?)*")


def mistakes_of_element(element):
    found, name = [], element.tag
    if name not in ATTRIBUTES:
        return [f"the element {name} is unknown"]
    needed, more = ATTRIBUTES[name]
    found += [f"{name} has no {a}" for a in needed if a not in element.attrib]
    for key, value in element.attrib.items():
        pattern = {**needed, **more}.get(key)
        if pattern is None or not re.fullmatch(pattern, value):
            found.append(f"{name} has {key}='{value}'")
    order = ORDER.get(name, [])
    children = [child.tag for child in element]
    if sorted(children, key=lambda t: order.index(t) if t in order else -1) != children:
        found.append(f"the children of {name} are in another order")
    found += [f"{name} holds a {t}" for t in set(children) - set(order)]
    found += [f"{name} holds several {t}" for t in ONCE if children.count(t) > 1]
    found += [f"{name} holds no {t}" for t in NEEDED.get(name, []) if t not in children]
    return found + [m for child in element for m in mistakes_of_element(child)]


def mistakes_of_variables(root):
    found, variables = [], root.findall("ModelVariables/Float64")
    for key in ("name", "valueReference"):
        values = [v.get(key) for v in variables]
        found += [f"two variables have the {key} {x}" for x in set(values) if values.count(x) > 1]
    for v in variables:
        causality, variability = v.get("causality", "local"), v.get("variability", "continuous")
        initial = v.get("initial")
        if initial not in TOGETHER.get((causality, variability), set()):
            found.append(f"{v.get('name')}: {causality}, {variability} and {initial} do not go together")
        starts = causality in ("input", "parameter") or initial in ("exact", "approx")
        if starts != ("start" in v.attrib):
            found.append(f"{v.get('name')}: start is missing, or must not be there")
        if root.get("variableNamingConvention") == "structured" and \
                not STRUCTURED.fullmatch(v.get("name")):
            found.append(f"{v.get('name')} is no structured name")
    if [v.get("causality") for v in variables].count("independent") > 1:
        found.append("several variables are independent")
    units = [u.get("name") for u in root.findall("UnitDefinitions/Unit")]
    found += [f"the unit {u} is defined twice" for u in set(units) if units.count(u) > 1]
    found += [f"the unit {v.get('unit')} is not defined" for v in variables
              if v.get("unit", units[0]) not in units]
    outputs = {v.get("valueReference") for v in variables if v.get("causality") == "output"}
    open_ones = {v.get("valueReference") for v in variables if v.get("causality") == "output"
                 and v.get("initial") in (None, "approx", "calculated")}
    for tag, wanted in (("Output", outputs), ("InitialUnknown", open_ones)):
        told = [o.get("valueReference") for o in root.findall(f"ModelStructure/{tag}")]
        if sorted(told) != sorted(wanted):
            found.append(f"the {tag}s are not those of the variables")
    return found


def mistakes_of_files(names, root, build):
    identifier = root.find("CoSimulation").get("modelIdentifier")
    found = [f"{n} stands beside what a unit may hold" for n in names if n.split("/")[0] not in
             ("modelDescription.xml", "binaries", "sources", "documentation", "resources", "extra",
              "terminalsAndIcons")]
    binaries = [n for n in names if n.startswith("binaries/") and not n.endswith("/")]
    found += [f"{n} is in no folder of a platform, or called otherwise" for n in binaries
              if not re.fullmatch(r"binaries/(x86|x86_64|aarch32|aarch64|riscv64)-"
                                  rf"(linux|windows|darwin)/{identifier}\.(so|dll|dylib)", n)]
    if build.find("BuildConfiguration").get("modelIdentifier") != identifier:
        found.append("what is built from the sources is called otherwise")
    found += [f"the source {s.get('name')} is not there" for s in build.iter("SourceFile")
              if "sources/" + s.get("name") not in names]
    return found


def mistakes(root, names, build):
    shape = mistakes_of_element(root)
    return shape or mistakes_of_variables(root) + mistakes_of_files(names, root, build)


unit = zipfile.ZipFile(sys.argv[1])
description = xml.fromstring(unit.read("modelDescription.xml"))
sources = xml.fromstring(unit.read("sources/buildDescription.xml"))
listed = unit.namelist()
found = mistakes(description, listed, sources)
if found:
    sys.exit("the unit breaks FMI 3.0:\n  " + "\n  ".join(found))

# Planted: (where, what is done to it).
VARIABLE = "ModelVariables/Float64[@causality='%s']"
PLANTED = [
    (".", lambda e: e.set("fmiVersion", "2.0")),
    (".", lambda e: e.attrib.pop("instantiationToken")),
    (".", lambda e: e.remove(e.find("ModelStructure"))),
    (".", lambda e: e.insert(0, e[-1])),
    (".", lambda e: e.append(xml.Element("Annotation"))),
    ("CoSimulation", lambda e: e.set("canGetAndSetFMUstate", "true")),
    ("CoSimulation", lambda e: e.set("modelIdentifier", "1st")),
    ("UnitDefinitions/Unit", lambda e: e.set("name", "degree")),
    ("UnitDefinitions/Unit/BaseUnit", lambda e: e.set("rad", "one")),
    (VARIABLE % "input", lambda e: e.attrib.pop("start")),
    (VARIABLE % "output", lambda e: e.set("start", "0")),
    (VARIABLE % "parameter", lambda e: e.set("variability", "continuous")),
    (VARIABLE % "parameter", lambda e: e.set("initial", "calculated")),
    (VARIABLE % "output", lambda e: e.set("name", "q q20")),
    (VARIABLE % "output", lambda e: e.set("valueReference", "1")),
    ("ModelStructure/Output", lambda e: e.set("valueReference", "1")),
    ("ModelStructure", lambda e: e.remove(e.find("InitialUnknown"))),
]
for number, (where, spoil) in enumerate(PLANTED):
    spoilt = copy.deepcopy(description)
    spoil(spoilt if where == "." else spoilt.find(where))
    if not mistakes(spoilt, listed, sources):
        sys.exit(f"planted mistake {number} is not found")
for files in (listed + ["readme.txt"], [n.replace("x86_64-linux", "linux64") for n in listed],
              [n for n in listed if not n.endswith("/fmu.c")]):
    if files != listed and not mistakes(description, files, sources):
        sys.exit("a planted mistake of the files is not found")
print(f"the unit keeps the rules, and {len(PLANTED) + 3} mistakes are found")
