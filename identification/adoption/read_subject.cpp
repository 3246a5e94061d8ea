// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/adoption/read_subject.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "identification/adoption/read_motion.h"
#include "identification/report/log_record.h"
#include "identification/subjects/driven_readings.h"

namespace sinew::diagnosis {
namespace {

class SubjectReader {
 public:
  explicit SubjectReader(const DiagnoseRequest& request)
      : request_(request), read_{empty_subject(request), {}, {}, {}} {}

  SubjectOfLogs operator()() {
    std::map<std::string, double> constants = request_.torque_constants;
    LoggedMotion logged = read_logs(request_, constants);
    std::vector<std::string> notes = request_.notes;
    if (const std::vector<std::string> open = open_currents(logged); !open.empty()) {
      for (std::string& note :
           fit_constants(logged, request_.payloads, open, read_.subject, constants))
        notes.push_back(std::move(note));
      scaled_to_model_ = open;
      logged = read_logs(request_, constants);
    }
    read_.torque_constants = constants_used(logged);
    for (std::size_t i = 0; i < logged.logs.size(); ++i)
      take(logged.logs[i], logged.channels[i], i >= request_.logs.size());
    tell_missing_loads(read_.subject.complete_loads());
    // Before the efforts are compared with what the model says: it may carry a load.
    const std::vector<PayloadNote> payloads = read_.subject.take_payloads();
    for (std::size_t i = 0; i < logged.logs.size(); ++i)
      check(logged.logs[i], logged.channels[i], payloads, i >= request_.logs.size(), read_.logs[i]);
    LogRecord& first = read_.logs.front();
    for (const std::string& note : notes) first.faults.push_back(first.file + ": " + note);
    return std::move(read_);
  }

 private:
  void take(const Log& log, const DrivenChannels& channels, bool held_out) {
    const DrivenColumns columns = columns_in(log, channels);
    read_.subject.add_log(log, columns, held_out, payload_of(request_.payloads, log.file));
    read_.columns[log.file] = judged_columns(log, columns);
    read_.logs.push_back(log_record(log, held_out));
  }

  void tell_missing_loads(const std::vector<std::string>& recordings) {
    for (LogRecord& log : read_.logs)
      if (std::any_of(recordings.begin(), recordings.end(),
                      [&](const std::string& name) { return name.starts_with(log.file); }))
        log.faults.push_back(log.file +
                             ": has no column 'load', which another log has; it counts as 0");
  }

  /// Throws LogError where going on is not safe.
  void check(const Log& log, const DrivenChannels& channels,
             const std::vector<PayloadNote>& payloads, bool held_out, LogRecord& record) const {
    DrivenColumns columns = columns_in(log, channels);
    for (const std::string& effort : scaled_to_model_)
      columns.scaled_to_model.push_back(log.channel(effort));
    for (const DataFault& doubt : check_columns(log, columns, held_out))
      record.faults.push_back(message(doubt));
    for (const PayloadNote& note : payloads)
      if (note.log == log.file) record.faults.push_back(log.file + ": " + note.text);
  }

  /// What each channel of the problem is measured by: forces of tendons stand for their joints.
  static std::vector<LoggedColumn> judged_columns(const Log& log, const DrivenColumns& columns) {
    std::vector<LoggedColumn> judged;
    const auto add = [&](int index, const std::string& whole) {
      const Channel& channel = log.channels[static_cast<std::size_t>(index)];
      judged.push_back({whole.empty() ? channel.name : whole, channel.column,
                        whole.empty() ? channel.quantum : 0.0});
    };
    const std::size_t joints = columns.positions.size() - columns.efforts.size();
    for (std::size_t j = 0; j < joints; ++j)
      add(columns.forces.front(),
          "the forces' torque at " +
              log.channels[static_cast<std::size_t>(columns.positions[j])].name);
    for (const int effort : columns.efforts) add(effort, {});
    return judged;
  }

  /// The model tells exchanged columns and wrong signs of coupled joints from what they lack.
  /// Throws LogError where going on is not safe, and gives what is doubtful.
  std::vector<DataFault> check_columns(const Log& log, const DrivenColumns& columns,
                                       bool held_out) const {
    const Recording* longest = nullptr;
    for (const Recording& r :
         held_out ? read_.subject.problem().holdout : read_.subject.problem().training)
      if (r.name.starts_with(log.file) && (!longest || r.time.size() > longest->time.size()))
        longest = &r;
    if (!longest) return {};
    FaultList faults(log.file);
    judge_driven_columns(log, columns, *longest, request_.model, read_.subject.effort(),
                         read_.subject.rigid(), request_.runtime, faults);
    if (faults.stops()) throw LogError(faults.all());
    return faults.all();
  }

  const DiagnoseRequest& request_;
  SubjectOfLogs read_;
  std::vector<std::string> scaled_to_model_;  ///< efforts from currents, their constants fitted
};

}  // namespace

DrivenSubject empty_subject(const DiagnoseRequest& request) {
  return {request.model, request.identified, request.runtime,
          request.mechanism
              ? std::make_shared<const RigidColumns>(*request.mechanism, request.runtime)
              : nullptr};
}

SubjectOfLogs read_subject(const DiagnoseRequest& request) {
  return SubjectReader(request)();
}

}  // namespace sinew::diagnosis
