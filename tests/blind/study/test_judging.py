# SPDX-License-Identifier: GPL-3.0-or-later
"""What judges an adopted model by physics: the documented filter, the held-out gain, bodies, simulation. Each rule
with the defect that it is there for."""
import math
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import compared  # noqa: E402
import filters  # noqa: E402
import gains  # noqa: E402
import physical  # noqa: E402
import rigs  # noqa: E402


class Compared(unittest.TestCase):
    def test_derivatives_pass_what_is_below_the_band(self):
        # Seen to fail: by differences of the smoothed position the acceleration at 25 Hz of 250 is 12 % short.
        step, w = 0.004, 2 * math.pi * 20.0
        x = [math.sin(w * step * k) for k in range(2000)]
        a = filters.smoothed(x, step, 25.0, 2)
        middle = range(200, 1800)
        worst = max(abs(a[k] + w * w * x[k]) for k in middle)
        self.assertLess(worst, 0.004 * w * w)
        slope = filters.smoothed([0.5 * step * k for k in range(500)], step, 25.0, 1)
        self.assertAlmostEqual(slope[250], 0.5)

    def test_a_comparison_is_flat_in_its_band_and_stopped_above(self):
        behind = filters.Comparison(0.002, 60.0)
        self.assertEqual(behind.every, 3)
        for hertz, low, high in ((60.0, 0.99, 1.01), (101.0, 0.0, 0.01)):
            y = behind([math.sin(2 * math.pi * hertz * 0.002 * k) for k in range(4000)])
            self.assertTrue(low < max(abs(v) for v in y) < high, hertz)

    def test_as_many_samples_are_kept_as_are_quick_to_transform(self):
        self.assertEqual([filters.quick_to_transform(n) for n in (658, 648, 1171, 33)], [648, 648, 1152, 32])

    def test_standstill_counts_for_nothing_and_has_flanks(self):
        step = 0.002
        v = [math.copysign(1.0, math.sin(2 * math.pi * 0.5 * step * (k + 0.5))) for k in range(2000)]
        still = compared.standstills([compared.stillness([v, v], step, 50.0)])
        weights = compared.weights(still, range(2000), step)
        self.assertEqual(weights[500], 0.0)  # a reversal
        self.assertEqual(weights[250], 1.0)
        self.assertTrue(0.0 < weights[500 + 4 + 5] < 1.0)
        # At rest for a tenth of a second; slow motion is motion after that.
        v = [1.0] * 500 + [0.0] * 50 + [1.0] * 500
        weights = compared.weights(compared.standstills([compared.stillness([v], step, 50.0)]), range(len(v)), step)
        self.assertEqual((weights[525], weights[100]), (0.0, 1.0))

    def test_a_tendon_that_creeps_in_its_guide_rests(self):
        # Seen to fail without the tendons' rests: a finger's gain of 54 % was worked out as 28 %.
        step, creep = 0.002, 2e-4
        v = [0.01] * 500 + [creep] * 100 + [0.01] * 500
        self.assertEqual(compared.standstills([compared.stillness([v], step, 50.0)]), [])
        [(start, end)] = compared.standstills([compared.stillness([v], step, 50.0, gains.IN_GUIDE)])
        self.assertTrue(start <= 500 and end >= 599 and end - start < 160)
        # Rests count for nothing however many there are, reversals stay where they would take too much.
        few, many, none = [k < 20 for k in range(100)], [k < 80 for k in range(100)], [False] * 100
        self.assertEqual(compared.standstills([(few, none), (many, none)]), [[0, 79]])
        self.assertEqual(compared.standstills([(none, few), (none, many)]), [[0, 19]])
        # A tendon that two joints move against each other rests, which counts at both.
        played = gains.Played.__new__(gains.Played)
        speed, one = [10.0] * 500 + [1.0] * 600, [0.01] * 1100
        played.step, played.v, played.slow = step, [speed, [1.0] * 1100], [None, [speed, [1.0] * 1100]]
        played.arms = [[one, [-0.01] * 1100], [one, one]]
        still = played.standstills(50.0)
        self.assertEqual(still[0], still[1])
        [(start, end)] = still[0]
        self.assertTrue(450 < start <= 500 and end == 1099)


