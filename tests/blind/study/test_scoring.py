# SPDX-License-Identifier: GPL-3.0-or-later
"""Each rule of scoring with the defect that it is there for. Seen to fail: matched() by name alone (without
place) lets a wrong place and a repeated name pass; right without len(told) lets a surplus set pass;
check_seal() without its first rule lets a dropped cause pass, without that of drives a model that lacks none;
drives_told() of any name, or with a rotor that was not told taken for right; check_sealed() without its list of files
lets a seal in the folder pass."""
import copy
import json
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import page  # noqa: E402
import results  # noqa: E402
import run_study  # noqa: E402
import score  # noqa: E402
import trials  # noqa: E402


def seal(*hidden, family="one", size=1.0):
    return {"family": family, "size": size, "reachable": True,
            "hidden": [{"cause": c, "place": p, "excess": size, **({"order": o} if o else {})}
                       for c, p, o in hidden]}


def findings(*sets, none=False):
    causes = [{"members": [{"name": n, "place": p} for n, p in s], "confidence": 0.9, "parameters": []}
              for s in sets]
    return {"verdict": {"causes": causes, "outcome": "causes named" if causes else "nothing beyond noise",
                        "unexplained": {"none_of_the_known": none}},
            "extension": {"adopted": False}, "seconds": 1.0, "logs": []}


STRIBECK = ("Stribeck friction", "joint j2")
COULOMB = ("Coulomb friction level", "joint j1")


class Names(unittest.TestCase):
    def test_the_right_name_at_the_right_place_is_right(self):
        s = score.score(seal(("stribeck", "joint j2", 0)), findings([STRIBECK]))
        self.assertTrue(s["right"] and s["inside"])
        self.assertEqual(s["false_names"], 0)

    def test_a_wrong_place_is_wrong(self):
        s = score.score(seal(("stribeck", "joint j1", 0)), findings([STRIBECK]))
        self.assertFalse(s["right"] or s["inside"])
        self.assertEqual(s["false_names"], 1)

    def test_a_repeated_name_elsewhere_is_a_false_name(self):
        s = score.score(seal(("stribeck", "joint j2", 0)), findings([STRIBECK], [("Stribeck friction", "joint j3")]))
        self.assertFalse(s["right"] or s["inside"])
        self.assertEqual(s["false_names"], 1)

    def test_one_set_told_twice_counts_once(self):
        s = score.score(seal(("stribeck", "joint j2", 0)), findings([STRIBECK], [STRIBECK]))
        self.assertFalse(s["right"])
        self.assertEqual(s["false_names"], 1)

    def test_a_later_member_is_in_the_set_and_not_right(self):
        s = score.score(seal(("stribeck", "joint j2", 0)), findings([COULOMB, STRIBECK]))
        self.assertFalse(s["right"])
        self.assertTrue(s["inside"])

    def test_one_set_does_not_serve_two_causes(self):
        both = seal(("stribeck", "joint j2", 0), ("coulomb_level", "joint j1", 0), family="two")
        self.assertFalse(score.score(both, findings([STRIBECK, COULOMB]))["inside"])
        self.assertTrue(score.score(both, findings([COULOMB], [STRIBECK]))["right"])

    def test_a_dropped_cause_of_two_is_not_right(self):
        both = seal(("stribeck", "joint j2", 0), ("coulomb_level", "joint j1", 0), family="two")
        s = score.score(both, findings([STRIBECK]))
        self.assertFalse(s["right"] or s["inside"])
        self.assertEqual(s["false_names"], 0)

    def test_a_ripple_needs_its_order(self):
        hidden = seal(("input_ripple", "motor", 2))
        self.assertTrue(score.score(hidden, findings([("ripple 2 times per motor turn", "motor")]))["right"])
        self.assertFalse(score.score(hidden, findings([("ripple once per motor turn", "motor")]))["right"])

    def test_gravity_goes_by_the_names_that_are_told(self):
        # Seen to fail: without these two names every gravity that was told counted as an unknown name.
        for cause, name in (("gravity", "direction of gravity"), ("gravity_left_out", "gravity left out")):
            self.assertTrue(score.score(seal((cause, "base", 0)), findings([(name, "base")]))["right"])

    def test_what_is_wrong_with_a_link_is_right_at_that_link_alone(self):
        for cause in ("link_mass", "link_centre", "link_products"):
            hidden = seal((cause, "link l2", 0))
            self.assertTrue(score.score(hidden, findings([("inertial parameters", "link l2")]))["right"])
            self.assertFalse(score.score(hidden, findings([("inertial parameters", "link l1")]))["right"])

    def test_a_ratio_is_no_pulley(self):
        hidden = seal(("coupling_ratio", "joint q22", 0))
        self.assertTrue(score.score(hidden, findings([("ratio of coupled joints", "joint q22")]))["right"])
        self.assertFalse(score.score(hidden, findings([("pulley radius", "joint q22")]))["right"])

    def test_an_unknown_name_is_false(self):
        self.assertEqual(score.score(seal(family="null"), findings([("gremlins", "motor")]))["false_names"], 1)

    def test_of_a_model_without_drives_every_rotor_counts(self):
        told = findings([("inertia", "joint j1")], [("inertial parameters", "link l2")])
        told["verdict"]["causes"][0]["parameters"] = [{"name": "inertia_change", "value": 0.19}]
        told["channels"] = [{"name": "effort of j1", "relative_error_before": 0.8, "relative_error_after": 0.01}]
        bare = {"family": "drives", "drives": [{"joint": "j1", "armature": 0.2}, {"joint": "j2", "armature": 0.1}]}
        found = score.drives_told(bare, told)
        self.assertAlmostEqual(found["rotors"]["j1"], 0.95)
        self.assertIsNone(found["rotors"]["j2"])
        self.assertEqual(found["errors"], {"effort of j1": [0.8, 0.01]})

    def test_a_model_without_drives_says_which_it_lacks(self):
        bare = seal(family="drives")
        self.assertRaises(score.BrokenTrial, score.check_seal, bare, "drives", 1.0)
        score.check_seal({**bare, "drives": [{"joint": "j1", "armature": 0.2}]}, "drives", 1.0)

    def test_outside_every_name_is_wrong(self):
        s = score.score(seal(("latch", "joint j2", 0), family="outside"), findings([STRIBECK], none=True))
        self.assertEqual(s["false_names"], 1)
        self.assertTrue(s["none_of_the_known"])


