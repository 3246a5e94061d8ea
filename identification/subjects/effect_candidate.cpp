// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/effect_candidate.h"

#include <algorithm>
#include <array>
#include <stdexcept>

extern "C" const sinew_catalogue effects_catalogue;

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t signals = 11;

const sinew_function& emitted(const std::string& id) {
  const std::string name = "effects_" + id;
  for (int i = 0; i < effects_catalogue.function_count; ++i)
    if (name == effects_catalogue.functions[i].name) return effects_catalogue.functions[i];
  throw std::logic_error(name + " is not emitted; sinew generate models/effects");
}

/// Where each signal's samples are, as signal_list() orders them; nullptr: one value for all.
struct SignalSamples {
  std::array<const double*, signals> samples{};
  std::array<double, signals> value{};
  double start = 0.0;  ///< of the log

  SignalSamples(const Recording& log, int axis) {
    const auto column = [&](const MatrixXd& x) { return x.data() + axis * x.rows(); };
    samples[0] = column(log.q);
    samples[1] = column(log.qd);
    samples[2] = column(log.acceleration());
    samples[3] = column(log.signals.at("jounce"));
    if (const MatrixXd* carried = log.signals.find("carried"))
      samples[4] = column(*carried);
    else if (log.load.size() > 0)
      samples[4] = column(log.load);
    samples[5] = log.time.data();
    samples[6] = column(log.signals.at("direction"));
    value[7] = log.step;
    start = log.started();
    constexpr const char* of_links[] = {"parting", "carried_inertia", "carried_jounce"};
    for (std::size_t k = 0; k < std::size(of_links); ++k)
      if (const MatrixXd* found = log.signals.find(of_links[k])) samples[8 + k] = column(*found);
  }
  void read(Index row, double* in) const {
    for (std::size_t s = 0; s < samples.size(); ++s)
      in[s] = samples[s] ? samples[s][row] : value[s];
    in[5] -= start;
  }
};

double unit_of(Scale scale, const LogScale& log) {
  switch (scale) {
    case Scale::none:
    case Scale::turning:
      return 1.0;
    case Scale::reach:
      return log.high - log.low;
    case Scale::speed:
      return log.speed;
    case Scale::duration:
      return log.duration;
    case Scale::mobility:
      return log.mobility;
  }
  return 1.0;
}

LinearParameter linear_parameter(const EffectColumn& column, bool revolute) {
  LinearParameter p;
  p.name = column.name;
  p.unit = unit_at(column.unit, revolute);
  p.low = limits_of(column).low;
  p.high = limits_of(column).high;
  p.per_log = column.per_log;
  p.share = column.share;
  return p;
}

/// Bounds and starting points beside a log of that scale.
NonlinearParameter nonlinear_parameter(const ShapeParameter& p, const LogScale& scale,
                                       bool revolute) {
  const std::string unit = unit_at(p.unit, revolute);
  if (p.scale == Scale::turning && scale.turns_on_bristles)
    return {p.name, unit, p.high, p.high, 1, true};
  const double one = unit_of(p.scale, scale);
  return {p.name, unit, p.low * one, p.high * one, p.grid, p.low > 0.0};
}

}  // namespace

LogScale scale_of(const std::vector<Recording>& logs, int axis) {
  LogScale s{1e300, -1e300, 0.0, 0.0, 0.0, 0.0};
  double agitation = 0.0, driven = 0.0;
  for (const Recording& log : logs) {
    s.low = std::min(s.low, log.q.col(axis).minCoeff());
    s.high = std::max(s.high, log.q.col(axis).maxCoeff());
    s.speed = std::max(s.speed, log.qd.col(axis).cwiseAbs().maxCoeff());
    s.duration = std::max(s.duration, log.time(log.time.size() - 1) + log.step - log.started());
    if (log.load.size() > 0) s.load = std::max(s.load, log.load.col(axis).cwiseAbs().maxCoeff());
    if (static_cast<std::size_t>(axis) >= log.target.size()) continue;
    const VectorXd acceleration = log.qdd.col(axis).array() - log.qdd.col(axis).mean();
    agitation += acceleration.squaredNorm();
    driven += acceleration.dot(log.target[static_cast<std::size_t>(axis)]);
  }
  s.mobility = driven > 0.0 ? agitation / driven : 1.0;
  return s;
}

Regressor::Regressor(const Effect& effect)
    : function(&emitted(effect.id)),
      columns(static_cast<Index>(effect.columns.size())),
      states(static_cast<Index>(effect.states.size())) {}

MatrixXd effect_columns(const Regressor& regressor, const Recording& log, int axis,
                        const VectorXd& shape) {
  const sinew_function& function = *regressor.function;
  const Index count = regressor.columns;
  const SignalSamples x(log, axis);
  std::vector<double> in(static_cast<std::size_t>(function.input_size));
  std::vector<double> out(static_cast<std::size_t>(function.output_size));
  std::copy(shape.begin(), shape.end(), in.begin() + static_cast<std::ptrdiff_t>(signals));
  const Index states = regressor.states;
  double* const state = in.data() + in.size() - states;
  MatrixXd columns(log.q.rows(), count);
  for (Index k = 0; k < columns.rows(); ++k) {
    x.read(k, in.data());
    function.call(in.data(), out.data());
    for (Index c = 0; c < count; ++c) columns(k, c) = out[static_cast<std::size_t>(c)];
    std::copy_n(out.data() + out.size() - states, states, state);
  }
  return columns;
}

Candidate effect_candidate(const Effect& effect, const EffectPlace& place, const LogScale& scale,
                           const std::optional<VectorXd>& fixed) {
  Candidate c;
  c.name = effect.name;
  c.place = place.name;
  c.channels = {place.axis};
  c.limit_meaning = effect.limit;
  c.isolating_experiment = effect.experiment;
  c.unlikely = effect.unlikely;
  for (const EffectColumn& column : effect.columns)
    c.linear.push_back(linear_parameter(column, place.revolute));
  if (!fixed)
    for (const ShapeParameter& p : effect.shapes)
      c.nonlinear.push_back(nonlinear_parameter(p, scale, place.revolute));
  if (std::any_of(effect.shapes.begin(), effect.shapes.end(),
                  [](const auto& s) { return s.inside || s.above; }))
    c.possible = [shapes = effect.shapes, ranges = c.nonlinear](const VectorXd&,
                                                                const VectorXd& nonlinear) {
      for (std::size_t p = 0; p < ranges.size(); ++p)
        if ((shapes[p].inside && nonlinear(static_cast<Index>(p)) > 0.98 * ranges[p].high) ||
            (shapes[p].above && nonlinear(static_cast<Index>(p)) < 1.02 * ranges[p].low))
          return false;
      return true;
    };
  c.columns = [regressor = Regressor(effect), axis = place.axis, fixed](
                  const Recording& log, int channel, const VectorXd& nonlinear) -> MatrixXd {
    if (channel != axis) return {};
    return effect_columns(regressor, log, axis, fixed ? *fixed : nonlinear);
  };
  return c;
}

}  // namespace sinew::diagnosis
