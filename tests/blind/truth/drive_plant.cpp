// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/blind/truth/drive_truth.h"
#include "tests/blind/truth/plant.h"

namespace sinew::truth {
namespace {

constexpr double pi = 3.14159265358979323846;

double rms(const std::vector<double>& x) {
  double sum = 0.0;
  for (const double v : x) sum += v * v;
  return x.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(x.size()));
}

// Terms of the model that are taken out before a cause's size is measured.
enum Terms : unsigned {
  t_inertia = 1,
  t_viscous = 2,
  t_level = 4,
  t_offset = 8,
  t_load = 16,
  t_all = 31
};

struct DriveCause {
  Cause cause;
  void (*set)(DriveHidden&, double);
  unsigned taken_out;
};

bool is_in_mujoco(const std::string& name) {
  for (const char* known : {"coulomb_level", "viscous_level", "inertia", "torque_constant",
                            "offset", "output_ripple", "input_ripple", "gear_elasticity", "delay"})
    if (name == known) return true;
  return false;
}

DriveModel draw_model(Draw& draw) {
  DriveModel m;
  m.linear = draw.chance(0.25);
  m.loaded = draw.chance(0.6);
  if (m.linear) {
    m.inertia = draw.log_uniform(20.0, 150.0);
    m.level = m.inertia * draw.uniform(0.1, 0.25);
    m.viscous = m.inertia * draw.uniform(1.0, 3.0);
    m.amplitude = draw.uniform(0.1, 0.25);
    m.top_speed = m.amplitude * draw.uniform(1.8, 2.6);
    m.shape = draw.uniform(60.0, 150.0) / m.top_speed;
    m.motor_turn = draw.uniform(0.0025, 0.01);
    m.output_turn = 0.0;
  } else {
    m.inertia = 2.05e-3 * draw.log_uniform(0.5, 4.0);
    m.level = 0.5586 * draw.log_uniform(0.15, 1.0);
    m.viscous = 0.0356 * draw.log_uniform(0.6, 2.0);
    m.amplitude = draw.uniform(3.5, 6.5);
    m.top_speed = draw.uniform(3.0, 5.0);
    m.shape = draw.uniform(10.0, 40.0);
    m.motor_turn = 2.0 * pi / (draw.chance(0.7) ? 100.0 : 50.0);
  }
  m.usual_load = m.loaded ? m.level * draw.uniform(0.8, 2.0) : 0.0;
  return m;
}

class DrivePlant : public Plant {
 public:
  DrivePlant(Draw draw, DriveCourse course, bool by_mujoco = false)
      : model_(draw_model(draw)), course_(course), by_mujoco_(by_mujoco) {
    run_.bouc_wen = draw.chance(0.5);
    run_.bristle = draw.uniform(2.0e-6, 5.0e-6) * model_.amplitude;
    run_.motor_share = draw.uniform(0.35, 0.65);
    if (course == DriveCourse::constant_load) {
      model_.loaded = true;
      model_.usual_load = model_.level * draw.uniform(0.8, 2.0);
    }
    if (course == DriveCourse::one_way || course == DriveCourse::one_speed) {
      model_.loaded = false;
      model_.usual_load = 0.0;
    }
    if (model_.loaded) {
      run_.load_mean = model_.usual_load * draw.uniform(0.5, 1.0);
      run_.load_swing =
          course == DriveCourse::constant_load ? 0.0 : model_.usual_load * draw.uniform(0.4, 0.8);
    }
    for (auto& stream : streams_) stream = draw.bits();
    for (auto& phase : phases_) phase = draw.uniform(0.0, 2.0 * pi);
    order_out_ = 1.0 + draw.below(2);
    order_in_ = 1.0 + draw.below(2);
    stribeck_speed_ = model_.top_speed * draw.uniform(0.06, 0.12);
    drift_time_ = draw.uniform(8.0, 25.0);
    bump_at_ = draw.uniform(-0.4, 0.4) * model_.amplitude;
    hum_rate_ = 2.0 * pi * draw.uniform(3.0, 12.0);
    swing_time_ = draw.uniform(2.5, 5.0);
    list_causes();
    allow_negative();
    const Table clean = simulate({}, 0);
    const double usual = rms(clean.columns[2]);
    sigma_ = usual * draw.uniform(0.02, 0.05);
    quantum_ = model_.amplitude * (draw.chance(0.5) ? 2.0e-6 : 5.0e-6);
  }

