// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/unexplained.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "identification/refine.h"
#include "identification/spectrum.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kWorthSaying = 0.04;  // share of the remaining loss a dependence must explain
constexpr double kNamesHold = 0.7;     // share of all structure the names must account for

enum class Variable { position, velocity, time, load };

struct Family {
  Variable variable;
  bool by_direction;
  int count;
  const char* depends_on;
};

VectorXd values(const Recording& log, Variable variable, int axis) {
  switch (variable) {
    case Variable::position:
      return log.q.col(axis);
    case Variable::velocity:
      return log.qd.col(axis);
    case Variable::time:
      return log.time.array() - log.time(0);
    case Variable::load:
      return log.load.col(axis);
  }
  return {};
}

Candidate make_family(const Family& family, double low, double high, double soft, int axis,
                      int channel) {
  Candidate c;
  c.name = std::string("any dependence on ") + family.depends_on;
  c.place = "axis " + std::to_string(axis + 1);
  c.kind = CandidateKind::flexible;
  c.depends_on = family.depends_on;
  c.channels = {channel};
  for (int k = 0; k < family.count; ++k)
    c.linear.push_back({std::string("b").append(std::to_string(k)), "", -1e300, 1e300, false, {}});
  c.columns = [family, low, high, soft, axis](const Recording& log, int, const VectorXd&) {
    MatrixXd basis = spline_basis(values(log, family.variable, axis), low, high, family.count);
    if (family.by_direction)
      basis = (log.qd.col(axis).array() / soft).tanh().matrix().asDiagonal() * basis;
    return basis;
  };
  return c;
}

/// Sine and cosine of any period in position, from two turns over the range to what is visible.
Candidate make_any_period(const FlexibleRanges& r, int axis, int channel) {
  Candidate c;
  c.name = "any period in position";
  c.place = "axis " + std::to_string(axis + 1);
  c.kind = CandidateKind::flexible;
  c.depends_on = "position, periodically";
  c.channels = {channel};
  const double reach = r.high - r.low;
  // Faster than 50 Hz at half the top speed would be out of the band.
  const double most = std::max(4.0, std::min(80.0, 100.0 * reach / r.speed));
  c.nonlinear = {{"turns per unit", "", 2.0 / reach, most / reach,
                  static_cast<int>(2.0 * (most - 2.0)), false}};
  for (const char* name : {"sine", "cosine"})
    c.linear.push_back({name, "", -1e300, 1e300, true, {}});
  c.columns = [axis](const Recording& log, int, const VectorXd& p) {
    const Eigen::ArrayXd angle = 2.0 * std::numbers::pi * p(0) * log.q.col(axis).array();
    MatrixXd x(angle.size(), 2);
    x.col(0) = angle.sin();
    x.col(1) = angle.cos();
    return x;
  };
  return c;
}

/// A flexible family on top of a model.
struct Flexible {
  int candidate = -1;
  double p_family = 1.0;
  Model model;
  Gain gain;
  double loss = 0.0;
};

double plain_loss(const Design& design, const Settings& settings, const Model& model,
                  const NoiseView& noise) {
  return cross_validate(design, model, noise.weights, settings.blocks).plain.sum();
}

/// The flexible family that takes most of the loss away, if any is significant and worth it.
Flexible best_flexible(const Design& design, const Settings& settings, const Model& model,
                       const NoiseView& noise, const Screening& screening) {
  Flexible best;
  const VectorXd before = cross_validate(design, model, noise.weights, settings.blocks).plain;
  for (const Screened& s : screening.candidates) {
    const Candidate& c = design.problem().library[static_cast<std::size_t>(s.candidate)];
    if (c.kind != CandidateKind::flexible || s.gate != Gate::open) continue;
    const double p = screening.family.p_value(s.surprise);
    if (p > settings.significance) continue;
    Flexible trial{s.candidate, p, model, {}, 0.0};
    append_term(design, noise.weights, c, s.nonlinear, trial.model);
    refine(design, noise.weights, RefineScope::last_term, trial.model);
    const VectorXd after =
        cross_validate(design, trial.model, noise.weights, settings.blocks).plain;
    trial.gain = block_bootstrap_gain(before, after, 0.95, settings.seed);
    trial.loss = after.sum();
    if (trial.gain.share < kWorthSaying) continue;
    if (best.candidate < 0 || trial.loss < best.loss) best = std::move(trial);
  }
  return best;
}

