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
  VectorXd speed_after(const VectorXd& effort) override {
    return v_ + step_ * inertia().ldlt().solve(effort -
                                               chain_.torque(q_, v_, VectorXd::Zero(q_.size())));
  }
  MatrixXd mobility() override {
    const Index n = q_.size();
    return step_ * inertia().ldlt().solve(MatrixXd::Identity(n, n));
  }
  void advance(const VectorXd& effort) override {
    v_ = speed_after(effort);
    q_ += step_ * v_;
  }

 private:
  MatrixXd inertia() const {
    const Index n = q_.size();
    const VectorXd zero = VectorXd::Zero(n), rest = chain_.torque(q_, zero, zero);
    MatrixXd inertia(n, n);
    for (Index j = 0; j < n; ++j) {
      inertia.col(j) = chain_.torque(q_, zero, VectorXd::Unit(n, j)) - rest;
      inertia(j, j) += chain_.links[chain_.link_of(j)].armature;
    }
    return inertia;
  }

  Chain chain_;
  double step_;
  VectorXd q_, v_;
};

/// Speed v with v + mobility * resisting(v) = free, resisting not falling with v: friction stops an
/// axis within a step, and does not throw it back.
template <class Resisting>
double stopped_speed(double free, double mobility, const Resisting& resisting) {
  const auto off = [&](double v) { return v + mobility * resisting(v) - free; };
  const double first = off(free);
  if (first == 0.0) return free;
  // Further and further towards where the effort pushes, until it is too far.
  double width = std::abs(first), low = free, high = free;
  for (int i = 0; i < 60; ++i, width *= 2.0) {
    (first > 0.0 ? low : high) = first > 0.0 ? free - width : free + width;
    if ((off(first > 0.0 ? low : high) > 0.0) != (first > 0.0)) break;
  }
  for (int i = 0; i < 60 && high - low > 1e-13 * (1.0 + std::abs(free)); ++i) {
    const double middle = 0.5 * (low + high);
    (off(middle) > 0.0 ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

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
  VectorXd resisting = VectorXd::Zero(n), before = VectorXd::Zero(n);
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
    course.q.row(k) = at_its_speed(q, v, course.step).transpose();
    course.v.row(k) = v.transpose();
    const VectorXd given = command.array() - known;
    const VectorXd free = integrator.speed_after(given);
    const MatrixXd mobility = integrator.mobility();
    const auto end_of_step = [&](Index j, double speed) -> Instant {
      const double carried = jointed.carries ? asked(j) : 0.0;
      return {course.step * static_cast<double>(k + 1), q(j) + course.step * speed, speed,
              (speed - v(j)) / course.step, carried + known};
    };
    // Axis after axis, until none moves any more.
    VectorXd speed = v;
    for (int sweep = 0; sweep < 40; ++sweep) {
      const VectorXd last = speed;
      for (Index j = 0; j < n; ++j) {
        Axis& axis = axes[static_cast<std::size_t>(j)];
        const double others = mobility.row(j).dot(resisting) - mobility(j, j) * resisting(j);
        const auto at = [&](double x) { return axis.would_resist(end_of_step(j, x), course.step); };
        speed(j) = stopped_speed(free(j) - others, mobility(j, j), at);
        resisting(j) = at(speed(j));
      }
      if ((speed - last).cwiseAbs().maxCoeff() < 1e-9 * (1.0 + last.cwiseAbs().maxCoeff())) break;
    }
    integrator.advance(given - resisting);
    const VectorXd now = integrator.v();
    for (Index j = 0; j < n; ++j) {
      course.a(k, j) = (now(j) - v(j)) / course.step;
      axes[static_cast<std::size_t>(j)].resist(end_of_step(j, now(j)), course.step);
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
