// SPDX-License-Identifier: GPL-3.0-or-later
// Sealed trials on drives: the program gets the model's nominal values and the logs alone; the seal
// is opened after the verdict. A few in every run; the study ([.study]) makes docs/blind_trials.md.
#include <fmt/core.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

#include "identification/diagnose.h"
#include "identification/driven_channels.h"
#include "tests/blind/truth/sealed_trial.h"
#include "tests/reference/temporary_folder.h"

namespace {

using namespace sinew;
using diagnosis::NamedCause;

/// The model under test from its nominal values.
DrivenModel nominal_model(const truth::Trial& trial) {
  const auto values = nlohmann::json::parse(trial.nominal);
  const auto number = [&](const char* key) { return values.at(key).get<double>(); };
  if (trial.plant == "drive") {
    MotorParameters motor;
    motor.gear_ratio = number("motor_turn") / (2.0 * std::numbers::pi);
    motor.gearbox_inertia = number("inertia");
    motor.torque_constant = 1.0;
    motor.gamma1 = number("friction_shape");
    motor.gamma2 = number("friction_level");
    motor.gamma3 = number("viscous");
    return driven_model(motor, "drive");
  }
  Mechanism slide;
  slide.name = "slide";
  Body body;
  body.name = "carriage";
  body.mass = number("inertia");
  Joint joint;
  joint.name = "x";
  joint.type = JointType::prismatic;
  joint.damping = number("viscous");
  joint.friction = number("friction_level") * std::numbers::pi / 2.0;
  joint.friction_speed = 1.0 / number("friction_shape");
  joint.motor_turn = number("motor_turn");
  slide.bodies = {body};
  slide.joints = {joint};
  slide.gravity.setZero();
  return driven_model(slide);
}

/// The seal's word for a cause.
std::string seal_name(const std::string& name) {
  static const std::map<std::string, std::string> words{
      {"inertia", "inertia"},
      {"viscous friction level", "viscous_level"},
      {"Coulomb friction level", "coulomb_level"},
      {"offset", "offset"},
      {"viscous asymmetry", "direction_asymmetry"},
      {"Coulomb friction asymmetry", "direction_asymmetry"},
      {"Stribeck friction", "stribeck"},
      {"friction concave in speed", "concave_friction"},
      {"load-dependent friction", "load_friction"},
      {"slow drift of friction", "friction_drift"},
      {"gear elasticity", "gear_elasticity"},
      {"backlash", "backlash"},
      {"delay", "delay"},
      {"torque constant", "torque_constant"},
      {"low-pass of the position sensor", "sensor_low_pass"},
      {"scale of the position sensor", "sensor_scale"},
      {"hysteresis of the position sensor", "sensor_hysteresis"},
      {"quantisation of the position sensor", "sensor_quantisation"}};
  if (name.rfind("ripple proportional to load", 0) == 0) return "load_ripple";
  if (name.rfind("ripple", 0) == 0)
    return name.find("motor") != std::string::npos ? "input_ripple" : "output_ripple";
  const auto found = words.find(name);
  return found == words.end() ? name : found->second;
}

diagnosis::Findings diagnose_trial(const truth::SealedTrial& trial, unsigned seed) {
  const reference::TemporaryFolder folder;
  truth::write_trial(trial, folder.path().string(), (folder.path() / "seal").string());
  diagnosis::DiagnoseRequest request;
  request.model = nominal_model(trial.open());
  request.name = request.model.name;
  request.runtime = SINEW_SOURCE_DIR "/runtime";
  request.logs = {(folder.path() / "train.csv").string()};
  request.holdout = {(folder.path() / "holdout.csv").string()};
  request.settings.edge_s = diagnosis::driven_edge;
  request.settings.band_hz = diagnosis::driven_band;
  request.settings.seed = seed;
  const bool revolute = trial.open().plant == "drive";
  request.channels = [revolute](const std::string&) {
    return diagnosis::drive_log_channels(revolute, {});
  };
  return diagnosis::diagnose(request).findings;
}

std::set<std::string> members(const NamedCause& cause) {
  std::set<std::string> names;
  for (const auto& member : cause.members) names.insert(seal_name(member.name));
  return names;
}

int environment(const char* name, int otherwise) {
  const char* value = std::getenv(name);
  return value ? std::atoi(value) : otherwise;
}

std::string told(const diagnosis::Verdict& verdict) {
  std::string text;
  for (const NamedCause& cause : verdict.causes) {
    text += " [";
    for (const auto& member : cause.members) text += " " + seal_name(member.name);
    text += fmt::format(" {:.2f}]", cause.confidence);
  }
  if (verdict.unexplained.none_of_the_known) text += " NONE-OF-THE-KNOWN";
  for (const auto& d : verdict.unexplained.depends_on) text += " ~" + d.on;
  return text;
}

}  // namespace

