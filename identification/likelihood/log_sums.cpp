// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/log_sums.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "identification/diagnosis/materiality.h"
#include "identification/diagnosis/verdict_errors.h"
#include "identification/likelihood/found_slots.h"
#include "identification/logs/sha256.h"
#include "identification/regression/baseline.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;

// What the reference logs say of a log's spectrum, and white noise of theirs, counts as so many
// real rows: ten seconds below 10 Hz. Logs of minutes have spectra of their own.
constexpr double kExpectedRows = 200.0;

Problem shared_by_all_logs(Problem problem) {
  if (!problem.noise_groups.empty())
    throw std::invalid_argument(
        "sums are written of drives, joints and arms whose channels have noise of their own; these "
        "channels share the noise of the forces that they are worked out from");
  problem.holdout.clear();
  for (Candidate& candidate : problem.library)
    for (LinearParameter& p : candidate.linear) p.per_log = false;
  return problem;
}

std::string text_of(const Hypothesis& h) {
  std::string text = fmt::format("{}|{}|{}", h.source->name, h.source->place, h.candidate);
  for (const LinearParameter& p : h.source->linear)
    text += fmt::format("|{} {} {:.9g} {:.9g}", p.name, p.unit, p.low, p.high);
  return text + "\n";
}

}  // namespace

void LogSums::add(const LogSums& other) {
  columns.add(other.columns);
  error += other.error;
}

ReferenceColumns::ReferenceColumns(Problem problem, const Settings& settings)
    : problem_(shared_by_all_logs(std::move(problem))), settings_(settings) {
  Design design(problem_, settings_);
  design.set_units(left_over(design, baseline_model(design)));
  baseline_ = shapes_of(problem_, fitted_baseline(design));
  hypotheses_ = make_hypotheses(design, baseline_with(design, baseline_));
  noise_ = {whitening_of(design, hypotheses_,
                         immaterial_variance(design, settings_, hypotheses_.parts.base),
                         {{}, kExpectedRows})
                .of_channel,
            kExpectedRows};
}

std::string ReferenceColumns::hash() const {
  std::string text;
  for (const Hypothesis& h : hypotheses_.list) text += text_of(h);
  for (const Shape& shape : hypotheses_.shapes) {
    text += fmt::format("{}", shape.hypothesis);
    // Nine digits are the same on every machine, the last bits of a logarithm are not.
    for (const double value : shape.nonlinear) text += fmt::format(" {:.9g}", value);
    text += "\n";
  }
  // Fitted values are the reference logs' and differ by a fit's tolerance: only which they are.
  for (const BaselineShape& b : baseline_)
    text += fmt::format("{} {}\n", b.of_library, b.candidate);
  Sha256 hash;
  hash.update(text.data(), text.size());
  return hash.finish();
}

LogSums ReferenceColumns::sums(std::vector<Recording> log) const {
  Problem problem = problem_;
  problem.training = std::move(log);
  const Design design(problem, settings_);
  const Hypotheses all = make_hypotheses(design, baseline_with(design, baseline_));
  const Whitening whitening =
      whitening_of(design, all, immaterial_variance(design, settings_, all.parts.base), noise_);
  LogSums sums{column_sums(design, all, whitening.training),
               channel_squares(design, all.parts.base, even_weights(design)).error};
  for (std::size_t i = 0; i < hypotheses_.shapes.size(); ++i) {
    Index expected = 0;
    for (const Eigen::MatrixXd& part : hypotheses_.shapes[i].columns)
      expected = std::max(expected, part.cols());
    if (i >= sums.columns.width.size() || sums.columns.width[i] != expected)
      throw std::invalid_argument(
          fmt::format("the log has other columns than the reference logs: those of '{}'",
                      hypotheses_.list[static_cast<std::size_t>(hypotheses_.shapes[i].hypothesis)]
                          .source->name));
  }
  return sums;
}

}  // namespace sinew::diagnosis
