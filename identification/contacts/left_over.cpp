// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/contacts/left_over.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "identification/contacts/channelwise_fit.h"
#include "identification/regression/spectrum.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A term as the design sees it, its rows samples.
Term in_time(const Design& design, const Term& term) {
  Term moved = term;
  BandColumns columns = design.columns(*term.candidate, term.nonlinear);
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (columns[i].size() > 0) columns[i] = from_band(columns[i], design.segments()[i].samples);
  moved.columns = std::move(columns);
  return moved;
}

LeftOver empty_recording(const Design& design, std::size_t segment) {
  const Segment& s = design.segments()[segment];
  const int channels = design.problem().channels;
  LeftOver r;
  r.recording = s.recording;
  r.held_out = s.holdout;
  r.time = design.at_instants(static_cast<int>(segment), design.recording(s.recording).time);
  r.measured = r.residual = r.explained = r.within_step = r.extrapolated = r.counts = r.position =
      r.velocity = MatrixXd::Zero(s.samples, channels);
  r.rate_hz = s.rate_hz;
  r.step = design.recording(s.recording).step;
  r.band_hz = s.filter.band_hz;
  r.reach = static_cast<double>(s.filter.half_width) * s.filter.step;
  return r;
}

/// Whether it is friction of the model: what turns over a way that is fitted.
bool is_turning(const Term& term) {
  return term.baseline && term.nonlinear.size() > 0;
}

/// Change of a signal in a part of the time between its samples, to either side the larger one.
VectorXd change_within(const VectorXd& x, double part) {
  VectorXd change = VectorXd::Zero(x.size());
  for (Index k = 0; k + 1 < x.size(); ++k) {
    const double one = part * std::abs(x(k + 1) - x(k));
    change(k) = std::max(change(k), one);
    change(k + 1) = one;
  }
  return change;
}

}  // namespace

Design evenly_banded(const Problem& problem, Settings settings) {
  for (const auto* logs : {&problem.training, &problem.holdout})
    for (const Recording& log : *logs)
      for (const double band : log.band_hz)
        settings.band_hz = settings.band_hz > 0.0 ? std::min(settings.band_hz, band) : band;
  settings.every_sample = true;
  return {problem, settings};
}

FitInTime::FitInTime(const Design& design, const Model& model) {
  for (const Term& term : model.terms)  // what a delay moves is in the target
    if (term.candidate->kind != CandidateKind::delay) model_.terms.push_back(in_time(design, term));
  for (std::size_t i = 0; i < design.segments().size(); ++i) {
    const Segment& s = design.segments()[i];
    if (recordings_.empty() || recordings_.back().recording != s.recording)
      recordings_.push_back(empty_recording(design, i));
    LeftOver& r = recordings_.back();
    if (s.samples != r.time.size())
      throw std::invalid_argument("channels of one log have different lengths");
    const double advance = i < model.advance.size() ? model.advance[i] : 0.0;
    const int segment = static_cast<int>(i);
    model_.target.push_back(from_band(design.target(segment, advance), s.samples));
    const Recording& log = design.recording(s.recording);
    r.measured.col(s.channel) =
        design.filtered(segment, log.target[static_cast<std::size_t>(s.channel)]);
    r.position.col(s.channel) = design.at_instants(segment, log.q.col(s.channel));
    r.velocity.col(s.channel) = design.at_instants(segment, log.qd.col(s.channel));
    r.counts.col(s.channel) = design.motion_window_of(segment);
    place_.emplace_back(recordings_.size() - 1, s.channel);
  }
  expect_no_more_than_measured();
}

