// SPDX-License-Identifier: GPL-3.0-or-later
// Drives, lone joints and arms: efforts and positions of one axis or of several.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/blind/truth/compared.h"
#include "tests/blind/truth/driven_setup.h"
#include "tests/blind/truth/signal_path.h"

namespace sinew::trials {
namespace {

using truth::Draw;

class DrivenPlant : public TrialPlant {
 public:
  DrivenPlant(DrivenSetup setup, Draw draw) : setup_(std::move(setup)) {
    for (auto& s : streams_) s = draw.bits();
    rate_ = 2.0 * pi * draw.uniform(0.15, 0.6);
    learn_scales(setup_.jointed, course({}, 0));
    const Log clean = replay(course({}, 0), {}, 0);
    for (std::size_t j = 0; j < axes(); ++j) {
      const VectorXd effort = clean.columns.col(effort_column(j));
      noise_.push_back(draw.uniform(0.008, 0.03) * rms(effort));
      peak_.push_back(effort.cwiseAbs().maxCoeff() * 1.05);
    }
    list_offers();
  }

  const std::vector<Offer>& offers() const override { return offers_; }
  void write_model(const std::filesystem::path& folder) const override;

  Course course(const std::vector<Hidden>& hidden, int log) const override {
    const Draw draw(streams_[log]);
    const Rhythm& r = setup_.rhythm;
    const VectorXd load = known_load(log);
    if (setup_.mechanics == Mechanics::mujoco)
      return in_mujoco(setup_.jointed, hidden, r, load, draw);
    if (axes() == 1)
      return in_closed_loop(setup_.jointed, hidden, commanded(setup_.jointed, r, draw), load, draw);
    return commanded(setup_.jointed, r, draw);
  }

  Course played(const std::vector<Hidden>& hidden, const MatrixXd& reference,
                const VectorXd& load) const override {
    if (axes() != 1 || setup_.mechanics != Mechanics::own)
      return TrialPlant::played(hidden, {}, {});
    const Index inner = setup_.rhythm.inner;
    VectorXd held(load.size() * inner);
    for (Index i = 0; i < held.size(); ++i) held(i) = load(i / inner);
    if (setup_.loaded && held.size() == 0)
      held = VectorXd::Constant(reference.rows() * inner, setup_.load_mean);
    return in_closed_loop(setup_.jointed, hidden, given(reference, setup_.rhythm), held,
                          Draw(streams_[2]));
  }

  Log replay(const Course& course, const std::vector<Hidden>& all, int log) const override {
    // An incremental encoder gives each log its own phase of a ripple.
    std::vector<Hidden> hidden = all;
    for (Hidden& h : hidden)
      if (h.cause.find("ripple") != std::string::npos) h.phase += 2.4 * log;
    const MatrixXd needed =
        course.command.size() > 0 ? course.command : needed_efforts(setup_.jointed, course, hidden);
    Log result;
    result.step = course.period();
    const Index rows = course.rows(), n = needed.cols();
    const bool load = course.load.size() > 0;
    result.columns.resize(rows, 2 * n + (load ? 1 : 0));
    for (Index j = 0; j < n; ++j) {
      const auto i = static_cast<std::size_t>(j);
      const auto here = only_at(hidden, static_cast<int>(j));
      VectorXd q(rows);
      for (Index k = 0; k < rows; ++k) q(k) = course.q(k * course.inner, j);
      result.columns.col(j) = sensed_position(q, here, result.step);
      const double peak = peak_.empty() ? 1.0 : peak_[i];
      result.columns.col(n + j) = logged_effort(needed.col(j), here, result.step, peak);
      name(result, i);
    }
    if (load) {
      for (Index k = 0; k < rows; ++k) result.columns(k, 2 * n) = course.load(k * course.inner);
      result.names.push_back("load");
      result.units.push_back(setup_.kind == DrivenKind::slide ? "N" : "N*m");
    }
    order_names(result);
    return result;
  }

  void measure(Log& log, int number) const override {
    Draw draw(streams_[number] ^ 0x5bd1e995u);
    for (std::size_t j = 0; j < axes(); ++j) {
      for (double& q : log.columns.col(static_cast<Index>(j)))
        q = setup_.encoder[j] * std::round(q / setup_.encoder[j]);
      truth::Noise noise(draw.fork());
      for (double& tau : log.columns.col(effort_column(j))) tau += noise_[j] * noise.next();
    }
  }