class Seals(unittest.TestCase):
    def test_a_dropped_cause_is_no_trial(self):
        two = seal(("stribeck", "joint j2", 0), ("offset", "joint j1", 0), family="two")
        score.check_seal(two, "two", 1.0)
        dropped = copy.deepcopy(two)
        dropped["hidden"].pop()
        with self.assertRaisesRegex(score.BrokenTrial, "hides 1 causes"):
            score.check_seal(dropped, "two", 1.0)

    def test_an_easier_size_is_no_trial(self):
        easier = seal(("stribeck", "joint j2", 0), size=2.0)
        with self.assertRaisesRegex(score.BrokenTrial, "has the size"):
            score.check_seal(easier, "one", 1.0)

    def test_unreachable_is_said(self):
        silent = seal(("backlash", "motor", 0))
        silent["reachable"] = False
        with self.assertRaisesRegex(score.BrokenTrial, "not said"):
            score.check_seal(silent, "one", 1.0)

    def test_a_fault_that_no_channel_shows_is_said(self):
        # Seen to fail where causes alone were asked: a study ended at its first wrist with another clock.
        clock = {"family": "fault", "hidden": [], "reachable": False,
                 "fault": {"fault": "clock", "channel": "time", "unreachable": "no channel shows it"}}
        score.check_seal(clock, "fault", 1.0)
        del clock["fault"]["unreachable"]
        with self.assertRaisesRegex(score.BrokenTrial, "not said"):
            score.check_seal(clock, "fault", 1.0)

    def test_one_cause_twice_is_no_pair(self):
        twice = seal(("offset", "motor", 0), ("offset", "motor", 0), family="two")
        with self.assertRaisesRegex(score.BrokenTrial, "twice"):
            score.check_seal(twice, "two", 1.0)


