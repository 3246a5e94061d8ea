// SPDX-License-Identifier: GPL-3.0-or-later
// Lever and tendon on a calibration rig: the tendon is drawn slowly, a load cell at its end and the
// lever's sensor are logged.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/blind/truth/chain.h"
#include "tests/blind/truth/compared.h"
#include "tests/blind/truth/lever_shape.h"
#include "tests/blind/truth/signal_path.h"
#include "tests/blind/truth/signals.h"
#include "tests/blind/truth/trial_plant.h"

namespace sinew::trials {
namespace {

using truth::Draw;

/// What the load cell shows that no cause of the library explains. Keeps what it remembers.
class Cell {
 public:
  Cell(const std::vector<Hidden>& hidden, double peak, double reach)
      : hidden_(hidden), peak_(peak), reach_(reach) {}

  double shown(double force, double x, double rate, double time, double step) {
    most_ = std::max(most_, x);
    slow_ += step / 2.0 * (force - slow_);
    warm_ += step / 8.0 * (4.0 * force * force / (peak_ * peak_) - warm_);
    fastest_ = std::max(std::abs(rate), fastest_ * std::exp(-step / 4.0));
    if (last_ * rate < 0.0) {
      if (std::abs(x - turned_) > 0.25 * reach_) latched_ = last_ > 0.0 ? 1.0 : -1.0;
      turned_ = x;
    }
    if (rate != 0.0) last_ = rate;
    double seen = force;
    for (const Hidden& h : hidden_) {
      const double u = force / peak_, place = x / reach_;
      if (h.dose == 0.0) continue;
      if (h.cause == "latch") seen += h.dose * latched_;
      if (h.cause == "speed_memory") seen += h.dose * fastest_ / reach_ * std::tanh(rate / 1e-4);
      if (h.cause == "other_stage")
        seen +=
            h.dose * std::sin(7.31 * pi * place + h.phase) * (1.0 + 0.5 * std::sin(3.7 * place));
      if (h.cause == "supply_sag") seen -= h.dose * force * u * u;
      if (h.cause == "saturation") seen = peak_ / h.dose * std::tanh(seen * h.dose / peak_);
      if (h.cause == "heat") seen *= 1.0 - h.dose * std::min(warm_, 1.0);
      if (h.cause == "filling") seen += h.dose * (force - slow_);
      if (h.cause == "contact" && place > 0.5 && std::fmod(time, 5.1) < 2.6)
        seen += h.dose * (x - 0.5 * reach_);
      if (h.cause == "outer_force" && std::fmod(time, 4.6) < 2.3)
        seen += h.dose * std::pow(std::sin(pi * std::fmod(time, 2.3) / 2.3), 2.0);
      if (h.cause == "tight_under_load")
        seen +=
            h.dose * force * std::tanh(rate / 1e-4) * std::exp(-20.0 * std::pow(place - 0.5, 2.0));
    }
    return seen;
  }

 private:
  const std::vector<Hidden>& hidden_;
  double peak_, reach_;
  double most_ = 0.0, slow_ = 0.0, warm_ = 0.0, fastest_ = 0.0, latched_ = 0.0, last_ = 0.0,
         turned_ = 0.0;
};

class LeverPlant : public TrialPlant {
 public:
  explicit LeverPlant(Draw draw) : curve_(shape_, 0.0, 0.0) {
    for (auto& s : streams_) s = draw.bits();
    shape_.stiffness *= draw.uniform(0.7, 1.4);
    shape_.arm *= draw.uniform(0.97, 1.03);
    curve_ = LeverCurve(shape_, 0.0, 0.0);
    guided_ = draw.chance(0.5);
    elongation_ = draw.chance(0.7);
    travel_ = 1.12 * shape_.reach;
    first_angle_ = shape_.rest;
    last_angle_ = curve_.angle(travel_);
    peak_ = curve_.force(shape_.reach);
    force_noise_ = draw.uniform(0.004, 0.012) * peak_;
    length_noise_ = draw.uniform(1e-5, 4e-5);
    resolved_ = draw.chance(0.5);
    grip_way_ = resolved_ ? draw.uniform(0.3e-4, 2e-4) : 1e-6;
    loop_way_ = draw.log_uniform(1e-4, 2e-3);
    list_offers();
  }

