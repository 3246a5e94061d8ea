// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/diagnosis/deviation_terms.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Covered = std::vector<std::vector<bool>>;

Covered covered_coefficients(const Problem& problem) {
  Covered covered;
  for (const Candidate& c : problem.baseline) covered.emplace_back(c.linear.size(), false);
  for (const ParameterDeviation& deviation : problem.deviations)
    for (const DeviationParameter& parameter : deviation.parameters)
      for (const DeviationParameter::Share& share : parameter.shares) {
        const auto t = static_cast<std::size_t>(share.term);
        const auto c = static_cast<std::size_t>(share.coefficient);
        if (share.term < 0 || t >= covered.size() || share.coefficient < 0 ||
            c >= covered[t].size() || problem.baseline[t].linear[c].per_log)
          throw std::invalid_argument("level '" + deviation.name + "': coefficient " +
                                      std::to_string(c) + " of baseline term " + std::to_string(t) +
                                      " is not there or belongs to a log");
        covered[t][c] = true;
      }
  return covered;
}

/// Column of a linear parameter in its term; parameters per log take one column for each log.
Index column_of(const Design& design, const Candidate& candidate, int parameter) {
  const auto layout = design.coefficients(candidate);
  for (std::size_t i = 0; i < layout.size(); ++i)
    if (layout[i].parameter == parameter) return static_cast<Index>(i);
  return -1;
}

/// The parameters of a baseline candidate that no deviation covers.
Term free_part(const Design& design, const Term& term, const std::vector<bool>& covered,
               std::vector<std::shared_ptr<const Candidate>>& made) {
  const Candidate& from = *term.candidate;
  auto rest = std::make_shared<Candidate>(from);
  std::vector<Index> parameters, columns;
  rest->linear.clear();
  for (std::size_t p = 0; p < from.linear.size(); ++p)
    if (!covered[p]) {
      rest->linear.push_back(from.linear[p]);
      parameters.push_back(static_cast<Index>(p));
    }
  const auto layout = design.coefficients(from);
  for (std::size_t i = 0; i < layout.size(); ++i)
    if (!covered[static_cast<std::size_t>(layout[i].parameter)])
      columns.push_back(static_cast<Index>(i));
  rest->columns = [all = from.columns, parameters](const Recording& log, int channel,
                                                   const VectorXd& nonlinear) -> MatrixXd {
    const MatrixXd x = all(log, channel, nonlinear);
    return x.cols() == 0 ? x : MatrixXd(x(Eigen::all, parameters));
  };
  Term part = term;
  BandColumns own = term.columns.get();
  for (MatrixXd& x : own)
    if (x.cols() > 0) x = MatrixXd(x(Eigen::all, columns));
  part.columns = std::move(own);
  part.candidate = rest.get();
  made.push_back(std::move(rest));
  return part;
}

/// Columns of a deviation in the recording's own samples; `terms`: the baseline's nonlinear
/// parameters.
ColumnFunction deviation_columns(const Problem& problem, const ParameterDeviation& deviation,
                                 std::vector<VectorXd> nonlinear) {
  return [&problem, &deviation, nonlinear = std::move(nonlinear)](const Recording& log, int channel,
                                                                  const VectorXd&) -> MatrixXd {
    MatrixXd x;
    const auto add = [&](std::size_t p, const VectorXd& column) {
      if (x.cols() == 0)
        x = MatrixXd::Zero(column.size(), static_cast<Index>(deviation.parameters.size()));
      x.col(static_cast<Index>(p)) += column;
    };
    for (std::size_t p = 0; p < deviation.parameters.size(); ++p) {
      for (const DeviationParameter::Share& share : deviation.parameters[p].shares) {
        const auto t = static_cast<std::size_t>(share.term);
        const Candidate& from = problem.baseline[t];
        if (!from.channels.empty() &&
            std::find(from.channels.begin(), from.channels.end(), channel) == from.channels.end())
          continue;
        const MatrixXd all = from.columns(log, channel, nonlinear[t]);
        if (all.cols() > 0) add(p, share.amount * all.col(share.coefficient));
      }
      if (!deviation.parameters[p].also) continue;
      const MatrixXd own = deviation.parameters[p].also(log, channel, VectorXd());
      if (own.cols() > 0) add(p, own.col(0));
    }
    return x;
  };
}

Term deviation_term(const Design& design, const Model& model, const FixedPart& nominal, int index,
                    std::vector<std::shared_ptr<const Candidate>>& made) {
  const Problem& problem = design.problem();
  const ParameterDeviation& deviation = problem.deviations[static_cast<std::size_t>(index)];
  auto c = std::make_shared<Candidate>();
  c->name = deviation.name;
  c->place = deviation.place;
  c->limit_meaning = deviation.limit_meaning;
  c->isolating_experiment = deviation.isolating_experiment;
  c->of_body = deviation.of_body;
  c->of_sensor = deviation.of_sensor;
  for (const DeviationParameter& p : deviation.parameters)
    c->linear.push_back({p.name, p.unit, p.low, p.high, false, {}, p.spread});
  std::vector<VectorXd> nonlinear(problem.baseline.size());
  for (const Term& term : model.terms)
    if (term.baseline)
      nonlinear[static_cast<std::size_t>(term.candidate - problem.baseline.data())] =
          term.nonlinear;
  c->columns = deviation_columns(problem, deviation, std::move(nonlinear));
  Term term;
  term.candidate = c.get();
  term.deviation = index;
  term.with_prior = true;
  term.columns = deviation.delayed ? delay_columns(design, *deviation.delayed, nominal)
                                   : design.columns(*c, VectorXd());
  made.push_back(std::move(c));
  return term;
}

}  // namespace

