// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/identification/report/example.h"

#include <ginac/ginac.h>

#include <cmath>
#include <limits>

#include "identification/adoption/held_out_judgement.h"
#include "symbolic/expressions/piecewise.h"
#include "symbolic/notation/print_mathml.h"
#include "tests/identification/report/example_plots.h"

namespace sinew::diagnosis::example {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

const std::string kHash = "9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08";

NamedCause cause(const std::string& name, const std::string& place, double confidence,
                 double share) {
  NamedCause c;
  c.members = {{0, name, place, 0.0, confidence}};
  c.confidence = confidence;
  c.log_odds = 2000.0 * share;
  c.cross_validated = {share, share - 0.06, share + 0.05};
  c.held_out = {share - 0.02, share - 0.09, share + 0.04};
  return c;
}

CauseTerm term(int index, const std::string& effect, const ex& effort, const std::string& signature,
               const std::string& excitation, bool compensable) {
  CauseTerm t;
  t.cause = index;
  t.effect = effect;
  t.mathml = mathml_equation("effort", effort);
  t.text = plain_equation("effort", effort);
  t.signature = signature;
  t.excitation = excitation;
  t.compensable = compensable;
  return t;
}

ChannelFinding channel(const std::string& name, const std::string& unit, double before,
                       double after) {
  ChannelFinding c;
  c.name = name;
  c.unit = unit;
  c.measured_rms = 28.1;
  c.standard_deviation = 27.4;
  c.quantum = 0.002;
  c.noise_floor = 0.41;
  c.unexplained_before = before * before;
  c.unexplained_after = after * after;
  const double share = 1.0 - after * after / (before * before);
  c.domains = {
      {"force",
       unit,
       before * 27.4,
       after * 27.4,
       {share, share - 0.07, share + 0.23 * (1.0 - share)}},
      {"window", "m", before * 4e-4, after * 5e-4, {share - 0.1, share - 0.2, share - 0.03}},
      {"open loop", "m", before * 0.02, before * 0.023, {-0.32, -0.6, 0.05}}};
  return c;
}

void add_drive_causes(Verdict& v) {
  v.causes = {cause("friction concave in speed", "motor", 0.96, 0.52),
              cause("viscous asymmetry", "motor", 0.93, 0.21),
              cause("ripple once per motor revolution", "motor", 0.92, 0.12),
              cause("delay", "motor", 0.91, 0.06)};
  v.causes[0].parameters = {{"plateau", "N", 12.34, 0.31, ""}, {"bend", "m/s", 0.0312, 0.0014, ""}};
  v.causes[1].parameters = {{"difference", "N*s/m", -8.61, 0.52, ""}};
  v.causes[2].parameters = {{"wavenumber", "rad/m", 157.08, 0.02, ""},
                            {"sine", "N", 1.52, 0.05, "slow_triangle.csv"},
                            {"cosine", "N", -0.31, 0.05, "slow_triangle.csv"},
                            {"sine", "N", 0.22, 0.06, "sweep.csv"},
                            {"cosine", "N", 1.49, 0.06, "sweep.csv"}};
  v.causes[3].parameters = {{"delay", "s", 0.00081, 0.00004, ""}};
  v.ruled_out = {
      {"Stribeck friction", "motor", "friction rises, not falls, as the drive starts to move", 4.0},
      {"ripple off the motor's order", "motor", "nothing beyond noise beside the named causes",
       -13.1},
      {"load-dependent friction", "motor", "not excited by these logs beside the model", -11.5},
      {"backlash", "gear", "too little beside the named causes to be told from noise", -4.1}};
}

std::vector<CauseTerm> drive_terms() {
  const symbol qd("qd"), q("q"), qdd("qdd"), plateau("plateau"), bend("bend"), d("difference"),
      k("wavenumber"), s("sine"), c("cosine"), delay("delay"), m("M"), f("F_v");
  return {
      term(0, "concave_friction", plateau * GiNaC::atan(qd / bend),
           "friction over velocity bends towards a plateau", "the whole range of speeds", true),
      term(1, "viscous_asymmetry", d * magnitude(qd),
           "the two directions have different slopes over velocity", "fast runs both ways", true),
      term(2, "ripple", s * GiNaC::sin(k * q) + c * GiNaC::cos(k * q),
           "a periodic effort over the position", "slow motion over several periods", true),
      term(3, "delay", -delay * (m * qdd + f * qd), "a residual in phase with the effort's rate",
           "fast changes of the effort", false)};
}

}  // namespace