class Leaks(unittest.TestCase):
    def folder(self, files):
        place = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory())) / "000007"
        for name, text in {"model/mechanism.toml": "[mechanism]\n", "train.csv": "time [s]\n",
                           "holdout.csv": "time [s]\n", **files}.items():
            (place / name).parent.mkdir(parents=True, exist_ok=True)
            (place / name).write_text(text, encoding="utf-8")
        return place

    def test_a_clean_folder_is_let_through(self):
        trials.check_sealed(self.folder({}), seal(("stribeck", "motor", 0)))

    def test_a_key_of_the_model_is_no_leak(self):
        trials.check_sealed(self.folder({"model/mechanism.toml": "[mechanism]\ngravity = 9.81\n"}),
                            seal(("gravity", "base", 0)))

    def test_a_seal_in_the_folder_is_a_leak(self):
        with self.assertRaisesRegex(trials.Leak, "no part of a model"):
            trials.check_sealed(self.folder({"seal.json": "{}"}), seal(("stribeck", "motor", 0)))

    def test_a_model_that_says_the_cause_is_a_leak(self):
        with self.assertRaisesRegex(trials.Leak, "says 'stribeck'"):
            trials.check_sealed(self.folder({"model/mechanism.toml": "# stribeck\n"}),
                                seal(("stribeck", "motor", 0)))

    def test_a_column_that_says_the_cause_is_a_leak(self):
        with self.assertRaisesRegex(trials.Leak, "says 'backlash'"):
            trials.check_sealed(self.folder({"train.csv": "time [s],backlash [1]\n"}),
                                seal(("backlash", "motor", 0)))

    def test_a_folder_that_says_the_cause_is_a_leak(self):
        place = self.folder({})
        named = place.rename(place.with_name("stribeck_7"))
        with self.assertRaisesRegex(trials.Leak, "name tells"):
            trials.check_sealed(named, seal(("stribeck", "motor", 0)))


