// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/adoption/physical_links.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "identification/regression/nearest_bodies.h"
#include "identification/regression/pseudo_inverse.h"
#include "identification/subjects/expected_bodies.h"
#include "symbolic/effects/model_effects.h"
#include "symbolic/extension/identified_mechanism.h"
#include "symbolic/model/pseudo_inertia.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Estimates = std::vector<std::vector<ParameterEstimate>>;

constexpr double least_reach = 0.05;  // m: what hangs on a link of no length
constexpr double worth_saying = 0.1;  // standard errors: less is what no log says anything about
constexpr double by_chance = 3.0;     // standard errors

/// Which of a body's ten numbers is called so; -1: none.
int number_of(const std::string& name) {
  const auto& names = find_model_effect("payload")->coefficients;
  for (std::size_t k = 0; k < names.size(); ++k)
    if (names[k].name == name) return static_cast<int>(k);
  return -1;
}

/// A term of the model that is about a link.
struct LinkTerm {
  std::size_t term = 0;
  std::string effect, place;
  EstimatedBody body;
  const Candidate* all_numbers = nullptr;  ///< of a payload that is adopted as a point
};

/// The payload of a link with its moments; nullptr where there is none.
const Candidate* payload_with_moments(const DrivenSubject& subject, const std::string& place) {
  const std::vector<Candidate>& library = subject.problem().library;
  for (std::size_t i = 0; i < library.size(); ++i)
    if (subject.library_origins()[i].effect == "payload" && library[i].place == place)
      return &library[i];
  return nullptr;
}

/// A payload told by its mass and first moments alone is adopted as a point, whose moments ask for
/// efforts as well: it is looked for among points with all ten numbers.
void look_for_point(const DrivenSubject& subject, LinkTerm& link) {
  if (link.effect != "payload" || link.body.has_moments() || link.body.before(0) > 0.0) return;
  link.all_numbers = payload_with_moments(subject, link.place);
  if (!link.all_numbers) return;
  link.body.as_point = true;
  link.body.estimated = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
}

/// What the estimates of a term are added to: of a payload what was learnt of it before, of a link
/// itself all of it.
BodyParameters before_of(const DrivenSubject& subject, const std::string& effect,
                         const std::string& place) {
  Eigen::Matrix4d J = Eigen::Matrix4d::Zero();
  if (effect == "payload") {
    for (const IdentifiedEffect& entry : subject.identified().effects)
      if (entry.effect == effect && entry.place == place) J += pseudo_inertia_of(entry);
  } else {
    for (const Body& body : subject.rigid()->mechanism().bodies)
      if ("link " + body.name == place) J += body_pseudo_inertia(body);
  }
  return body_parameters(J);
}

std::vector<LinkTerm> link_terms(const DrivenSubject& subject, const Model& model,
                                 const Estimates& estimates) {
  std::vector<LinkTerm> links;
  for (std::size_t t = 0; t < model.terms.size(); ++t) {
    const Term& term = model.terms[t];
    if (term.baseline) continue;
    const std::string& effect = subject.origin_of(term).effect;
    if (effect != "payload" && effect != "inertial_parameters") continue;
    if (estimates[t].size() == 1) continue;  // a mass that keeps the link's shape is a body's
    LinkTerm link{t, effect, term.candidate->place, {}};
    for (const ParameterEstimate& e : estimates[t])
      link.body.estimated.push_back(number_of(e.name));
    link.body.before = before_of(subject, effect, link.place);
    link.body.reach = std::max(least_reach, reach_of(subject.rigid()->mechanism()));
    look_for_point(subject, link);
    links.push_back(std::move(link));
  }
  return links;
}

/// Columns of the links' coefficients, and of all others that follow them.
struct Split {
  std::vector<Index> links, others;
};

Split split_columns(const Model& model, const std::vector<LinkTerm>& links) {
  const std::vector<Index> first = first_columns(model);
  Split split;
  std::vector<bool> of_link(static_cast<std::size_t>(first.back()), false);
  for (const LinkTerm& link : links)
    for (Index c = first[link.term]; c < first[link.term + 1]; ++c) {
      split.links.push_back(c);
      of_link[static_cast<std::size_t>(c)] = true;
    }
  for (Index c = 0; c < first.back(); ++c)
    if (!of_link[static_cast<std::size_t>(c)]) split.others.push_back(c);
  return split;
}

/// Adds the change of every coefficient to its estimate; a delay's is no coefficient.
void follow(const Design& design, const Model& model, const Split& split, const VectorXd& change,
            Estimates& estimates) {
  VectorXd all = VectorXd::Zero(first_columns(model).back());
  all(split.others) = change;
  const std::vector<Index> first = first_columns(model);
  for (std::size_t t = 0; t < model.terms.size(); ++t) {
    const Term& term = model.terms[t];
    if (term.candidate->kind == CandidateKind::delay) continue;
    const auto layout = design.coefficients(*term.candidate);
    std::size_t at = 0;
    for (Index c = 0; c < first[t + 1] - first[t]; ++c) {
      const auto training = static_cast<int>(design.problem().training.size());
      if (layout[static_cast<std::size_t>(c)].recording >= training) continue;
      estimates[t][at++].value += all(first[t] + c);
    }
  }
}