Findings rich_drive() {
  Findings f;
  f.model = "emps";
  f.description = "Ball-screw drive";
  f.model_hash = kHash;
  f.kind = "linear drive";
  f.logs = {{"slow_triangle.csv",
             kHash,
             false,
             24841,
             24.84,
             0.001,
             {},
             {"slow_triangle.csv:1:4: columns that are no channel of this model: temperature; they "
              "stay unused"}},
            {"sweep.csv",
             kHash,
             false,
             18000,
             18.0,
             0.001,
             {"sweep.csv:1042:3: 14 samples of x are missing; filled by a smooth curve",
              "sweep.csv:9001:2: time goes back by 2 ms; the row was left out"},
             {}},
            {"holdout.csv", kHash, true, 24841, 24.84, 0.001, {}, {}}};
  f.channels = {channel("f", "N", 0.0408, 0.0191)};
  f.channels[0].plots = drive_plots("f", "N", 24841, 1);
  add_drive_causes(f.verdict);
  f.verdict.unexplained.depends_on = {{"periodic in time, 50.0 Hz", "motor", 6.2}};
  f.verdict.unexplained.named_share = 0.94;
  f.verdict.unexplained.remaining = 0.22;
  f.verdict.baseline = {{"M", "kg", 95.12, 0.21, ""},
                        {"F_v", "N*s/m", 203.5, 1.9, ""},
                        {"F_C", "N", 20.38, 0.44, ""},
                        {"offset", "N", -3.163, 0.09, ""}};
  f.verdict.relative_error_before = 0.0408;
  f.verdict.relative_error_after = 0.0191;
  f.verdict.held_out = f.channels[0].domains[0].gain;
  f.terms = drive_terms();
  f.extension.model_folder = "models/emps_extended";
  f.extension.operations_before = 41;
  f.extension.operations_after = 58;
  decide_adoption(true, true, f.verdict.held_out,
                  {"emps_inverse_dynamics", "emps_friction_compensation"}, f.extension);
  f.headline =
      "The drive's friction flattens out at speed and differs between the two directions; a motor "
      "ripple and a delay of 0.8 ms add to it.";
  f.next_step =
      "Use the extended model in models/emps_extended. To pin down the delay, record one log with "
      "fast changes of the force.";
  f.seconds = 4.2;
  return f;
}

Findings inseparable_pair() {
  Findings f = rich_drive();
  f.model = "two_link_arm";
  f.kind = "robot";
  f.logs = {{"elbow_only.csv", kHash, false, 30000, 60.0, 0.002, {}, {}}};
  f.channels = {channel("tau_elbow", "N*m", 0.31, 0.074)};
  f.channels[0].plots = drive_plots("tau_elbow", "N*m", 3000, 3);
  Verdict v;
  v.causes = {cause("payload", "elbow", 0.96, 0.93)};
  v.causes[0].members = {{4, "payload", "elbow", 0.0, 0.58},
                         {9, "torque gain", "elbow", 0.3, 0.42}};
  v.causes[0].parameters = {{"mass", "kg", 0.412, 0.008, ""}};
  v.causes[0].separation.experiment =
      "move the shoulder as well, slowly, with the elbow held at 90 degrees. A payload loads the "
      "shoulder, a torque gain does not.";
  v.ruled_out = {
      {"Coulomb friction level", "elbow", "nothing beyond noise beside the named causes", -12.6}};
  v.relative_error_before = 0.31;
  v.relative_error_after = 0.074;
  f.verdict = v;
  const symbol mass("mass"), g("g"), l("l_2"), q("q2");
  f.terms = {term(0, "payload", mass * g * l * GiNaC::cos(q), "a load that follows gravity",
                  "motion through several angles", true)};
  f.extension = {false, false, "no term is adopted while the logs cannot tell which one is true.",
                 "",    {},    0,
                 0};
  f.headline =
      "The elbow carries more than the model says: a payload, or a torque gain that is off.";
  f.next_step = "Record the shoulder too: move it slowly with the elbow held at 90 degrees.";
  return f;
}

