// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blind/truth/tendon_setup.h"

#include <fmt/format.h>

#include <cmath>

#include "tests/blind/truth/wrist_shape.h"

namespace sinew::trials {
namespace {

using truth::Draw;

/// A finger in its base frame: it may abduct, then it flexes, and its last joint may be coupled to
/// the one before.
struct DrawnFinger {
  Chain chain;
  std::vector<AxisModel> axes;
  std::vector<double> middle;
};

DrawnFinger drawn_finger(Draw& draw, const std::string& name, int joints, int first_number,
                         bool coupled = false) {
  DrawnFinger f;
  f.chain.name = name;
  double length = 0.006, mass = draw.uniform(0.006, 0.02);
  const bool abducts = joints > 2;
  for (int i = 0; i < joints; ++i) {
    Link link;
    link.name = fmt::format("l{}", i + 1);
    link.joint = fmt::format("q{}", first_number + i);
    link.parent = i - 1;
    link.xyz = Vector3d(i == 0 ? 0.0 : length, 0, 0);
    const bool first_flexes = i == (abducts ? 1 : 0);
    if (first_flexes) link.rpy = Vector3d(0.5 * pi, 0, 0);
    length = abducts && i == 0 ? 0.006 : draw.uniform(0.02, 0.045);
    link.mass = abducts && i == 0 ? 0.003 : mass;
    const double thick = 0.012, along = link.mass * thick * thick / 8.0;
    const double across = link.mass * (length * length / 12.0 + thick * thick / 16.0);
    link.com = Vector3d(draw.uniform(0.4, 0.6) * length, 0, 0);
    link.inertia = Vector3d(along, across, across).asDiagonal();
    link.low = abducts && i == 0 ? -0.6 : -0.6;
    link.high = abducts && i == 0 ? 0.6 : 1.8;
    AxisModel m;
    m.level = draw.uniform(0.3e-3, 1.5e-3);
    m.viscous = draw.uniform(0.5e-4, 3e-4);
    m.range = abducts && i == 0 ? 0.28 : draw.uniform(0.45, 0.65);
    m.top_speed = draw.uniform(3.0, 5.0) * m.range;
    m.motor_turn = 0.35 * m.range;
    link.damping = m.viscous;
    link.friction = m.level;
    if (coupled && i + 1 == joints) {
      // What a coupled joint rubs, its loop takes to the joint before.
      link.damping = link.friction = 0.0;
    } else {
      f.axes.push_back(m);
      f.middle.push_back(abducts && i == 0 ? 0.0 : 0.55);
    }
    f.chain.links.push_back(link);
    if (i > 0 || !abducts) mass *= draw.uniform(0.5, 0.8);
  }
  f.chain.tip = Vector3d(length, 0, 0);
  // A pair of antagonists a joint; distal ones may pass the joint before, too.
  const int driven = coupled ? joints - 1 : joints;
  if (coupled) f.chain.links.back().follows = draw.uniform(0.6, 1.1);
  for (int j = 0; j < driven; ++j)
    for (const double side : {1.0, -1.0}) {
      Tendon tendon{fmt::format("h{}", f.chain.tendons.size() + 1), VectorXd::Zero(joints)};
      tendon.radius(j) = side * (0.0065 - 0.0007 * j);
      if (j > 0 && draw.chance(0.6))
        tendon.radius(j - 1) = draw.sign() * (0.0065 - 0.0007 * (j - 1));
      // Drive tendons run over both pulleys of the loop, on the same side.
      if (coupled && j + 1 == driven) tendon.radius(joints - 1) = side * 0.0035;
      f.chain.tendons.push_back(tendon);
    }
  return f;
}

void draw_common(TendonSetup& s, Draw& draw) {
  s.motor.inertia = 2.05e-3 * draw.log_uniform(0.5, 1.5);
  s.motor.level = draw.uniform(0.03, 0.1);
  s.motor.viscous = draw.uniform(0.01, 0.04);
  s.motor.turning = 0.1;
  s.motor.effort = s.motor_radius * s.pretension;
  s.motor.range = 0.6;
  s.motor.top_speed = 3.0;
  s.motor.motor_turn = 2.0 * pi / 100.0;
  s.motor.output_turn = 2.0 * pi;
  s.encoder = 2.0 * pi * std::ldexp(1.0, -(18 + draw.below(3)));
  s.resolved = draw.chance(0.5);
  const auto steps = [&] {
    return s.resolved ? draw.log_uniform(5.0, 50.0) : draw.log_uniform(0.05, 0.9);
  };
  for (std::size_t j = 0; j < s.jointed.axes.size(); ++j)
    s.jointed.bristles.push_back({s.encoder * steps(), draw.below(3)});
  s.motor_bristle = {2.0 * pi / 409600.0 * steps(), draw.below(3)};
  s.jointed.carries = false;
  s.rhythm.seconds = 10.0;
  s.rhythm.period = 0.002;
  s.rhythm.inner = 4;
  s.rhythm.kind = truth::Course::mixed;
}

std::string value(double x, const char* unit) {
  return fmt::format("{{ value = {:.12g}, unit = \"{}\", from = \"assumed\" }}\n", x, unit);
}

void write_motor(const TendonSetup& s, const std::filesystem::path& folder) {
  const AxisModel& m = s.motor;
  const double gear = m.motor_turn / (2.0 * pi);
  std::string text = "[part]\nname = \"motor\"\n\n[motor]\n";
  text += "gear_ratio = " + value(gear, "1");
  text += "rotor_inertia = " + value(0.8 * m.inertia * gear * gear, "kg*m^2");
  text += "gearbox_inertia = " + value(0.2 * m.inertia, "kg*m^2");
  text += "torque_constant = " + value(0.0085, "N*m/A");
  text += "pulley_radius = " + value(s.motor_radius, "m");
  text += "gamma1 = " + value(1.0 / m.turning, "s/rad");
  text += "gamma2 = " + value(2.0 / pi * m.level, "N*m");
  text += "gamma3 = " + value(m.viscous, "N*m*s/rad");
  text += "friction_compensation = " + value(0.9, "1");
  text += "ripple_compensation = " + value(0.9, "1");
  write_file(folder / "part.toml", text);
}

}  // namespace

void write_tendon_model(const TendonSetup& s, const std::filesystem::path& folder) {
  if (s.fingers.empty()) {
    write_mechanism(s.jointed.chain, folder / "model");
    if (s.motors) write_motor(s, folder / "motor");
    return;
  }
  std::string text = "[hand]\nname = \"trial_hand\"\nwrist = \"../wrist\"\n";
  int channel = 1, tendons = 0;
  for (std::size_t k = 0; k < s.fingers.size(); ++k) {
    const Chain& finger = s.fingers[k];
    write_mechanism(finger, folder / finger.name);
    const auto count = static_cast<int>(finger.tendons.size());
    text += fmt::format(
        "\n[[finger]]\nmodel = \"../{}\"\nbase.xyz = {{ value = [{:.12g}, {:.12g}, {:.12g}], unit "
        "= "
        "\"m\", from = \"assumed\" }}\nchannels = \"{}-{}\"\n",
        finger.name, s.bases[k].x(), s.bases[k].y(), s.bases[k].z(), channel, channel + count - 1);
    channel += count;
    tendons += count;
  }
  // The four-bar of the palm's edge is held, as the wrist is.
  text += fmt::format(
      "\n[four_bar]\nmodel = \"../bar\"\nbase.xyz = {{ value = [0.015, -0.027, -0.01], unit = "
      "\"m\", from = "
      "\"assumed\" }}\nchannels = \"{}-{}\"\n",
      channel, channel + 1);
  write_file(folder / "model" / "hand.toml", text);
  write_file(folder / "wrist" / "part.toml", wrist_part(WristShape{}, tendons + 2));
  write_file(folder / "bar" / "part.toml",
             "[part]\nname = \"bar\"\n\n[four_bar]\nground = " + value(0.012, "m") +
                 "crank = " + value(0.010, "m") + "coupler = " + value(0.012, "m") + "rocker = " +
                 value(0.011, "m") + "branch = \"open\"\npulley_radius = " + value(0.005, "m") +
                 "reference_theta2 = " + value(90.0, "deg") +
                 "theta2 = { value = [60, 120], unit = \"deg\", from = \"assumed\" }\n");
}

std::unique_ptr<TrialPlant> draw_finger(Draw draw, Mechanics mechanics) {
  TendonSetup s;
  s.mechanics = mechanics;
  s.motors = draw.chance(0.5);
  const int joints = 3 + draw.below(2);
  const bool coupled = draw.chance(0.35) && mechanics == Mechanics::own;
  DrawnFinger f = drawn_finger(draw, "finger", joints, 20, coupled);
  s.jointed.chain = f.chain;
  // A quarter moves across gravity, or is balanced: its model knows of none.
  if (draw.chance(0.25)) s.jointed.chain.gravity.setZero();
  s.jointed.axes = f.axes;
  s.jointed.middle = f.middle;
  for (std::size_t j = 0; j < f.axes.size(); ++j) s.channels.push_back(f.chain.links[j].joint);
  draw_common(s, draw);
  return tendon_plant(std::move(s), draw);
}

std::unique_ptr<TrialPlant> draw_hand(Draw draw) {
  TendonSetup s;
  const WristShape wrist;
  const PalmPose palm = palm_pose(wrist, reference_71(wrist), reference_73(wrist));
  Chain& whole = s.jointed.chain;
  whole.name = "hand";
  whole.gravity = palm.rotation.transpose() * Vector3d(0, 0, -9.81);
  const int fingers = 2 + draw.below(2);
  for (int k = 0; k < fingers; ++k) {
    const std::string name = fmt::format("f{}", k + 1);
    // A third of the fingers has a third joint, which follows the one before.
    const bool coupled = draw.chance(0.35);
    DrawnFinger f = drawn_finger(draw, name, coupled ? 3 : 2, 1, coupled);
    const Vector3d base(0.07, 0.02 - 0.014 * k, 0.0);
    const auto first = static_cast<int>(whole.links.size());
    for (Link link : f.chain.links) {
      if (link.follows == 0.0) s.channels.push_back(name + "." + link.joint);
      link.name = name + "_" + link.name;
      link.joint = name + "_" + link.joint;
      if (link.parent < 0)
        link.xyz += base;
      else
        link.parent += first;
      whole.links.push_back(link);
    }
    for (const Tendon& t : f.chain.tendons) {
      Tendon longer{name + "_" + t.name, VectorXd::Zero(3 * fingers)};
      longer.radius.segment(first, t.radius.size()) = t.radius;
      whole.tendons.push_back(longer);
    }
    s.jointed.axes.insert(s.jointed.axes.end(), f.axes.begin(), f.axes.end());
    s.jointed.middle.insert(s.jointed.middle.end(), f.middle.begin(), f.middle.end());
    s.fingers.push_back(f.chain);
    s.bases.push_back(base);
    whole.tip = f.chain.tip;
  }
  draw_common(s, draw);
  return tendon_plant(std::move(s), draw);
}

}  // namespace sinew::trials
