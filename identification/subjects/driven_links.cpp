// SPDX-License-Identifier: GPL-3.0-or-later
// What hangs behind a joint's gear: links that other joints carry too.
#include <algorithm>

#include "identification/subjects/driven_subject.h"
#include "identification/subjects/rigid_candidates.h"

namespace sinew::diagnosis {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// How the links of every joint would part from it, and what other joints feel of that.
void DrivenSubject::add_link_signals(Recording& log) const {
  const MatrixXd columns = rigid_->mass_matrix(log);
  const MatrixXd& carried = log.signals.at("carried");
  const MatrixXd& jounce = log.signals.at("jounce");
  const Index n = carried.cols();
  MatrixXd inertia(log.q.rows(), n), parting = inertia, all_jounces = inertia;
  MatrixXd& shares = log.signals["reaction"];
  shares = columns;
  for (Index j = 0; j < n; ++j) {
    const auto column = columns.middleCols(j * n, n);
    // Links without inertia part from nothing.
    inertia.col(j) = column.col(j).cwiseMax(1e-12);
    parting.col(j) = carried.col(j).cwiseQuotient(inertia.col(j));
    all_jounces.col(j) = column.cwiseProduct(jounce).rowwise().sum().cwiseQuotient(inertia.col(j));
    for (Index i = 0; i < n; ++i)
      shares.col(j * n + i) = column.col(i).cwiseQuotient(inertia.col(j));
  }
  log.signals["carried_inertia"] = std::move(inertia);
  log.signals["parting"] = std::move(parting);
  log.signals["carried_jounce"] = std::move(all_jounces);
}

/// Other joints whose effort shows what the links of this one do by themselves.
std::vector<int> DrivenSubject::reacting(std::size_t joint) const {
  constexpr double kWorthLooking = 0.1;  // of what it is of the joint's own effort
  const auto n = static_cast<Index>(model_.joints.size());
  VectorXd share = VectorXd::Zero(n), effort = share;
  for (const Recording& log : problem_.training)
    for (Index i = 0; i < n; ++i) {
      share(i) += log.signals.at("reaction").col(static_cast<Index>(joint) * n + i).squaredNorm();
      effort(i) += log.target[static_cast<std::size_t>(i)].squaredNorm();
    }
  const auto own = static_cast<Index>(joint);
  std::vector<int> list;
  for (Index i = 0; i < n; ++i)
    if (share(i) * effort(own) >= kWorthLooking * kWorthLooking * share(own) * effort(i))
      list.push_back(static_cast<int>(i));
  return list;
}

/// The effect as every joint feels it that carries the same links.
void DrivenSubject::let_others_react(std::size_t joint, Candidate& candidate) const {
  candidate.channels = reacting(joint);
  const auto own = static_cast<int>(joint);
  const auto n = static_cast<Index>(model_.joints.size());
  candidate.columns = [columns = candidate.columns, own, n, channels = candidate.channels](
                          const Recording& log, int channel, const VectorXd& shape) -> MatrixXd {
    if (std::find(channels.begin(), channels.end(), channel) == channels.end()) return {};
    const MatrixXd x = columns(log, own, shape);
    if (channel == own) return x;
    const VectorXd share = log.signals.at("reaction").col(own * n + channel);
    return share.asDiagonal() * x;
  };
}

}  // namespace sinew::diagnosis