/// The model with all numbers of the payloads that are adopted as points.
Model with_all_numbers(const Design& design, const std::vector<LinkTerm>& links, Model model) {
  for (const LinkTerm& link : links) {
    if (!link.all_numbers) continue;
    Term& term = model.terms[link.term];
    term.columns = design.columns(*link.all_numbers, VectorXd());
    term.candidate = link.all_numbers;
  }
  return model;
}

/// The term's numbers as they have to be; moments that no log told of join them.
void take(const LinkTerm& link, const BodyParameters& change,
          std::vector<ParameterEstimate>& estimates) {
  const auto& declared = find_model_effect("payload")->coefficients;
  for (int k = 0; k < (link.body.as_point ? 4 : 10); ++k) {
    const auto at = std::find(link.body.estimated.begin(), link.body.estimated.end(), k);
    if (at != link.body.estimated.end())
      estimates[static_cast<std::size_t>(at - link.body.estimated.begin())].value = change(k);
    else if (link.body.has_moments())
      estimates.push_back({declared[static_cast<std::size_t>(k)].name,
                           declared[static_cast<std::size_t>(k)].unit,
                           change(k),
                           0.0,
                           {}});
  }
}

/// Those that are told apart from a body by more than chance leaves open.
std::string sentence_of(const std::vector<const LinkTerm*>& links, double misfit) {
  std::string names;
  for (const LinkTerm* link : links)
    names += fmt::format("{}{} ({})", names.empty() ? "" : ", ",
                         find_model_effect(link->effect)->name, link->place);
  return fmt::format(
      "the mass properties fitted for {} are none that a body has; the nearest that one has, "
      "{:.2g} "
      "standard errors away, were taken",
      names, std::sqrt(misfit));
}

/// Links with moments that no body has as they were fitted.
std::vector<const LinkTerm*> impossible(const std::vector<LinkTerm>& links,
                                        const VectorXd& values) {
  std::vector<const LinkTerm*> list;
  Index at = 0;
  for (const LinkTerm& link : links) {
    const auto wide = static_cast<Index>(link.body.estimated.size());
    if (!link.body.as_point && !are_bodies({link.body}, values.segment(at, wide)))
      list.push_back(&link);
    at += wide;
  }
  return list;
}

/// What was fitted beside the links, and how it follows them.
struct Beside {
  MatrixXd information;  ///< of the links' numbers, all else free
  MatrixXd follows;      ///< change of all else over that of the links', both signs turned
};

Beside all_beside(const Model& model, const Split& split, const Weights& weights) {
  const MatrixXd gram = stack(model, weights).gram();
  const MatrixXd across = gram(split.others, split.links);
  Beside beside;
  beside.follows = scaled_pseudo_inverse(gram(split.others, split.others)) * across;
  beside.information = gram(split.links, split.links) - across.transpose() * beside.follows;
  return beside;
}

/// The link's own ten numbers as a candidate, whose priors say how far its drawing may be off;
/// nullptr where it has none, or where the fit has them already.
const Candidate* drawing_of(const DrivenSubject& subject, const std::vector<LinkTerm>& links,
                            const std::string& place) {
  if (std::any_of(links.begin(), links.end(), [&](const LinkTerm& link) {
        return link.place == place && link.effect == "inertial_parameters";
      }))
    return nullptr;
  const std::vector<Candidate>& library = subject.problem().library;
  for (std::size_t i = 0; i < library.size(); ++i)
    if (subject.library_origins()[i].effect == "inertial_parameters" && library[i].place == place &&
        library[i].linear.size() == 10 && library[i].linear.front().spread > 0.0)
      return &library[i];
  return nullptr;
}

/// Errors of drawings beside payloads that are no bodies.
struct Drawings {
  std::vector<std::size_t> links;  ///< indices of the payloads
  std::vector<Index> at;           ///< of all of them, ten each
  /// Posterior covariance, and the errors over what the payloads leave of the estimates.
  MatrixXd covariance, share;
};

Drawings drawings_beside(const DrivenSubject& subject, const std::vector<LinkTerm>& links,
                         const VectorXd& values, const MatrixXd& information) {
  Drawings drawings;
  std::vector<double> precision;  // before any log
  Index at = 0;
  for (std::size_t b = 0; b < links.size(); ++b) {
    const auto wide = static_cast<Index>(links[b].body.estimated.size());
    const Candidate* drawing = links[b].effect == "payload" && wide == 10
                                   ? drawing_of(subject, links, links[b].place)
                                   : nullptr;
    EstimatedBody with_moments = links[b].body;
    with_moments.as_point = false;
    if (drawing && !are_bodies({with_moments}, values.segment(at, wide))) {
      drawings.links.push_back(b);
      for (Index k = 0; k < wide; ++k) {
        drawings.at.push_back(at + k);
        const double spread = drawing->linear[static_cast<std::size_t>(k)].spread;
        precision.push_back(1.0 / (spread * spread));
      }
    }
    at += wide;
  }
  MatrixXd own = information(drawings.at, drawings.at);
  own.diagonal() += VectorXd::Map(precision.data(), static_cast<Index>(precision.size()));
  drawings.covariance = scaled_pseudo_inverse(own);
  drawings.share = drawings.covariance * information(drawings.at, Eigen::all);
  return drawings;
}

