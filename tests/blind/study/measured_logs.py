# SPDX-License-Identifier: GPL-3.0-or-later
"""measured_logs.py <sinew> <folder>: what `sinew diagnose` says of the two measured logs beside the
project, each with a model of its joint as a data sheet gives it; a line of JSON each to stdout, none for a
log that is not there."""
import json
import pathlib
import subprocess
import sys

DATA = pathlib.Path("../shared/data")
ROBOT = """<robot name="{name}">
  <link name="base"/>
  <link name="moving"><inertial><mass value="{mass}"/>
    <inertia ixx="{inertia}" iyy="{inertia}" izz="{inertia}" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="j" type="{kind}"><parent link="base"/><child link="moving"/><axis xyz="{axis}"/>
    <limit lower="-3" upper="3" effort="1000" velocity="10"/>
    <dynamics damping="{damping}" friction="{friction}"/></joint>
</robot>
"""
LOGS = [
    {"log": "positioning drive", "file": "emps/data_emps.csv", "motor_turn": (2.5, "mm"),
     "robot": {"name": "slide", "kind": "prismatic", "axis": "1 0 0", "mass": 95, "inertia": 1, "damping": 200,
               "friction": 20},
     "map": ["time=t_s [s]", "q_j=q_meas_m [m]", "q_j_ref=q_ref_m [m]", "tau_j=force_N [N]"]},
    {"log": "cable joint", "file": "dvrk_mtm/mtm_joint_test_cable.csv", "motor_turn": None,
     "robot": {"name": "wrist", "kind": "revolute", "axis": "0 0 1", "mass": 0.1, "inertia": 1e-3, "damping": 0,
               "friction": 0},
     "map": ["time=t_s [s]", "q_j=q1 [rad]", "tau_j=tau1 [N*m]"]},
]


def model(sinew, folder, each):
    robot = folder / (each["robot"]["name"] + ".urdf")
    robot.write_text(ROBOT.format(**each["robot"]), encoding="utf-8")
    made = folder / each["robot"]["name"]
    subprocess.run([sinew, "import", robot, "--out", made], check=True, stdout=subprocess.DEVNULL)
    if each["motor_turn"]:
        value, unit = each["motor_turn"]
        file = made / "mechanism.toml"
        text = file.read_text(encoding="utf-8")
        turn = f'motor_turn = {{ value = {value}, unit = "{unit}", from = "assumed" }}\n'
        file.write_text(text.replace("max_velocity", turn + "max_velocity", 1), encoding="utf-8")
    return made


def diagnosed(sinew, folder, each):
    command = [sinew, "diagnose", model(sinew, folder, each), "--log", DATA / each["file"], "--dry-run",
               "--json", "--out", folder / "found"]
    for text in each["map"]:
        command += ["--map", text]
    ended = subprocess.run(command, capture_output=True, text=True)
    if ended.returncode not in (0, 1):
        sys.exit(f"{each['file']}: {ended.stderr}")
    return json.loads(ended.stdout)["verdict"]


def main():
    sinew, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    for each in LOGS:
        if not (DATA / each["file"]).exists():
            continue
        verdict = diagnosed(sinew, folder, each)
        delays = [p["value"] for cause in verdict["causes"] for p in cause["parameters"]
                  if p["name"] == "delay"]
        print(json.dumps({"log": each["log"], "error": verdict["relative_error_after"], "delays": delays,
                          "named": [cause["members"][0]["name"] for cause in verdict["causes"]],
                          "ruled_out": [out["name"] for out in verdict["ruled_out"]]}))


main()