  std::string kind() const override { return model_.linear ? "linear_drive" : "drive"; }

  std::string nominal() const override {
    return fmt::format(
        "{{\"inertia\": {:.17g}, \"friction_shape\": {:.17g}, \"friction_level\": {:.17g}, "
        "\"viscous\": {:.17g}, \"motor_turn\": {:.17g}, \"output_turn\": {:.17g}, "
        "\"amplitude\": {:.17g}, \"top_speed\": {:.17g}, \"load\": {}}}",
        model_.inertia, model_.shape, model_.level, model_.viscous, model_.motor_turn,
        model_.output_turn, model_.amplitude, model_.top_speed, model_.loaded);
  }

  const std::vector<Cause>& causes() const override { return listed_; }

  Table simulate(const std::vector<Dose>& doses, int log) const override {
    return run(hidden_by(doses, log), run_, command(log));
  }

  DriveHidden hidden_by(const std::vector<Dose>& doses, int log) const {
    DriveHidden hidden;
    const double shift = 2.0 * pi * 0.381966 * log;  // an incremental encoder starts anywhere
    hidden.output_order = order_out_;
    hidden.input_order = order_in_;
    hidden.output_phase = phases_[0] + shift * 1.7;
    hidden.input_phase = phases_[1] + shift;
    hidden.load_ripple_phase = phases_[2] + shift * 2.3;
    hidden.stribeck_speed = stribeck_speed_;
    hidden.drift_time = drift_time_;
    hidden.bump_at = bump_at_;
    hidden.bump_width = 0.12 * model_.amplitude;
    hidden.hum_rate = hum_rate_;
    hidden.stop_at = 0.35 * model_.amplitude;
    hidden.swing_time = swing_time_;
    for (const Dose& dose : doses) chosen_[static_cast<size_t>(dose.cause)].set(hidden, dose.value);
    return hidden;
  }

  Table play(const std::vector<Dose>& doses, const Table& motion) const override {
    DriveRun as_long = run_;
    as_long.seconds = motion.columns[0].back();
    return run(hidden_by(doses, 3), as_long, followed_command(model_, as_long, command(3), motion));
  }

  Table run(const DriveHidden& hidden, const DriveRun& how, const DriveCommand& command) const {
    const DriveSamples s = by_mujoco_ ? run_drive_in_mujoco(model_, hidden, how, command)
                                      : run_drive(model_, hidden, how, command);
    Table table;
    const bool l = model_.linear;
    table.header = {"time [s]", l ? "x [m]" : "theta [rad]", l ? "f [N]" : "tau_m [N·m]",
                    l ? "x_ref [m]" : "theta_ref [rad]"};
    table.columns = {s.time, s.position, s.effort, s.reference};
    if (model_.loaded) {
      table.header.push_back(l ? "load [N]" : "load [N·m]");
      table.columns.push_back(s.load);
    }
    return table;
  }

  std::vector<std::vector<double>> left_over(const Table& log,
                                             const std::vector<Dose>& doses) const override {
    unsigned taken_out = t_all;
    for (const Dose& dose : doses) taken_out &= chosen_[static_cast<size_t>(dose.cause)].taken_out;
    const double period = run_.period;
    // Before friction, which rectifies them: what differences make of a coarse sensor's steps is no
    // cause's size.
    const std::vector<double> position = smoothed(log.columns[1], 3);
    const std::vector<double> effort = smoothed(log.columns[2], 3);
    const std::vector<double> load =
        model_.loaded ? smoothed(log.columns[4], 3) : std::vector<double>();
    const std::vector<double> v = derivative(position, period);
    const std::vector<double> a = derivative(v, period);
    std::vector<double> level(v.size()), rest(v.size());
    for (size_t k = 0; k < v.size(); ++k) {
      level[k] = std::atan(model_.shape * v[k]);
      rest[k] = effort[k] - model_.inertia * a[k] - model_.viscous * v[k] - model_.level * level[k];
      if (model_.loaded) rest[k] -= load[k];
    }
    const auto smooth = [](const std::vector<double>& x) {
      return thinned(smoothed(smoothed(x, 6), 6));
    };
    std::vector<std::vector<double>> columns;
    if (taken_out & t_inertia) columns.push_back(smooth(a));
    if (taken_out & t_viscous) columns.push_back(smooth(v));
    if (taken_out & t_level) columns.push_back(smooth(level));
    std::vector<double> left = smooth(rest);
    if (taken_out & t_offset) columns.emplace_back(left.size(), 1.0);
    if (model_.loaded && (taken_out & t_load)) columns.push_back(smooth(load));
    left = without_columns(left, columns);
    for (double& x : left) x /= sigma_;
    return {left};
  }

