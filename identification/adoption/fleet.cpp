// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/adoption/fleet.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>

#include "identification/adoption/held_out_judgement.h"
#include "identification/adoption/read_subject.h"
#include "identification/likelihood/explain_sums.h"
#include "identification/report/verdict_text.h"

namespace sinew::diagnosis {
namespace {

/// The reference logs' columns, and beside them a log that was prepared as a held-out one.
struct Prepared {
  std::unique_ptr<ReferenceColumns> reference;
  std::vector<Recording> log;
  std::vector<LogRecord> records;  ///< the reference logs' first
};

Prepared prepared(const DiagnoseRequest& request) {
  SubjectOfLogs read = read_subject(request);
  read.subject.prepare(request.settings);
  for (int c = 0; c < read.subject.problem().channels; ++c)
    read.subject.set_quantum(c, quantum_of(read.columns, c));
  Problem problem = read.subject.problem();
  std::vector<Recording> log = std::move(problem.holdout);
  return {std::make_unique<ReferenceColumns>(std::move(problem), request.settings), std::move(log),
          std::move(read.logs)};
}

std::string settings_text(const DiagnoseRequest& request) {
  const Settings& s = request.settings;
  std::string text = fmt::format("band {:g} Hz, edges {:g} s, material share {:g}{}", s.band_hz,
                                 s.edge_s, s.material_share, s.first_look ? ", first look" : "");
  for (const auto& [joint, constant] : request.torque_constants)
    text += fmt::format(", {:g} N*m/A or N/A at {}", constant, joint);
  return text;
}

/// All but the log's own part.
SumsOrigin origin_of(const DiagnoseRequest& request, const std::string& program,
                     const Prepared& p) {
  SumsOrigin origin;
  origin.program = program;
  origin.model = request.name;
  origin.model_hash = request.hash;
  origin.columns_hash = p.reference->hash();
  origin.settings = settings_text(request);
  for (const LogRecord& log : p.records)
    if (!log.held_out) origin.reference.push_back(log.sha256);
  std::sort(origin.reference.begin(), origin.reference.end());
  return origin;
}

LogRecord record_of(const SumsOrigin& o, bool held_out) {
  return {o.log, o.log_hash, held_out, o.log_rows, o.log_seconds, 0.0, o.faults, {}};
}

/// Files of one fleet, read one after another.
class FleetReader {
 public:
  explicit FleetReader(SumsOrigin own) : own_(std::move(own)) {}

  LogSums read(const std::string& file, bool held_out) {
    SumsFile sums = read_sums(file);
    check_same_fleet(own_, "this model with these reference logs", sums.origin, file);
    const auto [known, is_new] = files_.emplace(sums.origin.log_hash, file);
    if (!is_new)
      throw std::invalid_argument(
          fmt::format("{}: is of the same log as {}, '{}'; a log counts once", file, known->second,
                      sums.origin.log));
    records_.push_back(record_of(sums.origin, held_out));
    return std::move(sums.sums);
  }
  std::vector<LogRecord> records() { return std::move(records_); }

 private:
  SumsOrigin own_;
  std::map<std::string, std::string> files_;  ///< by the log's hash
  std::vector<LogRecord> records_;
};

LogSums added_up(const std::vector<std::string>& files, FleetReader& reader) {
  std::optional<LogSums> sums;
  for (const std::string& file : files) {
    LogSums own = reader.read(file, false);
    if (sums)
      sums->add(own);
    else
      sums = std::move(own);
  }
  if (!sums) throw std::invalid_argument("no sums are given; expected one file of sums at least");
  return std::move(*sums);
}

std::string headline_of_verdict(const Verdict& verdict) {
  Findings findings;
  findings.verdict = verdict;
  return headline(findings);
}

}  // namespace

SumsFile summarise(const DiagnoseRequest& request, const std::string& program) {
  Prepared p = prepared(request);
  SumsFile file;
  file.origin = origin_of(request, program, p);
  const LogRecord& log = p.records.back();
  file.origin.log = log.file;
  file.origin.log_hash = log.sha256;
  file.origin.log_rows = log.rows;
  file.origin.log_seconds = log.seconds;
  file.origin.faults = log.faults;
  file.sums = p.reference->sums(std::move(p.log));
  return file;
}

FleetFindings diagnose_sums(const DiagnoseRequest& request, const std::string& program,
                            const SumsOfLogs& files) {
  const auto start = std::chrono::steady_clock::now();
  const Prepared p = prepared(request);
  FleetReader reader(origin_of(request, program, p));
  const LogSums training = added_up(files.training, reader);
  ExplainedSums explained = explain_sums(*p.reference, training);
  FleetFindings f;
  if (!files.held_out.empty()) {
    HeldOutErrors errors(explained, training.columns);
    for (const std::string& file : files.held_out) errors.add(reader.read(file, true).columns);
    errors.tell(request.settings.seed, explained.verdict);
  }
  merge_members(explained.verdict);
  if (!files.held_out.empty()) confirm_on_held_out(explained.verdict);
  f.model = request.name;
  f.model_hash = request.hash;
  f.kind = request.kind;
  f.logs = reader.records();
  f.headline = headline_of_verdict(explained.verdict);
  f.verdict = std::move(explained.verdict);
  f.whitened_error_left = explained.whitened_error_left;
  f.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return f;
}

}  // namespace sinew::diagnosis
