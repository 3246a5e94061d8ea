// SPDX-License-Identifier: GPL-3.0-or-later
// Guiding friction from tables of measurements whose laws are known.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "identification/experiments/guiding_fit.h"
#include "symbolic/files/description_error.h"
#include "tests/reference/temporary_folder.h"

using namespace sinew;

namespace {

constexpr double degree = 3.14159265358979323846 / 180.0;

/// F = share T (1 - e^(-C1 alpha)) at bending angles up to `largest` degrees, with noise.
GuidingSeries measured(double share, double C1, double largest, double noise,
                       std::mt19937& random) {
  GuidingSeries series{"Dyneema", "pulley", "aluminium", 0.006, {}};
  std::normal_distribution<double> unit;
  for (const double tension : {20.0, 40.0})
    for (int i = 1; i <= 12; ++i) {
      const double bending = largest * degree * i / 12.0;
      series.points.push_back(
          {tension, bending,
           share * tension * (1.0 - std::exp(-C1 * bending)) + noise * unit(random)});
    }
  return series;
}

std::string message_of(const std::string& table) {
  const reference::TemporaryFolder folder;
  const auto file = folder.path() / "table.csv";
  reference::write_text(file, table);
  try {
    read_guiding_table(file);
  } catch (const DescriptionError& error) {
    return error.what();
  }
  return "accepted";
}

const std::string header =
    "tendon,guide,surface,radius [mm],tension [N],bending [deg],friction [N]\n";

}  // namespace

TEST_CASE("guiding friction's intervals cover the truth in 95 % of the trials", "[identify]") {
  constexpr int trials = 400;
  std::mt19937 random(1);
  int share = 0, C1 = 0, mu = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const GuidingFit fitted = fit_guiding(measured(0.4, 0.6, 360.0, 0.1, random));
    REQUIRE(fitted.fitted_identified);
    CHECK(fitted.capstan_contradicted);
    share += fitted.share.covers(0.4);
    C1 += fitted.C1.covers(0.6);
    mu += fit_guiding(measured(1.0, 0.1, 360.0, 0.1, random)).mu.covers(0.1);
  }
  for (const int covered : {share, C1, mu}) {
    CHECK(covered >= 0.92 * trials);
    CHECK(covered <= 0.98 * trials);
  }
}

TEST_CASE("the capstan law is kept where nothing contradicts it", "[identify]") {
  std::mt19937 random(2);
  int contradicted = 0;
  for (int trial = 0; trial < 200; ++trial)
    contradicted += fit_guiding(measured(1.0, 0.1, 360.0, 0.1, random)).capstan_contradicted;
  CHECK(contradicted <= 20);
}

TEST_CASE("C0 grows with the tension", "[identify]") {
  std::mt19937 random(3);
  const GuidingFit fit = fit_guiding(measured(0.4, 0.6, 360.0, 0.02, random));
  CHECK(fit.C0(15.0).value == Approx(6.0).epsilon(0.02));
  CHECK(fit.fitted(15.0, 2.0) == Approx(6.0 * (1.0 - std::exp(-1.2))).epsilon(0.01));
  CHECK(fit.capstan_residual > 3.0 * fit.fitted_residual);
}

TEST_CASE("small bending angles do not tell C0 and C1 apart, which is said", "[identify]") {
  std::mt19937 random(4);
  const GuidingFit fit = fit_guiding(measured(0.4, 0.1, 45.0, 0.1, random));
  CHECK(!fit.fitted_identified);
  CHECK(fit.capstan_identified);
  REQUIRE(!fit.missing.empty());
  CHECK(fit.missing.front().find("expected bending angles of") != std::string::npos);
  GuidingSeries few = measured(0.4, 0.6, 360.0, 0.1, random);
  few.points.resize(2);
  CHECK(!fit_guiding(few).capstan_identified);
  CHECK(fit_guiding(few).missing.front().find("expected four at three angles") !=
        std::string::npos);
}

TEST_CASE("guiding tables: units, order of columns, series", "[identify]") {
  const reference::TemporaryFolder folder;
  const auto file = folder.path() / "table.csv";
  reference::write_text(file,
                        "# measured on the machine\n"
                        "friction [mN],surface,guide,radius [cm],bending [rad],tension [N],tendon\n"
                        "1500,POM,sliding,0.6,1.5,20,steel\n"
                        "900,POM,pulley,0.6,1.5,20,steel\n"
                        "2500,POM,sliding,0.6,3,20,steel\n");
  const auto all = read_guiding_table(file);
  REQUIRE(all.size() == 2);
  CHECK(all[0].guide == "sliding");
  CHECK(all[0].radius == Approx(0.006));
  REQUIRE(all[0].points.size() == 2);
  CHECK(all[0].points[1].friction == Approx(2.5));
  CHECK(all[0].points[1].bending == Approx(3.0));
}

TEST_CASE("broken guiding tables are refused with file, row and column", "[identify]") {
  const std::string row = "Dyneema,pulley,aluminium,6,20,90,1.5\n";
  CHECK(message_of(header + row) == "accepted");
  const auto at = [&](const std::string& table, const std::string& place) {
    const std::string message = message_of(table);
    CAPTURE(message, place);
    CHECK(message.find("table.csv:" + place) != std::string::npos);
  };
  at("", "1:1: the table is empty");
  at(header, "1:1: the table has no measurements");
  at("tendon,guide,surface,radius,tension [N],bending [deg],friction [N]\n" + row,
     "1:22: 'radius' has no unit");
  at("tendon,guide,surface,radius [N],tension [N],bending [deg],friction [N]\n" + row,
     "1:22: 'N' is no unit of radius");
  at("tendon,guide,surface,radius [mm],tension [N],bending [deg]\n" + row,
     "1:1: there is no column 'friction'");
  at(header + "Dyneema,pulley,aluminium,6,20,nan,1.5\n", "2:31: 'nan' is no number");
  at(header + "Dyneema,pulley,aluminium,6,20,90,-1\n", "2:34: the friction is -1");
  at(header + "Dyneema,pulley,aluminium,6,20,90,25\n", "2:34: the friction is not below");
  at(header + "Dyneema,rope,aluminium,6,20,90,1\n", "2:9: 'rope' is no kind of guide");
  at(header + "Dyneema,pulley,aluminium,6,20,90\n", "2:1: the row has no cell");
}
