// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/wrist_observation.h"

#include <stdexcept>

#include "symbolic/argument.h"
#include "symbolic/exact_number.h"
#include "symbolic/wrist_geometry.h"

namespace sinew {
namespace {

using GiNaC::ex;

ObservationParameter deviation(const std::string& name, const char* unit, double low, double high,
                               double step) {
  return {GiNaC::symbol(name), name, unit, low, high, step};
}

ex first(const ObservationEffect& e) {
  return e.deviations.front().symbol;
}

struct WristEffects {
  ObservationEffect coupling{"wrist_coupling", "coupling left uncompensated", "wrist", {}, {}, {}};
  ObservationEffect zero71{"wrist_zero", "zero offset", "q71", {}, {}, {}};
  ObservationEffect zero73{"wrist_zero", "zero offset", "q73", {}, {}, {}};
  ObservationEffect contact{"contact_shift", "contact-point shift", "wrist", {}, {}, {}};
  ObservationEffect scale71{"sensor_scale", "scale of the angle sensor", "q71", {}, {}, {}};
  ObservationEffect scale73{"sensor_scale", "scale of the angle sensor", "q73", {}, {}, {}};
  std::vector<ObservationEffect> radii;

  explicit WristEffects(std::size_t tendons) {
    coupling.deviations = {deviation("share", "1", 0.0, 1.0, 1e-4)};
    coupling.limit = "more than the coupling would be compensated";
    coupling.signature = "motor angles left over in proportion to the tendons' lengths";
    coupling.excitation = "motion of the wrist";
    coupling.experiment = "the fingers watched while the wrist moves";
    contact.deviations = {deviation("radius", "m", 0.0, 0.02, 1e-6)};
    contact.limit = "the tendon would leave its pulley inwards";
    contact.signature = "tendons longer the farther they are bent from the reference pose";
    contact.excitation = "flexion and abduction far from the reference pose";
    contact.experiment = "one wrist angle at a time, over its whole range";
    name(zero71, zero73, "offset", "rad", 1e-5,
         "the palm set parallel to the forearm with a gauge");
    name(scale71, scale73, "scale_error", "1", 1e-5, "the angle between two stops, with a gauge");
    for (ObservationEffect* e : {&zero71, &zero73})
      e->signature = "lengths off by their slope over the angle";
    for (ObservationEffect* e : {&scale71, &scale73})
      e->signature = "lengths off in proportion to the angle";
    for (std::size_t i = 0; i < tendons; ++i) {
      ObservationEffect e{
          "pulley_radius",      "pulley radius", "motor " + std::to_string(i + 1), {}, {},
          {static_cast<int>(i)}};
      e.deviations = {deviation("change", "1", -0.5, 1.0, 1e-4)};
      e.signature = "one motor's angle off by a constant share";
      e.excitation = "motion of the wrist";
      e.experiment = "the pulley measured";
      e.limit = "half or twice the radius";
      radii.push_back(e);
    }
  }

  std::vector<ObservationEffect> all() const {
    std::vector<ObservationEffect> list{coupling, zero71, zero73, contact, scale71, scale73};
    list.insert(list.end(), radii.begin(), radii.end());
    return list;
  }

