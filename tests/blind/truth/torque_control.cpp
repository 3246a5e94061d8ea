// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blind/truth/torque_control.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tests/blind/truth/signal_path.h"

namespace sinew::trials {
namespace {

/// The chain's equations by Newton and Euler, semi-implicit Euler steps.
class OwnIntegrator : public Integrator {
 public:
  OwnIntegrator(Chain chain, double step) : chain_(std::move(chain)), step_(step) {}
  void start(const VectorXd& q, const VectorXd& v) override {
    q_ = q;
    v_ = v;
  }
  VectorXd q() const override { return q_; }
  VectorXd v() const override { return v_; }
  void advance(const VectorXd& effort, const VectorXd& slope) override {
    const Index n = q_.size();
    const VectorXd zero = VectorXd::Zero(n), rest = chain_.torque(q_, zero, zero);
    MatrixXd inertia(n, n);
    for (Index j = 0; j < n; ++j)
      inertia.col(j) = chain_.torque(q_, zero, VectorXd::Unit(n, j)) - rest;
    for (Index j = 0; j < n; ++j)
      inertia(j, j) += chain_.links[chain_.link_of(j)].armature + step_ * slope(j);
    v_ += step_ * inertia.ldlt().solve(effort - chain_.torque(q_, v_, zero));
    q_ += step_ * v_;
  }

 private:
  Chain chain_;
  double step_;
  VectorXd q_, v_;
};

std::vector<Axis> axes_of(const Jointed& jointed, const std::vector<Hidden>& hidden) {
  std::vector<Axis> axes;
  for (std::size_t i = 0; i < jointed.axes.size(); ++i) {
    auto here = only_at(hidden, static_cast<int>(i));
    std::erase_if(here, [](const Hidden& h) { return h.cause == "inertia"; });
    axes.emplace_back(jointed.axes[i], jointed.bristles[i], here);
  }
  return axes;
}

/// Computed torque by the model under test, friction by what is wanted: no steeper than tendons'
/// motors can follow.
VectorXd command_of(const Jointed& jointed, const VectorXd& asked, const VectorXd& pursued,
                    const VectorXd& speed) {
  VectorXd command = asked;
  for (Index j = 0; j < command.size(); ++j) {
    const AxisModel& m = jointed.axes[static_cast<std::size_t>(j)];
    const double turning = std::max(m.turning, 0.08 * m.top_speed);
    command(j) += jointed.chain.links[jointed.chain.link_of(j)].armature * pursued(j) +
                  0.8 * m.level * std::tanh(speed(j) / turning) + m.viscous * speed(j);
  }
  return command;
}

}  // namespace

Chain chain_in_motion(const Jointed& jointed, const std::vector<Hidden>& hidden) {
  Chain real = true_chain(jointed.chain, hidden);
  for (const Hidden& h : hidden)
    if (h.cause == "inertia")
      real.links[real.link_of(h.at)].armature +=
          std::max(h.dose, -0.8 * jointed.axes[static_cast<std::size_t>(h.at)].inertia);
  return real;
}

Course in_torque_control(const Jointed& jointed, const std::vector<Hidden>& hidden,
                         const Course& wanted, const VectorXd& load, double bandwidth,
                         Integrator& integrator) {
  Course course = wanted;
  course.load = load;
  const Index n = jointed.chain.size();
  course.command.resize(course.rows(), n);
  std::vector<Axis> axes = axes_of(jointed, hidden);
  integrator.start(wanted.q.row(0), wanted.v.row(0));
  VectorXd resisting = VectorXd::Zero(n), before = VectorXd::Zero(n), slope(n);
  for (Index k = 0; k < course.q.rows(); ++k) {
    const VectorXd q = integrator.q(), v = integrator.v();
    const VectorXd pursued = wanted.a.row(k).transpose() +
                             bandwidth * bandwidth * (wanted.q.row(k).transpose() - q) +
                             1.8 * bandwidth * (wanted.v.row(k).transpose() - v);
    const VectorXd asked = jointed.chain.torque(q, v, pursued);
    const double known = load.size() > 0 ? load(k) : 0.0;
    const VectorXd command = command_of(jointed, asked, pursued, wanted.v.row(k)).array() + known;
    // At a row's instant: the mean of what was given in the steps before and behind it.
    if (k % course.inner == 0)
      course.command.row(k / course.inner) =
          (k > 0 ? VectorXd(0.5 * (before + command)) : command).transpose();
    before = command;
    for (Index j = 0; j < n; ++j)
      slope(j) = axes[static_cast<std::size_t>(j)].slope(v(j), course.step);
    course.q.row(k) = q.transpose();
    course.v.row(k) = v.transpose();
    integrator.advance((command - resisting).array() - known, slope);
    const VectorXd next = integrator.q(), speed = integrator.v();
    for (Index j = 0; j < n; ++j) {
      course.a(k, j) = (speed(j) - v(j)) / course.step;
      const double carried = jointed.carries ? asked(j) : 0.0;
      resisting(j) = axes[static_cast<std::size_t>(j)].resist(
          {course.step * static_cast<double>(k + 1), next(j), speed(j), course.a(k, j),
           carried + known},
          course.step);
    }
  }
  if (!course.q.allFinite()) throw std::runtime_error("the controlled motion is not finite");
  return course;
}

Course in_joint_torques(const Jointed& jointed, const std::vector<Hidden>& hidden,
                        const Rhythm& rhythm, truth::Draw draw) {
  const Course wanted = commanded(jointed, rhythm, draw);
  OwnIntegrator integrator(chain_in_motion(jointed, hidden), wanted.step);
  // As stiff as motors that hold their positions pull through the tendons.
  const double bandwidth = 2.0 * pi * draw.fork().uniform(20.0, 30.0);
  return in_torque_control(jointed, hidden, wanted, {}, bandwidth, integrator);
}

}  // namespace sinew::trials
