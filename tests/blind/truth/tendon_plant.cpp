// SPDX-License-Identifier: GPL-3.0-or-later
// Fingers and hands: joints that tendons pull, their forces logged at the motors' end, with or
// without the motors' own angles and torques.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/blind/truth/compared.h"
#include "tests/blind/truth/in_motion.h"
#include "tests/blind/truth/jointed.h"
#include "tests/blind/truth/signal_path.h"
#include "tests/blind/truth/tendon_setup.h"

namespace sinew::trials {
namespace {

using truth::Draw;

/// Of the eighth order: a difference of neighbours alone would make a motor lighter the faster it
/// moves, which is what a soft gear does.
VectorXd slope_of(const VectorXd& x, double step) {
  constexpr double share[] = {4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0};
  constexpr Index reach = 4;
  const Index n = x.size();
  VectorXd d(n);
  for (Index k = 0; k < n; ++k) {
    const Index at = std::clamp(k, reach, n - 1 - reach);
    d(k) = 0.0;
    for (Index i = 1; i <= reach; ++i) d(k) += share[i - 1] * (x(at + i) - x(at - i)) / step;
  }
  return d;
}

/// Forces without torque, each 0.6 of the pretension or more: projected in turn on both, which meet
/// where every joint has antagonists.
VectorXd balanced_forces(const MatrixXd& inner, double pretension) {
  VectorXd forces = VectorXd::Constant(inner.rows(), pretension);
  for (int i = 0; i < 1000; ++i) forces = (inner * forces).cwiseMax(0.6 * pretension);
  return inner * forces;
}

class TendonPlant : public TrialPlant {
 public:
  TendonPlant(TendonSetup setup, Draw draw) : s_(std::move(setup)) {
    for (auto& stream : streams_) stream = draw.bits();
    const Index m = tendons(), n = joints();
    radii_.resize(m, n);
    radii_.setZero();
    // Over the pulley of a joint that follows, a tendon moves with the joint that leads.
    const Chain& chain = s_.jointed.chain;
    for (Index i = 0; i < m; ++i)
      for (std::size_t l = 0; l < chain.links.size(); ++l)
        radii_(i, chain.axis_of(l)) += share(l) * tendon(i).radius(static_cast<Index>(l));
    for (Index i = 0; i < m; ++i) {
      rate_.push_back(draw.uniform(0.8, 4.0));
      phase_.push_back(draw.uniform(0.0, 2.0 * pi));
      guide_.push_back(draw.log_uniform(5e-6, 5e-4));
    }
    inner_ = MatrixXd::Identity(m, m) -
             radii_ * (radii_.transpose() * radii_).ldlt().solve(radii_.transpose());
    balanced_ = balanced_forces(inner_, s_.pretension);
    force_noise_ = draw.uniform(0.003, 0.01);
    motor_noise_ = draw.uniform(0.005, 0.015);
    learn_scales(s_.jointed, course({}, 0));
    list_offers();
  }

  const std::vector<Offer>& offers() const override { return offers_; }
  void write_model(const std::filesystem::path& folder) const override {
    write_tendon_model(s_, folder);
  }

  Course course(const std::vector<Hidden>& hidden, int log) const override {
    const Draw draw(streams_[log]);
    // A joint rests while its friction turns, and its tendons stay as smooth as the motors that
    // pull them: motion that is prescribed would have them jump with it.
    if (s_.mechanics == Mechanics::mujoco)
      return in_mujoco(s_.jointed, at_joints(hidden), s_.rhythm, {}, draw);
    return in_joint_torques(s_.jointed, at_joints(hidden), s_.rhythm, draw);
  }

  Log replay(const Course& course, const std::vector<Hidden>& hidden, int log) const override;
  void measure(Log& log, int number) const override;
  std::vector<VectorXd> left_over(const Log& log) const override;
  bool shows(const Hidden& hidden, std::size_t channel) const override;
  std::vector<MatrixXd> fitted(const Log& log, unsigned which) const override;
  std::vector<VectorXd> moving(const Log& log) const override;

  std::vector<double> bands(const Log& perfect, const Log& measured) const override {
    double lowest = documented_band(perfect.step);
    for (Index j = 0; j < joints(); ++j)
      lowest = std::min(lowest, band_of(perfect.columns.col(j), measured.columns.col(j),
                                        perfect.step, documented_band(perfect.step)));
    std::vector<double> all(static_cast<std::size_t>(joints()), lowest);
    for (Index i = joints(); s_.motors && i < joints() + tendons(); ++i)
      all.push_back(band_of(perfect.columns.col(i), measured.columns.col(i), perfect.step,
                            documented_band(perfect.step)));
    return all;
  }

