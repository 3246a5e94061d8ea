// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/design.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "identification/regression/inner_loop.h"
#include "identification/regression/spectrum.h"
#include "identification/regression/standstill.h"
#include "identification/regression/thinned_recording.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Index edge_samples(const Settings& settings, double step) {
  return static_cast<Index>(std::lround(settings.edge_s / step));
}

}  // namespace

std::vector<int> noise_group(const Problem& problem, int channel) {
  if (problem.noise_groups.empty()) return {channel};
  const int own = problem.noise_groups[static_cast<std::size_t>(channel)];
  std::vector<int> group;
  for (int c = 0; c < problem.channels; ++c)
    if (problem.noise_groups[static_cast<std::size_t>(c)] == own) group.push_back(c);
  return group;
}

void Design::set_units(const VectorXd& units) {
  units_ = units;
  for (int c = 0; c < problem_.channels; ++c) {
    const std::vector<int> group = noise_group(problem_, c);
    units_(c) = std::sqrt(units(group).squaredNorm() / static_cast<double>(group.size()));
  }
}

Design::Design(const Problem& problem, const Settings& settings)
    : problem_(problem), settings_(settings), units_(VectorXd::Ones(problem.channels)) {
  add_segments(problem.training, 0, false);
  if (segments_.empty())
    throw std::invalid_argument(
        (problem.training.empty() ? std::string("the training logs") : problem.training[0].name) +
        ": no stretch without a gap is long enough to compare with the model; log for longer, or "
        "see what cuts it: values that stand still for many rows, gaps and spikes are left out");
  add_segments(problem.holdout, static_cast<int>(problem.training.size()), true);
}

void Design::add_segments(const std::vector<Recording>& recordings, int first, bool holdout) {
  for (std::size_t r = 0; r < recordings.size(); ++r) {
    const double band = highest_compared(recordings[r], settings_);
    const int index = first + static_cast<int>(r);
    const DecimatingFilter thinning = thinning_filter(recordings[r].step, band);
    if (thinning.factor > 1)
      thinned_[index] = {thinning, diagnosis::thinned(recordings[r], thinning)};
    const Recording& log = recording(index);
    for (int channel = 0; channel < static_cast<int>(log.target.size()); ++channel) {
      const Index raw = log.target[static_cast<std::size_t>(channel)].size();
      if (raw == 0) continue;
      Segment segment;
      segment.recording = index;
      segment.channel = channel;
      segment.holdout = holdout;
      const double seen = log.band_hz.empty()
                              ? band
                              : std::min(band, log.band_hz[static_cast<std::size_t>(channel)]);
      segment.filter = design_decimating_filter(log.step, std::min(seen, 0.4 / log.step));
      segment.samples =
          filtered_length(segment.filter, raw - 2 * edge_samples(settings_, log.step));
      if (segment.samples == 0) continue;
      segment.rate_hz = 1.0 / (log.step * segment.filter.factor);
      if (!log.target[static_cast<std::size_t>(channel)].allFinite())
        throw std::invalid_argument("log '" + log.name + "', channel " + std::to_string(channel) +
                                    ": the target is not finite everywhere");
      segment.bins = std::min<Index>(segment.samples / 2,
                                     static_cast<Index>(segment.filter.band_hz / segment.rate_hz *
                                                        static_cast<double>(segment.samples)) +
                                         1);
      segments_.push_back(segment);
      windows_.push_back(settings_.every_sample
                             ? VectorXd(VectorXd::Ones(segment.samples))
                             : VectorXd(motion_window_of(static_cast<int>(segments_.size()) - 1)
                                            .cwiseProduct(end_taper(segment.samples))));
    }
  }
}

/// 1 where what is measured counts, at the decimated instants.
VectorXd Design::motion_window_of(int segment) const {
  const Segment& s = segments_[static_cast<std::size_t>(segment)];
  const Recording& log = recording(s.recording);
  const auto channel = static_cast<std::size_t>(s.channel);
  std::vector<Standstill> left_out = log.disturbed;
  if (log.standstills.size() > channel)
    left_out.insert(left_out.end(), log.standstills[channel].begin(),
                    log.standstills[channel].end());
  if (left_out.empty()) return VectorXd::Ones(s.samples);
  return motion_window(left_out, at_instants(segment, log.time));
}

MatrixXd Design::seen_band(int segment, const MatrixXd& samples) const {
  const auto i = static_cast<std::size_t>(segment);
  return to_band(windows_[i].asDiagonal() * samples, segments_[i].bins);
}

const Recording& Design::recording(int index) const {
  const auto found = thinned_.find(index);
  return found == thinned_.end() ? given(index) : found->second.log;
}

MatrixXd Design::thinned(int segment, const MatrixXd& raw) const {
  const int index = segments_[static_cast<std::size_t>(segment)].recording;
  const auto found = thinned_.find(index);
  if (found == thinned_.end() || raw.rows() != given(index).q.rows()) return raw;
  return filter_decimate(found->second.filter, raw);
}

const Recording& Design::given(int index) const {
  const auto training = problem_.training.size();
  const auto i = static_cast<std::size_t>(index);
  return i < training ? problem_.training[i] : problem_.holdout[i - training];
}