Findings lone_cause() {
  Findings f = rich_drive();
  f.model = "index";
  f.kind = "tendon-driven joints";
  f.logs.erase(f.logs.begin() + 1);
  f.channels = {channel("tau_q20", "N*m", 0.53, 0.11)};
  f.channels[0].plots = drive_plots("tau_q20", "N*m", 3000, 3);
  const Gain gain = f.channels[0].domains[0].gain;
  Verdict v;
  v.causes = {cause("pulley radius", "joint q20", 0.94, 0.9)};
  v.causes[0].held_out = v.held_out = gain;
  v.causes[0].parameters = {{"gain_change", "1", -0.3526, 0.0041, ""}};
  v.unexplained.named_share = 0.88;
  v.unexplained.remaining = 0.055;
  v.relative_error_before = 0.53;
  v.relative_error_after = 0.11;
  f.verdict = v;
  const symbol model("model"), change("gain_change");
  f.terms = {term(0, "pulley_radius", model / (1 + change),
                  "torque in proportion to the tendons' torque",
                  "tendon forces that are known apart from the motion", false)};
  f.headline = f.next_step = "";
  return f;
}

Findings awkward_numbers() {
  Findings f = nothing_beyond_noise();
  ChannelFinding still = channel("tau_held", "N*m", 1.02, 1.02);
  still.measured_rms = 10.0;
  still.standard_deviation = 0.003;
  still.quantum = 0.0;
  still.domains = {{"force", "N*m", 0.00306, 0.00306, {}}};
  still.unexplained_before = still.unexplained_after = 0.0;
  const auto axes = [](const char* x, const char* y, double x0, double dx, double y0, double dy) {
    Plot plot{"position", "An awkward axis", x, y, "", false, {}};
    Series line{"measured", {}, {}, false};
    for (int i = 0; i <= 100; ++i) {
      line.x.push_back(x0 + dx * (i - 50) / 50.0);
      line.y.push_back(y0 + dy * std::sin(0.3 * i));
    }
    plot.series = {line};
    return plot;
  };
  still.plots = {
      axes("position [rad]", "residual [N*m]", 0.0, 1e-6, 0.0, 1.5e-5),
      axes("position [rad]", "residual [kg*m^2]", 1.0, 1e-5, -2e-5, 1e-9),
      axes("time [s]", "count", 1.5e6, 2.0, -123456.0, 4.0),
      axes("frequency [Hz]", "residual of a channel with a rather long name of its own [N*m*s/rad]",
           0.0, 1e7, 0.0, 9.9e6)};
  Plot powers = axes("frequency [Hz]", "residual [N*m/√Hz]", 2e-4, 1e-4, 2e-7, 1e-7);
  powers.logarithmic = true;
  still.plots.push_back(powers);
  f.channels = {still};
  f.verdict.relative_error_before = f.verdict.relative_error_after = 1.02;
  return f;
}

