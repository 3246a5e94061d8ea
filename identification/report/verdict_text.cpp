// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/report/verdict_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "identification/report/numbers.h"
#include "identification/report/wording.h"
#include "symbolic/effects/model_effects.h"
#include "symbolic/notation/print_mathml.h"

namespace sinew::diagnosis {
namespace {

std::string dependences(const Unexplained& unexplained) {
  std::vector<std::string> on;
  for (const Dependence& d : unexplained.depends_on) {
    if (on.size() == 2) break;
    on.push_back(dependence_text(d));
  }
  return on.empty() ? "nothing that was looked at" : joined(on, "and");
}

}  // namespace

std::string experiment_text(const Separation& separation) {
  constexpr double kPlenty = 100.0;
  if (!separation.motion) return separation.experiment;
  return fmt::format(
      "{}{}, expected to tell it from {} by {} standard errors", separation.experiment,
      separation.file.empty() ? "" : ", as in " + separation.file,
      joined(separation.rules_out, "and"),
      separation.expected > kPlenty ? "more than 100" : fmt::format("{:.0f}", separation.expected));
}

std::string disagreement_text(const Findings& f) {
  std::vector<std::string> parts;
  for (const Disagreement& d : f.verdict.disagreements)
    if (!d.name.empty() && !(d.in_training.low > 0.0))
      parts.push_back(fmt::format(
          "without {} ({}) the training logs leave an rms residual {:.1f} times as large, and in "
          "the held-out ones it takes away nothing",
          d.name, d.place, d.ratio));
    else if (!d.name.empty())
      parts.push_back(
          fmt::format("{} ({}) takes away {} of the squared error there in the training logs "
                      "(cross-validated gain), and nothing in the held-out ones",
                      d.name, d.place, shown_share(d.in_training.share)));
    else
      parts.push_back(fmt::format(
          "of '{}' the held-out logs leave an rms residual {:.1f} times that of the training logs",
          f.channels[static_cast<std::size_t>(d.channel)].name, d.ratio));
  return parts.empty() ? ""
                       : "The logs disagree: " + fmt::format("{}", fmt::join(parts, "; ")) + ".";
}

std::string headline(const Findings& f) {
  const Verdict& v = f.verdict;
  const std::string disagreement = disagreement_text(f);
  if (v.causes.empty() && !v.unexplained.none_of_the_known && !disagreement.empty())
    return disagreement;
  if (v.nothing_beyond_noise() && v.immaterial)
    return fmt::format(
        "The model leaves nothing over that is worth naming: no more than {} of each channel.",
        shown_share(f.channels.empty() ? Settings{}.material_share
                                       : f.channels.front().material_share));
  if (v.nothing_beyond_noise())
    return v.compared_below_hz > 0.0
               ? fmt::format("The model leaves nothing over but noise below {:.2g} Hz.",
                             v.compared_below_hz)
               : "The model leaves nothing over but noise.";
  if (v.causes.empty())
    return "The model leaves structure over that none of the known causes explains; it depends "
           "on " +
           dependences(v.unexplained) + ".";
  std::vector<std::string> names;
  constexpr std::size_t most = 3;
  for (const NamedCause& cause : v.causes)
    if (names.size() < most) names.push_back(cause_text(cause));
  if (v.causes.size() > most) names.push_back(fmt::format("{} more", v.causes.size() - most));
  std::string text = "The model lacks: " + joined(names, "and") + ".";
  if (v.unexplained.none_of_the_known)
    text += " Beyond that there is structure that no known cause explains; it depends on " +
            dependences(v.unexplained) + ".";
  return disagreement.empty() ? text : text + " " + disagreement;
}

std::string next_step(const Findings& f) {
  for (const NamedCause& cause : f.verdict.causes)
    if (cause.members.size() > 1)
      return fmt::format("To tell {} apart, log this: {}.", cause_text(cause),
                         cause.separation.experiment.empty()
                             ? "a motion with other speeds and loads"
                             : experiment_text(cause.separation));
  if (f.verdict.causes.empty() && f.verdict.unexplained.none_of_the_known)
    return "Look at the plots for what changes along with it, and log what might drive it.";
  if (f.verdict.causes.empty() && !f.verdict.disagreements.empty())
    return "See that all logs are of one machine in one state; what changes from log to log is "
           "named where every log shows it.";
  if (f.verdict.causes.empty()) return "Nothing to do.";
  if (std::all_of(f.verdict.causes.begin(), f.verdict.causes.end(),
                  [](const NamedCause& cause) { return cause.candidate == kNoTerm; }))
    return fmt::format("What the model says stands; for more, log {}.",
                       experiment_text(f.verdict.causes.front().separation));
  if (f.extension.adopted && f.extension.dry_run)
    return "The model was left as it is; without --dry-run it takes the terms named here.";
  if (f.extension.adopted) return "Generate the model again; it now holds the terms named here.";
  return "The model was left as it is: " + f.extension.reason + ".";
}

void describe_model_term(const std::string& effect, CauseTerm& term) {
  const ModelEffect* e = find_model_effect(effect);
  if (!e) return;
  term.mathml = mathml_equation("effort", e->effort);
  term.text = plain_equation("effort", e->effort);
  term.signature = e->signature;
  term.excitation = e->excitation;
}

}  // namespace sinew::diagnosis