BandColumns delay_columns(const Design& design, const std::vector<int>& channels,
                          const FixedPart& nominal) {
  BandColumns columns(design.segments().size());
  for (std::size_t s = 0; s < columns.size(); ++s) {
    const int channel = design.segments()[s].channel;
    if (!channels.empty() && std::find(channels.begin(), channels.end(), channel) == channels.end())
      continue;
    columns[s] = MatrixXd::Zero(2 * design.segments()[s].bins, 1);
    if (const std::optional<VectorXd> known = design.known(static_cast<int>(s), 1))
      columns[s] += *known;
    if (!nominal.rate.empty()) columns[s] += nominal.rate[s];
  }
  return columns;
}

FixedPart nominal_part(const Design& design, const Model& model, const Covered& covered) {
  FixedPart fixed;
  const auto add = [&](std::vector<VectorXd>& sum, const Term& term, const BandColumns& columns) {
    const Candidate& c = *term.candidate;
    const auto t = static_cast<std::size_t>(&c - design.problem().baseline.data());
    if (sum.empty())
      for (const Segment& s : design.segments()) sum.push_back(VectorXd::Zero(2 * s.bins));
    for (std::size_t p = 0; p < c.linear.size(); ++p) {
      if (!covered.empty() && !covered[t][p]) continue;
      const Index at = column_of(design, c, static_cast<int>(p));
      for (std::size_t s = 0; s < columns.size(); ++s)
        if (columns[s].cols() > 0) sum[s] += c.linear[p].nominal.value_or(0.0) * columns[s].col(at);
    }
  };
  for (const Term& term : model.terms) {
    if (!term.baseline) continue;
    const auto& linear = term.candidate->linear;
    if (std::none_of(linear.begin(), linear.end(),
                     [](const LinearParameter& p) { return p.nominal.value_or(0.0) != 0.0; }))
      continue;
    add(fixed.value, term, term.columns);
    add(fixed.rate, term,
        term.columns.rates([&] { return design.columns(*term.candidate, term.nonlinear, 1); }));
  }
  return fixed;
}

std::vector<VectorXd> said_unfiltered(const Design& design, const DeviationTerms& parts,
                                      const VectorXd& coefficients) {
  std::vector<VectorXd> said;
  for (std::size_t s = 0; s < design.segments().size(); ++s) {
    const Segment& segment = design.segments()[s];
    const auto channel = static_cast<std::size_t>(segment.channel);
    const Recording& log = design.recording(segment.recording);
    VectorXd sum = log.known.empty() ? VectorXd::Zero(log.time.size()) : log.known[channel];
    // Columns of a term that acts there, times the value of each of its shared parameters.
    const auto add = [&](const Candidate& c, const VectorXd& shape, const auto& value_of) {
      if (!acts_on(c, segment.channel)) return;
      const MatrixXd columns = c.columns(log, segment.channel, shape);
      for (Index p = 0; p < columns.cols(); ++p)
        if (!c.linear[static_cast<std::size_t>(p)].per_log) sum += value_of(p) * columns.col(p);
    };
    for (std::size_t t = 0; t < parts.nominal.size(); ++t) {
      const Candidate& c = *parts.nominal[t].candidate;
      add(c, parts.nominal[t].nonlinear, [&](Index p) {
        const auto i = static_cast<std::size_t>(p);
        return parts.covered[t][i] ? c.linear[i].nominal.value_or(0.0) : 0.0;
      });
    }
    const std::vector<Index> first = first_columns(parts.base);
    for (std::size_t t = 0; t < parts.base.terms.size(); ++t) {
      const Candidate& c = *parts.base.terms[t].candidate;
      if (c.kind == CandidateKind::delay || first[t + 1] == first[t]) continue;
      add(c, parts.base.terms[t].nonlinear, [&](Index p) {
        return coefficients(first[t] + column_of(design, c, static_cast<int>(p)));
      });
    }
    said.push_back(std::move(sum));
  }
  return said;
}

DeviationTerms take_apart(const Design& design, const Model& model) {
  const Problem& problem = design.problem();
  const Covered covered = covered_coefficients(problem);
  DeviationTerms parts;
  parts.base.advance = model.advance;
  parts.base.target = model.target;
  parts.base.fixed = nominal_part(design, model, covered);
  for (std::size_t s = 0; s < parts.base.fixed.value.size(); ++s)
    parts.base.target[s] -= parts.base.fixed.value[s];
  for (const Term& term : model.terms) {
    if (!term.baseline) {
      parts.base.terms.push_back(term);
      parts.base.terms.back().with_prior = true;
      continue;
    }
    const auto& mine = covered[static_cast<std::size_t>(term.candidate - problem.baseline.data())];
    parts.nominal.push_back({term.candidate, true, term.nonlinear, {}});
    parts.covered.push_back(mine);
    if (std::all_of(mine.begin(), mine.end(), [](bool c) { return c; })) continue;
    parts.base.terms.push_back(free_part(design, term, mine, parts.made));
  }
  for (int i = 0; i < static_cast<int>(problem.deviations.size()); ++i)
    parts.deviations.push_back(deviation_term(design, model, parts.base.fixed, i, parts.made));
  return parts;
}

}  // namespace sinew::diagnosis
