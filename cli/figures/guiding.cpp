// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/figures/guiding.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace sinew {
namespace {

constexpr double table_angles[] = {15, 30, 45, 60, 90, 120, 150, 180, 270, 360};  // deg

std::string guide_of(const GuidingSeries& s) {
  return fmt::format("{} {:.3g} mm, {}", s.guide, s.radius * 1e3, s.surface);
}

/// The fitted law where the measurements give it, else the capstan's.
double friction(const FittedSeries& s, double tension, double bending) {
  return s.fit.fitted_identified ? s.fit.fitted(tension, bending) : s.fit.capstan(tension, bending);
}

/// Whether a bending angle [deg] was measured, or one beyond it.
bool within(const FittedSeries& s, double angle) {
  return angle * degree <= s.fit.largest_bending * (1.0 + 1e-9);
}

const char* law_of(const FittedSeries& s) {
  return s.fit.fitted_identified ? "fitted" : "capstan";
}

std::vector<std::string> tendons_of(const std::vector<FittedSeries>& all) {
  std::vector<std::string> names;
  for (const FittedSeries& s : all)
    if (std::find(names.begin(), names.end(), s.series.tendon) == names.end())
      names.push_back(s.series.tendon);
  return names;
}

Series measured(const FittedSeries& s, double tension, int colour) {
  Series points{"", {}, {}, Look::dots, colour};
  for (const GuidingMeasurement& p : s.series.points) {
    points.x.push_back(p.bending / degree);
    points.y.push_back(p.friction * tension / p.tension);
  }
  return points;
}

template <typename Law>
Series curve(const std::string& title, double largest, int colour, Law law) {
  Series line{title, {}, {}, Look::line, colour};
  for (int i = 0; i <= 60; ++i) {
    const double angle = largest * i / 60.0;
    line.x.push_back(angle / degree);
    line.y.push_back(law(angle));
  }
  return line;
}

std::string friction_table(const std::vector<FittedSeries>& all, double tension) {
  std::string text =
      "tendon,guide,surface,radius [mm],tension [N],bending [deg],friction [N],law,"
      "capstan friction [N],measured\n";
  for (const FittedSeries& s : all) {
    if (!s.fit.capstan_identified) continue;
    for (const double angle : table_angles) {
      const double bending = angle * degree;
      text +=
          fmt::format("\"{}\",{},\"{}\",{:.6g},{:.6g},{},{:.4g},{},{:.4g},{}\n", s.series.tendon,
                      s.series.guide, s.series.surface, s.series.radius * 1e3, tension, angle,
                      friction(s, tension, bending), law_of(s), s.fit.capstan(tension, bending),
                      bending <= s.fit.largest_bending * (1 + 1e-9) ? "within" : "beyond");
    }
  }
  return text;
}

std::string choice_table(const std::vector<FittedSeries>& all, double tension) {
  std::string text =
      "tendon,pulley,pulley radius [mm],sliding surface,sliding radius [mm],tension [N],"
      "bending [deg],pulley friction [N],sliding friction [N],less friction,measured\n";
  for (const FittedSeries& pulley : all)
    for (const FittedSeries& sliding : all) {
      if (pulley.series.guide != "pulley" || sliding.series.guide != "sliding" ||
          pulley.series.tendon != sliding.series.tendon || !pulley.fit.capstan_identified ||
          !sliding.fit.capstan_identified)
        continue;
      for (const double angle : table_angles) {
        const double rolls = friction(pulley, tension, angle * degree),
                     slides = friction(sliding, tension, angle * degree);
        text += fmt::format("\"{}\",\"{}\",{:.6g},\"{}\",{:.6g},{:.6g},{},{:.4g},{:.4g},{},{}\n",
                            pulley.series.tendon, pulley.series.surface, pulley.series.radius * 1e3,
                            sliding.series.surface, sliding.series.radius * 1e3, tension, angle,
                            rolls, slides, rolls < slides ? "pulley" : "sliding",
                            within(pulley, angle) && within(sliding, angle) ? "within" : "beyond");
      }
    }
  return text;
}

}  // namespace

double usual_tension(const std::vector<FittedSeries>& all) {
  std::map<double, int> count;
  for (const FittedSeries& s : all)
    for (const GuidingMeasurement& p : s.series.points) ++count[p.tension];
  const auto most = std::max_element(
      count.begin(), count.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == count.end() ? 0.0 : most->first;
}

Figure figure_guiding_friction(const std::vector<FittedSeries>& all, double tension,
                               const std::string& origin) {
  Figure figure{"figure_4_10", "4.10", "Friction of a bent tendon", "", {}};
  for (const std::string& tendon : tendons_of(all)) {
    Panel panel{
        tendon, "total bending [deg]", fmt::format("friction at {:.4g} N [N]", tension), {}};
    int colour = 0;
    for (const FittedSeries& s : all) {
      if (s.series.tendon != tendon) continue;
      panel.series.push_back(measured(s, tension, ++colour));
      if (s.fit.capstan_identified)
        panel.series.push_back(curve(guide_of(s.series), s.fit.largest_bending, colour,
                                     [&](double angle) { return friction(s, tension, angle); }));
    }
    figure.panels.push_back(panel);
  }
  figure.differs = origin +
                   " Lines: C0 (1 - exp(-C1 alpha)) fitted to the points (4.1), the capstan law "
                   "where C0 and C1 cannot be told apart. Friction grows with the tension, so that "
                   "the points are scaled to one.";
  figure.numbers = {{"friction against the total bending angle",
                     "curves without numbers: more for Dyneema than for steel, more for smaller "
                     "pulleys",
                     "the same order, from assumed measurements"}};
  return figure;
}

Figure figure_pulley_or_sliding(const std::vector<FittedSeries>& all, const std::string& origin) {
  Figure figure{"figure_4_11", "4.11", "Pulley against sliding surface", "", {}};
  for (const std::string& tendon : tendons_of(all)) {
    Panel panel{tendon, "total bending [deg]", "share of the tension that is lost", {}};
    int colour = 0;
    for (const FittedSeries& s : all)
      if (s.series.tendon == tendon && s.fit.capstan_identified)
        panel.series.push_back(
            curve(fmt::format("{}: mu = {:.3f}", guide_of(s.series), s.fit.mu.value),
                  s.fit.largest_bending, ++colour,
                  [&](double angle) { return friction(s, 1.0, angle); }));
    figure.panels.push_back(panel);
  }
  figure.differs = origin +
                   " The source gives bars of coefficients of friction; here each guide's loss by "
                   "bending angle, which is what decides between a pulley and a sliding surface.";
  figure.numbers = {{"coefficients of friction", "bars without numbers",
                     "in the key, from assumed measurements"}};
  return figure;
}

FileSet guiding_tables(const std::vector<FittedSeries>& all) {
  const double tension = usual_tension(all);
  FileSet files{{"friction_by_angle.csv", friction_table(all, tension)},
                {"pulley_or_sliding.csv", choice_table(all, tension)}};
  Figure angle = figure_guiding_friction(all, tension, ""),
         choice = figure_pulley_or_sliding(all, "");
  angle.file = "friction_by_angle_plot";
  choice.file = "pulley_or_sliding_plot";
  files.merge(figure_files(angle));
  files.merge(figure_files(choice));
  return files;
}

}  // namespace sinew
