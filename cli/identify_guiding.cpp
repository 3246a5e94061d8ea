// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "cli/figures/guiding.h"
#include "cli/identify_experiments.h"
#include "identification/experiments/guiding_fit.h"

namespace sinew {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const GuidingSeries& s, const GuidingFit& g) {
  Json json{{"tendon", s.tendon},
            {"guide", s.guide},
            {"surface", s.surface},
            {"radius_m", s.radius},
            {"measurements", s.points.size()},
            {"largest_bending_rad", g.largest_bending},
            {"mean_tension_N", g.mean_tension}};
  if (g.mu.value > 0.0) {
    json["fitted_identified"] = g.fitted_identified;
    json["C0_N_at_mean_tension"] = sinew::json_of(g.C0(g.mean_tension));
    json["C0_over_tension"] = sinew::json_of(g.share);
    json["C1_per_rad"] = sinew::json_of(g.C1);
    json["fitted_residual_N"] = g.fitted_residual;
    json["capstan_identified"] = g.capstan_identified;
    json["friction_coefficient"] = sinew::json_of(g.mu);
    json["capstan_residual_N"] = g.capstan_residual;
    json["capstan_contradicted"] = g.capstan_contradicted;
  }
  return json;
}

std::string name_of(const GuidingSeries& s) {
  return s.tendon + ", " + s.guide + ", " + s.surface;
}

}  // namespace

IdentifyReport report_guiding(const std::vector<std::string>& files, bool with_tables) {
  IdentifyReport report{true, {}, {}, {}, {}};
  std::vector<FittedSeries> all;
  for (const std::string& file : files)
    for (GuidingSeries& s : read_guiding_table(file)) {
      GuidingFit fit = fit_guiding(s);
      all.push_back({std::move(s), std::move(fit)});
    }
  Json series = Json::array();
  for (const FittedSeries& each : all) {
    series.push_back(json_of(each.series, each.fit));
    report.identified = report.identified && each.fit.capstan_identified;
    for (const std::string& text : each.fit.missing)
      report.missing.push_back(name_of(each.series) + ": " + text);
  }
  report.results["series"] = series;
  if (with_tables) report.tables = guiding_tables(all);
  return report;
}

}  // namespace sinew
