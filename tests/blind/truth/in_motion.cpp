// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blind/truth/in_motion.h"

#include <algorithm>
#include <cmath>

namespace sinew::trials {
namespace {

constexpr double still = 5e-4, under_way = 1e-2;                    // of the top speed
constexpr double shortest = 0.04, longest_way = 0.1, flank = 0.02;  // s
constexpr double most = 0.7;  // of a log: reversals beyond it stay

class Marks {
 public:
  Marks(const VectorXd& velocity, double step, double cutoff)
      : v_(velocity),
        slow_(under_way * velocity.cwiseAbs().maxCoeff()),
        step_(step),
        cutoff_(cutoff),
        longest_(static_cast<Index>(longest_way / step)) {}

  /// As far as the smoother spreads a change of sign, and until the joint is under way.
  void reversals(std::vector<char>& marks) const {
    const double periods = std::min(1.2, 0.36 * std::sqrt(60.0 / std::min(cutoff_, 60.0)));
    const auto reach = static_cast<Index>(std::ceil(periods / (cutoff_ * step_)));
    for (Index k = 1; k < v_.size(); ++k)
      if ((v_(k) > 0.0) != (v_(k - 1) > 0.0))
        mark(k - reach - way(k - 1, -1), k + reach + way(k, 1), marks);
  }

  /// Rests of 40 ms and more, with the ways into and out of them.
  void rests(std::vector<char>& marks) const {
    const double resting = still / under_way * slow_;
    const auto reach = static_cast<Index>(std::ceil(1.2 / (cutoff_ * step_)));
    for (Index k = 0, end = 0; k < v_.size(); k = end + 1) {
      for (end = k; end < v_.size() && std::abs(v_(end)) <= resting;) ++end;
      if (end - k >= static_cast<Index>(std::ceil(shortest / step_)))
        mark(k - reach - way(k, -1), end + reach + way(end - 1, 1), marks);
    }
  }

 private:
  Index way(Index from, Index direction) const {
    Index n = 0;
    for (Index k = from; n < longest_ && k >= 0 && k < v_.size() && std::abs(v_(k)) < slow_;
         k += direction)
      ++n;
    return n;
  }
  void mark(Index from, Index to, std::vector<char>& marks) const {
    const Index begin = std::max<Index>(0, from), end = std::min(v_.size(), to);
    std::fill(marks.begin() + begin, marks.begin() + std::max(begin, end), char{1});
  }

  const VectorXd& v_;
  double slow_, step_, cutoff_;
  Index longest_;
};

bool too_many(const std::vector<char>& marks) {
  return static_cast<double>(std::count(marks.begin(), marks.end(), 1)) >
         most * static_cast<double>(marks.size());
}

Rests stretches(const std::vector<char>& marks) {
  Rests found;
  for (std::size_t k = 0; k < marks.size(); ++k) {
    const auto at = static_cast<Index>(k);
    if (!marks[k]) continue;
    if (k == 0 || !marks[k - 1]) found.emplace_back(at, at);
    found.back().second = at;
  }
  return found;
}

}  // namespace

Rests rests_of(const VectorXd& fast, const VectorXd& slow, double step, double cutoff) {
  std::vector<char> rest(static_cast<std::size_t>(fast.size()), 0);
  Marks(fast, step, cutoff).rests(rest);
  if (slow.size() > 0) Marks(slow, step, cutoff).rests(rest);
  std::vector<char> all = rest;
  Marks(fast, step, cutoff).reversals(all);
  return stretches(too_many(all) ? rest : all);
}

VectorXd weight_of(const Rests& rests, Index rows, double step) {
  VectorXd weight = VectorXd::Ones(rows);
  const auto reach = static_cast<Index>(std::ceil(flank / step));
  for (const auto& [from, to] : rests)
    for (Index k = std::max<Index>(0, from - reach); k < std::min(rows, to + reach + 1); ++k) {
      const double away = static_cast<double>(std::max(from - k, k - to)) * step / flank;
      if (away < 1.0) weight(k) *= away <= 0.0 ? 0.0 : 0.5 - 0.5 * std::cos(pi * away);
    }
  return weight;
}

}  // namespace sinew::trials
