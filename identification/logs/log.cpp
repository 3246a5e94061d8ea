// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/logs/log.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "symbolic/files/readable.h"

namespace sinew {
namespace {

std::string joined_messages(const std::vector<DataFault>& faults) {
  std::string text;
  for (const DataFault& fault : faults) {
    if (fault.severity != Severity::stop) continue;
    if (!text.empty()) text += '\n';
    text += message(fault);
  }
  return text;
}

}  // namespace

std::string fault_name(FaultKind kind) {
  switch (kind) {
    case FaultKind::missing_cell:
      return "missing cell";
    case FaultKind::not_a_number:
      return "not a number";
    case FaultKind::not_numeric:
      return "not numeric";
    case FaultKind::row_length:
      return "row length";
    case FaultKind::missing_unit:
      return "missing unit";
    case FaultKind::wrong_unit:
      return "wrong unit";
    case FaultKind::duplicate_time:
      return "duplicate time";
    case FaultKind::backward_time:
      return "backward time";
    case FaultKind::time_restart:
      return "time restart";
    case FaultKind::gap:
      return "gap";
    case FaultKind::jitter:
      return "jitter";
    case FaultKind::coarse_time:
      return "coarse time";
    case FaultKind::time_unit:
      return "time unit";
    case FaultKind::unit_slip:
      return "unit slip";
    case FaultKind::swapped_columns:
      return "swapped columns";
    case FaultKind::reversed_sign:
      return "reversed sign";
    case FaultKind::constant_channel:
      return "constant channel";
    case FaultKind::clipping:
      return "clipping";
    case FaultKind::stuck:
      return "stuck value";
    case FaultKind::held_samples:
      return "held samples";
    case FaultKind::spike:
      return "spike";
    case FaultKind::wrapped_angle:
      return "wrapped angle";
    case FaultKind::discrepancy:
      return "far off the model";
    case FaultKind::out_of_range:
      return "out of range";
    case FaultKind::too_short:
      return "too short";
    case FaultKind::too_long:
      return "too long";
  }
  return "unknown";
}

long diagnosis_values(std::size_t logs, bool first_look) {
  const long all = first_look ? 130'000 : 1'050'000;
  constexpr std::size_t kMostShares = 3;
  return all / static_cast<long>(std::clamp<std::size_t>(logs, 1, kMostShares));
}

std::string severity_name(Severity severity) {
  switch (severity) {
    case Severity::note:
      return "note";
    case Severity::repaired:
      return "repaired";
    case Severity::doubtful:
      return "doubtful";
    case Severity::stop:
      return "stop";
  }
  return "unknown";
}

std::string message(const DataFault& fault) {
  std::string text = fmt::format("{}:{}:{}: {}", readable_line(fault.file), fault.row, fault.column,
                                 message_part(fault.meaning));
  if (fault.count > 1) text += fmt::format(" ({} times)", fault.count);
  if (!fault.action.empty()) text += "; " + message_part(fault.action);
  return text;
}

LogError::LogError(std::vector<DataFault> findings)
    : std::runtime_error(joined_messages(findings)), faults(std::move(findings)) {}

int Log::channel(const std::string& name) const {
  for (size_t i = 0; i < channels.size(); ++i)
    if (channels[i].name == name) return static_cast<int>(i);
  return -1;
}

long Log::sample_count() const {
  long count = 0;
  for (const Segment& segment : segments) count += segment.samples.rows();
  return count;
}

Eigen::ArrayXd Log::joined(int channel) const {
  Eigen::ArrayXd all(sample_count());
  long at = 0;
  for (const Segment& segment : segments) {
    all.segment(at, segment.samples.rows()) = segment.samples.col(channel);
    at += segment.samples.rows();
  }
  return all;
}

double white_noise_rms(const Eigen::Ref<const Eigen::ArrayXd>& signal) {
  if (signal.size() < 8) return 0.0;
  const long n = signal.size() - 3;
  std::vector<double> size(static_cast<size_t>(n));
  for (long k = 0; k < n; ++k)
    size[static_cast<size_t>(k)] =
        std::abs(signal(k + 3) - 3.0 * signal(k + 2) + 3.0 * signal(k + 1) - signal(k));
  const auto middle = size.begin() + n / 2;
  std::nth_element(size.begin(), middle, size.end());
  // Median of |N(0, s)| is 0.6745 s, and a third difference of white noise has variance 20.
  return *middle / (0.674489750196 * std::sqrt(20.0));
}

}  // namespace sinew