  const std::vector<Offer>& offers() const override { return offers_; }
  void write_model(const std::filesystem::path& folder) const override {
    write_file(folder / "model" / "part.toml", lever_part(shape_, travel_, 40.0, 4040.0));
  }

  Course course(const std::vector<Hidden>&, int log) const override {
    Draw draw(streams_[log]);
    Course c;
    c.step = 0.002;
    const Index rows = 14000;
    c.q = MatrixXd::Zero(rows, 2);
    const auto table = truth::Motion(truth::Course::mixed, 0.5 * shape_.reach, 1.2 * shape_.reach,
                                     28.0, draw.fork())
                           .table(c.step, static_cast<std::size_t>(rows));
    double bend = 0.6;
    for (Index k = 0; k < rows; ++k) {
      if (k % 3000 == 0) bend = draw.uniform(0.3, 3.0);
      c.q(k, 0) = std::clamp(0.52 * shape_.reach + table[static_cast<std::size_t>(k)].position,
                             0.02 * shape_.reach, 1.1 * shape_.reach);
      c.q(k, 1) = bend;
    }
    return c;
  }

  Log replay(const Course& course, const std::vector<Hidden>& hidden, int log) const override;

  void measure(Log& log, int number) const override {
    Draw draw(streams_[number] ^ 0x5bd1e995u);
    truth::Noise force(draw.fork()), length(draw.fork());
    for (Index k = 0; k < log.columns.rows(); ++k) {
      log.columns(k, 0) = std::round(log.columns(k, 0));
      log.columns(k, 1) += force_noise_ * force.next();
      if (elongation_) log.columns(k, 2) += length_noise_ * length.next();
    }
  }

  std::vector<VectorXd> left_over(const Log& log) const override {
    const Index rows = log.columns.rows();
    std::vector<VectorXd> left(elongation_ ? 2 : 1, VectorXd(rows));
    for (Index k = 0; k < rows; ++k) {
      const double share = (log.columns(k, 0) - 40.0) / 4000.0;
      const double angle = first_angle_ + share * (last_angle_ - first_angle_);
      left[0](k) = log.columns(k, 1) - std::max(0.0, curve_.force_at(angle));
      if (elongation_) left[1](k) = log.columns(k, 2) - curve_.elongation_at(angle);
    }
    return left;
  }

  // Nothing is fitted to a rig in any case.
  std::vector<MatrixXd> fitted(const Log& log, unsigned) const override {
    return std::vector<MatrixXd>(elongation_ ? 2 : 1, MatrixXd(log.columns.rows(), 0));
  }
  std::vector<VectorXd> moving(const Log& log) const override {
    return std::vector<VectorXd>(elongation_ ? 2 : 1, VectorXd::Ones(log.columns.rows()));
  }
  std::vector<double> bands(const Log& log, const Log&) const override {
    return std::vector<double>(elongation_ ? 2 : 1, rig_band(log.step));
  }
  std::map<std::string, std::string> traits() const override {
    return {{"pre-sliding", resolved_ ? "resolved" : "below a step"},
            {"guide", guided_ ? "logged" : "none"},
            {"elongation", elongation_ ? "logged" : "not logged"}};
  }

 private:
  void list_offers() {
    const auto offer = [&](const char* cause, const char* place, double scale,
                           const char* parameter = "", bool outside = false) {
      offers_.push_back({cause, place, 0, scale, outside, fits_all, parameter, 1.0, 0});
    };
    offer("spring_constant", "lever", 1.0, "spring_change");
    offer("preload_offset", "lever", 1e-3, "preload");
    offer("lever_hysteresis", "lever", 1.0);
    if (elongation_) {
      offer("series_tendon", "tendon", 1.0, "compliance");
      offer("slack", "tendon", 1e-3, "slack");
    }
    offer("lever_scale", "sensor", 1.0, "scale_error");
    offer("lever_offset", "sensor", 4000.0, "count_offset");
    offer("sensor_quantisation", "sensor", 4.0e4);
    offer("sensor_low_pass", "sensor", 1.0);
    offer("sensor_hysteresis", "sensor", 4000.0);
    offer("force_sensor_offset", "sensor", peak_, "force_offset");
    if (guided_) offer("guiding_friction", "tendon", 1.0);
    for (const char* cause : {"latch", "speed_memory", "other_stage", "outer_force"})
      offer(cause, "lever", peak_, "", true);
    for (const char* cause : {"supply_sag", "saturation", "heat", "filling", "tight_under_load"})
      offer(cause, "lever", 1.0, "", true);
    offer("contact", "lever", peak_ / shape_.reach, "", true);
  }

