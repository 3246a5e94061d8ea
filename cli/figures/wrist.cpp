// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "cli/figures/source_figures.h"

namespace sinew {
namespace {

using Eigen::Vector3d;

using std::numbers::pi;
constexpr int path_points = 400;

struct Palm {
  double time, flexion, abduction;  ///< s, rad, rad
};

/// One second of flexion and extension, one second of abduction and adduction.
std::vector<Palm> motion(const WristParameters& p) {
  std::vector<Palm> palm;
  for (int i = 0; i <= path_points; ++i) {
    const double t = 2.0 * i / path_points, wave = std::sin(2 * pi * t);
    palm.push_back({t, t < 1 ? p.flexion.high * wave : 0, t < 1 ? 0 : p.abduction.high * wave});
  }
  return palm;
}

std::vector<double> bars(const CompiledModel& wrist, double flexion, double abduction) {
  std::vector<double> q = wrist("bar_angles", {flexion, abduction});
  q.resize(2);
  return q;
}

/// Largest error of the six link lengths [m].
double constraint_error(const std::vector<double>& rows, const WristParameters& p) {
  const Vector3d A(rows.data()), B(rows.data() + 3), C(rows.data() + 6);
  const Vector3d A0(0, p.width / 2, p.thickness), C0(0, p.width, 0);
  const double r = Vector3d(p.length, p.width, p.thickness).norm(),
               side = std::hypot(p.width / 2, p.thickness);
  double worst = 0;
  for (const double error :
       {(A - A0).norm() - std::hypot(p.length, p.thickness), B.norm() - r, (C - C0).norm() - r,
        (A - B).norm() - side, (A - C).norm() - side, (B - C).norm() - p.width})
    worst = std::max(worst, std::abs(error));
  return worst;
}

Figure constraints(const CompiledModel& wrist, const WristParameters& p) {
  Series series{"", {}, {}};
  for (const Palm& palm : motion(p)) {
    series.x.push_back(palm.time);
    series.y.push_back(
        constraint_error(wrist("points", bars(wrist, palm.flexion, palm.abduction)), p));
  }
  const double most = *std::max_element(series.y.begin(), series.y.end());
  return {"figure_6_09",
          "6.9",
          "Largest error of the six link lengths",
          "The closed form holds the lengths to the rounding of a double. The motion is given in "
          "palm angles and starts at the reference pose; the source does not print its time "
          "course.",
          {{"flexion/extension, then abduction/adduction",
            "time [s]",
            "error [m]",
            {series},
            "rounding noise of the closed form"}},
          {{"largest error of a link's length", "numerical inaccuracies; no number is printed",
            fmt::format("{:.2g} m", most)}}};
}

/// Displacement of every tendon along a track of palm angles [mm].
Panel displacements(const CompiledModel& wrist, const std::vector<Palm>& track,
                    const std::string& title, const std::string& x_label, double Palm::*abscissa,
                    double scale) {
  const std::vector<double> reference = wrist("tendon_lengths", bars(wrist, 0, 0));
  Panel panel{title, x_label, "displacement [mm]", {}};
  panel.series.resize(reference.size());
  for (const Palm& palm : track) {
    const std::vector<double> h =
        wrist("tendon_lengths", bars(wrist, palm.flexion, palm.abduction));
    for (std::size_t i = 0; i < h.size(); ++i) {
      panel.series[i].x.push_back(palm.*abscissa * scale);
      panel.series[i].y.push_back((h[i] - reference[i]) * 1e3);
    }
  }
  return panel;
}

Figure against_angles(const CompiledModel& wrist, const WristParameters& p) {
  std::vector<Palm> flexion, abduction;
  for (int i = 0; i <= path_points; ++i) {
    const double share = static_cast<double>(i) / path_points;
    flexion.push_back({0, p.flexion.low + share * (p.flexion.high - p.flexion.low), 0});
    abduction.push_back({0, 0, p.abduction.low + share * (p.abduction.high - p.abduction.low)});
  }
  return {"figure_6_12",
          "6.12, 6.13",
          "Tendon displacement by the wrist, against the palm angle",
          "The recorded motion is not printed: whole sweeps of both angles instead of it. The "
          "source's captions and its text exchange flexion and abduction between the two figures; "
          "here both are named.",
          {displacements(wrist, flexion, "flexion", "flexion [deg]", &Palm::flexion, 1 / degree),
           displacements(wrist, abduction, "abduction", "abduction [deg]", &Palm::abduction,
                         1 / degree)}};
}

/// Largest displacement in a stretch of the motion [mm].
double largest_within(const Panel& panel, double from, double to) {
  double most = 0.0;
  for (const Series& series : panel.series)
    for (std::size_t i = 0; i < series.x.size(); ++i)
      if (series.x[i] >= from && series.x[i] <= to) most = std::max(most, std::abs(series.y[i]));
  return most;
}

}  // namespace

std::vector<Figure> figures_wrist(const CompiledModel& wrist, const WristParameters& parameters) {
  Figure moved{
      "figure_6_10",
      "6.10",
      "Tendon displacement by a wrist motion",
      "Motion as for Fig. 6.9. {ABC} is a reconstruction, chosen so that flexion couples "
      "least; with it flexion moves the tendons by less than 0.75 mm.",
      {displacements(wrist, motion(parameters), "all tendons", "time [s]", &Palm::time, 1.0)}};
  const Panel& all = moved.panels.front();
  moved.numbers = {
      {"flexion of 30°", "moves the tendons least; no number is printed",
       fmt::format("at most {:.2f} mm", largest_within(all, 0.0, 0.999))},
      {"abduction of 20°", "a large influence, in proportion to the distance from the median axis",
       fmt::format("at most {:.2f} mm", largest_within(all, 1.001, 2.0))}};
  return {constraints(wrist, parameters), moved, against_angles(wrist, parameters)};
}

}  // namespace sinew