  std::map<std::string, std::string> traits() const override {
    return {{"pre-sliding", s_.resolved ? "resolved" : "below a step"},
            {"mechanics", s_.mechanics == Mechanics::mujoco ? "MuJoCo" : "own"},
            {"motors", s_.motors ? "logged" : "not logged"},
            {"joints", std::to_string(joints())},
            {"tendons", std::to_string(tendons())}};
  }

 private:
  Index joints() const { return s_.jointed.chain.size(); }
  /// Of its axis's motion that a link's joint has; behind one that follows none follows.
  double share(std::size_t link) const {
    const double follows = s_.jointed.chain.links[link].follows;
    return follows != 0.0 ? follows : 1.0;
  }
  Index tendons() const { return static_cast<Index>(s_.jointed.chain.tendons.size()); }
  const Tendon& tendon(Index i) const {
    return s_.jointed.chain.tendons[static_cast<std::size_t>(i)];
  }
  /// Force column of tendon i; theta and tau columns where the motors are logged.
  Index force_column(Index i) const { return joints() + (s_.motors ? 2 * tendons() : 0) + i; }
  int motor_axis(Index i) const { return static_cast<int>(joints() + i); }
  int force_cell(Index i) const { return static_cast<int>(joints() + tendons() + i); }

  std::vector<Hidden> at_joints(const std::vector<Hidden>& hidden) const {
    std::vector<Hidden> some;
    for (const Hidden& h : hidden)
      if (!acts_on_axis(h.cause) || h.at < joints()) some.push_back(h);
    return some;
  }

  /// Moment arms as they are: a pulley's radius, a guide that is off its place.
  MatrixXd true_arms(const std::vector<Hidden>& hidden, const VectorXd& q) const {
    MatrixXd arms = radii_;
    for (const Hidden& h : hidden) {
      if (h.cause == "pulley_radius") arms.col(h.at) *= 1.0 + h.dose;
      if (h.cause == "tendon_radius") arms.row(h.at) *= 1.0 + h.dose;
      if (h.cause == "coupling_ratio") {
        const auto link = static_cast<std::size_t>(h.at);
        for (Index i = 0; i < tendons(); ++i)
          arms(i, s_.jointed.chain.axis_of(link)) +=
              h.dose * share(link) * tendon(i).radius(static_cast<Index>(h.at));
      }
      if (h.cause == "routing_offset")
        for (Index j = 0; j < joints(); ++j)
          if (arms(h.at, j) != 0.0) arms(h.at, j) += h.dose * std::sin(0.7 * q(j) + 0.4);
    }
    return arms;
  }

  /// Moves no joint of the model, whatever its size: tendons that went slack on the way to a torque
  /// would not give it.
  VectorXd pretension_at(double time, int log) const {
    VectorXd wandering(tendons());
    for (Index i = 0; i < tendons(); ++i) {
      const auto w = static_cast<std::size_t>(i);
      wandering(i) = 0.25 * s_.pretension * std::sin(rate_[w] * time + phase_[w] + log);
    }
    return balanced_ + inner_ * wandering;
  }

  /// Smallest change of the pretension that gives the torque. Where a tendon would go slack, all
  /// are pulled more.
  VectorXd forces_for(const VectorXd& torque, const MatrixXd& arms, VectorXd tension) const {
    const auto inverse = (arms.transpose() * arms).ldlt();
    const auto give = [&] { tension -= arms * inverse.solve(torque + arms.transpose() * tension); };
    give();
    const double more = ((0.05 * s_.pretension - tension.array()) / balanced_.array()).maxCoeff();
    if (more > 0.0) {
      tension += 1.5 * more * balanced_;
      give();
    }
    return tension;
  }

  void log_motors(const Course& course, const MatrixXd& pull, const MatrixXd& at_motor,
                  const MatrixXd& lengths, const std::vector<Hidden>& hidden, int log,
                  Log& result) const;
  MatrixXd smooth(const Log& log, Index first, Index count) const;
  void list_offers();