class Physics(unittest.TestCase):
    def test_a_link_of_which_mass_and_centre_change_keeps_its_shape(self):
        """Planted defect, seen to fail: moments about the link's frame kept, as if they had been told."""
        with tempfile.TemporaryDirectory() as place:
            (pathlib.Path(place) / "mass_properties.csv").write_text(
                "link,mass [kg],com_x [m],com_y [m],com_z [m],ixx [kg*m^2],iyy [kg*m^2],izz [kg*m^2],"
                "ixy [kg*m^2],ixz [kg*m^2],iyz [kg*m^2]\nl1,1,0,0,0.1,0.0001,0.0001,0.0001,0,0,0\n")
            change = {"mass": 0.0, "first_moment_x": 0.05, "first_moment_y": 0.0, "first_moment_z": 0.0}
            effect = {"effect": "inertial_parameters", "place": "link l1",
                      "coefficient": [{"name": n, "value": v} for n, v in change.items()]}
            self.assertTrue(physical.bodies_are_possible(pathlib.Path(place), [effect]))
            effect["coefficient"] += [{"name": "moment_xx", "value": 0.0}]
            self.assertFalse(physical.bodies_are_possible(pathlib.Path(place), [effect]))
            effect["coefficient"] = [{"name": "mass", "value": -1.0}]
            self.assertFalse(physical.bodies_are_possible(pathlib.Path(place), [effect]))

    def test_a_negative_mass_is_no_body(self):
        self.assertTrue(physical.positive_definite(physical.pseudo_inertia(1, [0, 0, 0], [1, 1, 1, 0, 0, 0]), 4))
        self.assertFalse(physical.positive_definite(physical.pseudo_inertia(-1, [0, 0, 0], [1, 1, 1, 0, 0, 0]), 4))

    def test_moments_that_break_the_triangle_are_no_body(self):
        self.assertFalse(physical.positive_definite(physical.pseudo_inertia(1, [0, 0, 0], [3, 1, 1, 0, 0, 0]), 4))

    def test_channels_count_in_units_of_what_is_left_of_them_at_best(self):
        # Seen to fail: with sums of plain squares the heavy channel hides the light one: 0.0095 != 0.923.
        was, now = [[10.0, 10.0], [1.0, 1.0]], [[10.0, 10.0], [0.2, 0.2]]
        self.assertAlmostEqual(physical.together(was, now), 1 - 2 / 26)
        self.assertAlmostEqual(physical.together(now, was), 1 - 26 / 2)

    def test_nothing_learnt_is_every_coefficient_at_zero(self):
        # Seen to fail: with shapes at zero as well a friction's speed divides by nothing.
        text = ('[[effect]]\neffect = "stribeck"\n[[effect.shape]]\nname = "speed"\nvalue = 0.3\n'
                '[[effect.coefficient]]\nname = "change"\nvalue = -2e-3\nstandard_error = 0.1\n')
        self.assertEqual(gains.without_what_was_learnt(text), text.replace("-2e-3", "0.0"))

    def test_a_law_that_was_learnt_is_taken_away(self):
        # Seen to fail: it has no coefficient, and a bristle's friction stayed in the model as it was.
        law = '[[effect]]\neffect = "direction"\nplace = "j1"\n[[effect.shape]]\nname = "presliding_length"\n'
        rest = '[[effect]]\neffect = "offset"\n'
        self.assertEqual(gains.without_what_was_learnt("# head\n" + law + rest), "# head\n" + rest)

    def test_a_tendon_pulls_against_its_moment_arm(self):
        torques = gains.torques_of([[[0.01], [0.0]], [[-0.02], [0.03]]], [[10.0], [1.0]])
        self.assertAlmostEqual(torques[0][0], -0.08)
        self.assertAlmostEqual(torques[1][0], -0.03)

    def test_a_rig_s_zero_is_free_at_a_wrist_alone(self):
        seen, told = [[3.0] * 200], [[1.0] * 200]
        self.assertLess(max(abs(x) for x in rigs.left_over(told, seen, 0.01, True)[0]), 1e-9)
        self.assertAlmostEqual(rigs.left_over(told, seen, 0.01, False)[0][0], 2.0)

    def test_what_a_slow_and_a_loose_sensor_are_told_by_is_made_of_the_reading(self):
        # Seen to fail: only rates were, and a sensor's low-pass was judged with a speed of zero.
        log = {"time": [0.002 * k for k in range(500)], "q71": [0.3 * 0.002 * k for k in range(500)]}
        made = rigs.signals_of(log, [("q71", 1), ("q71_rate", 1), ("q71_side", 1), ("q71_speed", 1), ("step", 1)], 0.002)
        self.assertEqual(sorted(made), ["q71", "q71_rate", "q71_side", "q71_speed"])
        self.assertEqual(made["q71_side"][0][250], 1.0)
        self.assertEqual(rigs.side_of_play([0.0, 2.0, 0.0, 0.0, 0.0, -1.0]), [1.0, 1.0, 0.875, 0.5, -0.125, -1.0])
        self.assertAlmostEqual(made["q71_speed"][0][250], 0.3)
        self.assertAlmostEqual(made["q71_rate"][0][250], 0.3)
        self.assertEqual(rigs.resolution("count", [0.0, 0.5]), 1.0)
        self.assertEqual(rigs.resolution("q71", [0.0, 0.0, 0.0, 0.25, 0.25, 0.75]), 0.25)
        self.assertEqual(rigs.resolution("q71", [0.0, 0.1, 0.2, 0.2]), 0.0)

    def test_a_hand_s_links_are_those_of_its_fingers(self):
        # Seen to fail: a hand has no table of its own, and no body of it was ever judged.
        place = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        (place / "model").mkdir()
        (place / "f2").mkdir()
        (place / "model" / "hand.toml").write_text('[[finger]]\nmodel = "../f2"\n')
        (place / "f2" / "mass_properties.csv").write_text("link,mass [kg]\nl1,0.01\n")
        self.assertEqual(physical.links_of(place / "model")["f2_l1"]["mass [kg]"], "0.01")

    def test_all_of_the_held_out_log_is_simulated(self):
        """Planted defect, seen to fail: its first four seconds alone, in which the right model of a friction that
        drifts is 4 % worse than the one without it, and over the whole log 21 % better."""
        place = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        (place / "holdout.csv").write_text("time [s],a\n" + "".join(f"{10 + 0.5 * k},1\n" for k in range(40)))
        program = place / "sinew"
        program.write_text('#!/bin/sh\nwhile [ "$1" != --log ]; do shift; done\nrows=$(wc -l < "$2")\n'
                           'echo "{\\"deviations\\": [{\\"channel\\": \\"a\\", \\"sensor\\": $rows}]}"\n')
        program.chmod(0o755)
        tools = {"sinew": program, "limit": 10}
        self.assertEqual(physical.simulated(tools, place, place / "model"), {"a": 1 + 40})


if __name__ == "__main__":
    unittest.main()
