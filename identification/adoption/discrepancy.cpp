// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/adoption/discrepancy.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "identification/logs/signal_relations.h"
#include "identification/regression/standstill.h"

namespace sinew::diagnosis {
namespace {

constexpr double kHalf = 0.5;         // of the rms measured
constexpr double kHardlyNoise = 0.1;  // of what is left over

Eigen::ArrayXd changes(const Eigen::VectorXd& x, bool free_zero) {
  return free_zero ? centred(x.array()) : x.array();
}

double share(double part, double whole) {
  return whole > 0.0 ? part / whole : 0.0;
}

/// A log's recordings are called after it, and by their part where there are several.
const std::pair<const std::string, std::vector<LoggedColumn>>* log_of(
    const std::string& recording, const std::map<std::string, std::vector<LoggedColumn>>& columns) {
  for (const auto& log : columns)
    if (recording == log.first || recording.starts_with(log.first + " part ")) return &log;
  return nullptr;
}

DataFault discrepancy(const std::string& file, const LoggedColumn& at, double left, double noise) {
  DataFault fault;
  fault.kind = FaultKind::discrepancy;
  fault.severity = Severity::doubtful;
  fault.file = file;
  fault.column = at.column;
  fault.channel = at.name;
  fault.meaning =
      fmt::format("of '{}' the model leaves {:.3g} % over, and its noise is no more than {:.2g} %",
                  at.name, 100.0 * left, 100.0 * noise);
  fault.action = "check units, signs and exchanged columns, or whether this is another model's log";
  return fault;
}

}  // namespace

std::vector<DataFault> discrepant_channels(
    const Problem& problem, const std::vector<MeasuredChannel>& measured,
    const std::map<std::string, std::vector<LoggedColumn>>& columns, bool free_zero) {
  std::vector<DataFault> faults;
  std::set<std::pair<std::string, int>> told;
  for (const MeasuredChannel& m : measured) {
    const auto index = static_cast<std::size_t>(m.recording), first = problem.training.size();
    const Recording& r = index < first ? problem.training[index] : problem.holdout[index - first];
    const auto* log = log_of(r.name, columns);
    if (!log) continue;
    const auto c = static_cast<std::size_t>(m.channel);
    // What a joint holds while it rests is its friction's to tell: it counts here as in every gain.
    const auto size = [&](const Eigen::VectorXd& x) {
      const Eigen::ArrayXd changed = changes(x, free_zero);
      return m.counts.size() > 0 ? rms(changed * m.counts.array()) : rms(changed);
    };
    // An extension may do harm where it was not learnt; the log is as the better of both says.
    const auto rest = [&](const Eigen::VectorXd& said) {
      return share(size(m.measured - said), size(m.measured));
    };
    const double left = std::min(rest(m.before), rest(m.after));
    Eigen::ArrayXd whole = changes(r.target[c], free_zero);
    if (!r.disturbed.empty()) whole *= motion_window(r.disturbed, r.time).array();
    const double noise = share(white_noise_rms(r.target[c].array()), rms(whole));
    if (left < kHalf || noise > kHardlyNoise * left) continue;
    if (told.insert({log->first, m.channel}).second)
      faults.push_back(discrepancy(log->first, log->second[c], left, noise));
  }
  return faults;
}

double quantum_of(const std::map<std::string, std::vector<LoggedColumn>>& columns, int channel) {
  double coarsest = 0.0;
  for (const auto& [file, list] : columns)
    coarsest = std::max(coarsest, list[static_cast<std::size_t>(channel)].quantum);
  return coarsest;
}

void report_discrepancies(const std::vector<DataFault>& faults, Findings& findings) {
  if (faults.empty()) return;
  for (const DataFault& fault : faults)
    for (LogRecord& log : findings.logs)
      if (log.file == fault.file) log.faults.push_back(message(fault));
  const DataFault& first = faults.front();
  const std::string what = fmt::format(
      "of '{}' in {}{}: {}.", first.channel, first.file,
      faults.size() > 1 ? fmt::format(" and {} more", faults.size() - 1) : "", first.action);
  if (findings.verdict.nothing_beyond_noise()) {
    findings.verdict.unexplained.none_of_the_known = true;
    findings.headline = "The model explains less than half " + what;
  } else {
    findings.headline += " It explains less than half " + what;
  }
}

}  // namespace sinew::diagnosis
