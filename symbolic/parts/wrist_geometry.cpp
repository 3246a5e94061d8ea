// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/parts/wrist_geometry.h"

#include "symbolic/expressions/argument.h"
#include "symbolic/expressions/exact_number.h"
#include "symbolic/expressions/piecewise.h"

namespace sinew {
namespace {

using GiNaC::ex;

/// A vector in the bar plane: along e, along y, along the plane's normal.
using InPlane = Vector3;

Vector3 from_plane(const InPlane& v, const BarAngles& q) {
  return {v[0] * q.cos_q71 - v[2] * q.sin_q71, v[1], v[0] * q.sin_q71 + v[2] * q.cos_q71};
}

}  // namespace

WristLinks::WristLinks(const WristParameters& parameters)
    : a(exact_number(parameters.length)),
      b(exact_number(parameters.width)),
      c(exact_number(parameters.thickness)),
      r_squared(a * a + b * b + c * c),
      margin(exact_number(parameters.singular_margin)) {
  r = rational_root(r_squared);
}

WristPose wrist_pose(DefinitionList& list, const WristLengths& links, const BarAngles& q) {
  const auto& [a, b, c, r, r_squared, margin] = links;
  // (6.1), (6.4): the crossed loop in the bar plane needs no angle t_C: C is the inversion of B in
  // a circle about C0 and defined in the flat pose, too.
  const ex B_e = list.define("B_e", r * q.sin_q73);
  const ex B_y = list.define("B_y", r * q.cos_q73);
  const ex inverted = list.define("B_to_C0_squared", r_squared + b * b - 2 * b * B_y);
  const ex ratio = list.define("ratio", (r_squared - b * b) / inverted);
  const ex C_e = list.define("C_e", ratio * B_e);
  const ex C_y = list.define("C_y", ratio * (B_y - b));
  const ex M_e = list.define("M_e", (B_e + C_e) / 2);
  const ex M_y = list.define("M_y", (B_y + C_y) / 2);
  // {BCM}: x along MC, z the plane's normal, y = z × x.
  const ex u_e = list.define("u_e", (C_e - B_e) / b);
  const ex u_y = list.define("u_y", (C_y - B_y) / b);
  // (6.6): A0 = (0, b/2, c) seen from {BCM}.
  const ex s_e = list.define("s_e", c * q.sin_q71 - M_e);
  const ex s_y = list.define("s_y", b / 2 - M_y);
  const ex p_x = list.define("p_x", s_e * u_e + s_y * u_y);
  const ex p_y = list.define("p_y", s_y * u_e - s_e * u_y);
  const ex p_z = list.define("p_z", c * q.cos_q71);
  // (6.7): p_y cos t_A + p_z sin t_A = κ, plus branch. Limited to what the links can reach.
  const ex reach_squared =
      list.define("reach_squared", maximum(p_y * p_y + p_z * p_z, margin * margin * c * c));
  const ex reach = list.define("reach", GiNaC::sqrt(reach_squared));
  const ex projection = list.define("projection", (p_x * p_x + reach_squared - a * a) / (2 * c));
  const ex limited = list.define("limited", clamped(projection, -reach, reach));
  const ex clearance = list.define(
      "clearance", maximum((reach - limited) * (reach + limited), margin * margin * reach_squared));
  const ex root = list.define("root", GiNaC::sqrt(clearance));
  const ex cos_A = list.define("cos_A", (p_y * limited - p_z * root) / reach_squared);
  const ex sin_A = list.define("sin_A", (p_z * limited + p_y * root) / reach_squared);
  // {ABC} in the bar plane: y = (B - C)/b, z = (M - A)/c, x = y × z.
  const InPlane y{-u_e, -u_y, 0}, z{cos_A * u_y, -cos_A * u_e, -sin_A};
  const InPlane x{sin_A * u_y, -sin_A * u_e, cos_A};
  WristPose pose;
  pose.B = define(list, "B", from_plane({B_e, B_y, 0}, q));
  pose.C = define(list, "C", from_plane({C_e, C_y, 0}, q));
  pose.x = define(list, "x", from_plane(define(list, "x_plane", x), q));
  pose.y = define(list, "y", from_plane(y, q));
  pose.z = define(list, "z", from_plane(define(list, "z_plane", z), q));
  const Vector3 M = define(list, "M", from_plane({M_e, M_y, 0}, q));
  pose.A = M - c * pose.z;
  pose.origin = define(list, "origin", M - (c / 2) * pose.z);
  pose.sine_flat = q.sin_q73;
  pose.reach = reach;
  pose.projection = projection;
  pose.root = root;
  return pose;
}

WristStart::WristStart(const WristParameters& parameters) : links(parameters) {
  const std::vector<Range> ranges = bar_ranges(parameters);
  inputs = {scalar_argument("q71", "rad", ranges[0], "turns the bar plane about y"),
            scalar_argument("q73", "rad", ranges[1], "swings the bars within their plane")};
  const std::vector<double> reference = rounded_reference(parameters);
  for (std::size_t i = 0; i < 2; ++i) inputs[i].reference = {reference[i]};
  BarAngles q;
  q.cos_q71 = list.define("cos_q71", GiNaC::cos(q71()));
  q.sin_q71 = list.define("sin_q71", GiNaC::sin(q71()));
  q.cos_q73 = list.define("cos_q73", GiNaC::cos(q73()));
  q.sin_q73 = list.define("sin_q73", GiNaC::sin(q73()));
  pose = wrist_pose(list, links.lengths(), q);
}

Function WristStart::finish(const std::string& name, const std::string& equation,
                            const std::string& doc, std::vector<Output> outputs) const {
  return {name, doc, equation, inputs, list.items(), std::move(outputs)};
}

}  // namespace sinew
