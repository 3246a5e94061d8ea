// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/identify_logs.h"

#include <fmt/format.h>

#include <cmath>

namespace sinew {
namespace {

constexpr double most_deviation = 0.5;  // of a logged velocity from the position's derivative
constexpr double times_noise = 20.0;    // times its noise: a position that moves

bool is_repair(const DataFault& fault) {
  switch (fault.kind) {
    case FaultKind::missing_cell:
    case FaultKind::not_a_number:
    case FaultKind::not_numeric:
    case FaultKind::row_length:
    case FaultKind::duplicate_time:
    case FaultKind::backward_time:
    case FaultKind::time_restart:
      return true;
    default:
      return false;
  }
}

void refuse_repairs(const Log& log) {
  std::vector<DataFault> refused;
  for (const DataFault& fault : log.faults) {
    if (!is_repair(fault) || fault.severity == Severity::note) continue;
    refused.push_back(fault);
    refused.back().severity = Severity::stop;
    refused.back().action = "repeat the experiment; --repair takes the log as docs/logs.md says";
  }
  if (!refused.empty()) throw LogError(std::move(refused));
}

/// Sums of squares of the position's slope and of its distance from the logged velocity.
struct Comparison {
  double slope = 0.0, distance = 0.0, noise = 0.0;

  void add(const Eigen::ArrayXd& position, const Eigen::ArrayXd& velocity, double period,
           double position_noise) {
    const long n = position.size(), m = std::max(1L, std::lround(0.01 / period));
    if (n <= 2 * m) return;
    const Eigen::ArrayXd rate = (position.tail(n - 2 * m) - position.head(n - 2 * m)) /
                                (2.0 * static_cast<double>(m) * period);
    const double noise_of_rate = position_noise / (static_cast<double>(m) * period);
    noise += static_cast<double>(rate.size()) * noise_of_rate * noise_of_rate;
    // The mean over the same stretch: the trapezoid of its samples.
    double sum = velocity.head(2 * m).sum();
    for (long i = 0; i + 2 * m < n; ++i) {
      const double ends = 0.5 * (velocity(i + 2 * m) - velocity(i));
      const double mean = (sum + ends) / (2.0 * static_cast<double>(m));
      slope += rate(i) * rate(i);
      distance += (rate(i) - mean) * (rate(i) - mean);
      sum += velocity(i + 2 * m) - velocity(i);
    }
  }
};

void require_velocity(const Log& log) {
  const int theta = log.channel("theta"), omega = log.channel("omega");
  if (theta < 0 || omega < 0) return;
  Comparison sums;
  for (const Segment& segment : log.segments)
    sums.add(segment.samples.col(theta), segment.samples.col(omega), log.period,
             log.channels[static_cast<std::size_t>(theta)].noise_floor);
  if (sums.slope <= times_noise * times_noise * sums.noise ||
      sums.distance <= most_deviation * most_deviation * sums.slope)
    return;
  const Channel &position = log.channels[static_cast<std::size_t>(theta)],
                &velocity = log.channels[static_cast<std::size_t>(omega)];
  DataFault fault;
  fault.kind = FaultKind::swapped_columns;
  fault.severity = Severity::stop;
  fault.file = log.file;
  fault.column = velocity.column;
  fault.row = fault.last_row = log.segments.empty() ? 0 : log.segments.front().first_row;
  fault.channel = velocity.name;
  fault.meaning = fmt::format(
      "'{}' is not the derivative of '{}' (column {}): it is off by {:.3g} of it; expected the "
      "output shaft's angle and velocity",
      velocity.name, position.name, position.column, std::sqrt(sums.distance / sums.slope));
  fault.action = "name the columns with --map";
  throw LogError({fault});
}

}  // namespace

std::vector<Log> read_experiment_logs(const std::vector<std::string>& files,
                                      const std::vector<std::string>& map,
                                      const std::vector<ChannelSpec>& channels, bool repair) {
  ReadOptions options;
  options.map = map;
  options.check_consistency = false;  // made for work: an experiment excites other relations
  std::vector<Log> logs;
  for (const std::string& file : files) {
    logs.push_back(read_csv(file, channels, options));
    if (!repair) refuse_repairs(logs.back());
    require_velocity(logs.back());
  }
  return logs;
}

}  // namespace sinew
