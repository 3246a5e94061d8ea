// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/calls/alike.h"

#include <algorithm>
#include <map>
#include <set>

#include "generator/loops/unify.h"

namespace sinew {
namespace {

/// What repeats as often in a function is left to its loops, which write it once.
constexpr int often = 6;

std::vector<double> gains_of(const Graph& graph) {
  const Forms forms = forms_of(graph, {});
  std::map<std::uint64_t, int> count;
  for (Value v = 0; v < graph.size(); ++v)
    if (arity(graph[v].op) > 0) ++count[forms[static_cast<std::size_t>(v)]];
  std::vector<double> gains;
  for (Value v = 0; v < graph.size(); ++v) {
    const int alike = count[forms[static_cast<std::size_t>(v)]];
    const double weight = arity(graph[v].op) > 0 ? instructions_of(graph[v].op).written : 0;
    gains.push_back(alike < often ? weight : weight / alike);
  }
  return gains;
}

bool is_at(const Place& place, Value v) {
  return std::find(place.at.begin(), place.at.end(), v) != place.at.end();
}

/// Operations, and what parts give, that need the numbers of a place; where it has none all.
std::vector<bool> inner_values(const CallingFunction& function, const Place& base) {
  const Graph& graph = function.rest;
  const std::vector<const Call*> calls = calls_by_port(function);
  std::vector<bool> needs_it(static_cast<std::size_t>(graph.size()), base.at.empty());
  std::vector<bool> inner;
  for (Value v = 0; v < graph.size(); ++v) {
    const auto i = static_cast<std::size_t>(v);
    for (Value need : needs_of(graph, v))
      if (needs_it[static_cast<std::size_t>(need)] || is_at(base, need)) needs_it[i] = true;
    const bool is_given =
        graph[v].op == Op::input && calls[graph.port_of_input(graph[v].index)] != nullptr;
    inner.push_back((is_given || arity(graph[v].op) > 0) && needs_it[i] && !is_at(base, v));
  }
  return inner;
}

/// In the order of the numbers in which most is alike.
PartInstance instance_at(const std::vector<CallingFunction>& functions, const Alike& alike,
                         const Place& place) {
  PartInstance best;
  double most = -1.0;
  std::vector<Value> at = place.at;
  std::sort(at.begin(), at.end());
  do {
    PartInstance now{
        {place.function, at},
        images(functions[alike.base.function], alike.base.at, functions[place.function], at)};
    if (const double weight = alike.weight(alike.inner, &now); weight > most) {
      most = weight;
      best = std::move(now);
    }
  } while (std::next_permutation(at.begin(), at.end()));
  return best;
}

PartInstance base_instance(const Place& base, Value size) {
  PartInstance instance{base, {}};
  for (Value v = 0; v < size; ++v) instance.image.push_back(v);
  return instance;
}

bool is_base(const Alike& alike, const PartInstance& instance) {
  return instance.place.function == alike.base.function && instance.place.at == alike.base.at;
}

Alike alike_with(const std::vector<CallingFunction>& functions, const std::vector<Place>& places,
                 const Place& base, double least) {
  const CallingFunction& function = functions[base.function];
  Alike alike{base, gains_of(function.rest), inner_values(function, base), {}};
  for (const Place& place : places) {
    if (place.at.size() != base.at.size()) continue;
    PartInstance instance = place.function == base.function && place.at == base.at
                                ? base_instance(base, function.rest.size())
                                : instance_at(functions, alike, place);
    if (is_base(alike, instance) || alike.weight(alike.inner, &instance) >= least)
      alike.instances.push_back(std::move(instance));
  }
  return alike;
}

/// Where steps of one computation follow each other, what two places have alike may overlap: it
/// counts once.
double covered(const Alike& alike, const std::vector<bool>& may) {
  std::set<std::pair<std::size_t, Value>> seen;
  double sum = 0.0;
  for (const PartInstance& each : alike.instances)
    for (std::size_t v = 0; v < may.size(); ++v)
      if (may[v] && each.image[v] != no_value &&
          seen.insert({each.place.function, each.image[v]}).second)
        sum += alike.gains[v];
  return sum;
}

void add_candidates(const std::vector<Alike>& all, std::size_t which,
                    std::vector<PartCandidate>& candidates) {
  const Alike& alike = all[which];
  for (const PartInstance& other : alike.instances) {
    if (is_base(alike, other)) continue;
    PartCandidate candidate{which, alike.inner, 0.0};
    for (std::size_t v = 0; v < alike.inner.size(); ++v)
      candidate.may[v] = alike.inner[v] && other.image[v] != no_value;
    candidate.score = covered(alike, candidate.may) - alike.weight(candidate.may);
    candidates.push_back(std::move(candidate));
  }
}

}  // namespace

double Alike::weight(const std::vector<bool>& values, const PartInstance* instance) const {
  double sum = 0.0;
  for (std::size_t v = 0; v < gains.size(); ++v)
    if (values[v] && (!instance || instance->image[v] != no_value)) sum += gains[v];
  return sum;
}

std::vector<Alike> all_alike(const std::vector<CallingFunction>& functions, double least) {
  std::vector<Place> places;
  for (std::size_t f = 0; f < functions.size(); ++f)
    for (const std::vector<Value>& at : places_of(functions[f])) places.push_back({f, at});
  std::vector<Alike> all;
  for (const Place& base : places) all.push_back(alike_with(functions, places, base, least));
  return all;
}

std::vector<PartCandidate> part_candidates(const std::vector<Alike>& all) {
  constexpr std::size_t most = 16;
  std::vector<PartCandidate> candidates;
  for (std::size_t k = 0; k < all.size(); ++k) add_candidates(all, k, candidates);
  std::stable_sort(
      candidates.begin(), candidates.end(),
      [](const PartCandidate& a, const PartCandidate& b) { return a.score > b.score; });
  const auto same = [](const PartCandidate& a, const PartCandidate& b) {
    return a.score == b.score;  // the same values, from the other place
  };
  candidates.erase(std::unique(candidates.begin(), candidates.end(), same), candidates.end());
  if (candidates.size() > most) candidates.resize(most);
  return candidates;
}

}  // namespace sinew
