// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/unexplained.h"

#include <algorithm>
#include <cmath>

namespace sinew {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

enum class Variable { position, velocity, time, load };

struct Family {
  Variable variable;
  bool by_direction;
  int count;
  const char* depends_on;
};

VectorXd values(const Recording& log, Variable variable, int axis) {
  switch (variable) {
    case Variable::position:
      return log.q.col(axis);
    case Variable::velocity:
      return log.qd.col(axis);
    case Variable::time:
      return log.time.array() - log.time(0);
    case Variable::load:
      return log.load.col(axis);
  }
  return {};
}

Candidate make_family(const Family& family, double low, double high, double soft, int axis,
                      int channel) {
  Candidate c;
  c.name = std::string("any dependence on ") + family.depends_on;
  c.place = "axis " + std::to_string(axis + 1);
  c.kind = CandidateKind::flexible;
  c.depends_on = family.depends_on;
  c.channels = {channel};
  for (int k = 0; k < family.count; ++k)
    c.linear.push_back({std::string("b").append(std::to_string(k)), "", -1e300, 1e300, false, {}});
  c.columns = [family, low, high, soft, axis](const Recording& log, int, const VectorXd&) {
    MatrixXd basis = spline_basis(values(log, family.variable, axis), low, high, family.count);
    if (family.by_direction)
      basis = (log.qd.col(axis).array() / soft).tanh().matrix().asDiagonal() * basis;
    return basis;
  };
  return c;
}

}  // namespace

MatrixXd spline_basis(const VectorXd& x, double low, double high, int count) {
  const int intervals = std::max(1, count - 3);
  MatrixXd basis = MatrixXd::Zero(x.size(), count);
  for (Index i = 0; i < x.size(); ++i) {
    const double u = std::clamp((x(i) - low) / (high - low), 0.0, 1.0) * intervals;
    const int k = std::min(static_cast<int>(u), intervals - 1);
    const double t = u - k, r = 1.0 - t;
    const double weights[4] = {r * r * r / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0,
                               (-3.0 * t * t * t + 3.0 * t * t + 3.0 * t + 1.0) / 6.0,
                               t * t * t / 6.0};
    for (int j = 0; j < 4 && k + j < count; ++j) basis(i, k + j) = weights[j];
  }
  return basis;
}

std::vector<Candidate> flexible_families(const FlexibleRanges& r, int axis, int channel) {
  const double soft = 1e-2 * r.speed;
  std::vector<Candidate> list;
  const auto add = [&](const Family& family, double low, double high) {
    if (high > low) list.push_back(make_family(family, low, high, soft, axis, channel));
  };
  add({Variable::position, false, 12, "position"}, r.low, r.high);
  add({Variable::position, true, 12, "position x direction"}, r.low, r.high);
  add({Variable::velocity, false, 14, "velocity"}, -r.speed, r.speed);
  add({Variable::time, false, 10, "time"}, 0.0, r.duration);
  add({Variable::time, true, 10, "time x direction"}, 0.0, r.duration);
  if (r.load > 0.0) {
    add({Variable::load, false, 8, "load"}, -r.load, r.load);
    add({Variable::load, true, 8, "load x direction"}, -r.load, r.load);
  }
  return list;
}

}  // namespace sinew
