# SPDX-License-Identifier: GPL-3.0-or-later
"""sympy_dynamics.py <robot.urdf> <gx,gy,gz> <out.c> [lagrange]

The dynamics of a chain of revolute joints about z as SymPy gives them: derived symbolically, common
subexpressions found by cse, printed by ccode. The peer that a user of SymPy would write.

  sympy_inverse_dynamics, sympy_bias, sympy_mass_matrix   Newton-Euler recursion
  sympy_lagrange_inverse_dynamics                         d/dt dL/dqd - dL/dq (with `lagrange`)
"""
import math
import sys
import xml.etree.ElementTree as xml

import sympy as sp


def numbers(text):
    return [float(word) for word in text.split()]


def exact(value):
    """Entries of rotations by quarter turns are 0 and +-1, not 6e-17."""
    return sp.Integer(round(value)) if abs(value - round(value)) < 1e-12 else sp.Float(value)


def number(value):
    return sp.Integer(0) if value == 0 else sp.Float(value)


def rotation(rpy):
    (sr, sp_, sy), (cr, cp, cy) = map(math.sin, rpy), map(math.cos, rpy)
    rows = [[cy * cp, cy * sp_ * sr - sy * cr, cy * sp_ * cr + sy * sr],
            [sy * cp, sy * sp_ * sr + cy * cr, sy * sp_ * cr - cy * sr],
            [-sp_, cp * sr, cp * cr]]
    return sp.Matrix(3, 3, [exact(entry) for row in rows for entry in row])


class Link:
    def __init__(self, joint, link):
        origin = joint.find("origin")
        placed = {} if origin is None else origin.attrib
        self.turn = rotation(numbers(placed.get("rpy", "0 0 0")))
        self.place = sp.Matrix([number(x) for x in numbers(placed.get("xyz", "0 0 0"))])
        inertial = link.find("inertial")
        self.mass = sp.Float(inertial.find("mass").get("value"))
        self.centre = sp.Matrix([number(x) for x in numbers(inertial.find("origin").get("xyz"))])
        entry = {key: number(float(x)) for key, x in inertial.find("inertia").attrib.items()}
        self.inertia = sp.Matrix(3, 3, lambda r, c: entry["i" + "".join(sorted("xyz"[r] + "xyz"[c]))])


def read_chain(file):
    root = xml.parse(file).getroot()
    links = {link.get("name"): link for link in root.findall("link")}
    chain = []
    for joint in root.findall("joint"):
        if joint.get("type") != "revolute" or numbers(joint.find("axis").get("xyz")) != [0, 0, 1]:
            sys.exit(f"{file}: joint {joint.get('name')}: only revolute joints about z are understood")
        chain.append(Link(joint, links[joint.find("child").get("link")]))
    return chain


def about_z(angle):
    c, s = sp.cos(angle), sp.sin(angle)
    return sp.Matrix([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def newton_euler(chain, q, qd, qdd, gravity):
    z = sp.Matrix([0, 0, 1])
    spin, spin_rate, acceleration = sp.zeros(3, 1), sp.zeros(3, 1), -gravity
    turns, forces, moments = [], [], []
    for link, angle, rate, rate_rate in zip(chain, q, qd, qdd):
        turn = link.turn * about_z(angle)
        moved = acceleration + spin_rate.cross(link.place) + spin.cross(spin.cross(link.place))
        spin, spin_rate, acceleration = turn.T * spin, turn.T * spin_rate, turn.T * moved
        spin_rate = spin_rate + spin.cross(z * rate) + z * rate_rate
        spin = spin + z * rate
        force = link.mass * (acceleration + spin_rate.cross(link.centre)
                             + spin.cross(spin.cross(link.centre)))
        turns.append(turn)
        forces.append(force)
        moments.append(link.inertia * spin_rate + spin.cross(link.inertia * spin)
                       + link.centre.cross(force))
    torques = [None] * len(chain)
    for i in reversed(range(len(chain))):
        torques[i] = moments[i][2]
        if i:
            passed = turns[i] * forces[i]
            forces[i - 1] = forces[i - 1] + passed
            moments[i - 1] = moments[i - 1] + turns[i] * moments[i] + chain[i].place.cross(passed)
    return torques


def lagrange(chain, q, qd, qdd, gravity):
    turn, place = sp.eye(3), sp.zeros(3, 1)
    energy = 0
    spin = sp.zeros(3, 1)
    for link, angle, rate in zip(chain, q, qd):
        place = place + turn * link.place
        turn = turn * link.turn * about_z(angle)
        spin = (link.turn * about_z(angle)).T * spin + sp.Matrix([0, 0, rate])
        centre = place + turn * link.centre
        speed = centre.jacobian(q) * sp.Matrix(qd)
        energy += (link.mass * speed.dot(speed) + spin.dot(link.inertia * spin)) / 2
        energy += link.mass * gravity.dot(centre)
    torques = []
    for angle, rate in zip(q, qd):
        momentum = sp.diff(energy, rate)
        torques.append(sum(sp.diff(momentum, x) * xd for x, xd in zip(q, qd))
                       + sum(sp.diff(momentum, xd) * xdd for xd, xdd in zip(qd, qdd))
                       - sp.diff(energy, angle))
    return torques


def c_function(name, results, arrays):
    shared, reduced = sp.cse(results, symbols=sp.numbered_symbols("t"))
    lines = [f"void {name}(const double *q, const double *qd, const double *u, double *out)", "{"]
    lines += ["    (void)q, (void)qd, (void)u;"]
    lines += [f"    const double {s} = {sp.ccode(e.xreplace(arrays))};" for s, e in shared]
    lines += [f"    out[{i}] = {sp.ccode(e.xreplace(arrays))};" for i, e in enumerate(reduced)]
    return "\n".join(lines + ["}", ""])


def main():
    file, gravity_text, out = sys.argv[1:4]
    chain = read_chain(file)
    gravity = sp.Matrix([number(float(x)) for x in gravity_text.split(",")])
    n = len(chain)
    q, qd, qdd = ([sp.Symbol(f"{name}_{i}") for i in range(n)] for name in ("q", "qd", "u"))
    arrays = {s: sp.Symbol("{}[{}]".format(*s.name.split("_"))) for s in q + qd + qdd}
    zeros = [sp.Integer(0)] * n
    unit = lambda j: [sp.Integer(int(i == j)) for i in range(n)]
    columns = [newton_euler(chain, q, zeros, unit(j), sp.zeros(3, 1)) for j in range(n)]
    functions = {
        "sympy_inverse_dynamics": newton_euler(chain, q, qd, qdd, gravity),
        "sympy_bias": newton_euler(chain, q, qd, zeros, gravity),
        "sympy_mass_matrix": [columns[max(i, j)][min(i, j)] for i in range(n) for j in range(n)],
    }
    if "lagrange" in sys.argv[4:]:
        functions["sympy_lagrange_inverse_dynamics"] = lagrange(chain, q, qd, qdd, gravity)
    with open(out, "w", encoding="ascii") as c:
        c.write("/* Made by sympy_dynamics.py. */\n#include <math.h>\n\n")
        for name, results in functions.items():
            c.write(c_function(name, results, arrays) + "\n")


main()
