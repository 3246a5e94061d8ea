// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/adoption/observed_extension.h"

#include <Eigen/QR>
#include <algorithm>
#include <map>

#include "identification/diagnosis/form_errors.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kRounds = 4;  // Gauss-Newton steps from the linear estimate

/// The entry of an effect at a place, made where there is none.
IdentifiedEffect& entry_of(Identified& identified, const ObservationEffect& effect) {
  for (IdentifiedEffect& entry : identified.effects)
    if (entry.effect == effect.id && entry.place == effect.place) return entry;
  IdentifiedEffect entry;
  entry.effect = effect.id;
  entry.place = effect.place;
  for (const ObservationParameter& p : effect.shapes)
    entry.shape.push_back({p.name, p.high, 0.0, p.unit});
  for (const ObservationParameter& p : effect.deviations)
    entry.coefficients.push_back({p.name, 0.0, 0.0, p.unit});
  identified.effects.push_back(std::move(entry));
  return identified.effects.back();
}

/// A named effect's place among the open observation's deviations.
struct Free {
  const ObservationEffect* effect;
  std::size_t parameter;
  Index at;
};

/// Residual and derivatives of all training channels behind the filter, each channel in units of
/// its own residual.
class Linearised {
 public:
  Linearised(const ObservedSubject& subject, const Design& design) : s_(subject), design_(design) {}

  MatrixXd columns;
  VectorXd residual;

  void at(const VectorXd& deviation, const VectorXd& shape, const std::vector<Free>& free) {
    std::map<int, std::vector<MatrixXd>> runs;
    std::vector<MatrixXd> parts;
    Index rows = 0;
    for (std::size_t i = 0; i < design_.segments().size(); ++i) {
      const Segment& segment = design_.segments()[i];
      if (segment.holdout) continue;
      if (!runs.contains(segment.recording))
        runs[segment.recording] =
            runs_of(design_.recording(segment.recording), deviation, shape, free);
      parts.push_back(part_of(static_cast<int>(i), runs[segment.recording]));
      rows += parts.back().rows();
    }
    columns.resize(rows, static_cast<Index>(free.size()));
    residual.resize(rows);
    Index row = 0;
    for (const MatrixXd& part : parts) {
      residual.segment(row, part.rows()) = part.col(0);
      columns.middleRows(row, part.rows()) = part.rightCols(columns.cols());
      row += part.rows();
    }
  }

 private:
  /// What the model says, and its derivatives by every free deviation.
  std::vector<MatrixXd> runs_of(const Recording& log, const VectorXd& deviation,
                                const VectorXd& shape, const std::vector<Free>& free) const {
    std::vector<MatrixXd> all{s_.open()(log, deviation, shape)};
    for (const Free& f : free) {
      const double step = f.effect->deviations[f.parameter].step;
      VectorXd up = deviation, down = deviation;
      up(f.at) += step;
      down(f.at) -= step;
      all.push_back((s_.open()(log, up, shape) - s_.open()(log, down, shape)) / (2.0 * step));
    }
    return all;
  }

  MatrixXd part_of(int index, const std::vector<MatrixXd>& runs) {
    const Segment& segment = design_.segments()[static_cast<std::size_t>(index)];
    const auto c = static_cast<Index>(segment.channel);
    const Recording& log = design_.recording(segment.recording);
    MatrixXd raw(log.time.size(), static_cast<Index>(runs.size()));
    raw.col(0) = log.target[static_cast<std::size_t>(c)] - runs[0].col(c);
    for (std::size_t k = 1; k < runs.size(); ++k) raw.col(static_cast<Index>(k)) = runs[k].col(c);
    MatrixXd part = design_.filtered(index, raw);
    const bool zero =
        std::any_of(s_.problem().baseline.begin(), s_.problem().baseline.end(),
                    [&](const Candidate& b) { return b.channels.front() == segment.channel; });
    if (zero) part = (part.rowwise() - part.colwise().mean()).eval();
    // The first look sets the units; they stay, so that every round asks the same question.
    if (!units_.contains(index))
      units_[index] =
          std::max(part.col(0).norm() / std::sqrt(static_cast<double>(part.rows())), 1e-300);
    return part / units_[index];
  }

  const ObservedSubject& s_;
  const Design& design_;
  std::map<int, double> units_;
};

struct Learning {
  VectorXd deviation, shape;
  std::vector<Free> free;
};

Index first_of(const Observation& observation, int effect, bool shapes) {
  Index at = 0;
  for (int i = 0; i < effect; ++i) {
    const ObservationEffect& e = observation.effects[static_cast<std::size_t>(i)];
    at += static_cast<Index>(shapes ? e.shapes.size() : e.deviations.size());
  }
  return at;
}

}  // namespace