  LeverShape shape_;
  LeverCurve curve_;
  bool guided_ = false, elongation_ = true, resolved_ = false;
  double travel_ = 0.01, first_angle_ = 0.0, last_angle_ = 1.0, peak_ = 80.0;
  double force_noise_ = 0.5, length_noise_ = 2e-5, grip_way_ = 4e-5, loop_way_ = 4e-4;
  std::uint64_t streams_[4] = {};
  std::vector<Offer> offers_;
};

Log LeverPlant::replay(const Course& course, const std::vector<Hidden>& hidden, int) const {
  const auto dose = [&](const char* cause) {
    for (const Hidden& h : hidden)
      if (h.cause == cause) return h.dose;
    return 0.0;
  };
  int law = 0;
  std::vector<Hidden> of_sensor;
  for (const Hidden& h : hidden) {
    if (h.cause == "guiding_friction") law = h.law;
    if (h.cause == "sensor_low_pass" || h.cause == "sensor_hysteresis") of_sensor.push_back(h);
  }
  const LeverCurve curve(shape_, dose("spring_constant"), dose("preload_offset"));
  const double slack = dose("slack"), series = dose("series_tendon"),
               loop = dose("lever_hysteresis"), guiding = dose("guiding_friction"),
               scale = dose("lever_scale"), zero = dose("lever_offset"),
               coarse = dose("sensor_quantisation"), force_zero = dose("force_sensor_offset");
  Log log;
  log.step = course.step;
  log.names = {"count", "force"};
  log.units = {"1", "N"};
  if (elongation_) log.names.push_back("elongation"), log.units.push_back("m");
  if (guided_) log.names.push_back("bend"), log.units.push_back("rad");
  const Index rows = course.q.rows();
  log.columns.resize(rows, static_cast<Index>(log.names.size()));
  Cell cell(hidden, peak_, shape_.reach);
  double lever = course.q(0, 0), before = lever, grip = 0.0, held = 0.0, last = lever;
  for (Index k = 0; k < rows; ++k) {
    const double drawn = course.q(k, 0), bend = course.q(k, 1);
    // Drawn length = slack + lever + stretch of the tendon itself; some rounds settle it.
    double force = 0.0;
    for (int i = 0; i < 5; ++i) {
      force = std::max(0.0, curve.force(lever));
      lever = std::max(0.0, drawn - slack - series * force);
    }
    // Bouc-Wen's loop, as wide as the force; the guide's friction holds where the tendon stops.
    const double way = lever - before, side = way < 0.0 ? -1.0 : 1.0;
    const double part = std::abs(way) / loop_way_;
    grip = std::clamp(
        grip + side * part * (1.0 - (side * grip > 0.0 ? grip * grip : 0.0)) / (1.0 + part), -1.0,
        1.0);
    before = lever;
    const double pulled = drawn - last, toward = pulled < 0.0 ? -1.0 : 1.0;
    last = drawn;
    held = toward + (held - toward) * std::exp(-std::abs(pulled) / grip_way_);
    double seen = force * (1.0 + loop * grip);
    if (guided_ && guiding != 0.0)
      seen = law == 0 ? seen * std::exp(guiding * bend * held)
                      : seen + guiding * peak_ * held * (1.0 - std::exp(-0.7 * bend));
    seen = cell.shown(seen, lever, pulled / course.step, course.step * static_cast<double>(k),
                      course.step) +
           force_zero;
    const double share = (curve.angle(lever) - first_angle_) / (last_angle_ - first_angle_);
    log.columns(k, 0) = 4000.0 * share * (1.0 + scale) + 40.0 + zero;
    log.columns(k, 1) = seen;
    if (elongation_) log.columns(k, 2) = drawn;
    if (guided_) log.columns(k, log.columns.cols() - 1) = bend;
  }
  log.columns.col(0) = sensed_position(log.columns.col(0), of_sensor, log.step);
  if (coarse > 1.0)
    for (double& count : log.columns.col(0)) count = coarse * std::round(count / coarse);
  return log;
}

}  // namespace

std::unique_ptr<TrialPlant> draw_lever(Draw draw) {
  return std::make_unique<LeverPlant>(draw);
}

}  // namespace sinew::trials
