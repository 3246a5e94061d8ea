// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/extension/wrist_observation.h"

#include <stdexcept>

#include "symbolic/expressions/argument.h"
#include "symbolic/expressions/exact_number.h"
#include "symbolic/extension/late_sensor.h"
#include "symbolic/extension/wrist_effects.h"
#include "symbolic/parts/wrist_geometry.h"

namespace sinew {
namespace {

using GiNaC::ex;

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

struct AngleEffects {
  const ObservationEffect &scale, &zero, &low_pass, &play;
};

/// One angle of the wrist: what its sensor reads, and where the wrist is.
class Angle {
 public:
  Angle(const std::string& name, const Range& range, const AngleEffects& effects)
      : reading(scalar_argument(name, "rad", range, "as logged")),
        late(late_inputs(name, "rad/s", kFastest)),
        name_(name),
        e_(effects) {}

  ex true_angle(DefinitionList& list, double reference) {
    const ex zero_pose = exact_number(reference);
    const ex logged = in_time(reading.symbols[0], late, e_.low_pass, e_.play);
    return list.define(
        "true_" + name_,
        zero_pose + (logged - zero_pose) / (1 + e_.scale.deviation()) + e_.zero.deviation());
  }

  Argument reading;
  LateInputs late;

 private:
  static constexpr double kFastest = 10.0;  // rad/s
  std::string name_;
  AngleEffects e_;
};

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
    const ex change = list.define("change", length - rest_length + e.contact.deviation() * turned);
    theta.push_back(-change * (1 - e.coupling.deviation()) / exact_number(p.motor_radius) /
                    (1 + e.radii[i].deviation()));
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
  Angle first("q71", ranges[0],
              {effects.scale71, effects.zero71, effects.low_pass71, effects.play71});
  Angle second("q73", ranges[1],
               {effects.scale73, effects.zero73, effects.low_pass73, effects.play73});
  DefinitionList list;
  const ex q71 = first.true_angle(list, reference_q71(parameters));
  const ex q73 = second.true_angle(list, reference_q73(parameters));
  const BarAngles angles{
      list.define("cos_q71", GiNaC::cos(q71)), list.define("sin_q71", GiNaC::sin(q71)),
      list.define("cos_q73", GiNaC::cos(q73)), list.define("sin_q73", GiNaC::sin(q73))};
  const WristPose pose = wrist_pose(list, links.lengths(), angles);
  Output measured{"measured", static_cast<int>(parameters.palm_points.size()), 1, {}, "rad", ""};
  measured.doc = "motor angles, 0 in the reference pose";
  measured.values = motor_angles(parameters, links, pose, effects, list);
  return {model,
          {"observation",
           "Where the motors stand that keep the tendons at their force while the wrist moves.",
           "(6.9)",
           {first.reading, second.reading, first.late.speed, second.late.speed, first.late.side,
            second.late.side},
           list.items(),
           {measured}},
          effects.all()};
}

}  // namespace sinew
