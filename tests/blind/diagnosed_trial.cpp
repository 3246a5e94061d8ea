// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blind/diagnosed_trial.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>

#include "tests/reference/temporary_folder.h"

namespace sinew::blind {
namespace {

void judge(Outcome& o) {
  std::set<std::string> hidden, covered, first;
  for (const auto& cause : o.seal.hidden) hidden.insert(cause.name);
  const diagnosis::Verdict& verdict = o.findings.verdict;
  o.detected = !verdict.nothing_beyond_noise();
  for (const diagnosis::NamedCause& cause : verdict.causes) {
    bool hit = false;
    for (const auto& member : cause.members) {
      const std::string name = o.words(member.name, member.place);
      ++o.members;
      if (!hidden.contains(name)) continue;
      hit = true;
      covered.insert(name);
    }
    if (!hit) ++o.false_names;
    const std::string best = o.words(cause.members.front().name, cause.members.front().place);
    if (hidden.contains(best)) first.insert(best);
  }
  o.all_inside = o.false_names == 0 && covered.size() == hidden.size() && !hidden.empty();
  o.all_right = o.all_inside && first.size() == hidden.size();
}

/// The trial's logs as files, as long as it lives.
struct LogFiles {
  explicit LogFiles(const truth::SealedTrial& trial) {
    truth::write_trial(trial, folder.path().string(), (folder.path() / "seal").string());
  }
  std::vector<std::string> train() const { return {(folder.path() / "train.csv").string()}; }
  std::vector<std::string> holdout() const { return {(folder.path() / "holdout.csv").string()}; }
  std::string add(const std::string& name, const std::string& text) const {
    const std::filesystem::path path = folder.path() / name;
    std::ofstream(path, std::ios::binary) << text;
    return path.string();
  }
  reference::TemporaryFolder folder;
};

}  // namespace

Outcome judged(truth::Seal seal, diagnosis::Findings findings, const Words& words) {
  Outcome outcome;
  outcome.words = words;
  outcome.findings = std::move(findings);
  outcome.seal = std::move(seal);
  judge(outcome);
  return outcome;
}

Words by_table(std::map<std::string, std::string> table) {
  return [table = std::move(table)](const std::string& name, const std::string&) {
    const auto found = table.find(name);
    return found == table.end() ? name : found->second;
  };
}

bool Outcome::hides(const std::string& name, const std::string& place, double size) const {
  if (seal.hidden.size() != 1) return false;
  const truth::HiddenCause& cause = seal.hidden.front();
  return cause.name == name && cause.place == place && std::abs(cause.size / size - 1.0) <= 0.2;
}

std::string Outcome::told() const {
  std::string text;
  for (const diagnosis::NamedCause& cause : findings.verdict.causes) {
    text += " [";
    for (const auto& member : cause.members)
      text += fmt::format(" {}@{}", words(member.name, member.place), member.place);
    text += fmt::format(" {:.2f}]", cause.confidence);
    for (const auto& p : cause.parameters)
      text += fmt::format(" {}={:.3g}+-{:.2g}", p.name, p.value, p.standard_error);
  }
  if (findings.verdict.unexplained.none_of_the_known) text += " NONE-OF-THE-KNOWN";
  for (const auto& d : findings.verdict.unexplained.depends_on)
    text += fmt::format(" ~{} ({}, {:.3f})", d.on, d.place, d.gain.share);
  return text;
}

std::string Outcome::hidden() const {
  std::string text;
  for (const auto& cause : seal.hidden)
    text += fmt::format(" {}@{}={:.4g}({:.2f})", cause.name, cause.place, cause.value, cause.size);
  return text;
}

std::string Outcome::missed() const {
  std::string text;
  for (const auto& out : findings.verdict.ruled_out)
    for (const auto& cause : seal.hidden)
      if (words(out.name, out.place) == cause.name)
        text += fmt::format("        {} @ {}: {} (statistic {:.1f}, p {:.3f})\n", out.name,
                            out.place, out.reason, out.statistic, out.p_family);
  return text;
}

namespace {

diagnosis::DiagnoseRequest filled(diagnosis::DiagnoseRequest request, const LogFiles& files,
                                  std::uint64_t seed) {
  request.name = request.model.name;
  request.runtime = SINEW_SOURCE_DIR "/runtime";
  request.logs = files.train();
  request.holdout = files.holdout();
  request.settings.edge_s = diagnosis::driven_edge;
  request.settings.band_hz = diagnosis::driven_band;
  request.settings.seed = static_cast<unsigned>(seed);
  return request;
}

}  // namespace

Outcome diagnose_driven(
    const truth::TrialRequest& wanted,
    const std::function<diagnosis::DiagnoseRequest(const truth::Trial&)>& request_for,
    const Words& words) {
  const truth::SealedTrial trial(wanted);
  const LogFiles files(trial);
  const auto request = filled(request_for(trial.open()), files, wanted.seed);
  return judged(trial.seal(), diagnosis::diagnose(request).findings, words);
}

Settled settle_driven(
    const truth::TrialRequest& wanted,
    const std::function<diagnosis::DiagnoseRequest(const truth::Trial&)>& request_for,
    const Words& words) {
  const truth::SealedTrial trial(wanted);
  const LogFiles files(trial);
  auto request = filled(request_for(trial.open()), files, wanted.seed);
  diagnosis::Diagnosis first = diagnosis::diagnose(request);
  Settled settled{judged(trial.seal(), first.findings, words), {}};
  if (first.experiments.empty()) return settled;
  const auto& [name, motion] = *first.experiments.begin();
  request.logs.push_back(files.add(name, trial.play(motion)));
  settled.after = judged(trial.seal(), diagnosis::diagnose(request).findings, words);
  return settled;
}

Outcome diagnose_rig(const truth::TrialRequest& wanted,
                     const std::function<diagnosis::ObservedRig(const truth::Trial&)>& rig,
                     const Words& words) {
  const truth::SealedTrial trial(wanted);
  const LogFiles files(trial);
  diagnosis::ObservedRequest request;
  request.rig = rig(trial.open());
  request.name = trial.open().plant;
  request.runtime = SINEW_SOURCE_DIR "/runtime";
  request.logs = files.train();
  request.holdout = files.holdout();
  request.settings.edge_s = 0.1;
  request.settings.seed = static_cast<unsigned>(wanted.seed);
  return judged(trial.seal(), diagnosis::diagnose_observed(request).findings, words);
}

void Rates::add(const Outcome& o) {
  ++trials;
  detected += o.detected;
  all_inside += o.all_inside;
  all_right += o.all_right;
  false_names += o.false_names;
  trials_with_false_name += o.false_names > 0;
  none_of_the_known += o.findings.verdict.unexplained.none_of_the_known;
  sets += static_cast<int>(o.findings.verdict.causes.size());
  members += o.members;
  adopted += o.findings.extension.adopted;
}

std::string Rates::text() const {
  return fmt::format(
      "trials {}: detected {}, all inside {}, all right {}, false names {} in {} trials, none of "
      "the known {}, mean set {:.2f}, adopted {}",
      trials, detected, all_inside, all_right, false_names, trials_with_false_name,
      none_of_the_known, sets ? static_cast<double>(members) / sets : 0.0, adopted);
}

bool Outcome::is_settled() const {
  if (!all_right) return false;
  for (const diagnosis::NamedCause& cause : findings.verdict.causes)
    for (const auto& member : cause.members) {
      const std::string name = words(member.name, member.place);
      const bool is_hidden =
          std::any_of(seal.hidden.begin(), seal.hidden.end(),
                      [&](const truth::HiddenCause& h) { return h.name == name; });
      const auto& rivals = seal.admissible;
      if (!is_hidden && std::find(rivals.begin(), rivals.end(), name) != rivals.end()) return false;
    }
  return true;
}

Rates run(const Trials& diagnose, truth::TrialRequest request, int count,
          const std::function<void(std::uint64_t, const Outcome&)>& each) {
  Rates rates;
  for (int i = 0; i < count; ++i, ++request.seed) {
    const Outcome outcome = diagnose(request);
    if (outcome.seal.hidden.size() != truth::wanted_causes(request.family))
      throw std::runtime_error(fmt::format("seed {} of {} ({}) hides {} causes", request.seed,
                                           request.plant, truth::family_name(request.family),
                                           outcome.seal.hidden.size()));
    rates.add(outcome);
    if (each) each(request.seed, outcome);
  }
  return rates;
}

}  // namespace sinew::blind
