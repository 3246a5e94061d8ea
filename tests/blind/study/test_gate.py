# SPDX-License-Identifier: GPL-3.0-or-later
"""The rules of gate.py. Seen to fail: each defect that stands here, planted in a trial's line; and a program that
finds nothing worth naming (`--material 1`), on which every gate for a cause or a structure goes red."""
import pathlib
import unittest

import gate
import score
import trials
from test_scoring import STRIBECK, findings, seal


class Gates(unittest.TestCase):
    """Each defect that gate.py is there for, planted in a trial's line."""

    wish = {"cause": "stribeck", "wanted": "right"}

    def line(self, **changes):
        told = score.score(seal(("stribeck", "joint j2", 0)), findings([STRIBECK]))
        return {"status": "ran", "seal": seal(("stribeck", "joint j2", 0)), **told, **changes}

    def test_a_trial_that_is_what_it_was_passes(self):
        self.assertEqual(gate.failures(self.wish, self.line()), [])

    def test_another_cause_behind_the_seed_fails(self):
        other = seal(("coulomb_level", "joint j2", 0))
        self.assertIn("hides", gate.failures(self.wish, self.line(seal=other))[0])

    def test_a_wrong_name_a_refusal_and_a_crash_fail(self):
        for changes in ({"right": False}, {"status": "refused"}, {"status": "crashed"}):
            self.assertEqual(len(gate.failures(self.wish, self.line(**changes))), 1)

    def test_what_is_told_of_nothing_fails(self):
        silent = {"cause": "", "wanted": "silent"}
        quiet = self.line(seal=seal(family="null"), detected=False)
        self.assertEqual(gate.failures(silent, quiet), [])
        for what in ("detected", "alarms", "adopted"):
            self.assertEqual(len(gate.failures(silent, {**quiet, what: 1})), 1)

    def test_one_name_too_many_is_no_two(self):
        surplus = {"cause": "stribeck", "wanted": "surplus"}
        told = {"sets": [["stribeck@joint j2"], ["delay@joint j2"]], "right": False, "false_names": 1}
        self.assertEqual(gate.failures(surplus, self.line(**told)), [])
        for changes in ({"false_names": 2}, {"sets": [["delay@joint j2"]]}):
            self.assertEqual(len(gate.failures(surplus, self.line(**{**told, **changes}))), 1)

    def test_an_impossible_body_and_a_gain_that_the_c_has_not_fail(self):
        for physical_line in ({"bodies": False}, {"mass_matrix": False},
                              {"gain": {"told": 0.9, "recomputed": 0.8}}, {"not_judged": "KeyError"}):
            self.assertEqual(len(gate.failures(self.wish, self.line(physical=physical_line))), 1)

    def test_every_plant_has_gates_and_every_wish_a_meaning(self):
        gates = gate.read_gates(pathlib.Path(gate.__file__).with_name("gates.csv"))
        for g in gates:
            gate.failures(g, self.line())
            self.assertLess(g["seed"], trials.FIRST_SEED)
            self.assertIn(g["when"], ("test", "verify"))


if __name__ == "__main__":
    unittest.main()
