// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of motor, lever and guides: what they show, and that they say that it is simulated.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <sstream>

#include "tests/cli/program.h"

using namespace sinew;

namespace {

const std::string source = SINEW_SOURCE_DIR;

struct Curve {
  std::vector<double> x, y;
  double peak() const { return *std::max_element(y.begin(), y.end()); }
  double at_peak() const {
    return x[static_cast<std::size_t>(std::max_element(y.begin(), y.end()) - y.begin())];
  }
};

/// Curves of a figure's CSV by "panel|series".
std::map<std::string, Curve> curves(const Workplace& here, const std::string& file) {
  std::map<std::string, Curve> all;
  std::istringstream in(here.text("figures/" + file + ".csv"));
  std::string line;
  std::getline(in, line);
  CHECK(line.rfind("# Fig. ", 0) == 0);
  std::getline(in, line);
  while (std::getline(in, line)) {
    const std::size_t panel = line.find("\",\""), series = line.find("\",", panel + 3),
                      comma = line.find(',', series + 2);
    Curve& curve =
        all[line.substr(1, panel - 1) + "|" + line.substr(panel + 3, series - panel - 3)];
    curve.x.push_back(std::stod(line.substr(series + 2, comma - series - 2)));
    curve.y.push_back(std::stod(line.substr(comma + 1)));
  }
  return all;
}

void draw(const Workplace& here, const std::string& chapter) {
  const Ended run = here.sinew({"figures", "--chapter", chapter, "--out", "figures", "--models",
                                source + "/models", "--generated", source + "/generated",
                                "--runtime", source + "/runtime"});
  INFO(run.output);
  REQUIRE(run.status == 0);
}

}  // namespace

TEST_CASE("chapter 3's figures show friction, ripple and its compensation", "[figures]") {
  const Workplace here;
  draw(here, "3");
  const auto friction = curves(here, "figure_3_03");
  const Curve& fitted = friction.at("friction curve|(3.8) fitted");
  for (std::size_t i = 0; i < fitted.x.size(); ++i) {
    const double w = fitted.x[i];
    CHECK(fitted.y[i] == Approx(0.5586 * std::atan(10 * w) + 0.0356 * w).margin(0.003));
  }
  CHECK(curves(here, "figure_3_04").at("ten runs at 1 rad/s|").x.size() > 5000);
  const auto two = curves(here, "figure_3_05");
  CHECK(two.at("spectrum|1 rad/s").at_peak() == Approx(15.9).margin(0.2));
  CHECK(two.at("spectrum|0.5 rad/s").at_peak() == Approx(7.96).margin(0.2));
  const auto compensation = curves(here, "figure_3_06");
  const double before = compensation.at("spectrum|without compensation").peak(),
               after = compensation.at("spectrum|with compensation").peak();
  CHECK(before > 0.03);
  CHECK(after < 0.2 * before);
  const std::string index = here.text("figures/index.html");
  for (const char* number : {"Fig. 3.3", "Fig. 3.4", "Fig. 3.5", "Fig. 3.6"})
    CHECK(index.find(number) != std::string::npos);
  CHECK(index.find("Simulated with the emitted C of models/motor, not measured") !=
        std::string::npos);
  CHECK(index.find("Fig. 5.7") == std::string::npos);
}

TEST_CASE("chapter 4's figures show lever, calibration and guiding friction", "[figures]") {
  const Workplace here;
  draw(here, "4");
  const auto lever = curves(here, "figure_4_07");
  const Curve &force = lever.at("force|"), &stiffness = lever.at("stiffness|");
  CHECK(force.y.front() == Approx(0.0).margin(1e-9));
  CHECK(force.y.back() == Approx(99.0).margin(1.0));
  CHECK(stiffness.y.front() == Approx(5.6).margin(0.1));
  CHECK(stiffness.y.back() == Approx(41.8).margin(0.5));
  const auto calibration = curves(here, "figure_4_08");
  // Loading and unloading are apart by the loop.
  const Curve& measured = calibration.at("on the rig|measured");
  double low = 1e9, high = 0.0;
  for (std::size_t i = 0; i < measured.x.size(); ++i)
    if (std::abs(measured.x[i] - 11.0) < 0.1) {
      low = std::min(low, measured.y[i]);
      high = std::max(high, measured.y[i]);
    }
  CHECK(high - low > 5.0);
  const auto guiding = curves(here, "figure_4_10");
  CHECK(guiding.at("Dyneema 0.8 mm|pulley 4 mm, aluminium").peak() >
        guiding.at("Dyneema 0.8 mm|pulley 10 mm, aluminium").peak());
  CHECK(guiding.at("Dyneema 0.8 mm|pulley 4 mm, aluminium").peak() >
        guiding.at("steel 0.6 mm|pulley 4 mm, aluminium").peak());
  const std::string index = here.text("figures/index.html");
  CHECK(index.find("A simulated rig, not a measured one") != std::string::npos);
  CHECK(index.find("Assumed measurements") != std::string::npos);
}

TEST_CASE("chapter 6's figures stand beside the source's words, and rounding is called so",
          "[figures]") {
  const Workplace here;
  draw(here, "6");
  const std::string page = here.text("figures/index.html");
  // Planted defect: without `noise_` in draw_panel.cpp and the panel's note nothing says what 1e-17
  // is.
  CHECK(page.find("rounding noise") != std::string::npos);
  CHECK(page.find("<th scope=\"col\">The source</th><th scope=\"col\">Here</th>") !=
        std::string::npos);
  CHECK(page.find("numerical inaccuracies; no number is printed") != std::string::npos);
  // A minus sign, and none that is cut: labels stand within the sheet.
  const std::string svg = here.text("figures/figure_6_10.svg");
  CHECK(svg.find("−") != std::string::npos);
  CHECK(svg.find(">-") == std::string::npos);
}
