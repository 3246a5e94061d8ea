// SPDX-License-Identifier: GPL-3.0-or-later
// Arms whose models hold what a maker's URDF does: links as they were drawn, nothing of the drives.
#include <fmt/format.h>

#include <cmath>

#include "tests/blind/truth/driven_setup.h"

namespace sinew::trials {
namespace {

using truth::Draw;

/// Of a seven-joint arm: its joints roll and bend in turn.
Link arm_link(std::size_t i, double length, double mass, Draw& draw) {
  Link link;
  const bool rolls = i % 2 == 0;
  link.axis = rolls ? Vector3d(0, 0, 1) : Vector3d(0, 1, 0);
  const double thick = 0.3 * length + 0.03;
  const double across = mass * (length * length + thick * thick) / 12.0;
  link.mass = mass;
  link.com = Vector3d(draw.uniform(-0.1, 0.1) * length, draw.uniform(-0.1, 0.1) * length,
                      draw.uniform(0.3, 0.6) * length);
  link.inertia = Vector3d(across, across, mass * thick * thick / 6.0).asDiagonal();
  return link;
}

/// Turns about the vertical, lifts along it, and turns again: a small assembly robot.
Link slide_link(std::size_t i, double length, double mass, Draw& draw) {
  Link link;
  link.slides = i == 1;
  link.axis = Vector3d(0, 0, 1);
  const double across = mass * length * length / 12.0;
  link.mass = mass;
  link.com = Vector3d(draw.uniform(0.3, 0.6) * length, draw.uniform(-0.05, 0.05) * length, 0.0);
  link.inertia = Vector3d(0.1 * across, across, across).asDiagonal();
  return link;
}

/// What is drawn of a link is a few per cent off.
Link as_drawn(Link link, double off, Draw& draw) {
  const double heavier = 1.0 + off * draw.uniform(-1.0, 1.0);
  link.mass *= heavier;
  link.inertia *= heavier;
  link.com *= 1.0 + off * draw.uniform(-1.0, 1.0);
  link.armature = link.damping = link.friction = link.friction_speed = link.motor_turn = 0.0;
  return link;
}

AxisModel drive_of(const Link& link, double effort, double carried, Draw& draw) {
  AxisModel m;
  m.level = effort * draw.log_uniform(0.1, 0.5);
  m.range = link.slides ? draw.uniform(0.06, 0.12) : draw.uniform(0.7, 1.3);
  m.top_speed = m.range * draw.uniform(1.2, 2.2);
  m.viscous = m.level * draw.log_uniform(0.3, 2.0) / m.top_speed;
  m.turning = draw.chance(0.5) ? m.top_speed * draw.log_uniform(0.004, 0.03) : 0.0;
  m.motor_turn = link.slides ? 0.005 : 2.0 * pi / (draw.chance(0.5) ? 100.0 : 50.0);
  if (!link.slides) m.output_turn = 2.0 * pi;
  m.inertia = carried;
  return m;
}

}  // namespace

std::unique_ptr<TrialPlant> draw_bare_arm(Draw draw, Mechanics mechanics, bool slides) {
  DrivenSetup s;
  s.kind = DrivenKind::arm;
  s.mechanics = mechanics;
  const std::size_t joints = slides ? 3 : 7;
  const double off = draw.chance(0.5) ? 0.0 : 0.03;
  Chain& chain = s.jointed.chain;
  chain.name = "arm";
  double length = 0.0, mass = draw.uniform(2.0, 5.0);
  for (std::size_t i = 0; i < joints; ++i) {
    const double before = length;
    length = slides ? draw.uniform(0.15, 0.3) : draw.uniform(0.08, 0.25);
    Link link = slides ? slide_link(i, length, mass, draw) : arm_link(i, length, mass, draw);
    link.name = fmt::format("l{}", i + 1);
    link.joint = fmt::format("j{}", i + 1);
    link.parent = static_cast<int>(i) - 1;
    link.xyz = slides ? Vector3d(before, 0, i == 0 ? 0.4 : 0.0) : Vector3d(0, 0, before);
    mass *= slides ? 0.6 : draw.uniform(0.6, 0.9);
    chain.links.push_back(link);
    s.jointed.middle.push_back(slides       ? 0.0
                               : i % 2 == 0 ? draw.uniform(-0.4, 0.4)
                                            : draw.sign() * draw.uniform(0.4, 0.9));
  }
  chain.tip = slides ? Vector3d(length, 0, 0) : Vector3d(0, 0, length);
  const VectorXd middle = VectorXd::Map(s.jointed.middle.data(), static_cast<Index>(joints));
  const VectorXd none = VectorXd::Zero(middle.size()), rest = chain.torque(middle, none, none);
  for (std::size_t i = 0; i < joints; ++i) {
    const auto j = static_cast<Index>(i);
    Link& link = chain.links[i];
    const double carried = chain.carried(middle, j);
    // High gears make a rotor as heavy as what it moves, at the wrist heavier.
    link.armature = std::max(carried * draw.log_uniform(0.2, 3.0), link.slides ? 0.5 : 0.02);
    const double effort = std::max(std::abs(rest(j)), 4.0 * (carried + link.armature));
    const AxisModel m = drive_of(link, effort, carried + link.armature, draw);
    link.low = -3.0 * m.range + s.jointed.middle[i];
    link.high = 3.0 * m.range + s.jointed.middle[i];
    s.jointed.axes.push_back(m);
    s.encoder.push_back(link.slides ? std::ldexp(1.0, -(17 + draw.below(3)))
                                    : 2.0 * pi * std::ldexp(1.0, -(16 + draw.below(5))));
  }
  s.resolved = draw.chance(0.5);
  for (const double step : s.encoder)
    s.jointed.bristles.push_back(
        {step * (s.resolved ? draw.log_uniform(5.0, 50.0) : draw.log_uniform(0.05, 0.9)),
         draw.below(3)});
  s.drawing = chain;
  for (Link& link : s.drawing->links) link = as_drawn(link, off, draw);
  s.jointed.carries = s.weighs = true;
  s.jointed.motor_share = draw.uniform(0.35, 0.65);
  s.rhythm.seconds = 25.0;
  s.rhythm.period = 0.001;
  s.rhythm.inner = 4;
  s.rhythm.kind = draw.chance(0.5) ? truth::Course::sines : truth::Course::mixed;
  return driven_plant(std::move(s), draw);
}

}  // namespace sinew::trials