MatrixXd Design::filtered(int segment, const MatrixXd& as_given, double advance,
                          int derivative) const {
  const Segment& s = segments_[static_cast<std::size_t>(segment)];
  const MatrixXd raw = thinned(segment, as_given);
  const Index edge = edge_samples(settings_, s.filter.step);
  return filter_decimate(s.filter, raw.middleRows(edge, raw.rows() - 2 * edge), advance, derivative)
      .topRows(s.samples);
}

VectorXd Design::at_instants(int segment, const VectorXd& as_given) const {
  const Segment& s = segments_[static_cast<std::size_t>(segment)];
  const VectorXd raw = thinned(segment, as_given);
  const Index edge = edge_samples(settings_, s.filter.step);
  VectorXd out(s.samples);
  for (Index k = 0; k < s.samples; ++k) out(k) = raw(edge + centre_sample(s.filter, k));
  return out;
}

bool acts_on(const Candidate& candidate, int channel) {
  return candidate.channels.empty() ||
         std::find(candidate.channels.begin(), candidate.channels.end(), channel) !=
             candidate.channels.end();
}

VectorXd Design::in_band(int segment, const VectorXd& raw, double advance) const {
  return seen_band(segment, filtered(segment, raw, advance));
}

VectorXd Design::target(int segment, double advance) const {
  const Segment& s = segments_[static_cast<std::size_t>(segment)];
  const VectorXd& raw = recording(s.recording).target[static_cast<std::size_t>(s.channel)];
  const VectorXd band = in_band(segment, raw, advance);
  const std::optional<VectorXd> said = known(segment, 0);
  return said ? VectorXd(band - *said) : band;
}

std::optional<VectorXd> Design::known(int segment, int derivative) const {
  const Segment& s = segments_[static_cast<std::size_t>(segment)];
  const Recording& log = recording(s.recording);
  if (log.known.empty()) return std::nullopt;
  const VectorXd& raw = log.known[static_cast<std::size_t>(s.channel)];
  return VectorXd(seen_band(segment, filtered(segment, raw, 0.0, derivative)));
}

int Design::first_of_log(int index) const {
  const auto training = static_cast<int>(problem_.training.size());
  const std::string& log = given(index).log;
  const int start = index < training ? 0 : training;
  if (log.empty()) return index;
  for (int other = start; other < index; ++other)
    if (given(other).log == log) return other;
  return index;
}

int Design::owner_of(const Candidate& candidate, int parameter, int recording) const {
  return candidate.linear[static_cast<std::size_t>(parameter)].per_stretch
             ? recording
             : first_of_log(recording);
}

std::vector<Design::Coefficient> Design::coefficients(const Candidate& candidate) const {
  std::vector<Coefficient> list;
  const int logs = static_cast<int>(problem_.training.size() + problem_.holdout.size());
  for (int p = 0; p < static_cast<int>(candidate.linear.size()); ++p) {
    if (!candidate.linear[static_cast<std::size_t>(p)].per_log) {
      list.push_back({p, -1});
      continue;
    }
    for (int log = 0; log < logs; ++log)
      if (owner_of(candidate, p, log) == log) list.push_back({p, log});
  }
  return list;
}

Index Design::width(const Candidate& candidate) const {
  return static_cast<Index>(coefficients(candidate).size());
}

/// Empty where the candidate does not act.
MatrixXd Design::segment_columns(std::size_t i, const Candidate& candidate,
                                 const VectorXd& nonlinear, int derivative) const {
  const Segment& s = segments_[i];
  if (!acts_on(candidate, s.channel)) return {};
  const MatrixXd raw = candidate.columns(recording(s.recording), s.channel, nonlinear);
  if (raw.cols() == 0) return {};
  if (raw.cols() != static_cast<Index>(candidate.linear.size()))
    throw std::logic_error("candidate '" + candidate.name + "': columns and coefficients differ");
  if (!raw.allFinite())
    throw std::invalid_argument("log '" + recording(s.recording).name + "': the columns of '" +
                                candidate.name + "' are not finite everywhere");
  const MatrixXd band =
      seen_band(static_cast<int>(i), filtered(static_cast<int>(i), raw, 0.0, derivative));
  const std::vector<Coefficient> layout = coefficients(candidate);
  MatrixXd result = MatrixXd::Zero(band.rows(), static_cast<Index>(layout.size()));
  for (std::size_t c = 0; c < layout.size(); ++c)
    if (layout[c].recording < 0 ||
        layout[c].recording == owner_of(candidate, layout[c].parameter, s.recording))
      result.col(static_cast<Index>(c)) = band.col(layout[c].parameter);
  return result;
}

BandColumns Design::columns(const Candidate& candidate, const VectorXd& nonlinear,
                            int derivative) const {
  BandColumns result(segments_.size());
  inner_loop(segments_.size(), [&](std::size_t i) {
    result[i] = segment_columns(i, candidate, nonlinear, derivative);
  });
  return result;
}

BandColumns Design::columns_at(const std::vector<bool>& segments, const Candidate& candidate,
                               const VectorXd& nonlinear) const {
  BandColumns result(segments_.size());
  inner_loop(segments_.size(), [&](std::size_t i) {
    if (segments[i]) result[i] = segment_columns(i, candidate, nonlinear, 0);
  });
  return result;
}

}  // namespace sinew::diagnosis
