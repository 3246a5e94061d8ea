// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/adoption/read_motion.h"

#include <fmt/format.h>

#include <algorithm>

#include "identification/logs/read_csv.h"
#include "identification/subjects/torque_constants.h"

namespace sinew::diagnosis {
namespace {

const Channel& channel_of(const Log& log, const std::string& name) {
  return log.channels[static_cast<std::size_t>(log.channel(name))];
}

[[noreturn]] void refuse(const Log& log, const std::vector<std::string>& open) {
  std::vector<DataFault> faults;
  for (const std::string& name : open) {
    const Channel& c = channel_of(log, name);
    faults.push_back({FaultKind::wrong_unit, Severity::stop, log.file,
                      log.segments.front().first_row, log.segments.front().first_row, c.column,
                      c.name, 1,
                      fmt::format("'{}' is a current, and nothing in these logs tells "
                                  "what effort 1 A makes",
                                  c.name),
                      fmt::format("say it: --torque-constant \"{}=VALUE\" in {}/A, or in "
                                  "channels.toml",
                                  joint_of_effort(c.name), c.unit)});
  }
  throw LogError(std::move(faults));
}

}  // namespace

LoggedMotion read_logs(const DiagnoseRequest& request,
                       const std::map<std::string, double>& constants) {
  LoggedMotion logged;
  std::vector<LogFile> files;
  ReadOptions options;
  options.map = request.map;
  const bool first_look = request.settings.first_look;
  options.max_values = diagnosis_values(request.logs.size() + request.holdout.size(), first_look);
  for (const std::vector<std::string>& group : {request.logs, request.holdout})
    for (const std::string& file : group) {
      logged.channels.push_back(request.channels(file));
      set_torque_constants(constants, logged.channels.back());
      files.push_back({file, logged.channels.back().specs});
      options.max_rate = logged.channels.back().forces.empty() ? kDiagnosisRate : kTendonRate;
      if (first_look) options.max_rate = kFirstLookRate;
    }
  logged.training = request.logs.size();
  logged.logs = read_csv(files, options);
  return logged;
}

DrivenColumns columns_in(const Log& log, const DrivenChannels& channels) {
  const auto found = [&](const std::vector<std::string>& names) {
    std::vector<int> columns;
    for (const std::string& name : names) columns.push_back(log.channel(name));
    return columns;
  };
  return {found(channels.positions), found(channels.efforts),
          found(channels.forces),    channels.load.empty() ? -1 : log.channel(channels.load),
          log.channel("payload"),    {}};
}

std::vector<std::string> open_currents(const LoggedMotion& logged) {
  std::vector<std::string> open;
  for (std::size_t i = 0; i < logged.logs.size(); ++i)
    for (const ChannelSpec& spec : logged.channels[i].specs)
      if (spec.keep_ampere && logged.logs[i].channel(spec.name) >= 0 &&
          channel_of(logged.logs[i], spec.name).is_current &&
          std::find(open.begin(), open.end(), spec.name) == open.end())
        open.push_back(spec.name);
  return open;
}

std::vector<std::string> fit_constants(const LoggedMotion& logged,
                                       const std::vector<CarriedPayload>& payloads,
                                       const std::vector<std::string>& open,
                                       const DrivenSubject& subject,
                                       std::map<std::string, double>& constants) {
  DrivenSubject trial = subject;
  const auto carries = [&](const Log& log) {
    return payload_of(payloads, log.file) != nullptr || log.channel("payload") >= 0;
  };
  const auto end = logged.logs.begin() + static_cast<std::ptrdiff_t>(logged.training);
  const bool all_carry = std::all_of(logged.logs.begin(), end, carries);
  for (std::size_t i = 0; i < logged.training; ++i)
    if (all_carry || !carries(logged.logs[i]))
      trial.add_log(logged.logs[i], columns_in(logged.logs[i], logged.channels[i]), false);
  const std::vector<std::string>& efforts = logged.channels.front().efforts;
  const std::size_t first = subject.model().joints.size() - efforts.size();
  std::vector<std::size_t> joints;
  for (const std::string& name : open)
    joints.push_back(first +
                     static_cast<std::size_t>(std::find(efforts.begin(), efforts.end(), name) -
                                              efforts.begin()));
  const std::vector<FittedConstant> fitted =
      fit_torque_constants(trial.problem().training, subject.effort(), joints);
  if (fitted.empty()) refuse(logged.logs.front(), open);
  std::vector<std::string> said;
  for (std::size_t k = 0; k < open.size(); ++k) {
    const Channel& c = channel_of(logged.logs.front(), open[k]);
    const std::string joint = joint_of_effort(open[k]);
    constants[open[k]] = fitted[k].value;
    said.push_back(
        fitted[k].assumed
            ? fmt::format("'{}' is a current and its torque constant is told neither by the model "
                          "nor by these logs: {:.4g} {}/A are assumed, the mean of the other "
                          "joints; --torque-constant {}=VALUE says it",
                          c.name, fitted[k].value, c.unit, joint)
            : fmt::format(
                  "'{}' is a current: the torque constant {:.4g} ± {:.2g} {}/A was fitted to "
                  "what the model's masses ask for; --torque-constant {}=VALUE says a "
                  "measured one",
                  c.name, fitted[k].value, fitted[k].standard_error, c.unit, joint));
  }
  return said;
}

std::map<std::string, double> constants_used(const LoggedMotion& logged) {
  std::map<std::string, double> used;
  for (std::size_t i = 0; i < logged.logs.size(); ++i)
    for (const ChannelSpec& spec : logged.channels[i].specs)
      if (spec.per_ampere > 0.0 && logged.logs[i].channel(spec.name) >= 0 &&
          channel_of(logged.logs[i], spec.name).is_current)
        used[joint_of_effort(spec.name)] = spec.per_ampere;
  return used;
}

}  // namespace sinew::diagnosis
