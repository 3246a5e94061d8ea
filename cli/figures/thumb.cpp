// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <random>

#include "cli/figures/source_figures.h"

namespace sinew {
namespace {

struct Case {
  int steps;
  double noise;  ///< m
};

struct Angles {
  double q10, q11;
};

/// Algorithm 1, corrected, from (0, 0). The first call evaluates the start.
Angles by_gradient(const CompiledModel& thumb, const std::vector<double>& h, int steps) {
  std::vector<double> search{0, 0, 0, 0, 300, 1};
  for (int i = 0; i <= steps; ++i) {
    std::vector<double> inputs = h;
    inputs.insert(inputs.end(), search.begin(), search.end());
    search = thumb("link_position_gradient_step", inputs);
  }
  return {search[0], search[1]};
}

Angles by_levenberg_marquardt(const CompiledModel& thumb, std::vector<double> h) {
  h.insert(h.end(), {0, 0});
  const std::vector<double> q = thumb("link_position", h);
  return {q[0], q[1]};
}

/// Standard normal, by Box and Muller from the engine's bits: every library gives the same.
double normal(std::mt19937_64& random) {
  const auto uniform = [&] {
    return (static_cast<double>(random() >> 11) + 0.5) / 9007199254740992.0;
  };
  const double radius = std::sqrt(-2 * std::log(uniform()));
  return radius * std::cos(360 * degree * uniform());
}

struct Estimates {
  Series gradient{"estimated", {}, {}, Look::crosses, 0};
  Series marquardt{"estimated", {}, {}, Look::crosses, 0};
  Series truth{"original", {}, {}, Look::circles, 1};
  double gradient_rms = 0, marquardt_rms = 0;
};

Estimates estimates(const CompiledModel& thumb, const Case& of) {
  std::mt19937_64 random(1);
  Estimates result;
  int count = 0;
  for (int i = -40; i <= 40; i += 8)
    for (int j = -40; j <= 40; j += 8, ++count) {
      const Angles q{i * degree, j * degree};
      std::vector<double> h = thumb("tendon_lengths", {q.q10, q.q11, 0, 0});
      h.resize(4);
      for (double& length : h) length += of.noise * normal(random);
      const auto add = [&](Series& series, const Angles& at) {
        series.x.push_back(at.q10);
        series.y.push_back(at.q11);
        return std::pow(at.q10 - q.q10, 2) + std::pow(at.q11 - q.q11, 2);
      };
      add(result.truth, q);
      result.gradient_rms += add(result.gradient, by_gradient(thumb, h, of.steps));
      result.marquardt_rms += add(result.marquardt, by_levenberg_marquardt(thumb, h));
    }
  result.gradient_rms = std::sqrt(result.gradient_rms / (2 * count));
  result.marquardt_rms = std::sqrt(result.marquardt_rms / (2 * count));
  return result;
}

Figure compared(const CompiledModel& thumb, const Case& of, const std::string& file,
                const std::string& number) {
  const Estimates e = estimates(thumb, of);
  Figure figure{file,
                number,
                fmt::format("{} steps, {} mm of noise, from (0, 0)", of.steps, of.noise * 1e3),
                "",
                {}};
  figure.panels = {{fmt::format("gradient, rms {:.2g} rad", e.gradient_rms),
                    "q10 [rad]",
                    "q11 [rad]",
                    {e.truth, e.gradient}},
                   {fmt::format("Levenberg-Marquardt (4), rms {:.2g} rad", e.marquardt_rms),
                    "q10 [rad]",
                    "q11 [rad]",
                    {e.truth, e.marquardt}}};
  figure.differs =
      "The gradient search is the corrected Algorithm 1 (an accepted step keeps the point); as "
      "printed nothing guards against too long a step. Distal insertions are assumed; noise is "
      "normal with the "
      "amplitude as standard deviation, the distribution is not printed. Levenberg-Marquardt with "
      "four iterations is "
      "shown beside it.";
  figure.numbers = {{fmt::format("error after {} steps", of.steps),
                     "a picture, with errors in the corners; no number is printed",
                     fmt::format("{:.2g} rad rms; Levenberg–Marquardt {:.2g} rad", e.gradient_rms,
                                 e.marquardt_rms)}};
  return figure;
}

}  // namespace

std::vector<Figure> figures_link_position(const CompiledModel& thumb) {
  std::vector<Figure> figures{compared(thumb, {30, 0.0}, "figure_5_16", "5.16")};
  char panel = 'a';
  for (const int steps : {50, 30, 15})
    for (const double noise : {0.0, 0.5e-3, 1e-3}) {
      const std::string letter(1, panel++);
      figures.push_back(compared(thumb, {steps, noise}, "figure_5_17" + letter, "5.17" + letter));
    }
  return figures;
}

}  // namespace sinew