Dependence describe(const Flexible& flexible) {
  const Term& term = flexible.model.terms.back();
  Dependence d{term.candidate->depends_on, term.candidate->place, flexible.p_family, flexible.gain};
  if (term.nonlinear.size() > 0) d.on += ", period " + std::to_string(1.0 / term.nonlinear(0));
  return d;
}

/// A decoy that was accepted is structure without a name: it leaves the model, so that flexible
/// families say what the structure depends on, and is listed with what it explained.
std::vector<Dependence> take_out_decoys(const Design& design, const Settings& settings,
                                        Selection& selection) {
  std::vector<Dependence> list;
  for (std::size_t t = 0; t < selection.model.terms.size();) {
    const Term& term = selection.model.terms[t];
    if (term.baseline || term.candidate->kind != CandidateKind::decoy) {
      ++t;
      continue;
    }
    list.push_back({term.candidate->depends_on, term.candidate->place,
                    selection.evidence[t].p_family, selection.evidence[t].gain});
    remove_term(design, t, selection.model);
    selection.evidence.erase(selection.evidence.begin() + static_cast<std::ptrdiff_t>(t));
  }
  if (list.empty()) return list;
  selection.noise = own_noise(design, selection.model, settings.threads);
  refine(design, selection.noise.weights, RefineScope::all_terms, selection.model);
  selection.noise = own_noise(design, selection.model, settings.threads);
  return list;
}

/// Names whose part the flexible terms take over.
void withdraw(const Design& design, const Settings& settings, const Model& with_flexible,
              Selection& selection, Unexplained& result) {
  const NoiseView noise = own_noise(design, with_flexible, settings.threads);
  const double full = plain_loss(design, settings, with_flexible, noise);
  const double named = plain_loss(design, settings, selection.model, selection.noise);
  std::vector<const Candidate*> gone;
  for (std::size_t t = 0; t < with_flexible.terms.size(); ++t) {
    const Term& term = with_flexible.terms[t];
    if (term.baseline || term.candidate->kind == CandidateKind::flexible) continue;
    Model without = with_flexible;
    remove_term(design, t, without);
    const double beside = plain_loss(design, settings, without, noise) - full;
    Model alone = selection.model;
    std::size_t at = 0;
    while (alone.terms[at].candidate != term.candidate) ++at;
    remove_term(design, at, alone);
    const double before = plain_loss(design, settings, alone, selection.noise) - named;
    if (beside < 0.4 * before) gone.push_back(term.candidate);
  }
  for (const Candidate* candidate : gone) {
    std::size_t at = 0;
    while (selection.model.terms[at].candidate != candidate) ++at;
    remove_term(design, at, selection.model);
    selection.evidence.erase(selection.evidence.begin() + static_cast<std::ptrdiff_t>(at));
    result.withdrawn.push_back(candidate->name);
  }
}

}  // namespace

MatrixXd spline_basis(const VectorXd& x, double low, double high, int count) {
  const int intervals = std::max(1, count - 3);
  MatrixXd basis = MatrixXd::Zero(x.size(), count);
  for (Index i = 0; i < x.size(); ++i) {
    const double u = std::clamp((x(i) - low) / (high - low), 0.0, 1.0) * intervals;
    const int k = std::min(static_cast<int>(u), intervals - 1);
    const double t = u - k, r = 1.0 - t;
    const double weights[4] = {r * r * r / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0,
                               (-3.0 * t * t * t + 3.0 * t * t + 3.0 * t + 1.0) / 6.0,
                               t * t * t / 6.0};
    for (int j = 0; j < 4 && k + j < count; ++j) basis(i, k + j) = weights[j];
  }
  return basis;
}

std::vector<Candidate> flexible_families(const FlexibleRanges& r, int axis, int channel) {
  const double soft = 1e-2 * r.speed;
  std::vector<Candidate> list;
  const auto add = [&](const Family& family, double low, double high) {
    if (high > low) list.push_back(make_family(family, low, high, soft, axis, channel));
  };
  add({Variable::position, false, 12, "position"}, r.low, r.high);
  add({Variable::position, true, 12, "position x direction"}, r.low, r.high);
  add({Variable::velocity, false, 14, "velocity"}, -r.speed, r.speed);
  add({Variable::time, false, 10, "time"}, 0.0, r.duration);
  add({Variable::time, true, 10, "time x direction"}, 0.0, r.duration);
  if (r.load > 0.0) {
    add({Variable::load, false, 8, "load"}, -r.load, r.load);
    add({Variable::load, true, 8, "load x direction"}, -r.load, r.load);
  }
  if (r.high > r.low && r.speed > 0.0) list.push_back(make_any_period(r, axis, channel));
  return list;
}

