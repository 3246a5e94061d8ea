# SPDX-License-Identifier: GPL-3.0-or-later
"""check_fmu.py <unit> <folder of its sources>: an importer of one FMI 3.0 co-simulation unit."""
import ctypes as c
import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml
import zipfile

unit, sources = sys.argv[1], sys.argv[2] + "/sources"
folder = tempfile.mkdtemp()
zipfile.ZipFile(unit).extractall(folder)
description = xml.parse(folder + "/modelDescription.xml").getroot()
assert description.get("fmiVersion") == "3.0"
identifier = description.find("CoSimulation").get("modelIdentifier")
variables = {v.get("name"): v for v in description.find("ModelVariables")}
reference = {name: int(v.get("valueReference")) for name, v in variables.items()}
assert sorted(reference.values()) == list(range(len(reference))), "value references are not unique"
outputs = {o.get("valueReference") for o in description.findall("ModelStructure/Output")}
assert outputs == {v.get("valueReference") for v in variables.values()
                   if v.get("causality") == "output"}
initial = {o.get("valueReference") for o in description.findall("ModelStructure/InitialUnknown")}
assert initial == outputs
units = {u.get("name") for u in description.findall("UnitDefinitions/Unit")}
assert all(v.get("unit") in units | {None} for v in variables.values())
library = c.CDLL(f"{folder}/binaries/x86_64-linux/{identifier}.so"
                 if os.uname().machine == "x86_64" else
                 f"{folder}/binaries/{os.uname().machine}-linux/{identifier}.so")
library.fmi3GetVersion.restype = c.c_char_p
assert library.fmi3GetVersion() == b"3.0"
said = []
Log = c.CFUNCTYPE(None, c.c_void_p, c.c_int, c.c_char_p, c.c_char_p)
log = Log(lambda _, status, category, message: said.append(message.decode()))
make = library.fmi3InstantiateCoSimulation
make.restype = c.c_void_p
make.argtypes = [c.c_char_p, c.c_char_p, c.c_char_p, c.c_bool, c.c_bool, c.c_bool, c.c_bool,
                 c.c_void_p, c.c_size_t, c.c_void_p, Log, c.c_void_p]


def instance(token):
    return make(b"finger", token, None, False, False, False, False, None, 0, None, log, None)


assert not instance(b"another") and "another model" in said.pop()
one = c.c_void_p(instance(description.get("instantiationToken").encode()))
assert one


def call(name, *arguments):
    return getattr(library, name)(one, *arguments)


def put(values):
    n = len(values)
    return call("fmi3SetFloat64", (c.c_uint32 * n)(*[reference[k] for k in values]), c.c_size_t(n),
                (c.c_double * n)(*values.values()), c.c_size_t(n))


def get(names):
    n = len(names)
    found = (c.c_double * n)()
    assert call("fmi3GetFloat64", (c.c_uint32 * n)(*[reference[k] for k in names]), c.c_size_t(n),
                found, c.c_size_t(n)) == 0
    return list(found)


def step(time, by):
    flags = [c.c_bool() for _ in range(3)]
    reached = c.c_double()
    status = call("fmi3DoStep", c.c_double(time), c.c_double(by), True,
                  *[c.byref(f) for f in flags], c.byref(reached))
    assert status == 0 and abs(reached.value - time - by) < 1e-15, said
    return reached.value


joints = [f"q{i}" for i in range(20, 24)]
start = dict(zip(joints, [0.1, 0.3, 0.4, 0.2]))
assert call("fmi3EnterInitializationMode", False, c.c_double(0), c.c_double(0), False,
            c.c_double(0)) == 0
assert put({f"q_start.{k}": v for k, v in start.items()}) == 0
assert put({"tendon_force.h1": 2.0, "tendon_force.h2": 2.5, "tendon_force.h3": 2.0,
            "tendon_force.h4": 2.4, "tendon_force.h5": 1.0, "tendon_force.h6": 1.2,
            "joint_torque.q23": 1e-4}) == 0
assert call("fmi3ExitInitializationMode") == 0
assert get([f"q.{k}" for k in joints]) == list(start.values())
assert put({"q.q20": 1.0}) == 3 and "only inputs" in said.pop()  # an output is not set
state = c.c_void_p()
assert call("fmi3GetFMUState", c.byref(state)) == 0
names = [f"q.{k}" for k in joints] + [f"qd.{k}" for k in joints] + ["tip.x", "tendon_length.h7"]
time = 0.0
for _ in range(20):
    time = step(time, 0.001)
moved = get(names)
# The same from the kept state, in other communication steps: the integration's own error apart.
assert call("fmi3SetFMUState", state) == 0
for at in range(5):
    step(at * 0.004, 0.004)
assert max(abs(a - b) for a, b in zip(get(names), moved)) < 1e-9
assert call("fmi3FreeFMUState", c.byref(state)) == 0
library.fmi3FreeInstance(one)

# Apart from the unit: the emitted C alone, by the explicit midpoint rule with far shorter steps.
program = folder + "/apart"
open(program + ".c", "w").write(r"""
#include <stdio.h>
#include "index.h"
static void rate(const double *q, const double *qd, double *qdd) {
  const double f[8] = {2.0, 2.5, 2.0, 2.4, 1.0, 1.2, 0, 0};
  double tau[4];
  index_joint_torque(q, f, tau);
  tau[3] += 1e-4;
  for (int i = 0; i < 4; ++i) tau[i] -= 1e-4 * qd[i];
  index_forward_dynamics(q, qd, tau, qdd);
}
int main(void) {
  double q[4] = {0.1, 0.3, 0.4, 0.2}, qd[4] = {0}, qm[4], vm[4], a[4], T[16], h[8];
  const int steps = 40000;
  const double dt = 0.02 / steps;
  for (int k = 0; k < steps; ++k) {
    rate(q, qd, a);
    for (int i = 0; i < 4; ++i) qm[i] = q[i] + dt / 2 * qd[i], vm[i] = qd[i] + dt / 2 * a[i];
    rate(qm, vm, a);
    for (int i = 0; i < 4; ++i) q[i] += dt * vm[i], qd[i] += dt * a[i];
  }
  index_forward_kinematics(q, T);
  index_tendon_lengths(q, h);
  for (int i = 0; i < 4; ++i) printf("%.17g ", q[i]);
  for (int i = 0; i < 4; ++i) printf("%.17g ", qd[i]);
  printf("%.17g %.17g\n", T[3], h[6]);
  return 0;
}
""")
subprocess.run(["cc", "-O2", "-ffp-contract=off", "-I" + sources, program + ".c",
                sources + "/index.c", "-o", program], check=True)
apart = [float(x) for x in subprocess.run([program], check=True, capture_output=True).stdout.split()]
for name, a, b in zip(names, moved, apart):
    if abs(a - b) > 1e-7 * max(1.0, abs(b)):
        sys.exit(f"the motion differs: {name} is {a}, apart from the unit {b}")
assert max(abs(apart[i] - q) for i, q in enumerate(start.values())) > 0.01, "it hardly moved"
print(f"{len(variables)} variables; after 20 ms the unit is where the emitted C is")
