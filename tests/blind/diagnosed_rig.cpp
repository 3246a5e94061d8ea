// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blind/diagnosed_rig.h"

#include <fmt/core.h>

#include <cstdlib>
#include <set>

#include "tests/reference/temporary_folder.h"

namespace sinew::blind {
namespace {

std::string word(const Outcome& outcome, const std::string& name) {
  const auto found = outcome.words.find(name);
  return found == outcome.words.end() ? name : found->second;
}

void judge(Outcome& o) {
  std::set<std::string> hidden, covered, first;
  for (const auto& cause : o.seal.hidden) hidden.insert(cause.name);
  const diagnosis::Verdict& verdict = o.findings.verdict;
  o.detected = !verdict.nothing_beyond_noise();
  for (const diagnosis::NamedCause& cause : verdict.causes) {
    bool hit = false;
    for (const auto& member : cause.members) {
      const std::string name = word(o, member.name);
      ++o.members;
      if (!hidden.contains(name)) continue;
      hit = true;
      covered.insert(name);
    }
    if (!hit) ++o.false_names;
    const std::string best = word(o, cause.members.front().name);
    if (hidden.contains(best)) first.insert(best);
  }
  o.all_inside = o.false_names == 0 && covered.size() == hidden.size() && !hidden.empty();
  o.all_right = o.all_inside && first.size() == hidden.size();
}

int environment(const char* name, int otherwise) {
  const char* value = std::getenv(name);
  return value ? std::atoi(value) : otherwise;
}

}  // namespace

std::string Outcome::told() const {
  std::string text;
  for (const diagnosis::NamedCause& cause : findings.verdict.causes) {
    text += " [";
    for (const auto& member : cause.members)
      text += fmt::format(" {}@{}", word(*this, member.name), member.place);
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

Outcome diagnose_trial(const truth::TrialRequest& wanted,
                       const std::function<diagnosis::ObservedRig(const truth::Trial&)>& rig,
                       const std::map<std::string, std::string>& words) {
  const truth::SealedTrial trial(wanted);
  const reference::TemporaryFolder folder;
  truth::write_trial(trial, folder.path().string(), (folder.path() / "seal").string());
  diagnosis::ObservedRequest request;
  request.rig = rig(trial.open());
  request.name = trial.open().plant;
  request.runtime = SINEW_SOURCE_DIR "/runtime";
  request.logs = {(folder.path() / "train.csv").string()};
  request.holdout = {(folder.path() / "holdout.csv").string()};
  request.settings.edge_s = 0.1;
  request.settings.seed = static_cast<unsigned>(wanted.seed);
  Outcome outcome;
  outcome.words = words;
  outcome.findings = diagnosis::diagnose_observed(request).findings;
  outcome.seal = trial.seal();
  judge(outcome);
  return outcome;
}

void study(const std::function<Outcome(std::uint64_t, truth::Family, double)>& trial) {
  const int trials = environment("SINEW_TRIALS", 20), first = environment("SINEW_SEED", 1);
  const double size = environment("SINEW_SIZE", 100) / 100.0;
  const auto family = static_cast<truth::Family>(environment("SINEW_FAMILY", 1));
  int detected = 0, inside = 0, right = 0, false_names = 0, sets = 0, members = 0, adopted = 0;
  for (int i = 0; i < trials; ++i) {
    const Outcome o = trial(static_cast<std::uint64_t>(first + i), family, size);
    detected += o.detected;
    inside += o.all_inside;
    right += o.all_right;
    false_names += o.false_names;
    sets += static_cast<int>(o.findings.verdict.causes.size());
    members += o.members;
    adopted += o.findings.extension.adopted;
    fmt::print("{:5d} {} hidden:{} | told:{} | {:.1f} s\n", first + i,
               o.all_right    ? "ok "
               : o.all_inside ? "in "
                              : "-- ",
               o.hidden(), o.told(), o.findings.seconds);
    std::fflush(stdout);
  }
  fmt::print(
      "trials {} size {}: detected {} all inside {} all right {} false names {} mean set {:.2f} "
      "adopted {}\n",
      trials, size, detected, inside, right, false_names,
      sets ? static_cast<double>(members) / sets : 0.0, adopted);
}

}  // namespace sinew::blind
