# SPDX-License-Identifier: GPL-3.0-or-later
"""check_python.py <source folder>: the installed package sinew_index against generated/index."""
import csv
import inspect
import json
import sys
import typing

import numpy as np
import sinew_index as index

folder = sys.argv[1] + "/generated/index"
manifest = json.load(open(folder + "/manifest.json"))


def reference():
    """{(function, state): {argument: values}}"""
    table = {}
    for row in csv.reader(line for line in open(folder + "/reference.csv") if line[0] != "#"):
        if row[0] != "function":
            entry = table.setdefault((row[0], row[1]), {})
            # Where an argument and a result have one name, the second one is the result.
            entry[row[2] if row[2] not in entry else row[2] + "_out"] = np.array(row[3:], float)
    return table


checked = 0
values = reference()
for function in manifest["functions"]:
    short = function["name"][len("index_"):]
    call = getattr(index, short)
    text = inspect.getdoc(call)
    for port in function["inputs"] + function["outputs"]:
        assert port["name"] + ": (" in text or port["name"] + ": ()" in text, (short, port)
        if port["unit"]:
            assert f"[{port['unit']}]" in text, (short, port["unit"])
    assert "return" in typing.get_type_hints(call)
    single = []
    for state in ("reference", "beside"):
        # Where no argument is a position there is one state.
        entry = values.get((function["name"], state), values[(function["name"], "reference")])
        given = [entry[p["name"]].reshape([p["rows"], p["cols"]][: 1 if p["cols"] == 1 else 2]
                                          if p["rows"] * p["cols"] > 1 else [])
                 for p in function["inputs"]]
        results = call(*given)
        results = results if isinstance(results, tuple) else (results,)
        for port, result in zip(function["outputs"], results):
            name = port["name"]
            expected = entry.get(name + "_out", entry[name])
            assert result.size == port["rows"] * port["cols"], (short, result.shape)
            if not np.array_equal(np.ravel(result), expected):
                sys.exit(f"{short}: {name} differs from reference.csv: {result} {expected}")
            checked += 1
        single.append((given, results))
    # Many states at once: the same bits, in whatever way they are stacked.
    stacked = [np.stack([a, b, a]) for a, b in zip(single[0][0], single[1][0])]
    many = call(*stacked)
    many = many if isinstance(many, tuple) else (many,)
    for k, result in enumerate(many):
        for state, of in enumerate((0, 1, 0)):
            assert np.array_equal(result[state], single[of][1][k]), (short, "batch")

assert index.JOINTS == ("q20", "q21", "q22", "q23")
assert index.TENDONS == tuple(f"h{i}" for i in range(1, 9))
assert index.FRAMES == ("tip",) and index.LOW.shape == (4,)
assert index.SHA256 == manifest["sha256"]

# Broadcasting: 5 positions against 3 sets of forces.
q = np.linspace(index.LOW, index.HIGH, 5)[:, None, :]
f = np.linspace(np.zeros(8), np.full(8, 50.0), 3)
tau = index.joint_torque(q, f)
assert tau.shape == (5, 3, 4)
assert np.array_equal(tau[2, 1], index.joint_torque(q[2, 0], f[1]))
assert index.mass_matrix(np.zeros((0, 4))).shape == (0, 4, 4)
M, h = index.mass_matrix_and_bias(q[0, 0], np.zeros(4))
assert np.array_equal(M, M.T) and index.mass_matrix_and_bias(q[0, 0], np.zeros(4)).h.shape == (4,)
for wrong in (np.zeros(3), np.zeros((4, 5)), 0.0):
    try:
        index.mass_matrix(wrong)
    except ValueError as error:
        assert "expected (4,)" in str(error)
    else:
        sys.exit("a wrong shape is taken")
print(f"{checked} results are those of reference.csv, bit for bit")