  void scale_noise(double factor) override { sigma_ *= factor; }

  void measure(Table& log, int number) const override {
    Draw draw(streams_[static_cast<size_t>(number) % std::size(streams_)] ^ 0x5bd1e995u);
    Noise effort(draw.fork()), load(draw.fork());
    for (double& x : log.columns[1]) x = quantum_ * std::round(x / quantum_);
    for (double& x : log.columns[2]) x += sigma_ * effort.next();
    if (model_.loaded)
      for (double& x : log.columns[4]) x += 0.1 * sigma_ * load.next();
  }

 private:
  // Log 0 and 1 follow the course; a follow-up is varied.
  const DriveCommand& command(int log) const {
    const size_t slot = static_cast<size_t>(log) % std::size(streams_);
    DriveCommand& kept = commands_[slot];
    if (!kept.reference.empty()) return kept;
    DriveRun run = run_;
    if (course_ == DriveCourse::one_speed && log < 2) run.course = Course::one_speed;
    if (course_ == DriveCourse::one_way && log < 2) run.course = Course::one_way;
    if (course_ == DriveCourse::constant_load && log >= 2) run.load_swing = 0.7 * model_.usual_load;
    kept = draw_command(model_, run, Draw(streams_[slot]));
    return kept;
  }

  static std::vector<double> thinned(const std::vector<double>& x) {
    std::vector<double> y;
    for (size_t k = 14; k + 14 < x.size(); k += 3) y.push_back(x[k]);
    return y;
  }

  void add(const char* name, const char* place, const char* unit, double guess, double most,
           void (*set)(DriveHidden&, double), unsigned taken_out = t_all, bool outside = false) {
    chosen_.push_back({{name, place, unit, guess, most, 0.0, outside, false}, set, taken_out});
    listed_.push_back(chosen_.back().cause);
  }

  void list_causes();
  void allow_negative();