Identified extended_observation(const ObservedSubject& subject, const Design& design,
                                const Explanation& explanation) {
  const Selection& selection = explanation.selection;
  const auto all = told_estimates(design, selection.model, selection.noise);
  const Observation& observation = subject.observation();
  Learning l{subject.learnt(), subject.shapes(), {}};
  Identified result = subject.identified();
  std::vector<std::pair<Free, double>> errors;
  for (std::size_t t = 0; t < selection.model.terms.size(); ++t) {
    const Term& term = selection.model.terms[t];
    if (term.baseline || term.candidate->kind != CandidateKind::named) continue;
    const auto c = static_cast<std::size_t>(term.candidate - subject.problem().library.data());
    const int index = subject.origins()[c].effect;
    if (index < 0) continue;
    const ObservationEffect& effect = observation.effects[static_cast<std::size_t>(index)];
    const Index at = first_of(observation, index, false),
                shape = first_of(observation, index, true);
    for (Index k = 0; k < term.nonlinear.size(); ++k) l.shape(shape + k) = term.nonlinear(k);
    for (std::size_t p = 0; p < effect.deviations.size(); ++p) {
      const Index place = at + static_cast<Index>(p);
      for (const ParameterEstimate& e : all[t])
        if (e.name == effect.deviations[p].name) {
          l.deviation(place) += e.value;
          errors.push_back({{&effect, p, place}, e.standard_error});
        }
      l.free.push_back({&effect, p, place});
    }
    entry_of(result, effect);
  }
  if (l.free.empty()) return result;
  Linearised linearised(subject, design);
  for (int i = 0; i < kRounds; ++i) {
    linearised.at(l.deviation, l.shape, l.free);
    const VectorXd change = linearised.columns.colPivHouseholderQr().solve(linearised.residual);
    if (!change.allFinite()) break;
    for (std::size_t k = 0; k < l.free.size(); ++k) {
      const ObservationParameter& p = l.free[k].effect->deviations[l.free[k].parameter];
      double& value = l.deviation(l.free[k].at);
      value = std::clamp(value + change(static_cast<Index>(k)), p.low, p.high);
    }
  }
  for (const Free& f : l.free) {
    IdentifiedEffect& entry = entry_of(result, *f.effect);
    entry.coefficients[f.parameter].value = l.deviation(f.at);
    for (const auto& [of, error] : errors)
      if (of.at == f.at) entry.coefficients[f.parameter].standard_error = error;
    const auto index = static_cast<int>(f.effect - observation.effects.data());
    const Index shape = first_of(observation, index, true);
    for (std::size_t k = 0; k < entry.shape.size(); ++k)
      entry.shape[k].value = l.shape(shape + static_cast<Index>(k));
  }
  return result;
}

std::vector<MeasuredChannel> measure_observation(const ObservedSubject& subject,
                                                 const Design& design, const Identified& after,
                                                 bool free_zero) {
  const auto closed = [&](const Identified& identified) {
    return ObservedModel(subject.observation().model,
                         closed_observation(subject.observation(), identified), subject.runtime());
  };
  ObservedModel model_before = closed(subject.identified()), model_after = closed(after);
  model_before.set_units(subject.units());
  model_after.set_units(subject.units());
  std::map<int, std::pair<MatrixXd, MatrixXd>> said;
  std::vector<MeasuredChannel> result;
  for (std::size_t i = 0; i < design.segments().size(); ++i) {
    const Segment& s = design.segments()[i];
    const Recording& log = design.recording(s.recording);
    const int segment = static_cast<int>(i);
    if (!said.contains(s.recording)) said[s.recording] = {model_before(log), model_after(log)};
    MeasuredChannel m;
    m.recording = s.recording;
    m.channel = s.channel;
    m.held_out = s.holdout;
    m.step = 1.0 / s.rate_hz;
    m.band_hz = s.filter.band_hz;
    const auto c = static_cast<Index>(s.channel);
    m.time = design.at_instants(segment, log.time);
    m.position = design.at_instants(segment, log.q.col(0));
    m.velocity = design.at_instants(segment, log.qd.col(0));
    if (log.load.size() > 0) m.load = design.at_instants(segment, log.load.col(0));
    m.measured = design.filtered(segment, log.target[static_cast<std::size_t>(c)]);
    m.before = design.filtered(segment, said[s.recording].first.col(c));
    m.after = design.filtered(segment, said[s.recording].second.col(c));
    if (free_zero) {
      m.before.array() += (m.measured - m.before).mean();
      m.after.array() += (m.measured - m.after).mean();
    }
    for (VectorXd* x : {&m.measured, &m.before, &m.after}) *x *= subject.units()(c);
    result.push_back(std::move(m));
  }
  return result;
}

int observation_operations(const ObservedSubject& subject, const Identified& identified) {
  return ObservedModel(subject.observation().model,
                       closed_observation(subject.observation(), identified), subject.runtime())
      .operations();
}

}  // namespace sinew::diagnosis
