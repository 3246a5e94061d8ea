// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/parts/four_bar.h"

#include <cmath>
#include <stdexcept>

#include "symbolic/expressions/argument.h"
#include "symbolic/expressions/definition_list.h"
#include "symbolic/expressions/differentiate.h"
#include "symbolic/expressions/evaluate_function.h"
#include "symbolic/expressions/exact_number.h"
#include "symbolic/expressions/piecewise.h"

namespace sinew {
namespace {

using GiNaC::ex;

Argument crank_angle(const FourBarParameters& parameters) {
  Argument theta2 = scalar_argument("theta2", "rad", parameters.theta2, "crank angle");
  theta2.reference = {parameters.reference_theta2};
  return theta2;
}

/// The linkage in closed form (Freudenstein's equation), without inverse trigonometry.
struct Linkage {
  explicit Linkage(const FourBarParameters& parameters);
  Function finish(const std::string& name, const std::string& doc,
                  std::vector<Output> outputs) const {
    return {name, doc, "", {theta2}, list.items(), std::move(outputs)};
  }

  Argument theta2;
  DefinitionList list;
  ex cos2, sin2, cos3, sin3, cos4, sin4;
  ex slack;   ///< (reach² - C²) (a/b)² = sin²(theta3 - theta4); negative beyond a locking pose
  ex sin_34;  ///< sin(theta3 - theta4), kept away from zero
  ex cos_34;
  GiNaC::numeric g, a, b, c, margin;
};

GiNaC::numeric checked_length(double length) {
  if (!(length > 0.0)) throw std::invalid_argument("a four-bar link needs a length above 0 m");
  return exact_number(length);
}

Linkage::Linkage(const FourBarParameters& p)
    : theta2(crank_angle(p)),
      g(checked_length(p.ground)),
      a(checked_length(p.crank)),
      b(checked_length(p.coupler)),
      c(checked_length(p.rocker)),
      margin(exact_number(p.singular_margin)) {
  if (p.branch != 1 && p.branch != -1)
    throw std::invalid_argument("the branch of a four-bar is +1 or -1");
  const int sigma = p.branch;
  cos2 = list.define("cos2", GiNaC::cos(theta2.symbols[0]));
  sin2 = list.define("sin2", GiNaC::sin(theta2.symbols[0]));
  // A cos θ4 + B sin θ4 = C.
  const ex A = list.define("A", cos2 - g / a);
  const ex C = list.define("C", (a * a - b * b + c * c + g * g) / (2 * a * c) - (g / c) * cos2);
  const ex reach_squared =
      list.define("reach_squared", maximum(A * A + sin2 * sin2, margin * margin));
  const ex reach = list.define("reach", GiNaC::sqrt(reach_squared));
  const ex limited = list.define("limited", clamped(C, -reach, reach));
  slack = list.define("slack", (a * a / (b * b)) * (reach - C) * (reach + C));
  // sin(θ3 - θ4) = σ (a/b) √(reach² - C²): one root serves the pose and its derivatives.
  const ex root = list.define("root", GiNaC::sqrt(maximum(slack, margin * margin)));
  sin_34 = sigma * root;
  const ex side = list.define("side", (sigma * b / a) * root);
  cos4 = list.define("cos4", (A * limited - sin2 * side) / reach_squared);
  sin4 = list.define("sin4", (sin2 * limited + A * side) / reach_squared);
  cos_34 = list.define("cos_34", (c - a * limited) / b);
  // Coupler from the crank's end to the rocker's; its length is b except beyond a locking pose.
  const ex along = list.define("along", g + c * cos4 - a * cos2);
  const ex across = list.define("across", c * sin4 - a * sin2);
  const ex length = list.define(
      "length", GiNaC::sqrt(maximum(along * along + across * across, margin * margin * b * b)));
  cos3 = list.define("cos3", along / length);
  sin3 = list.define("sin3", across / length);
}

/// LinkDirection of the joint's link at the reference crank angle: 50 digits, so that a joint's
/// zero is the same on every machine.
struct LinkDirection {
  ex cosine, sine;
};

LinkDirection reference_direction(const FourBarParameters& parameters, FourBarAngle angle) {
  const Linkage k(parameters);
  std::vector<Output> both{{"cosine", 1, 1, {k.cos4}, "1", ""}, {"sine", 1, 1, {k.sin4}, "1", ""}};
  if (angle == FourBarAngle::coupler_on_crank) {
    both[0].values = {k.cos3 * k.cos2 + k.sin3 * k.sin2};
    both[1].values = {k.sin3 * k.cos2 - k.cos3 * k.sin2};
  }
  const auto values = evaluate_precisely(k.finish("zero", "", both),
                                         {binary_fraction(parameters.reference_theta2)});
  return {values[0], values[1]};
}

}  // namespace

Function four_bar(const FourBarParameters& parameters) {
  const Linkage k(parameters);
  const ex theta3 = GiNaC::atan2(k.sin3, k.cos3), theta4 = GiNaC::atan2(k.sin4, k.cos4);
  const ex slope3 = k.a * (k.sin4 * k.cos2 - k.cos4 * k.sin2) / (k.b * k.sin_34);
  const ex slope4 = k.a * (k.sin3 * k.cos2 - k.cos3 * k.sin2) / (k.c * k.sin_34);
  return k.finish("four_bar", "Coupler and rocker angle of the four-bar and their derivatives.",
                  {{"out",
                    4,
                    1,
                    {theta3, theta4, slope3, slope4},
                    "rad, rad, 1, 1",
                    "theta3, theta4, dtheta3/dtheta2, dtheta4/dtheta2"}});
}

Function four_bar_locking(const FourBarParameters& parameters) {
  Linkage k(parameters);
  const ex sine = k.list.define("sine", GiNaC::sqrt(maximum(k.slack, 0)));
  // Written so that a comparison that fails, whatever the reason, says 1.
  const ex status = choose(k.slack - k.margin * k.margin, 0, 1);
  return k.finish("locking", "How far the four-bar is from locking.",
                  {{"distance",
                    1,
                    1,
                    {GiNaC::atan2(sine, magnitude(k.cos_34))},
                    "rad",
                    "angle between coupler and rocker, folded to 0..pi/2"},
                   {"status",
                    1,
                    1,
                    {status},
                    "1",
                    "0 fine, 1 at or beyond a locking pose",
                    {"fine", "locked"}}});
}

Function four_bar_coupler_pose(const FourBarParameters& parameters) {
  const Linkage k(parameters);
  return k.finish(
      "coupler_pose", "Pose of the coupler: maps its frame to the linkage's plane frame.",
      {{"T",
        4,
        4,
        {k.cos3, -k.sin3, 0, k.a * k.cos2, k.sin3, k.cos3, 0, k.a * k.sin2, 0, 0, 1, 0, 0, 0, 0, 1},
        "1 and m",
        "homogeneous transform"}});
}

Function four_bar_tendon_lengths(const FourBarParameters& parameters) {
  const Argument theta2 = crank_angle(parameters);
  DefinitionList list;
  const ex length =
      list.define("length", exact_number(parameters.pulley_radius) *
                                (theta2.symbols[0] - exact_number(parameters.reference_theta2)));
  return {"tendon_lengths",
          "Lengths of the two antagonistic tendons on the crank's pulley.",
          "",
          {theta2},
          list.items(),
          {{"h", 2, 1, {length, -length}, "m", "0 at the reference crank angle"}}};
}

Function four_bar_joint(const FourBarParameters& parameters, FourBarAngle angle) {
  Linkage k(parameters);
  const bool rocker = angle == FourBarAngle::rocker;
  ex cosine = k.cos4, sine = k.sin4;
  if (!rocker) {
    cosine = k.list.define("cos_32", k.cos3 * k.cos2 + k.sin3 * k.sin2);
    sine = k.list.define("sin_32", k.sin3 * k.cos2 - k.cos3 * k.sin2);
  }
  // Turned back by the reference angle, so that the cut of atan2 is half a turn away from it.
  const LinkDirection zero = reference_direction(parameters, angle);
  const ex slope = k.list.define(
      "slope", rocker ? k.a * (k.sin3 * k.cos2 - k.cos3 * k.sin2) / (k.c * k.sin_34)
                      : k.a * (k.sin4 * k.cos2 - k.cos4 * k.sin2) / (k.b * k.sin_34) - 1);
  const ex turned = k.list.define("angle", GiNaC::atan2(sine * zero.cosine - cosine * zero.sine,
                                                        cosine * zero.cosine + sine * zero.sine));
  ForwardDerivative by_theta2(k.list, k.theta2.symbols[0], "theta2");
  const ex curvature = k.list.define("curvature", by_theta2.of(slope));
  return k.finish("joint", "Angle of a joint that the four-bar moves, and its derivatives.",
                  {{"angle", 1, 1, {turned}, "rad", "0 at the reference crank angle"},
                   {"slope", 1, 1, {slope}, "1", "d angle / d theta2"},
                   {"curvature", 1, 1, {curvature}, "1/rad", "d2 angle / d theta2 2"}});
}

std::vector<Function> four_bar_functions(const FourBarParameters& p) {
  return {four_bar(p), four_bar_locking(p), four_bar_coupler_pose(p), four_bar_tendon_lengths(p)};
}

std::optional<double> unreachable_crank_angle(const FourBarParameters& p) {
  // The diagonal from the crank's end to the rocker's pivot is longest or shortest at the ends of
  // the range or where crank and ground line up.
  std::vector<double> angles{p.theta2.low, p.theta2.high};
  const double pi = std::acos(-1.0);
  for (double k = std::ceil(p.theta2.low / pi); k * pi <= p.theta2.high; ++k)
    angles.push_back(k * pi);
  for (const double angle : angles) {
    const double diagonal = std::sqrt(p.ground * p.ground + p.crank * p.crank -
                                      2 * p.ground * p.crank * std::cos(angle));
    const double C = (p.rocker * p.rocker + diagonal * diagonal - p.coupler * p.coupler) /
                     (2 * p.rocker * diagonal);
    if (!(std::abs(C) < 1)) return angle;
    // sin(theta3 - theta4) of the triangle of coupler, rocker and diagonal
    if (!(diagonal * std::sqrt(1 - C * C) > p.coupler * p.singular_margin)) return angle;
  }
  return std::nullopt;
}

std::vector<double> locking_angles(const FourBarParameters& p) {
  std::vector<double> angles;
  for (const double diagonal : {p.coupler + p.rocker, p.coupler - p.rocker}) {
    const double cosine =
        (p.ground * p.ground + p.crank * p.crank - diagonal * diagonal) / (2 * p.ground * p.crank);
    if (std::abs(cosine) <= 1) angles.push_back(std::acos(cosine));
  }
  return angles;
}

}  // namespace sinew