// SINEW_TRIALS, SINEW_SIZE (percent of the noise), SINEW_SEED, SINEW_FAMILY choose the run.
TEST_CASE("study: sealed drives", "[.study]") {
  const int trials = environment("SINEW_TRIALS", 20);
  const double size = environment("SINEW_SIZE", 100) / 100.0;
  const int first = environment("SINEW_SEED", 1);
  const auto family = static_cast<truth::Family>(environment("SINEW_FAMILY", 1));
  const char* plant = std::getenv("SINEW_PLANT");
  int detected = 0, inside = 0, right = 0, false_names = 0, sets = 0, in_sets = 0, adopted = 0;
  for (int i = 0; i < trials; ++i) {
    truth::TrialRequest request;
    request.seed = static_cast<std::uint64_t>(first + i);
    request.plant = plant ? plant : "drive";
    request.family = family;
    request.size = size;
    const truth::SealedTrial trial(request);
    const diagnosis::Findings findings = diagnose_trial(trial, static_cast<unsigned>(first + i));
    const diagnosis::Verdict& verdict = findings.verdict;
    std::set<std::string> hidden;
    std::string truth_text;
    for (const auto& cause : trial.seal().hidden) {
      hidden.insert(cause.name);
      truth_text += fmt::format(" {}({:.2f})", cause.name, cause.size);
    }
    detected += verdict.nothing_beyond_noise() ? 0 : 1;
    bool all_inside = !verdict.causes.empty(), all_right = !verdict.causes.empty();
    std::set<std::string> found;
    for (const NamedCause& cause : verdict.causes) {
      const auto names = members(cause);
      ++sets;
      in_sets += static_cast<int>(names.size());
      bool hit = false;
      for (const std::string& h : hidden) hit = hit || names.contains(h);
      if (!hit) ++false_names;
      all_inside = all_inside && hit;
      all_right = all_right && hidden.contains(seal_name(cause.members.front().name));
    }
    inside += all_inside ? 1 : 0;
    right += all_right ? 1 : 0;
    adopted += findings.extension.adopted ? 1 : 0;
    fmt::print("{:5d} {} hidden:{} | told:{} | {:.1f} s\n", first + i, all_inside ? "ok " : "-- ",
               truth_text, told(verdict), findings.seconds);
    if (!all_inside)
      for (const auto& out : verdict.ruled_out)
        if (hidden.contains(seal_name(out.name)))
          fmt::print("        {}: {} (statistic {:.1f}, p {:.3f})\n", out.name, out.reason,
                     out.statistic, out.p_family);
    std::fflush(stdout);
  }
  fmt::print(
      "trials {} size {}: detected {} all inside {} all right {} false names {} mean set {:.2f} "
      "adopted {}\n",
      trials, size, detected, inside, right, false_names,
      sets ? static_cast<double>(in_sets) / sets : 0.0, adopted);
}

TEST_CASE("hidden causes of drives are named from the logs alone") {
  // Drawn seeds, one cause each as large as the noise; what is hidden is only in the seal.
  for (const int seed : {2, 3, 5, 10, 16, 23}) {
    truth::TrialRequest request;
    request.seed = static_cast<std::uint64_t>(seed);
    request.size = 1.0;
    const truth::SealedTrial trial(request);
    const diagnosis::Findings findings = diagnose_trial(trial, static_cast<unsigned>(seed));
    INFO("seed " << seed << ", told:" << told(findings.verdict));
    REQUIRE(findings.verdict.causes.size() == 1);
    CHECK(members(findings.verdict.causes.front()).contains(trial.seal().hidden.front().name));
    CHECK(findings.extension.adopted);
  }
}

TEST_CASE("a drive that hides nothing is told to leave nothing over") {
  for (const int seed : {503, 526, 548, 559, 561}) {
    truth::TrialRequest request;
    request.seed = static_cast<std::uint64_t>(seed);
    request.family = truth::Family::nothing;
    const diagnosis::Findings findings =
        diagnose_trial(truth::SealedTrial(request), static_cast<unsigned>(seed));
    INFO("seed " << seed << ", told:" << told(findings.verdict));
    CHECK(findings.verdict.causes.empty());
    CHECK_FALSE(findings.extension.adopted);
  }
}
