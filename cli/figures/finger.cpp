// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "cli/figures/source_figures.h"

namespace sinew {
namespace {

using Eigen::VectorXd;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr double tendon_stiffness = 1.0e4;  // N/m
constexpr double damping_ratio = 1e-3;
constexpr double integration_step = 2e-5, released_for = 0.3;  // s
constexpr int joint_count = 4, sampled_every = 25;

std::vector<double> numbers(const VectorXd& v) {
  return {v.data(), v.data() + v.size()};
}

VectorXd vector(const std::vector<double>& values) {
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

template <class... Vectors>
std::vector<double> joined(const Vectors&... parts) {
  std::vector<double> all;
  (all.insert(all.end(), parts.data(), parts.data() + parts.size()), ...);
  return all;
}

enum class Terms { all, no_coriolis, no_coriolis_no_gravity };

/// The finger on its tendons, the motors fixed at q = 0.
class Finger {
 public:
  explicit Finger(const CompiledModel& model) : model_(model) {
    const VectorXd rest = VectorXd::Zero(joint_count), f = VectorXd::Zero(8),
                   kt = VectorXd::Constant(8, tendon_stiffness);
    const auto K = model("joint_stiffness", joined(rest, f, kt)),
               M = model("mass_matrix", numbers(rest));
    stiffness_ = Eigen::Map<const Matrix>(K.data(), joint_count, joint_count);
    const Matrix mass = Eigen::Map<const Matrix>(M.data(), joint_count, joint_count);
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(stiffness_, mass);
    const Eigen::MatrixXd shape = mass * modes.eigenvectors();
    const VectorXd rates = 2 * damping_ratio * modes.eigenvalues().cwiseSqrt();
    damping_ = shape * rates.asDiagonal() * shape.transpose();
  }

  VectorXd acceleration(const VectorXd& q, const VectorXd& qd, Terms terms) const {
    VectorXd tau = -stiffness_ * q - damping_ * qd;
    // Without a velocity the bias is gravity alone; adding it to the torque leaves it out.
    const VectorXd rate = terms == Terms::all ? qd : VectorXd(VectorXd::Zero(joint_count));
    if (terms == Terms::no_coriolis_no_gravity) tau += vector(model_("gravity", numbers(q)));
    return vector(model_("forward_dynamics", joined(q, rate, tau)));
  }

 private:
  const CompiledModel& model_;
  Matrix stiffness_, damping_;
};

/// Positions at every sampled time, by the classical Runge-Kutta method.
std::vector<VectorXd> released(const Finger& finger, Terms terms) {
  VectorXd q = VectorXd::Zero(joint_count), qd = VectorXd::Zero(joint_count);
  q[1] = 0.1;
  std::vector<VectorXd> track;
  const double h = integration_step;
  for (int step = 0; step * h <= released_for; ++step) {
    if (step % sampled_every == 0) track.push_back(q);
    const VectorXd a1 = finger.acceleration(q, qd, terms), v2 = qd + h / 2 * a1;
    const VectorXd a2 = finger.acceleration(q + h / 2 * qd, v2, terms), v3 = qd + h / 2 * a2;
    const VectorXd a3 = finger.acceleration(q + h / 2 * v2, v3, terms), v4 = qd + h * a3;
    const VectorXd a4 = finger.acceleration(q + h * v3, v4, terms);
    q += h / 6 * (qd + 2 * v2 + 2 * v3 + v4);
    qd += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  return track;
}

Panel difference_panel(const std::string& title, const std::vector<VectorXd>& full,
                       const std::vector<VectorXd>& reduced, double& largest) {
  const char* names[joint_count] = {"base abduction", "base flexion", "PIP", "DIP"};
  Panel panel{title, "time [s]", "difference [rad]", {}};
  for (int j = 0; j < joint_count; ++j) {
    Series series{names[j], {}, {}};
    for (std::size_t i = 0; i < full.size(); ++i) {
      series.x.push_back(static_cast<double>(i) * sampled_every * integration_step);
      series.y.push_back(full[i][j] - reduced[i][j]);
      largest = std::max(largest, std::abs(series.y.back()));
    }
    panel.series.push_back(series);
  }
  return panel;
}

}  // namespace

Figure figure_coriolis(const CompiledModel& index) {
  const Finger finger(index);
  const auto full = released(finger, Terms::all),
             no_coriolis = released(finger, Terms::no_coriolis),
             neither = released(finger, Terms::no_coriolis_no_gravity);
  double base = 0, coriolis = 0, both = 0;
  for (const VectorXd& q : full) base = std::max(base, std::abs(q[0]));
  Figure figure{"figure_5_07", "5.7", "Index finger released from 0.1 rad of flexion", "", {}};
  figure.panels = {difference_panel("Coriolis terms left out", full, no_coriolis, coriolis),
                   difference_panel("Coriolis and gravity left out", full, neither, both)};
  figure.differs = fmt::format(
      "Tendon stiffnesses are not printed: {} N/m each. The lateral offsets of Table 5.1 move the "
      "base joint, by {:.2g} mrad here, where the source says that it rests. Leaving out Coriolis "
      "terms makes up to {:.3g} rad, leaving out gravity too {:.3g} rad. The ratio of Coriolis to "
      "inertial terms does not depend on the masses' scale, so small masses justify nothing.",
      tendon_stiffness, base * 1e3, coriolis, both);
  const std::vector<double> weight = index("gravity", std::vector<double>(joint_count, 0.0));
  figure.numbers = {
      {"the base joint", "rests at 0 rad", fmt::format("moves by {:.2g} mrad", base * 1e3)},
      {"difference without Coriolis terms",
       "small against the sensors' accuracy; no number is printed",
       fmt::format("up to {:.3g} rad", coriolis)},
      {"torque of the finger's weight", "about 0.002 N m",
       fmt::format("{:.2g} N m at the base, stretched out", std::abs(weight[1]))}};
  return figure;
}

}  // namespace sinew