void FitInTime::expect_no_more_than_measured() {
  const VectorXd measured = measured_rms().cwiseMax(1e-300);
  const std::vector<Index> first = first_columns(model_);
  expected_ = VectorXd::Zero(first.back());
  for (std::size_t t = 0; t < model_.terms.size(); ++t)
    for (std::size_t i = 0; i < place_.size(); ++i) {
      const MatrixXd& columns = model_.terms[t].columns[i];
      if (columns.cols() == 0) continue;
      const double most = std::pow(measured(place_[i].second), 2);
      const VectorXd made =
          columns.colwise().squaredNorm() / static_cast<double>(columns.rows()) / most;
      auto own = expected_.segment(first[t], columns.cols());
      own = own.cwiseMax(made);
    }
}

VectorXd FitInTime::columns_at(std::size_t segment, Index sample,
                               const std::vector<Index>& first) const {
  VectorXd all = VectorXd::Zero(first.back());
  for (std::size_t t = 0; t < model_.terms.size(); ++t) {
    const MatrixXd& columns = model_.terms[t].columns[segment];
    if (columns.cols() > 0) all.segment(first[t], columns.cols()) = columns.row(sample);
  }
  return all;
}

VectorXd FitInTime::measured_rms() const {
  VectorXd sum = VectorXd::Zero(recordings_.front().measured.cols());
  double count = 0.0;
  for (const LeftOver& r : recordings_) {
    if (r.held_out) continue;
    sum += r.measured.colwise().squaredNorm().transpose();
    count += static_cast<double>(r.time.size());
  }
  return (sum / std::max(count, 1.0)).cwiseSqrt();
}

std::vector<LeftOver> FitInTime::operator()(const std::vector<SetAside>& aside,
                                            const VectorXd& sizes) const {
  Weights weights;
  for (const auto& [recording, channel] : place_) {
    const LeftOver& r = recordings_[recording];
    const VectorXd in = (!aside[recording]).cast<double>().matrix();
    weights.push_back(r.held_out
                          ? VectorXd()
                          : VectorXd(r.counts.col(channel).cwiseProduct(in) / sizes(channel)));
  }
  std::vector<int> channels;
  for (const auto& [recording, channel] : place_) channels.push_back(channel);
  Stack rows = stack(model_, weights);
  rows.prior += expected_;
  const ChannelwiseFit fit(rows, channels);
  const VectorXd& coefficients = fit.coefficients();
  std::vector<const BandColumns*> columns;
  for (const Term& term : model_.terms) columns.push_back(&term.columns.get());
  VectorXd of_causes = coefficients, turning = coefficients;
  const std::vector<Index> first = first_columns(model_);
  for (std::size_t t = 0; t < model_.terms.size(); ++t) {
    const Index wide = first[t + 1] - first[t];
    if (model_.terms[t].baseline) of_causes.segment(first[t], wide).setZero();
    if (!is_turning(model_.terms[t])) turning.segment(first[t], wide).setZero();
  }
  std::vector<LeftOver> result = recordings_;
  for (std::size_t i = 0; i < place_.size(); ++i) {
    const auto& [recording, channel] = place_[i];
    VectorXd rest = model_.target[i];
    const VectorXd said = predict(columns, coefficients, i);
    if (said.size() > 0) rest -= said;
    LeftOver& r = result[recording];
    r.residual.col(channel) = rest;
    for (Index k = 0; k < rest.size(); ++k)
      if (aside[recording](k))
        r.extrapolated(k, channel) = std::sqrt(fit.variance(columns_at(i, k, first)));
    const VectorXd explained = predict(columns, of_causes, i);
    if (explained.size() > 0) r.explained.col(channel) = explained;
    // Friction turns with the speed, inertia with the acceleration: what jumps in both may undo
    // itself in their sum.
    VectorXd friction = predict(columns, turning, i);
    if (friction.size() == 0) friction = VectorXd::Zero(rest.size());
    const double step = r.step * r.rate_hz;
    const VectorXd others = r.measured.col(channel) - rest - friction;
    r.within_step.col(channel) =
        (change_within(friction, step).cwiseAbs2() + change_within(others, step).cwiseAbs2())
            .cwiseSqrt();
  }
  return result;
}

}  // namespace sinew::diagnosis