SpectralLine strongest_line(const Design& design, const Model& model) {
  SpectralLine best;
  double tests = 0.0;
  for (const Segment& s : design.segments())
    if (!s.holdout) tests += static_cast<double>(s.bins);
  for (std::size_t i = 0; i < design.segments().size(); ++i) {
    const Segment& s = design.segments()[i];
    if (s.holdout) continue;
    Index wide = 0;
    for (const Term& term : model.terms) wide += term.columns[i].cols();
    MatrixXd x(2 * s.bins, wide);
    wide = 0;
    for (const Term& term : model.terms) {
      if (term.columns[i].cols() == 0) continue;  // does not act on this channel
      x.middleCols(wide, term.columns[i].cols()) = term.columns[i];
      wide += term.columns[i].cols();
    }
    const VectorXd residual = model.target[i] - x * (scaled_pseudo_inverse(x.transpose() * x) *
                                                     (x.transpose() * model.target[i]));
    const VectorXd energy = bin_energy(residual);
    const VectorXd around = smooth_ratio(energy, VectorXd::Ones(s.bins), 12, 0.12);
    for (Index b = 2; b + 2 < s.bins; ++b) {
      const double half = std::max(12.0, 0.12 * static_cast<double>(b));
      const double peak = energy.segment(b - 1, 3).maxCoeff();
      // The neighbourhood without the line itself.
      const double level = std::max(
          (around(b) * (2.0 * half + 1.0) - energy.segment(b - 2, 5).sum()) / (2.0 * half - 4.0),
          0.05 * around(b));
      const double p =
          -std::expm1(tests * std::log1p(-std::min(std::exp(-peak / level), 0.999999)));
      if (p < best.p_value)
        best = {static_cast<double>(b) * s.rate_hz / static_cast<double>(s.samples), p,
                (energy.segment(b - 1, 3).sum() - 3.0 * level) / energy.sum()};
    }
  }
  return best;
}

Unexplained find_unexplained(const Design& design, const Library& library, const Settings& settings,
                             Selection& selection) {
  Unexplained result;
  const std::vector<Dependence> decoys = take_out_decoys(design, settings, selection);
  const double named = plain_loss(design, settings, selection.model, selection.noise);
  Model model = selection.model;
  NoiseView noise = selection.noise;
  double last = named;
  for (int round = 0; round < 3; ++round) {
    draw_surrogates(design, settings, noise);
    const Screening screening =
        screen(design, library, model, noise.weights, noise.surrogates, settings.threads);
    Flexible best = best_flexible(design, settings, model, noise, screening);
    if (best.candidate < 0) break;
    result.depends_on.push_back(describe(best));
    model = std::move(best.model);
    noise = own_noise(design, model, settings.threads);
    last = best.loss;
  }
  const double base = selection.baseline_loss;
  result.remaining = named / base;
  for (const Dependence& decoy : decoys) result.depends_on.push_back(decoy);
  std::stable_sort(
      result.depends_on.begin(), result.depends_on.end(),
      [](const Dependence& a, const Dependence& b) { return a.gain.share > b.gain.share; });
  const SpectralLine line = strongest_line(design, model);
  // A line that stands out and is next to nothing is worth nobody's time.
  if (line.p_value < settings.significance && line.share > settings.least_share) {
    Dependence d;
    d.on = "time, periodically, " + std::to_string(line.frequency_hz) + " Hz";
    d.p_family = line.p_value;
    d.gain.share = d.gain.low = d.gain.high = line.share;
    result.depends_on.push_back(d);
  }
  if (result.depends_on.empty()) return result;
  // What the decoys took away was structure, too, though no flexible family needs to have found it.
  double by_decoys = 0.0;
  for (const Dependence& decoy : decoys) by_decoys += decoy.gain.share * named;
  last = std::min(last, named - by_decoys);
  result.named_share = base > last ? std::clamp((base - named) / (base - last), 0.0, 1.0) : 0.0;
  const bool any_name = std::any_of(selection.model.terms.begin(), selection.model.terms.end(),
                                    [](const Term& t) { return !t.baseline; });
  if (any_name && result.named_share < kNamesHold)
    withdraw(design, settings, model, selection, result);
  result.none_of_the_known = !any_name || result.named_share < kNamesHold;
  return result;
}

}  // namespace sinew::diagnosis