  TendonSetup s_;
  std::uint64_t streams_[4] = {};
  MatrixXd radii_, inner_;  ///< inner_: projects on forces that move no joint
  VectorXd balanced_;
  std::vector<double> rate_, phase_, guide_;
  double force_noise_ = 0.1, motor_noise_ = 0.01;
  std::vector<Offer> offers_;
};

Log TendonPlant::replay(const Course& course, const std::vector<Hidden>& hidden, int log) const {
  const Index n = joints(), m = tendons(), rows = course.rows();
  const MatrixXd torque = course.command.size() > 0
                              ? course.command
                              : needed_efforts(s_.jointed, course, at_joints(hidden));
  MatrixXd pull(rows, m), at_motor(rows, m), lengths(rows, m);
  VectorXd held = VectorXd::Zero(m), before;
  for (Index k = 0; k < rows; ++k) {
    const double t = course.period() * static_cast<double>(k);
    const VectorXd q = course.q.row(k * course.inner), v = course.v.row(k * course.inner);
    const MatrixXd arms = true_arms(hidden, q);
    const VectorXd tension = forces_for(torque.row(k), arms, pretension_at(t, log));
    pull.row(k) = tension.transpose();
    at_motor.row(k) = tension.transpose();
    lengths.row(k) = (arms * q).transpose();
    for (const Hidden& h : hidden) {
      if (h.cause != "guiding_friction") continue;
      // Dahl over some micrometres of the tendon's own way.
      const double rate = -(arms.row(h.at) * v)(0), way = std::abs(rate) * course.period();
      const double side = rate < 0.0 ? -1.0 : 1.0;
      double& z = held(h.at);
      z = side + (z - side) * std::exp(-way / guide_[static_cast<std::size_t>(h.at)]);
      double bend = 0.6;
      for (Index j = 0; j < n; ++j)
        if (radii_(h.at, j) != 0.0) bend += std::abs(q(j));
      if (h.law == 0)
        at_motor(k, h.at) *= std::exp(h.dose * bend * z);
      else
        at_motor(k, h.at) += h.dose * s_.pretension * z * (1.0 - std::exp(-0.7 * bend));
    }
  }
  Log result;
  result.step = course.period();
  result.columns.resize(rows, n + (s_.motors ? 3 : 1) * m);
  for (Index j = 0; j < n; ++j) {
    VectorXd q(rows);
    for (Index k = 0; k < rows; ++k) q(k) = course.q(k * course.inner, j);
    auto here = only_at(hidden, static_cast<int>(j));
    result.columns.col(j) = sensed_position(q, here, result.step);
    result.names.push_back(s_.channels[static_cast<std::size_t>(j)]);
    result.units.push_back("rad");
  }
  if (s_.motors) log_motors(course, pull, at_motor, lengths, hidden, log, result);
  for (Index i = 0; i < m; ++i) {
    VectorXd shown = at_motor.col(i);
    for (const Hidden& h : hidden) {
      if (h.at != i) continue;
      if (h.cause == "force_sensor_scale") shown *= 1.0 + h.dose;
      if (h.cause == "force_sensor_offset") shown.array() += h.dose;
    }
    result.columns.col(force_column(i)) =
        logged_effort(shown, only_at(hidden, force_cell(i)), result.step, 2.0 * s_.pretension);
    result.names.push_back(fmt::format("force_{}", i + 1));
    result.units.push_back("N");
  }
  return result;
}

void TendonPlant::log_motors(const Course& course, const MatrixXd& pull, const MatrixXd& at_motor,
                             const MatrixXd& lengths, const std::vector<Hidden>& hidden, int log,
                             Log& result) const {
  const Index n = joints(), m = tendons(), rows = pull.rows();
  const double step = course.period();
  for (Index i = 0; i < m; ++i) {
    auto here = only_at(hidden, motor_axis(i));
    for (Hidden& h : here)
      if (h.cause.find("ripple") != std::string::npos) h.phase += 2.4 * log;
    const VectorXd theta = (pull.col(i) / s_.stiffness - lengths.col(i)) / s_.motor_radius;
    const VectorXd omega = slope_of(theta, step), alpha = slope_of(omega, step);
    Axis axis(s_.motor, s_.motor_bristle, here);
    VectorXd tau(rows);
    for (Index k = 0; k < rows; ++k) {
      const double load = s_.motor_radius * at_motor(k, i);
      const double friction =
          axis.resist({step * static_cast<double>(k), theta(k), omega(k), alpha(k), load}, step);
      tau(k) = friction + s_.motor.inertia * alpha(k) + load;
    }
    result.columns.col(n + i) = sensed_position(theta, here, step);
    result.columns.col(n + m + i) = logged_effort(tau, here, step, 2.0 * s_.motor.effort);
  }
  for (const char* name : {"theta", "tau"})
    for (Index i = 0; i < m; ++i) {
      result.names.push_back(fmt::format("{}_{}", name, i + 1));
      result.units.push_back(name[1] == 'h' ? "rad" : "N*m");
    }
}

void TendonPlant::measure(Log& log, int number) const {
  Draw draw(streams_[number] ^ 0x5bd1e995u);
  for (Index j = 0; j < joints(); ++j)
    for (double& q : log.columns.col(j)) q = s_.encoder * std::round(q / s_.encoder);
  for (Index i = 0; i < tendons(); ++i) {
    truth::Noise of_force(draw.fork()), of_motor(draw.fork());
    for (double& f : log.columns.col(force_column(i)))
      f += force_noise_ * s_.pretension * 0.2 * of_force.next();
    if (!s_.motors) continue;
    const double count = 2.0 * pi / 409600.0;
    for (double& x : log.columns.col(joints() + i)) x = count * std::round(x / count);
    for (double& tau : log.columns.col(joints() + tendons() + i))
      tau += motor_noise_ * s_.motor.effort * of_motor.next();
  }
}

MatrixXd TendonPlant::smooth(const Log& log, Index first, Index count) const {
  MatrixXd motion(log.columns.rows(), 3 * count);
  for (Index j = 0; j < count; ++j) {
    const Smoothed s = smoothed(log.columns.col(first + j), log.step, documented_band(log.step));
    motion.col(j) = s.q;
    motion.col(count + j) = s.v;
    motion.col(2 * count + j) = s.a;
  }
  return motion;
}

std::vector<VectorXd> TendonPlant::left_over(const Log& log) const {
  const Index n = joints(), m = tendons(), rows = log.columns.rows();
  const MatrixXd motion = smooth(log, 0, n);
  const MatrixXd forces = log.columns.rightCols(m);
  std::vector<VectorXd> left(static_cast<std::size_t>(n + (s_.motors ? m : 0)), VectorXd(rows));
  for (Index k = 0; k < rows; ++k) {
    const VectorXd q = motion.row(k).head(n), v = motion.row(k).segment(n, n),
                   a = motion.row(k).tail(n);
    const VectorXd rigid = s_.jointed.chain.torque(q, v, a);
    const VectorXd pulled = -radii_.transpose() * forces.row(k).transpose();
    for (Index j = 0; j < n; ++j) {
      const AxisModel& x = s_.jointed.axes[static_cast<std::size_t>(j)];
      left[static_cast<std::size_t>(j)](k) = pulled(j) - rigid(j) - x.viscous * v(j) -
                                             x.level * std::tanh(v(j) / (0.01 * x.top_speed));
    }
  }
  if (!s_.motors) return left;
  const MatrixXd turning = smooth(log, n, m);
  for (Index i = 0; i < m; ++i)
    for (Index k = 0; k < rows; ++k) {
      const double v = turning(k, m + i);
      left[static_cast<std::size_t>(n + i)](k) =
          log.columns(k, n + m + i) - s_.motor.inertia * turning(k, 2 * m + i) -
          2.0 / pi * s_.motor.level * std::atan(v / s_.motor.turning) - s_.motor.viscous * v -
          s_.motor_radius * forces(k, i);
    }
  return left;
}

/// A joint's cause moves its tendons' motors otherwise, and their friction turns elsewhere: the
/// model knows that as it knows all friction. A motor shows what is at itself and at its force
/// cell.
bool TendonPlant::shows(const Hidden& hidden, std::size_t channel) const {
  const Index motor = static_cast<Index>(channel) - joints();
  if (motor < 0) return true;
  static const std::set<std::string> elsewhere{
      "guiding_friction", "tendon_radius", "routing_offset", "pulley_radius",
      "coupling_ratio",   "link_mass",     "link_centre",    "link_products"};
  if (elsewhere.contains(hidden.cause)) return false;
  if (hidden.cause == "force_sensor_scale" || hidden.cause == "force_sensor_offset")
    return hidden.at == motor;
  return hidden.at == motor_axis(motor) || hidden.at == force_cell(motor);
}

std::vector<MatrixXd> TendonPlant::fitted(const Log& log, unsigned which) const {
  std::vector<MatrixXd> all;
  const Index n = joints(), m = s_.motors ? tendons() : 0;
  const MatrixXd motion = smooth(log, 0, n), turning = m > 0 ? smooth(log, n, m) : MatrixXd();
  for (Index j = 0; j < n; ++j)
    all.push_back(fitted_at(s_.jointed.axes[static_cast<std::size_t>(j)], motion.col(n + j),
                            motion.col(2 * n + j), log.step, which));
  for (Index i = 0; i < m; ++i)
    all.push_back(fitted_at(s_.motor, turning.col(m + i), turning.col(2 * m + i), log.step, which));
  return all;
}

std::vector<VectorXd> TendonPlant::moving(const Log& log) const {
  std::vector<VectorXd> all;
  for (Index i = 0; i < joints() + (s_.motors ? tendons() : 0); ++i)
    all.push_back(in_motion(log.columns.col(i), log.step));
  return all;
}

void TendonPlant::list_offers() {
  const Jointed& jointed = s_.jointed;
  const auto offer = [&](const char* cause, const std::string& place, Index at, double scale,
                         const char* parameter = "", double factor = 1.0) {
    offers_.push_back(
        {cause, place, static_cast<int>(at), scale, false, fits_all, parameter, factor, 0});
  };
  for (Index j = 0; j < joints(); ++j) {
    const std::string place = "joint " + jointed.chain.links[jointed.chain.link_of(j)].joint;
    offer_axis(jointed, static_cast<std::size_t>(j), place, false, true, offers_);
    offer("pulley_radius", place, j, 1.0, "gain_change");
    offer("sensor_offset", place, j, 1.0, "zero_offset");
    offers_.push_back({"sensor_scale", place, static_cast<int>(j), 1.0, false, fits_turning,
                       "scale_error", 1.0, 0});
    offers_.push_back({"sensor_low_pass", place, static_cast<int>(j), 1.0, false, fits_turning,
                       "time_constant", 1.0, 0});
    const double range = 2.0 * jointed.axes[static_cast<std::size_t>(j)].range;
    offer("sensor_quantisation", place, j, range);
    offer("sensor_hysteresis", place, j, range, "half_play", 0.5);
  }
  for (std::size_t l = 0; l < jointed.chain.links.size(); ++l)
    if (jointed.chain.links[l].follows != 0.0)
      offer("coupling_ratio", "joint " + jointed.chain.links[l].joint, static_cast<Index>(l), 1.0);
  offer_links(jointed, false, offers_);
  offer_gravity(jointed, offers_);
  for (Index i = 0; i < tendons(); ++i) {
    const std::string place = "tendon " + tendon(i).name;
    offer("guiding_friction", place, i, 1.0);
    // What the findings call an excess is an effort to be provided: a sensor that shows more has
    // less.
    offer("force_sensor_scale", place, i, 1.0, "force_excess", -1.0);
    offer("force_sensor_offset", place, i, s_.pretension, "force_offset", -1.0);
    offer("tendon_radius", place, i, 1.0, "radius_change");
    // Its force cell warms up, saturates, sags with its supply or has coarse steps.
    for (const char* cause : {"heat", "saturation", "supply_sag", "coarse_command"})
      offers_.push_back({cause, place, force_cell(i),
                         cause == std::string("coarse_command") ? s_.pretension : 1.0, true,
                         fits_all, "", 1.0, 0});
    offer("routing_offset", place, i, 0.5 * radii_.row(i).cwiseAbs().maxCoeff());
  }
  if (!s_.motors) return;
  Jointed motors;
  motors.axes.assign(static_cast<std::size_t>(tendons()), s_.motor);
  for (Index i = 0; i < tendons(); ++i) {
    std::vector<Offer> own;
    offer_axis(motors, static_cast<std::size_t>(i), fmt::format("motor {}", i + 1), true, true,
               own);
    for (Offer& o : own) {
      if (o.cause == "gear_elasticity" || o.cause == "backlash") continue;
      o.at = motor_axis(i);
      offers_.push_back(o);
    }
  }
}

}  // namespace

std::unique_ptr<TrialPlant> tendon_plant(TendonSetup setup, Draw draw) {
  return std::make_unique<TendonPlant>(std::move(setup), draw);
}

}  // namespace sinew::trials