 private:
  static void name(ObservationEffect& a, ObservationEffect& b, const char* parameter,
                   const char* unit, double step, const char* experiment) {
    for (ObservationEffect* e : {&a, &b}) {
      e->deviations = {deviation(std::string(parameter), unit, -0.5, 0.5, step)};
      e->experiment = experiment;
      e->excitation = "both wrist angles over their range";
      e->limit = "half a radian, or half the angle";
    }
  }
};

/// From the forearm point of a tendon to its palm point.
Vector3 span(const WristParameters& p, std::size_t i, const WristPose& pose) {
  const Vector3 F = exact_vector(p.forearm_points[i]), P = exact_vector(p.palm_points[i]);
  return pose.origin + (P[0] * pose.x + P[1] * pose.y + P[2] * pose.z) - F;
}

/// The same in the reference pose: {ABC} parallel to {0}, its origin at (a, b/2, c/2).
Vector3 reference_span(const WristParameters& p, std::size_t i, const WristLinks& links) {
  return exact_vector(p.palm_points[i]) - exact_vector(p.forearm_points[i]) +
         Vector3{links.a, links.b / 2, links.c / 2};
}

ex true_angle(DefinitionList& list, const std::string& name, const ex& logged, double reference,
              const ObservationEffect& scale, const ObservationEffect& zero) {
  const ex zero_pose = exact_number(reference);
  return list.define(name, zero_pose + (logged - zero_pose) / (1 + first(scale)) + first(zero));
}

void describe(WristEffects& e) {
  const GiNaC::symbol theta("theta"), h("h"), q71("q71"), q73("q73"), turned("turned");
  const auto say = [](ObservationEffect& effect, const char* left, const ex& term) {
    effect.left = left;
    effect.term = term;
  };
  say(e.coupling, "theta", theta * (1 - first(e.coupling)));
  say(e.zero71, "q71", q71 + first(e.zero71));
  say(e.zero73, "q73", q73 + first(e.zero73));
  say(e.contact, "h", h + first(e.contact) * turned);
  say(e.scale71, "q71", q71 / (1 + first(e.scale71)));
  say(e.scale73, "q73", q73 / (1 + first(e.scale73)));
  for (ObservationEffect& r : e.radii) say(r, "theta", theta / (1 + first(r)));
}

std::vector<ex> motor_angles(const WristParameters& p, const WristLinks& links,
                             const WristPose& pose, const WristEffects& e, DefinitionList& list) {
  std::vector<ex> theta;
  for (std::size_t i = 0; i < p.palm_points.size(); ++i) {
    const Vector3 here = define(list, "span", span(p, i, pose));
    const Vector3 rest = reference_span(p, i, links);
    const ex length = list.define("length", GiNaC::sqrt(dot(here, here)));
    const ex rest_length = rational_root(GiNaC::ex_to<GiNaC::numeric>(dot(rest, rest)));
    const Vector3 aside = define(list, "aside", cross(rest, here));
    const ex turned =
        list.define("turned", GiNaC::atan2(GiNaC::sqrt(dot(aside, aside)), dot(rest, here)));
    const ex change = list.define("change", length - rest_length + first(e.contact) * turned);
    theta.push_back(-change * (1 - first(e.coupling)) / exact_number(p.motor_radius) /
                    (1 + first(e.radii[i])));
  }
  return theta;
}

}  // namespace

Observation wrist_observation(const WristParameters& parameters, const std::string& model) {
  if (parameters.forearm_points.size() != parameters.palm_points.size())
    throw std::invalid_argument("each wrist tendon needs a forearm point and a palm point");
  WristEffects effects(parameters.palm_points.size());
  const WristLinks links(parameters);
  const std::vector<Range> ranges = bar_ranges(parameters);
  std::vector<Argument> inputs{scalar_argument("q71", "rad", ranges[0], "as logged"),
                               scalar_argument("q73", "rad", ranges[1], "as logged")};
  DefinitionList list;
  const ex q71 = true_angle(list, "true_q71", inputs[0].symbols[0], reference_q71(parameters),
                            effects.scale71, effects.zero71);
  const ex q73 = true_angle(list, "true_q73", inputs[1].symbols[0], reference_q73(parameters),
                            effects.scale73, effects.zero73);
  const BarAngles angles{
      list.define("cos_q71", GiNaC::cos(q71)), list.define("sin_q71", GiNaC::sin(q71)),
      list.define("cos_q73", GiNaC::cos(q73)), list.define("sin_q73", GiNaC::sin(q73))};
  const WristPose pose = wrist_pose(list, links, angles);
  Output measured{"measured", static_cast<int>(parameters.palm_points.size()), 1, {}, "rad", ""};
  measured.doc = "motor angles, 0 in the reference pose";
  measured.values = motor_angles(parameters, links, pose, effects, list);
  describe(effects);
  return {model,
          {"observation",
           "Where the motors stand that keep the tendons at their force while the wrist moves.",
           "(6.9)",
           std::move(inputs),
           list.items(),
           {measured}},
          effects.all()};
}

}  // namespace sinew
