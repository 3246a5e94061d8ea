# SPDX-License-Identifier: GPL-3.0-or-later
"""chain_growth.py <sinew> <scratch folder> <out.csv> [joints...]

Processor seconds of `sinew generate`, and the operations of what it emits, for chains of 2 to 30
joints. Every chain is as general as chains come: full inertias, arbitrary offsets, each joint turned
against the one before it by arbitrary angles.
"""
import json
import pathlib
import random
import resource
import subprocess
import sys


def triple(chance, low, high):
    return " ".join(f"{chance.uniform(low, high):.6f}" for _ in range(3))


def link(chance, i):
    a, b, c = (chance.uniform(2e-3, 4e-3) for _ in range(3))
    xy, xz, yz = (chance.uniform(-5e-4, 5e-4) for _ in range(3))
    return (f'  <link name="l{i}"><inertial><origin xyz="{triple(chance, -0.1, 0.1)}"/>'
            f'<mass value="{chance.uniform(0.5, 2.0):.6f}"/><inertia ixx="{a:.8f}" iyy="{b:.8f}" '
            f'izz="{c:.8f}" ixy="{xy:.8f}" ixz="{xz:.8f}" iyz="{yz:.8f}"/></inertial></link>')


def joint(chance, i):
    parent = f"l{i - 1}" if i else "base"
    return (f'  <joint name="j{i}" type="revolute"><parent link="{parent}"/><child link="l{i}"/>'
            f'<origin xyz="{triple(chance, -0.3, 0.3)}" rpy="{triple(chance, -1.5, 1.5)}"/>'
            '<axis xyz="0 0 1"/><limit lower="-3" upper="3" effort="10" velocity="5"/></joint>')


def urdf(joints):
    chance = random.Random(joints)
    lines = [f'<robot name="chain{joints}">', '  <link name="base"/>']
    lines += [link(chance, i) for i in range(joints)] + [joint(chance, i) for i in range(joints)]
    return "\n".join(lines + ["</robot>", ""])


def processor_seconds(command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def operations(folder):
    manifest = json.loads((folder / "manifest.json").read_text(encoding="utf-8"))
    return {f["name"].split("_", 1)[1]: f["operations"]["multiply_add"]
            for f in manifest["functions"]}


def main():
    sinew, place, out = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]
    sizes = [int(word) for word in sys.argv[4:]] or [2, 4, 6, 8, 10, 12, 15, 20, 25, 30]
    place.mkdir(parents=True, exist_ok=True)
    with open(out, "w", encoding="ascii") as csv:
        csv.write("joints,seconds,inverse_dynamics,mass_matrix,forward_dynamics,coriolis_matrix\n")
        for joints in sizes:
            file, model = place / f"chain{joints}.urdf", place / "models" / f"chain{joints}"
            file.write_text(urdf(joints), encoding="ascii")
            subprocess.run([sinew, "import", str(file), "--out", str(model), "--force"], check=True,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            emitted = place / "generated" / f"chain{joints}"
            seconds = processor_seconds([sinew, "generate", str(model), "--out", str(emitted)])
            counts = operations(emitted)
            csv.write(f"{joints},{seconds:.3f},{counts['inverse_dynamics']},"
                      f"{counts['mass_matrix']},{counts['forward_dynamics']},"
                      f"{counts['coriolis_matrix']}\n")
            csv.flush()


if __name__ == "__main__":
    main()