  DriveModel model_;
  DriveCourse course_;
  bool by_mujoco_ = false;
  DriveRun run_;
  std::uint64_t streams_[4] = {};
  mutable DriveCommand commands_[4];
  double phases_[3] = {};
  double order_out_ = 1.0, order_in_ = 1.0, stribeck_speed_ = 0.1, drift_time_ = 10.0;
  double bump_at_ = 0.0, hum_rate_ = 30.0, swing_time_ = 3.0;
  double sigma_ = 1.0, quantum_ = 1.0e-6;
  std::vector<DriveCause> chosen_;
  std::vector<Cause> listed_;
};

void DrivePlant::list_causes() {
  const DriveModel& m = model_;
  const double f = m.level * 1.5;  // about the plateau
  const char* force = m.linear ? "N" : "N*m";
  using H = DriveHidden;
  add(
      "coulomb_level", "motor", "1", 0.1, 3.0, [](H& h, double v) { h.friction_scale = v; },
      t_all & ~t_level);
  add(
      "viscous_level", "motor", "", 0.3 * m.viscous, 10.0 * m.viscous,
      [](H& h, double v) { h.viscous_more = v; }, t_all & ~t_viscous);
  add("direction_asymmetry", "motor", "1", 0.1, 0.6, [](H& h, double v) { h.level_asymmetry = v; });
  add("direction_asymmetry", "motor", "", 0.3 * m.viscous, 0.9 * m.viscous,
      [](H& h, double v) { h.viscous_asymmetry = v; });
  add("stribeck", "motor", force, 0.2 * f, 3.0 * f, [](H& h, double v) { h.stribeck = v; });
  add("concave_friction", "motor", force, 0.2 * f, 5.0 * f, [](H& h, double v) { h.concave = v; });
  if (!m.linear)
    add("output_ripple", "motor", force, 0.1 * f, 3.0 * f,
        [](H& h, double v) { h.output_ripple = v; });
  add("input_ripple", "motor", force, 0.1 * f, 3.0 * f, [](H& h, double v) { h.input_ripple = v; });
  add(
      "inertia", "motor", m.linear ? "kg" : "kg*m^2", 0.1 * m.inertia, 20.0 * m.inertia,
      [](H& h, double v) { h.inertia_more = v; }, t_all & ~t_inertia);
  add(
      "torque_constant", "motor", "1", 0.05, 0.8, [](H& h, double v) { h.torque_gain = v; },
      t_offset);
  add(
      "offset", "motor", force, 0.1 * f, 3.0 * f, [](H& h, double v) { h.offset = v; },
      t_all & ~t_offset);
  add("friction_drift", "motor", "1", 0.2, 3.0, [](H& h, double v) { h.drift = v; });
  // No softer than 3 Hz: below, it is a load on a rubber band.
  add("gear_elasticity", "motor", "", 1.0e-3 / m.inertia, 5.0e-3 / m.inertia,
      [](H& h, double v) { h.compliance = v; });
  add("backlash", "motor", m.linear ? "m" : "rad", 2.0e-3 * m.amplitude, 0.1 * m.amplitude,
      [](H& h, double v) { h.backlash = v; });
  add("delay", "motor", "s", 2.0e-3, 0.03, [](H& h, double v) { h.delay = v; });
  add(
      "sensor_scale", "sensor", "1", 0.05, 0.5, [](H& h, double v) { h.sensor_scale = v; },
      t_offset);
  add("sensor_quantisation", "sensor", m.linear ? "m" : "rad", 2.0e-4 * m.amplitude,
      0.02 * m.amplitude, [](H& h, double v) { h.sensor_quantum = v; });
  add("sensor_low_pass", "sensor", "s", 2.0e-3, 0.03, [](H& h, double v) { h.sensor_lag = v; });
  add("sensor_hysteresis", "sensor", m.linear ? "m" : "rad", 1.0e-3 * m.amplitude,
      0.05 * m.amplitude, [](H& h, double v) { h.sensor_play = v; });
  if (m.loaded) {
    add("load_friction", "motor", "1", 0.1, 1.0, [](H& h, double v) { h.load_friction = v; });
    add("load_ripple", "motor", "1", 0.1, 1.0, [](H& h, double v) { h.load_ripple = v; });
  }
  add(
      "tight_spot", "motor", force, 0.2 * f, 5.0 * f, [](H& h, double v) { h.bump = v; }, t_all,
      true);
  add(
      "hum", "motor", force, 0.1 * f, 5.0 * f, [](H& h, double v) { h.hum = v; }, t_all, true);
  add(
      "soft_stop", "motor", "", f / m.amplitude, 20.0 * f / m.amplitude,
      [](H& h, double v) { h.stop_stiffness = v; }, t_all, true);
  add(
      "friction_memory", "motor", "1", 0.3, 5.0, [](H& h, double v) { h.memory = v; }, t_all, true);
  add(
      "friction_swing", "motor", "1", 0.2, 0.9, [](H& h, double v) { h.swing = v; }, t_all, true);
}

void DrivePlant::allow_negative() {
  for (DriveCause& c : chosen_) {
    const std::string& name = c.cause.name;
    if (name == "coulomb_level" || name == "torque_constant" || name == "sensor_scale")
      c.cause.least = -0.45;
    if (name == "direction_asymmetry" || name == "offset") c.cause.least = -c.cause.most;
    if (name == "viscous_level") c.cause.least = -0.7 * model_.viscous;
    if (name == "inertia") c.cause.least = -0.5 * model_.inertia;
    if (name == "friction_drift") c.cause.least = -0.6;
  }
  if (by_mujoco_)
    std::erase_if(chosen_, [](const DriveCause& c) { return !is_in_mujoco(c.cause.name); });
  listed_.clear();
  for (const DriveCause& c : chosen_) listed_.push_back(c.cause);
}

}  // namespace

std::unique_ptr<Plant> draw_drive(Draw draw, DriveCourse course) {
  return std::make_unique<DrivePlant>(draw, course);
}

std::unique_ptr<Plant> draw_mujoco_drive(Draw draw) {
  if (!mujoco_is_there()) return nullptr;
  return std::make_unique<DrivePlant>(draw, DriveCourse::any, true);
}

}  // namespace sinew::truth
