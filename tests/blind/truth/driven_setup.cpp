// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blind/truth/driven_setup.h"

#include <fmt/format.h>

#include <cmath>

namespace sinew::trials {
namespace {

using truth::Draw;

/// Half of all axes slide for 5 to 50 encoder steps before friction is full, the others below one.
void draw_bristles(DrivenSetup& s, Draw& draw) {
  s.resolved = draw.chance(0.5);
  for (const double step : s.encoder)
    s.jointed.bristles.push_back(
        {step * (s.resolved ? draw.log_uniform(5.0, 50.0) : draw.log_uniform(0.05, 0.9)),
         draw.below(3)});
}

Link plain_link(bool slides, double inertia) {
  Link link;
  link.name = "l1";
  link.joint = "j1";
  link.slides = slides;
  link.axis = slides ? Vector3d(1, 0, 0) : Vector3d(0, 0, 1);
  link.mass = slides ? inertia : 1.0;
  link.inertia = Eigen::Matrix3d::Identity() * (slides ? 1.0 : inertia);
  return link;
}

void set_link(Link& link, const AxisModel& m) {
  link.damping = m.viscous;
  link.friction = m.level;
  link.friction_speed = m.turning;
  link.motor_turn = m.motor_turn;
}

}  // namespace

std::unique_ptr<TrialPlant> draw_drive(Draw draw, Mechanics mechanics, const Pairing* pairing) {
  DrivenSetup s;
  s.mechanics = mechanics;
  s.kind = draw.chance(0.25) && !pairing ? DrivenKind::slide : DrivenKind::motor;
  s.loaded = draw.chance(0.6);
  if (pairing) s.loaded = pairing->loaded, s.rhythm.kind = pairing->course;
  AxisModel m;
  if (s.kind == DrivenKind::slide) {
    m.inertia = draw.log_uniform(20.0, 150.0);
    m.level = m.inertia * draw.uniform(0.15, 0.4);
    m.viscous = m.inertia * draw.uniform(1.0, 3.0);
    m.range = draw.uniform(0.1, 0.25);
    m.top_speed = m.range * draw.uniform(1.8, 2.6);
    m.turning = m.top_speed / draw.uniform(60.0, 150.0);
    m.motor_turn = draw.uniform(0.0025, 0.01);
    s.encoder = {std::ldexp(1.0, -(17 + draw.below(4)))};
  } else {
    m.inertia = 2.05e-3 * draw.log_uniform(0.5, 4.0);
    m.level = 0.877 * draw.log_uniform(0.15, 1.0);
    m.viscous = 0.0356 * draw.log_uniform(0.6, 2.0);
    m.range = draw.uniform(3.5, 6.5);
    m.top_speed = draw.uniform(3.0, 5.0);
    m.turning = 1.0 / draw.uniform(10.0, 40.0);
    m.motor_turn = 2.0 * pi / (draw.chance(0.7) ? 100.0 : 50.0);
    m.output_turn = 2.0 * pi;
    s.encoder = {2.0 * pi * std::ldexp(1.0, -(18 + draw.below(4)))};
  }
  Link link = plain_link(s.kind == DrivenKind::slide, m.inertia);
  link.low = -4.0 * m.range;
  link.high = 4.0 * m.range;
  set_link(link, m);
  s.jointed.chain = {"drive", Vector3d::Zero(), {link}, {}, 0.0, Vector3d::Zero()};
  s.jointed.axes = {m};
  s.jointed.middle = {0.0};
  s.jointed.motor_share = draw.uniform(0.35, 0.65);
  s.rhythm.seconds = 20.0;
  s.rhythm.period = draw.chance(0.5) ? 1.0e-3 : 2.0e-3;
  s.rhythm.inner = s.rhythm.period < 1.5e-3 ? 4 : 8;
  if (s.loaded) {
    const double usual = m.level * draw.uniform(0.8, 2.0);
    s.load_mean = usual * draw.uniform(0.5, 1.0);
    s.load_swing = usual * draw.uniform(0.4, 0.8);
    if (pairing) s.load_swing = 0.0;
  }
  draw_bristles(s, draw);
  return driven_plant(std::move(s), draw);
}

std::unique_ptr<TrialPlant> draw_joint(Draw draw, double heavier, const Pairing* pairing) {
  DrivenSetup s;
  s.kind = DrivenKind::joint;
  const int drawn = draw.below(3);  // pendulum, flywheel, slide
  const int kind = !pairing ? drawn : pairing->carries ? 0 : 1;
  const bool slides = kind == 2;
  AxisModel m;
  m.inertia = heavier * draw.log_uniform(0.5, 2.0) * (slides ? 60.0 : kind == 0 ? 0.05 : 0.02);
  m.range = slides ? draw.uniform(0.08, 0.2) : draw.uniform(0.7, 1.4);
  m.top_speed = m.range * draw.uniform(1.5, 2.5);
  const double usual = m.inertia * m.top_speed * 6.0;
  m.level = usual * draw.uniform(0.3, 1.2);
  m.viscous = usual * draw.uniform(0.3, 1.0) / m.top_speed;
  m.turning = draw.chance(0.5) ? m.top_speed / draw.uniform(40.0, 150.0) : 0.0;
  m.motor_turn = m.range / draw.uniform(4.0, 16.0);
  if (!slides) m.output_turn = 2.0 * pi;
  Link link = plain_link(slides, m.inertia);
  Vector3d gravity = Vector3d::Zero();
  if (kind == 0) {
    const double arm = 0.18;
    link.mass = 0.5 * m.inertia / (arm * arm);
    link.com = Vector3d(arm, 0, 0);
    link.axis = Vector3d(0, -1, 0);
    link.inertia = Eigen::Matrix3d::Identity() * (m.inertia - link.mass * arm * arm);
    gravity = Vector3d(0, 0, -9.81);
  }
  // One that always goes forward turns round and round.
  const double turns = pairing ? 60.0 : 3.0;
  link.low = -turns * m.range;
  link.high = turns * m.range;
  set_link(link, m);
  s.jointed.chain = {"joint", gravity, {link}, {}, 0.0, Vector3d(0.3, 0, 0)};
  s.jointed.axes = {m};
  s.jointed.middle = {kind == 0 ? draw.uniform(-0.4, 0.4) : 0.0};
  s.weighs = kind == 0;
  // A quarter of the pendulums is balanced, and their models know of no gravity.
  if (draw.chance(0.25) && !pairing) s.jointed.chain.gravity.setZero();
  s.jointed.carries = !s.jointed.chain.gravity.isZero();
  s.encoder = {(slides ? 1.28 : 2.0 * pi) * std::ldexp(1.0, -(17 + draw.below(4)))};
  const double rates[] = {250.0, 500.0, 1000.0};
  s.jointed.motor_share = draw.uniform(0.35, 0.65);
  s.rhythm.seconds = 16.0;
  s.rhythm.period = 1.0 / rates[draw.below(3)];
  s.rhythm.inner = static_cast<int>(std::lround(s.rhythm.period / 2.5e-4));
  s.rhythm.kind = draw.chance(0.4) ? truth::Course::strokes : truth::Course::mixed;
  if (pairing) s.rhythm.kind = pairing->course;
  draw_bristles(s, draw);
  return driven_plant(std::move(s), draw);
}

std::unique_ptr<TrialPlant> draw_arm(Draw draw, Mechanics mechanics) {
  static const Vector3d long_axes[] = {{0, 0, 1},  {0, -1, 0}, {0, -1, 0}, {1, 0, 0},
                                       {0, -1, 0}, {1, 0, 0},  {0, -1, 0}};
  DrivenSetup s;
  s.kind = DrivenKind::arm;
  s.mechanics = mechanics;
  // Short arms are as common as long ones: two or three joints, or four to seven.
  const int joints = draw.chance(0.6) ? 2 + draw.below(2) : 4 + draw.below(4);
  const bool upright = joints >= 3 || draw.chance(0.5);
  double length = 0.0, mass = draw.uniform(1.5, 4.0);
  s.jointed.chain.name = "arm";
  for (int i = 0; i < joints; ++i) {
    Link link;
    link.name = fmt::format("l{}", i + 1);
    link.joint = fmt::format("j{}", i + 1);
    link.parent = i - 1;
    link.axis = joints > 3         ? long_axes[i]
                : upright && i > 0 ? Vector3d(0, -1, 0)
                                   : Vector3d(0, 0, 1);
    link.xyz = Vector3d(length, 0, i == 0 ? 0.3 : 0.0);
    length = draw.uniform(0.15, 0.4);
    const double thick = 0.05, across = mass * (length * length + thick * thick) / 12.0;
    link.mass = mass;
    link.com = Vector3d(draw.uniform(0.3, 0.6) * length, 0,
                        joints > 3 ? draw.uniform(0.05, 0.2) * length : 0.0);
    link.inertia = Vector3d(mass * thick * thick / 6.0, across, across).asDiagonal();
    link.armature = draw.chance(0.5) ? draw.uniform(0.2, 2.0) * across : 0.0;
    AxisModel m;
    m.level = draw.uniform(0.15, 0.4) * mass;
    m.viscous = draw.uniform(0.05, 0.2) * mass;
    m.turning = draw.chance(0.5) ? draw.log_uniform(0.005, 0.03) : 0.0;
    m.range = draw.uniform(0.6, 1.1);
    m.top_speed = draw.uniform(1.2, 2.2);
    m.motor_turn = 2.0 * pi / (draw.chance(0.5) ? 100.0 : 50.0);
    m.output_turn = 2.0 * pi;
    set_link(link, m);
    s.jointed.axes.push_back(m);
    s.jointed.middle.push_back(draw.uniform(-0.4, 0.4));
    s.encoder.push_back(2.0 * pi * std::ldexp(1.0, -(18 + draw.below(4))));
    s.jointed.chain.links.push_back(link);
    mass *= draw.uniform(0.45, 0.75);
  }
  s.jointed.chain.tip = Vector3d(length, 0, 0);
  s.jointed.carries = s.weighs = true;
  // A fifth lies on its side or is balanced: its model knows of no gravity.
  if (draw.chance(0.2)) s.jointed.chain.gravity.setZero();
  s.rhythm.seconds = 14.0;
  s.rhythm.period = draw.chance(0.5) ? 0.004 : 0.002;
  s.rhythm.inner = s.rhythm.period > 0.003 ? 8 : 4;
  s.rhythm.kind = draw.chance(0.5) ? truth::Course::sines : truth::Course::mixed;
  draw_bristles(s, draw);
  return driven_plant(std::move(s), draw);
}

}  // namespace sinew::trials
