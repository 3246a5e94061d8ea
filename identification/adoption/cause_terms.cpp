// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/adoption/cause_terms.h"

#include "identification/report/verdict_text.h"
#include "symbolic/effects/effects.h"
#include "symbolic/notation/print_mathml.h"

namespace sinew::diagnosis {
namespace {

/// The search fits by how much the logged effort exceeds what the motion took; people, the
/// equation and the model know the change of the radius or of the constant itself.
void tell_gain_change(const std::string& id, std::vector<ParameterEstimate>& parameters) {
  if (id != "torque_constant" && id != "pulley_radius") return;
  for (ParameterEstimate& p : parameters) {
    if (p.name != "gain") continue;
    const double whole = 1.0 + p.value;
    p.name = "gain_change";
    p.value = 1.0 / whole - 1.0;
    p.standard_error /= whole * whole;
  }
}

void fill_term(const std::string& id, CauseTerm& term) {
  for (const Effect& effect : effects()) {
    if (effect.id != id) continue;
    term.mathml = mathml_equation("effort", effort(effect));
    term.text = plain_equation("effort", effort(effect));
    term.signature = effect.signature;
    term.excitation = effect.excitation;
    term.compensable = effect.compensable;
    return;
  }
  describe_model_term(id, term);
}

}  // namespace

std::string effect_of(const DrivenSubject& subject, const NamedCause& cause) {
  // A cause without a term of the model may be one of the library all the same.
  const int candidate =
      cause.candidate == kNoTerm ? cause.members.front().candidate : cause.candidate;
  if (candidate == kNoTerm) return "unlogged_force";
  if (candidate >= 0) return subject.library_origins()[static_cast<std::size_t>(candidate)].effect;
  return subject.deviation_origin(-1 - candidate).effect;
}

void describe_terms(const DrivenSubject& subject, Findings& findings) {
  std::vector<NamedCause>& causes = findings.verdict.causes;
  for (std::size_t c = 0; c < causes.size(); ++c) {
    const std::string id = effect_of(subject, causes[c]);
    tell_gain_change(id, causes[c].parameters);
    CauseTerm term;
    term.cause = static_cast<int>(c);
    term.effect = id;
    fill_term(id, term);
    findings.terms.push_back(std::move(term));
  }
}

}  // namespace sinew::diagnosis