  std::vector<VectorXd> left_over(const Log& log) const override {
    const auto n = static_cast<Index>(axes());
    const Index rows = log.columns.rows();
    const MatrixXd motion = smooth(log);
    std::vector<VectorXd> left(axes(), VectorXd(rows));
    const Index load = log.columns.cols() > 2 * n ? 2 * n : -1;
    for (Index k = 0; k < rows; ++k) {
      const VectorXd q = motion.row(k).head(n), v = motion.row(k).segment(n, n),
                     a = motion.row(k).tail(n);
      const VectorXd rigid = setup_.jointed.chain.torque(q, v, a);
      for (Index j = 0; j < n; ++j) {
        const AxisModel& m = setup_.jointed.axes[static_cast<std::size_t>(j)];
        const double side = m.turning > 0.0 ? 2.0 / pi * std::atan(v(j) / m.turning)
                                            : std::tanh(v(j) / (0.01 * m.top_speed));
        left[static_cast<std::size_t>(j)](k) =
            log.columns(k, n + j) - rigid(j) -
            setup_.jointed.chain.links[static_cast<std::size_t>(j)].armature * a(j) -
            m.level * side - m.viscous * v(j) - (load >= 0 ? log.columns(k, load) : 0.0);
      }
    }
    return left;
  }

  std::vector<MatrixXd> fitted(const Log& log, unsigned which) const override {
    const MatrixXd motion = smooth(log);
    const auto n = static_cast<Index>(axes());
    std::vector<MatrixXd> columns;
    for (Index j = 0; j < n; ++j)
      columns.push_back(fitted_at(setup_.jointed.axes[static_cast<std::size_t>(j)],
                                  motion.col(n + j), motion.col(2 * n + j), log.step, which));
    return columns;
  }

  std::vector<VectorXd> moving(const Log& log) const override {
    std::vector<VectorXd> all;
    for (std::size_t j = 0; j < axes(); ++j)
      all.push_back(in_motion(log.columns.col(static_cast<Index>(j)), log.step));
    return all;
  }

  std::vector<double> bands(const Log& perfect, const Log& measured) const override {
    std::vector<double> all;
    for (std::size_t j = 0; j < axes(); ++j) {
      const auto c = static_cast<Index>(j);
      all.push_back(band_of(perfect.columns.col(c), measured.columns.col(c), perfect.step,
                            documented_band(perfect.step)));
    }
    // A position of an arm that is noise cuts the efforts of all joints.
    const double lowest = *std::min_element(all.begin(), all.end());
    if (axes() > 1) std::fill(all.begin(), all.end(), lowest);
    return all;
  }

  std::map<std::string, std::string> traits() const override {
    static constexpr const char* kinds[] = {"motor", "slide", "joint", "arm"};
    return {{"pre-sliding", setup_.resolved ? "resolved" : "below a step"},
            {"mechanics", setup_.mechanics == Mechanics::mujoco ? "MuJoCo" : "own"},
            {"kind", kinds[static_cast<int>(setup_.kind)]},
            {"joints", std::to_string(axes())}};
  }

  std::vector<DriveTruth> drives() const override {
    std::vector<DriveTruth> all;
    if (!setup_.drawing) return all;
    for (std::size_t j = 0; j < axes(); ++j) {
      const Link& link = setup_.jointed.chain.links[j];
      const AxisModel& m = setup_.jointed.axes[j];
      all.push_back({link.joint, link.armature, m.level, m.viscous});
    }
    return all;
  }

 private:
  std::size_t axes() const { return setup_.jointed.axes.size(); }
  Index effort_column(std::size_t j) const { return static_cast<Index>(axes() + j); }

  MatrixXd smooth(const Log& log) const {
    const auto n = static_cast<Index>(axes());
    MatrixXd motion(log.columns.rows(), 3 * n);
    for (Index j = 0; j < n; ++j) {
      const Smoothed s = smoothed(log.columns.col(j), log.step, documented_band(log.step));
      motion.col(j) = s.q;
      motion.col(n + j) = s.v;
      motion.col(2 * n + j) = s.a;
    }
    return motion;
  }

  VectorXd known_load(int log) const {
    if (!setup_.loaded) return {};
    const double step = setup_.rhythm.period / setup_.rhythm.inner;
    VectorXd load(std::lround(setup_.rhythm.seconds / setup_.rhythm.period) * setup_.rhythm.inner);
    for (Index k = 0; k < load.size(); ++k)
      load(k) = setup_.load_mean +
                setup_.load_swing * std::sin(rate_ * step * static_cast<double>(k) + log);
    return load;
  }