class Counts(unittest.TestCase):
    def test_seeds_are_the_hash_s_and_not_development_s(self):
        one = trials.seed_of("ab", "drive", "one", 1.0, 0)
        self.assertGreaterEqual(one, trials.FIRST_SEED)
        self.assertNotEqual(one, trials.seed_of("ac", "drive", "one", 1.0, 0))
        self.assertEqual(one, trials.seed_of("ab", "drive", "one", 1.0, 0))

    def test_logs_that_are_missing_are_no_trial(self):
        # Seen to fail: with "--log train.csv" alone a second log was written and never read.
        place = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        for name in ("train.csv", "train2.csv", "holdout.csv"):
            (place / name).write_text("time [s]\n", encoding="utf-8")
        self.assertEqual(trials.training_logs(place, 2), ["--log", "train.csv", "--log", "train2.csv"])
        with self.assertRaisesRegex(score.BrokenTrial, "2 logs for training, asked for 1"):
            trials.training_logs(place, 1)

    def test_several_logs_are_trials_of_their_own(self):
        one = {"plant": "joint", "family": "one", "size": 0.5, "cause": "", "number": 3, "logs": 1}
        self.assertNotEqual(trials.name_of(one), trials.name_of({**one, "logs": 2}))
        self.assertNotEqual(trials.seed_of("ab", "joint", "one", 0.5, 3), trials.seed_of("ab", "joint", "one", 0.5, 3, "", 2))
        in_turn = {**one, "cause": "delay", "each": True}
        self.assertEqual(page.standard([one, {**one, "logs": 2}, {**one, "cause": "delay"}, in_turn]), [one, in_turn])

    def test_the_standard_table_keeps_its_size(self):
        here = pathlib.Path(__file__).parent
        table = trials.in_turn(trials.rows(here / "rows.csv", 1), trials.causes_of(here / "causes.csv"))
        self.assertLessEqual(sum(row[3] for row in table), 1400)

    def test_every_cause_gets_its_trials_in_turn(self):
        # Seen to fail: drawn, 22 causes share 220 trials as chance will, and some have four.
        rows = trials.in_turn([("drive", "one", 1.0, 3, "each", 1), ("drive", "null", 1.0, 2, "", 1)],
                              {"drive": ["delay", "offset"]})
        listed = trials.listed("ab", rows)
        self.assertEqual([t["cause"] for t in listed if t["each"]], ["delay", "offset"] * 3)
        self.assertEqual(len({t["seed"] for t in listed}), 8)
        self.assertEqual(len({trials.name_of(t) for t in listed}), 8)
        self.assertEqual([t["cause"] for t in run_study.shortened(listed, 0.4)], ["", "delay", "offset"])

    def test_standard_rows_hold_ten_of_each_cause_of_small_plants(self):
        here = pathlib.Path(__file__).parent
        for plant in ("drive", "joint", "lever", "wrist"):
            counts = [n for p, f, _, n, cause, logs in trials.rows(here / "rows.csv", 1)
                      if (p, f, cause, logs) == (plant, "one", "each", 1)]
            self.assertGreaterEqual(sum(counts), 10)

    def test_causes_with_fewer_than_ten_trials_are_told(self):
        line = {"plant": "drive", "family": "one", "size": 1.0, "status": "ran", "right": True,
                "seal": {"hidden": [{"cause": "delay"}], "traits": {}}}
        self.assertIn("delay (9)", page.too_few([line] * 9))
        # Seen to fail: counted with those that no dose reached, nine and one were ten.
        self.assertIn("delay (9)", page.too_few([line] * 9 + [{**line, "status": "unreachable"}]))
        self.assertNotIn("delay", page.too_few([line] * 10))

    def test_evidence_sorts_trials_by_what_is_to_be_seen(self):
        # Planted defect: with "low < nats" the one at 12 stands in no row.
        def line(nats, right):
            return {"plant": "drive", "family": "one", "size": 1.0, "status": "ran", "cause": "delay", "right": right,
                    "detected": right, "inside": right,
                    "seal": {"hidden": [{"cause": "delay", "place": "motor", "nats": nats}]}}
        rows = page.evidence([line(3.0, False), line(12.0, True), line(900.0, True)]).splitlines()[2:]
        self.assertEqual([row.split(" | ")[1] for row in rows], ["1", "1", "0", "0", "0", "1"])
        self.assertIn("delay (1)", rows[0])
        self.assertNotIn("delay", rows[1])

    def test_the_picture_has_every_cause_with_its_interval(self):
        lines = [{"plant": "drive", "family": "one", "size": 1.0, "status": "ran", "right": right, "cause": "",
                  "seal": {"hidden": [{"cause": "delay"}], "traits": {}}} for right in (True, False)]
        drawn = page.picture_of_causes(lines)
        self.assertIn(">delay<", drawn)
        self.assertIn("1 of 2", drawn)

    def test_the_engine_s_hash_follows_its_sources(self):
        root = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        (root / "identification").mkdir()
        source = root / "identification" / "a.cpp"
        source.write_text("int a;", encoding="utf-8")
        before = trials.engine_hash(root)
        source.write_text("int b;", encoding="utf-8")
        self.assertNotEqual(before, trials.engine_hash(root))

    def test_unreachable_trials_are_not_misses_and_refused_ones_are(self):
        lines = [{"status": "unreachable"}, {"status": "refused"}, {"status": "ran", "right": True}]
        r = results.rate(results.counted(lines), results.said("right"))
        self.assertEqual((r.hits, r.trials), (1, 2))

    def test_wilson_s_interval(self):
        low, high = results.wilson(9, 10)
        self.assertAlmostEqual(low, 0.596, 3)
        self.assertAlmostEqual(high, 0.982, 3)

    def test_a_fault_counts_where_its_channel_is_named(self):
        fault = {**seal(family="fault"), "fault": {"fault": "unit", "channel": "q_j1", "factor": 57.3}}
        self.assertTrue(score.fault_found(fault, None, "log.csv:1:2: 'q_j1' is in degrees\n", {}))
        self.assertTrue(score.fault_found(fault, None, "log.csv:1:2: 'ch01' is in degrees\n", {"q_j1": "ch01"}))
        self.assertFalse(score.fault_found(fault, None, "log.csv:1:2: 'q_j2' is in degrees\n", {}))


    def test_what_is_told_of_the_other_log_as_well_is_no_fault_found(self):
        # Seen to fail: what is wrong with both logs, and so with the model, counted as found whatever was planted.
        fault = {**seal(family="fault"), "fault": {"fault": "unit", "channel": "bend", "factor": 1000.0}}
        told = findings()
        left = "of 'bend' the model leaves {} % over"
        told["logs"] = [{"held_out": False, "faults": ["train.csv:0:5: " + left.format(71.2)]},
                        {"held_out": True, "faults": ["holdout.csv:0:5: " + left.format(64)]}]
        self.assertFalse(score.fault_found(fault, told, "", {}))
        told["logs"][0]["faults"].append("train.csv:2:5: 'bend' is 1000 times too large")
        self.assertTrue(score.fault_found(fault, told, "", {}))

    def test_what_is_told_of_some_row_is_no_fault_of_the_column(self):
        # Seen to fail: a bend that rests at its highest value in one of two logs counted as degrees found.
        fault = {**seal(family="fault"), "fault": {"fault": "unit", "channel": "bend", "factor": 57.3}}
        told = findings()
        told["logs"] = [{"held_out": False, "faults": ["train.csv:9002:5: 'bend' stays at its limit 90.2"]}]
        self.assertFalse(score.fault_found(fault, told, "", {}))
        told["logs"][0]["faults"].append("train.csv:0:5: of 'bend' the model leaves 98 % over")
        self.assertTrue(score.fault_found(fault, told, "", {}))

    def test_a_refusal_is_read_from_standard_output(self):
        # Seen to fail: with standard error alone, which --json leaves empty, refusals named no channel: 3 of 25.
        text = json.dumps({"errors": [{"message": "'f' acts against 'x'", "file": "train.csv", "line": 2, "column": 3}]})
        self.assertEqual(trials.errors_told(text, ""), "train.csv:2:3: 'f' acts against 'x'")
        self.assertEqual(trials.errors_told("", "no model"), "no model")

    def test_an_alarm_where_nothing_was_done_to_a_log_is_counted(self):
        told = findings()
        told["logs"] = [{"held_out": False, "faults": ["train.csv:2:5: 'bend' stays"]}]
        self.assertEqual(score.score(seal(family="null"), told)["alarms"], 1)

    def test_an_interval_that_misses_is_counted(self):
        hidden = seal(("viscous_level", "joint j1", 0))
        hidden["hidden"][0]["parameter"] = {"name": "viscous_change", "value": 1.0}
        told = findings([("viscous friction level", "joint j1")])
        told["verdict"]["causes"][0]["parameters"] = [{"name": "viscous_change", "value": 1.3, "standard_error": 0.1}]
        self.assertFalse(score.in_interval(hidden, told)[0]["holds"])
        told["verdict"]["causes"][0]["parameters"][0]["value"] = 1.1
        self.assertTrue(score.in_interval(hidden, told)[0]["holds"])


