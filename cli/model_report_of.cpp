// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/model_report_of.h"

#include <fmt/format.h>

#include <numeric>

#include "cli/models/plausibility.h"
#include "symbolic/dynamics/coordinates.h"

namespace sinew {
namespace {

std::string number(double value) {
  return fmt::format("{:.4g}", value);
}

std::string vector_in_mm(const Eigen::Vector3d& v) {
  return fmt::format("{:.4g}, {:.4g}, {:.4g}", 1e3 * v[0], 1e3 * v[1], 1e3 * v[2]);
}

/// Of the coupling matrix all columns but those in `free`.
std::vector<int> columns(int count) {
  std::vector<int> all(static_cast<std::size_t>(count));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

bool offers(const EmittedModel& model, const std::string& name) {
  for (const Graph& graph : model.functions)
    if (graph.name == name) return true;
  return false;
}

std::string offered(const EmittedModel& model, const std::string& name) {
  return offers(model, name) ? name : "";
}

std::string routing_of(const Tendon& tendon) {
  std::string text;
  for (const StraightRouting& s : tendon.straights)
    text +=
        (text.empty() ? "" : "; ") + fmt::format("straight from {} to {}", s.from_body, s.to_body);
  for (const PulleyRouting& p : tendon.pulleys)
    text += (text.empty() ? "" : "; ") + fmt::format("{}: {} mm", p.joint, number(1e3 * p.radius));
  return text;
}

void add_tables(const Mechanism& mechanism, ModelReport& report) {
  TableOfModel bodies{"Bodies", {"Body", "#Mass [g]", "Centre of mass [mm]", "Carried by"}, {}};
  TableOfModel joints{"Joints", {"Joint", "Kind", "Range", "Moves"}, {}};
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const Body& body = mechanism.bodies[i];
    const Joint& joint = mechanism.joints[i];
    bodies.rows.push_back(
        {body.name, number(1e3 * body.mass), vector_in_mm(body.centre_of_mass), joint.name});
    const bool slides = joint.type == JointType::prismatic;
    const double scale = slides ? 1e3 : 180.0 / 3.141592653589793;
    joints.rows.push_back(
        {joint.name,
         joint.type == JointType::fixed ? "fixed"
         : slides                       ? "prismatic"
                                        : "revolute",
         joint.type == JointType::fixed ? "–"
                                        : fmt::format("{:.4g} to {:.4g}{}", scale * joint.low,
                                                      scale * joint.high, slides ? " mm" : "°"),
         body.name +
             (joint.parent < 0
                  ? " on the base"
                  : " on " + mechanism.bodies[static_cast<std::size_t>(joint.parent)].name)});
  }
  report.tables = {bodies, joints};
  if (mechanism.tendons.empty()) return;
  TableOfModel tendons{"Tendons: signed radii; a tendon gets longer by radius times angle",
                       {"Tendon", "Routing"},
                       {}};
  for (const Tendon& tendon : mechanism.tendons)
    tendons.rows.push_back({tendon.name, routing_of(tendon)});
  report.tables.push_back(tendons);
}

void describe(const Mechanism& mechanism, ModelReport& report) {
  report.kind = mechanism.tendons.empty() ? "chain or tree of bodies" : "finger";
  report.drawing = scene_of(mechanism, "tip_jacobian");
  report.lengths = offered(report.emitted, "tendon_lengths");
  report.coupling = offered(report.emitted, "coupling_matrix");
  report.stiffness = offered(report.emitted, "joint_stiffness");
  report.gravity = offered(report.emitted, "gravity");
  report.held = columns(Coordinates(mechanism).count());
  report.force_high = mechanism.tendon_force_high;
  report.stiffness_low = mechanism.tendon_stiffness_low;
  report.stiffness_high = mechanism.tendon_stiffness_high;
  add_tables(mechanism, report);
  if (mechanism.tendons.empty())
    report.missing.push_back(
        "Tendons: this model has none, so there are no tendon lengths, moment arms, forces, "
        "stiffness or force closure.");
  else
    report.missing.push_back(
        "Where exactly a tendon runs over a pulley: the model knows its moment arm, and the "
        "drawing "
        "puts a pulley of that radius on the joint's axis.");
  if (is_massless(mechanism)) report.missing.push_back("Dynamics: " + why_no_dynamics(mechanism));
  report.missing.push_back("Shapes: each body is drawn as the box that has its mass and inertia.");
}

void describe(const WristParameters& wrist, ModelReport& report) {
  report.kind = "wrist";
  report.drawing = scene_of(wrist);
  report.lengths = offered(report.emitted, "tendon_lengths");
  report.coupling = offered(report.emitted, "tendon_jacobian");
  report.free = {0, 1};
  report.tables = {{"Links",
                    {"Length", "#mm"},
                    {{"length a", number(1e3 * wrist.length)},
                     {"width b", number(1e3 * wrist.width)},
                     {"thickness c", number(1e3 * wrist.thickness)}}}};
  report.missing = {
      "Force closure: the tendons belong to the fingers and pass the wrist, which has a drive of "
      "its "
      "own. What they make that drive hold is shown.",
      "Bodies and dynamics: the wrist is a closed form of its links' lengths; no masses are in it.",
      "Manipulability and stiffness at a tip: the palm has no fingertip; the joint stiffness is "
      "among the functions."};
}

void describe(const Hand& hand, ModelReport& report) {
  report.kind = "hand";
  report.drawing = scene_of(hand);
  report.lengths = offered(report.emitted, "tendon_lengths");
  report.coupling = offered(report.emitted, "coupling_matrix");
  report.stiffness = offered(report.emitted, "joint_stiffness");
  const int coordinates = static_cast<int>(report.drawing->coordinates.size()) - 2;
  report.held = columns(coordinates);
  report.free = {coordinates, coordinates + 1};
  TableOfModel fingers{"Fingers", {"Finger", "#Joints", "#Tendons", "Rides on", "#Mass [g]"}, {}};
  int weighed = 0;
  for (const HandFinger& finger : hand.fingers) {
    double mass = 0.0;
    weighed += Coordinates(finger.mechanism).count();
    for (const Body& body : finger.mechanism.bodies) mass += body.mass;
    fingers.rows.push_back(
        {finger.mechanism.name, std::to_string(Coordinates(finger.mechanism).count()),
         std::to_string(finger.mechanism.tendons.size()),
         finger.on_coupler ? "the four-bar's coupler" : "the palm", number(1e3 * mass)});
    report.force_high = finger.mechanism.tendon_force_high;
    report.stiffness_low = finger.mechanism.tendon_stiffness_low;
    report.stiffness_high = finger.mechanism.tendon_stiffness_high;
  }
  report.tables = {fingers};
  report.weighed = {offered(report.emitted, "finger_gravity"),
                    offered(report.emitted, "inverse_dynamics"), weighed};
  report.missing = {
      report.weighed.torques.empty()
          ? "The bodies' weight in the tensions shown: not every finger has masses."
          : "What the weight of a finger on the four-bar asks of its crank, in the tensions shown: "
            "the fingers' dynamics are of bases that are held.",
      "Where exactly a tendon runs over a pulley: the model knows its moment arm, and the drawing "
      "puts a pulley of that radius on the joint's axis.",
      "Shapes: each body is drawn as the box that has its mass and inertia."};
}

const char* kind_of(const Part& part) {
  struct Names {
    const char* operator()(const WristParameters&) const { return "wrist"; }
    const char* operator()(const FourBarParameters&) const { return "four-bar linkage"; }
    const char* operator()(const LeverParameters&) const { return "variable-stiffness lever"; }
    const char* operator()(const MotorParameters&) const { return "motor with gear"; }
    const char* operator()(const FittedGuiding&) const { return "guiding friction"; }
    const char* operator()(const CapstanGuiding&) const { return "guiding friction"; }
    const char* operator()(const TendonWithLever&) const { return "tendon with lever"; }
    const char* operator()(const EffectLibrary&) const { return "library of effects"; }
  };
  return std::visit(Names{}, part.parameters);
}

void describe(const Part& part, ModelReport& report) {
  if (const auto* wrist = std::get_if<WristParameters>(&part.parameters))
    return describe(*wrist, report);
  report.kind = kind_of(part);
  report.missing = {fmt::format(
      "A drawing, a workspace, tendons and force closure: a {} is a set of formulas without bodies "
      "that could be drawn. Every formula can be tried above.",
      report.kind)};
}

}  // namespace

ModelReport model_report_of(const ModelFolder& folder, const EmittedModel& emitted) {
  ModelReport report;
  report.emitted = emitted;
  report.folder = folder.folder.string();
  std::visit([&](const auto& model) { describe(model, report); }, folder.model);
  report.warnings = plausibility_warnings(folder);
  for (const std::string& remark : folder.remarks) report.warnings.push_back(remark);
  return report;
}

}  // namespace sinew