DrawingError drawing_error(const LinkTerm& link, const VectorXd& values, const VectorXd& variance) {
  DrawingError error{link.term, link.place, {}};
  const auto& declared = find_model_effect("payload")->coefficients;
  for (int k = 0; k < 10; ++k) {
    ParameterEstimate e;
    e.name = declared[static_cast<std::size_t>(k)].name;
    e.unit = declared[static_cast<std::size_t>(k)].unit;
    e.value = values(k);
    e.standard_error = std::sqrt(std::max(0.0, variance(k)));
    error.estimates.push_back(std::move(e));
  }
  return error;
}

/// Bodies, and the errors of drawings beside payloads.
struct Bodies {
  NearestBodies nearest;
  std::vector<DrawingError> drawings;
  VectorXd numbers;  ///< all that the links' numbers are then
};

VectorXd numbers_of(const std::vector<LinkTerm>& links, const NearestBodies& nearest) {
  std::vector<double> list;
  for (std::size_t b = 0; b < links.size(); ++b)
    for (const int k : links[b].body.estimated) list.push_back(nearest.changes[b](k));
  return VectorXd::Map(list.data(), static_cast<Index>(list.size()));
}

/// Of what noise makes of bodies: a point gives up six numbers that the fit had free.
double expected_misfit(const std::vector<LinkTerm>& links) {
  double numbers = 1.0;
  for (const LinkTerm& link : links)
    if (link.body.as_point) numbers += 6.0;
  return by_chance * by_chance * numbers;
}

Bodies find_bodies(const DrivenSubject& subject, const std::vector<LinkTerm>& links,
                   const VectorXd& values, const MatrixXd& information) {
  std::vector<EstimatedBody> bodies;
  for (const LinkTerm& link : links) bodies.push_back(link.body);
  Bodies found{nearest_bodies(bodies, values, information), {}, {}};
  found.numbers = numbers_of(links, found.nearest);
  if (found.nearest.misfit < expected_misfit(links)) return found;
  const Drawings drawings = drawings_beside(subject, links, values, information);
  if (drawings.links.empty()) return found;
  const MatrixXd rest = information - information(Eigen::all, drawings.at) * drawings.share;
  found.nearest = nearest_bodies(bodies, values, rest);
  found.numbers = numbers_of(links, found.nearest);
  const VectorXd errors = drawings.share * (values - found.numbers);
  found.numbers(drawings.at) += errors;
  for (std::size_t i = 0; i < drawings.links.size(); ++i) {
    const auto at = static_cast<Index>(10 * i);
    found.drawings.push_back(drawing_error(links[drawings.links[i]], errors.segment(at, 10),
                                           drawings.covariance.diagonal().segment(at, 10)));
  }
  return found;
}

}  // namespace

PhysicalLinks make_links_physical(const DrivenSubject& subject, const Design& design,
                                  const Selection& selection, Estimates& estimates) {
  const std::vector<LinkTerm> links = link_terms(subject, selection.model, estimates);
  if (links.empty()) return {};
  const Model model = with_all_numbers(design, links, selection.model);
  const Weights& weights = selection.noise.weights;
  const Split split = split_columns(model, links), told = split_columns(selection.model, links);
  const VectorXd fitted = solve(stack(model, weights)).coefficients;
  const VectorXd values = fitted(split.links);
  const std::vector<const LinkTerm*> wrong = impossible(links, values);
  const bool points = std::any_of(links.begin(), links.end(),
                                  [](const LinkTerm& link) { return link.body.as_point; });
  if (wrong.empty() && !points) return {};
  const Beside beside = all_beside(model, split, weights);
  const Bodies bodies = find_bodies(subject, links, values, beside.information);
  const VectorXd before = solve(stack(selection.model, weights)).coefficients(told.others);
  follow(design, selection.model, told,
         fitted(split.others) - before - beside.follows * (bodies.numbers - values), estimates);
  for (std::size_t b = 0; b < links.size(); ++b)
    take(links[b], bodies.nearest.changes[b], estimates[links[b].term]);
  PhysicalLinks physical{bodies.drawings, {}};
  if (!wrong.empty() && bodies.nearest.misfit >= worth_saying * worth_saying)
    physical.changed.push_back(sentence_of(wrong, bodies.nearest.misfit));
  for (const DrawingError& error : bodies.drawings)
    physical.changed.push_back(fmt::format(
        "what the logs tell of the payload ({0}) is none that a body has; the drawing of {0} is "
        "taken to be off by the rest",
        error.link));
  return physical;
}

}  // namespace sinew::diagnosis