class Pairs(unittest.TestCase):
    def pair(self, apart=0.05):
        s = seal(("offset", "motor", 0), family="pair")
        return {**s, "admissible": [{"cause": "offset", "place": "motor"},
                                    {"cause": "coulomb_level", "place": "motor"}], "apart": apart}

    def test_a_pair_that_the_log_tells_apart_is_no_trial(self):
        score.check_seal(self.pair(), "pair", 1.0)
        with self.assertRaisesRegex(score.BrokenTrial, "told from the others"):
            score.check_seal(self.pair(0.7), "pair", 1.0)
        alone = self.pair()
        alone["admissible"] = alone["admissible"][1:]
        with self.assertRaisesRegex(score.BrokenTrial, "no others"):
            score.check_seal(alone, "pair", 1.0)

    def test_a_pair_is_told_as_a_set_that_holds_the_truth(self):
        offset, level = ("offset", "motor"), ("Coulomb friction level", "motor")
        self.assertTrue(score.pair_told(self.pair(), findings([level, offset])))
        # The truth alone is a guess, the other alone is wrong, and a second set is a false name.
        self.assertFalse(score.pair_told(self.pair(), findings([offset])))
        self.assertFalse(score.pair_told(self.pair(), findings([level, ("delay", "motor")])))
        self.assertFalse(score.pair_told(self.pair(), findings([level, offset], [("delay", "motor")])))
        self.assertFalse(score.pair_told(self.pair(), findings([level, ("offset", "joint j1")])))

    def test_a_pair_s_set_is_not_one_that_is_too_large(self):
        # Seen to fail: with pairs among them the mean of 1 and 3 is 2.
        line = {"plant": "drive", "size": 1.0, "status": "ran", "seal": {"traits": {"motion": "one way"}}}
        goals = page.goals([{**line, "family": "one", "sets": [["a"]]}, {**line, "family": "pair", "sets": [["a", "b", "c"]]}])
        self.assertIn("| all | mean size of a set | ≤ 1.3 | 1.00 | met |", goals)

    def test_settled_is_the_right_one_alone(self):
        offset, level = ("offset", "motor"), ("Coulomb friction level", "motor")
        self.assertTrue(score.settled(self.pair(), findings([offset])))
        for left in ([[level]], [[offset, level]], [[offset], [level]], []):
            self.assertFalse(score.settled(self.pair(), findings(*left)))

    def test_the_motion_that_is_proposed_is_found(self):
        told = findings([("offset", "motor"), ("Coulomb friction level", "motor")])
        self.assertEqual(trials.proposed_motion(told), "")
        told["verdict"]["causes"][0]["separating_motion"] = "experiment_1.csv"
        self.assertEqual(trials.proposed_motion(told), "experiment_1.csv")


if __name__ == "__main__":
    unittest.main()
