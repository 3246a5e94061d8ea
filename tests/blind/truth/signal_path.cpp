// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blind/truth/signal_path.h"

#include <algorithm>
#include <cmath>

#include "tests/blind/truth/random_draw.h"

namespace sinew::trials {
namespace {

VectorXd later(const VectorXd& x, double samples) {
  VectorXd y(x.size());
  for (Index k = 0; k < x.size(); ++k) {
    const double at =
        std::clamp(static_cast<double>(k) + samples, 0.0, static_cast<double>(x.size()) - 1.0);
    const auto i = std::min(static_cast<Index>(at), x.size() - 2);
    y(k) = x(i) + (at - static_cast<double>(i)) * (x(i + 1) - x(i));
  }
  return y;
}

double step_of(double x, double quantum) {
  return quantum * std::round(x / quantum);
}

/// What weakens the motor by what it has given: the supply at once, the winding in time.
VectorXd weakened(const VectorXd& needed, const Hidden& h, double step, double peak) {
  VectorXd logged = needed;
  double loaded = 0.0;
  const double rate = h.cause == "heat" ? step / 8.0 : step / 0.03;
  for (Index k = 0; k < needed.size(); ++k) {
    const double u = needed(k) / peak;
    loaded += rate * ((h.cause == "heat" ? 4.0 : 1.0) * u * u - loaded);
    logged(k) = needed(k) / (1.0 - std::min(0.9, h.dose * std::min(loaded, 1.0)));
  }
  return logged;
}

/// An amplifier that gives less once it has given much for a while, until it has rested.
VectorXd folded_back(const VectorXd& needed, double dose, double step, double peak) {
  VectorXd logged = needed;
  double loaded = 0.0;
  bool folded = false;
  for (Index k = 0; k < needed.size(); ++k) {
    const double u = needed(k) / peak;
    loaded += step / 0.15 * (u * u - loaded);
    folded = loaded > (folded ? 0.08 : 0.2);
    if (folded) logged(k) = needed(k) / (1.0 - dose);
  }
  return logged;
}

}  // namespace

bool acts_on_amplifier(const std::string& cause) {
  return cause == "torque_constant" || cause == "delay" || cause == "supply_sag" ||
         cause == "heat" || cause == "saturation" || cause == "coarse_command" ||
         cause == "foldback";
}

VectorXd logged_effort(const VectorXd& needed, const std::vector<Hidden>& hidden, double step,
                       double peak) {
  VectorXd logged = needed;
  for (const Hidden& h : hidden) {
    if (h.dose == 0.0) continue;
    if (h.cause == "torque_constant") logged /= 1.0 + h.dose;
    if (h.cause == "supply_sag" || h.cause == "heat") logged = weakened(logged, h, step, peak);
    if (h.cause == "foldback") logged = folded_back(logged, h.dose, step, peak);
    if (h.cause == "saturation")
      for (double& u : logged)
        u = peak / h.dose * std::atanh(std::clamp(u * h.dose / peak, -0.995, 0.995));
    if (h.cause == "coarse_command") {
      // What acts has the converter's steps, smeared by a dither of a third of one.
      truth::Draw draw(h.seed);
      for (double& u : logged)
        u -= step_of(u + 0.33 * h.dose * draw.uniform(-1.0, 1.0), h.dose) - u;
    }
    if (h.cause == "delay") logged = later(logged, h.dose / step);
  }
  return logged;
}

bool acts_on_sensor(const std::string& cause) {
  return cause == "sensor_scale" || cause == "sensor_offset" || cause == "sensor_low_pass" ||
         cause == "sensor_quantisation" || cause == "sensor_hysteresis";
}

VectorXd sensed_position(const VectorXd& q, const std::vector<Hidden>& hidden, double step) {
  VectorXd seen = q;
  for (const Hidden& h : hidden) {
    if (h.dose == 0.0) continue;
    if (h.cause == "sensor_scale") seen *= 1.0 + h.dose;
    if (h.cause == "sensor_offset") seen.array() += h.dose;
    if (h.cause == "sensor_low_pass")
      for (Index k = 1; k < seen.size(); ++k)
        seen(k) += (seen(k - 1) - seen(k)) * std::exp(-step / h.dose);
    if (h.cause == "sensor_hysteresis")
      for (Index k = 1; k < seen.size(); ++k)
        seen(k) = std::clamp(seen(k - 1), seen(k) - 0.5 * h.dose, seen(k) + 0.5 * h.dose);
    if (h.cause == "sensor_quantisation")
      for (double& x : seen) x = step_of(x, h.dose);
  }
  return seen;
}

std::vector<Hidden> only_at(const std::vector<Hidden>& hidden, int at) {
  std::vector<Hidden> some;
  for (const Hidden& h : hidden)
    if (h.at == at) some.push_back(h);
  return some;
}

}  // namespace sinew::trials