Findings none_of_the_known() {
  Findings f = inseparable_pair();
  f.model = "drive_7";
  f.kind = "rotary drive";
  f.channels = {channel("tau_m", "N*m", 0.19, 0.19)};
  f.channels[0].plots = drive_plots("tau_m", "N*m", 5000, 5, false);
  f.verdict = {};
  f.verdict.unexplained = {
      true, {{"position x direction", "motor", 310.0}, {"velocity", "motor", 21.0}}, 0.18, 0.83};
  f.verdict.ruled_out = {
      {"Stribeck friction", "motor", "nothing beyond noise beside the named causes", -12.0}};
  f.verdict.relative_error_before = f.verdict.relative_error_after = 0.19;
  f.terms.clear();
  f.extension = {false, true, "there is no term to add.", "", {}, 0, 0};
  f.headline =
      "Something real is missing that depends on position and direction, and none of the "
      "known causes explains it.";
  f.next_step =
      "Look at the mechanics where the residual over the position is largest, near 0.1 rad.";
  return f;
}

Findings nothing_beyond_noise() {
  Findings f = none_of_the_known();
  f.verdict = {};
  f.verdict.relative_error_before = f.verdict.relative_error_after = 0.0121;
  f.channels = {channel("tau_m", "N*m", 0.0121, 0.0121)};
  f.channels[0].domains.resize(1);
  f.extension.reason = "nothing is missing that these logs show.";
  f.headline = f.next_step = "";
  return f;
}

Findings large_finger() {
  Findings f = rich_drive();
  f.model = "index_finger_with_four_antagonistic_tendons";
  f.kind = "finger";
  f.channels.clear();
  for (int i = 1; i <= 8; ++i) {
    const std::string name = i <= 4 ? "tau_" + std::to_string(i) : "theta_" + std::to_string(i - 4);
    f.channels.push_back(channel(name, i <= 4 ? "N*m" : "rad", 0.08 + 0.01 * i, 0.03));
    f.channels.back().plots =
        drive_plots(name, i <= 4 ? "N*m" : "rad", 60000, static_cast<unsigned>(i));
  }
  f.verdict.causes[1] = cause("guiding friction against bending angle", "tendon 1", 0.93, 0.3);
  f.verdict.causes[1].members = {
      {1, "guiding friction against bending angle", "tendon 1", 0.0, 0.5},
      {2, "guiding friction against bending angle", "tendon 3", 0.5, 0.5}};
  for (int i = 0; i < 60; ++i)
    f.verdict.ruled_out.push_back({"lever hysteresis with a name of some length",
                                   "tendon " + std::to_string(i),
                                   "nothing beyond noise beside the named causes", -12.4});
  f.logs[0].file = "measurements/2026-11-21/index_finger_slow_triangular_motion_of_all_joints.csv";
  return f;
}

Findings empty() {
  Findings f;
  f.model = "drive";
  return f;
}

Findings hostile() {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double inf = std::numeric_limits<double>::infinity();
  Findings f = rich_drive();
  f.headline = "<script>alert('x')</script> & \"quotes\" <b>bold</b>";
  f.model = "a<b&c\"d'e";
  f.kind = "\xff\xfe not UTF-8";
  f.channels[0].measured_rms = nan;
  f.channels[0].noise_floor = inf;
  f.channels[0].domains[0].gain = {nan, -inf, inf};
  f.channels[0].plots.resize(2);
  f.channels[0].plots[0].title = "quit' ; <img src=x> \n quit";
  f.channels[0].plots[0].series[0].y.assign(100, nan);
  f.channels[0].plots[1].series = {{"constant", {1.0, 1.0}, {2.0, 2.0}, false},
                                   {"uneven", {1.0, inf, 3.0}, {1.0}, true}};
  f.verdict.causes[0].confidence = nan;
  f.verdict.causes[1].held_out = {nan, nan, nan};
  f.verdict.causes[2].members.clear();
  f.verdict.causes[3].parameters = {{"<x>", "<unit>^z", inf, nan, "<log>"}};
  f.verdict.relative_error_after = nan;
  f.terms[0].cause = 17;
  f.terms[1].cause = -1;
  return f;
}

}  // namespace sinew::diagnosis::example