  void name(Log& log, std::size_t j) const {
    const Link& link = setup_.jointed.chain.links[j];
    const bool motor = setup_.kind == DrivenKind::motor, slide = setup_.kind == DrivenKind::slide;
    log.names.push_back(motor ? "theta" : slide ? "x" : "q_" + link.joint);
    log.units.push_back(link.slides ? "m" : "rad");
  }
  void order_names(Log& log) const {
    std::vector<std::string> names(log.names.begin(),
                                   log.names.begin() + static_cast<long>(axes()));
    std::vector<std::string> units(log.units.begin(),
                                   log.units.begin() + static_cast<long>(axes()));
    for (std::size_t j = 0; j < axes(); ++j) {
      const Link& link = setup_.jointed.chain.links[j];
      names.push_back(setup_.kind == DrivenKind::motor   ? "tau_m"
                      : setup_.kind == DrivenKind::slide ? "f"
                                                         : "tau_" + link.joint);
      units.push_back(link.slides ? "N" : "N*m");
    }
    names.insert(names.end(), log.names.begin() + static_cast<long>(axes()), log.names.end());
    units.insert(units.end(), log.units.begin() + static_cast<long>(axes()), log.units.end());
    log.names = names;
    log.units = units;
  }

  void list_offers() {
    const Jointed& jointed = setup_.jointed;
    for (std::size_t j = 0; j < axes(); ++j) {
      const std::string place =
          setup_.kind == DrivenKind::motor ? "motor" : "joint " + jointed.chain.links[j].joint;
      offer_axis(jointed, j, place, true, setup_.loaded || jointed.carries, offers_);
    }
    if (jointed.carries) offer_links(jointed, true, offers_);
    if (setup_.weighs) offer_gravity(jointed, offers_);
    if (jointed.carries && axes() > 1)
      for (std::size_t j = 0; j < axes(); ++j)
        offers_.push_back({"sensor_offset", "joint " + jointed.chain.links[j].joint,
                           static_cast<int>(j), 1.0, false, fits_all, "zero_offset", 1.0, 0});
    // Its mechanics are MuJoCo's: nothing is put between motor and load there.
    if (setup_.mechanics == Mechanics::mujoco)
      std::erase_if(offers_, [](const Offer& o) {
        return o.cause == "gear_elasticity" || o.cause == "backlash";
      });
  }

  DrivenSetup setup_;
  std::uint64_t streams_[4] = {};
  double rate_ = 1.0;
  std::vector<double> noise_, peak_;
  std::vector<Offer> offers_;
};

void DrivenPlant::write_model(const std::filesystem::path& folder) const {
  if (setup_.kind != DrivenKind::motor)
    return write_mechanism(setup_.drawing.value_or(setup_.jointed.chain), folder / "model");
  const AxisModel& m = setup_.jointed.axes.front();
  const double gear = m.motor_turn / (2.0 * pi);
  const double inertia = setup_.jointed.chain.links.front().inertia(2, 2);
  const auto value = [](double x, const char* unit) {
    return fmt::format("{{ value = {:.12g}, unit = \"{}\", from = \"assumed\" }}\n", x, unit);
  };
  std::string text = "[part]\nname = \"motor\"\n\n[motor]\n";
  text += "gear_ratio = " + value(gear, "1");
  text += "rotor_inertia = " + value(0.8 * inertia * gear * gear, "kg*m^2");
  text += "gearbox_inertia = " + value(0.2 * inertia, "kg*m^2");
  text += "torque_constant = " + value(0.0085, "N*m/A");
  text += "pulley_radius = " + value(0.005, "m");
  text += "gamma1 = " + value(1.0 / m.turning, "s/rad");
  text += "gamma2 = " + value(2.0 / pi * m.level, "N*m");
  text += "gamma3 = " + value(m.viscous, "N*m*s/rad");
  text += "friction_compensation = " + value(0.9, "1");
  text += "ripple_compensation = " + value(0.9, "1");
  write_file(folder / "model" / "part.toml", text);
}

}  // namespace

std::unique_ptr<TrialPlant> driven_plant(DrivenSetup setup, Draw draw) {
  return std::make_unique<DrivenPlant>(std::move(setup), draw);
}

}  // namespace sinew::trials
