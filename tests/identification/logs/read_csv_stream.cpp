// SPDX-License-Identifier: GPL-3.0-or-later
// Long logs: speed, bounded memory, thinning without a phase shift, holes and stretches.
#include <fmt/format.h>
#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "identification/logs/read_csv.h"
#include "identification/logs/uniform_grid.h"
#include "tests/identification/logs/planted_log.h"
#include "tests/reference/temporary_folder.h"
#include "tests/skip.h"

using namespace sinew;
using sinew::test::write_file;

namespace {

constexpr double pi = 3.14159265358979323846;

// One slow and one fast sine; the fast one lies above what is kept after thinning.
std::string sines(long rows, double dt, double fast_hertz) {
  std::string text = "time [s],theta [rad],tau_m [N·m]\n";
  text.reserve(static_cast<size_t>(rows) * 40);
  for (long k = 0; k < rows; ++k) {
    const double t = static_cast<double>(k) * dt;
    fmt::format_to(std::back_inserter(text), "{:.6f},{:.9g},{:.9g}\n", t,
                   std::sin(2.0 * pi * 0.7 * t),
                   std::cos(2.0 * pi * 0.7 * t) + std::sin(2.0 * pi * fast_hertz * t));
  }
  return text;
}

}  // namespace

TEST_CASE("a 60 s log of 12 channels at 3 kHz is read whole") {
  std::string text = "time [s]";
  std::vector<ChannelSpec> specs;
  for (int c = 1; c <= 12; ++c) {
    text += fmt::format(",theta_{} [rad]", c);
    ChannelSpec spec;
    spec.name = fmt::format("theta_{}", c);
    spec.unit = "rad";
    spec.role = ChannelRole::position;
    spec.required = true;
    specs.push_back(spec);
  }
  text += '\n';
  for (int k = 0; k < 180000; ++k) {
    fmt::format_to(std::back_inserter(text), "{:.6f}", k / 3000.0);
    for (int c = 1; c <= 12; ++c)
      fmt::format_to(std::back_inserter(text), ",{:.8f}", std::sin(1.0e-3 * k * (1.0 + 0.1 * c)));
    text += '\n';
  }
  const std::string path = write_file("long.csv", text);
  const Log log = read_csv(path, specs);
  CHECK(log.sample_count() == 180000);
  CHECK(log.decimation == 1);
}

TEST_CASE("thinning keeps the phase and removes what would fold back") {
  const double dt = 1.0e-3;
  ReadOptions options;
  options.max_samples = 5000;
  const Log log =
      read_csv(write_file("thin.csv", sines(40000, dt, 180.0)), rotary_drive_channels(), options);
  REQUIRE(log.decimation == 8);
  REQUIRE(log.segments.size() == 1);
  const auto& samples = log.segments[0].samples;
  REQUIRE(samples.rows() == 5000);
  double worst = 0.0;
  for (long k = 0; k < samples.rows(); ++k) {
    const double t = log.segments[0].start + static_cast<double>(k) * log.period;
    const double slow = std::cos(2.0 * pi * 0.7 * t);
    if (k > 20 && k < samples.rows() - 20) worst = std::max(worst, std::abs(samples(k, 1) - slow));
    REQUIRE(std::abs(samples(k, 0) - std::sin(2.0 * pi * 0.7 * t)) < 2.0e-3);
  }
  CHECK(worst < 2.0e-3);
  // The check sees a fold: every eighth sample as it stands has the fast sine in it.
  double folded = 0.0;
  for (int k = 0; k < 5000; ++k)
    folded = std::max(folded, std::abs(std::sin(2.0 * pi * 180.0 * 8.0 * k * dt)));
  CHECK(folded > 0.5);
}

TEST_CASE("of a log that is too long stretches from its beginning to its end are read") {
  // Planted defect: with spread_stretches giving none the log is read whole.
  ReadOptions options;
  options.max_rate = 500.0;
  options.max_values = 2 * 6000;
  const Log log = read_csv(write_file("far.csv", sines(60000, 1.0e-3, 180.0)),
                           rotary_drive_channels(), options);
  CHECK(log.decimation == 2);  // for the rate alone: what fast effects need stays
  REQUIRE(log.segments.size() == 2);
  CHECK(log.sample_count() == 6000);
  CHECK(log.segments.front().start == 0.0);
  const Segment& last = log.segments.back();
  CHECK(last.start + log.period * static_cast<double>(last.samples.rows()) == Approx(60.0));
  for (const Segment& s : log.segments)
    for (long k = 20; k < s.samples.rows() - 20; ++k) {
      const double t = s.start + static_cast<double>(k) * log.period;
      REQUIRE(std::abs(s.samples(k, 0) - std::sin(2.0 * pi * 0.7 * t)) < 1.0e-4);
    }
  REQUIRE(log.faults.size() == 1);
  CHECK(log.faults.front().kind == FaultKind::too_long);
  CHECK(log.faults.front().severity == Severity::note);
}

TEST_CASE("memory does not grow with the log") {
  const auto peak = [] {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
  };
  // Written in pieces, so that the writer itself stays small.
  const sinew::reference::TemporaryFolder folder;
  const auto path = folder.path() / "very_long.csv";
  {
    std::ofstream out(path, std::ios::binary);
    out << "time [s],theta [rad],tau_m [N·m]\n";
    std::string piece;
    for (long k = 0; k < 1500000; ++k) {
      fmt::format_to(std::back_inserter(piece), "{:.6f},{:.9g},{:.9g}\n",
                     static_cast<double>(k) * 1.0e-3, std::sin(0.003 * static_cast<double>(k)),
                     std::cos(0.003 * static_cast<double>(k)));
      if (piece.size() > 100000) {
        out << piece;
        piece.clear();
      }
    }
    out << piece;
  }
  ReadOptions options;
  options.max_samples = 20000;
  options.check_consistency = false;
  const double before = peak();
  const Log log = read_csv(path.string(), rotary_drive_channels(), options);
  const double grown = peak() - before;
  CHECK(log.rows == 1500000);
  CHECK(log.sample_count() <= 20000);
  CAPTURE(grown);
  CHECK(grown < 24.0);  // MiB; the values of all rows alone would be 34
}

TEST_CASE("short holes are filled on the curve, long ones begin a new stretch") {
  FaultList faults("made");
  GridSettings settings;
  settings.period = 0.001;
  UniformBuilder builder(settings, 1, faults);
  const auto value = [](long k) { return std::sin(0.01 * static_cast<double>(k)); };
  for (long k = 0; k < 1000; ++k) {
    if (k >= 200 && k < 204) continue;  // four rows missing
    if (k >= 500 && k < 540) continue;  // forty
    builder.push(k + 2, 0.001 * static_cast<double>(k), {k == 300 ? std::nan("") : value(k)});
  }
  const auto segments = builder.finish();
  REQUIRE(segments.size() == 2);
  CHECK(segments[0].samples.rows() == 500);
  CHECK(segments[1].samples.rows() == 460);
  CHECK(segments[1].start == Approx(0.54));
  CHECK(segments[1].first_row == 542);
  for (long k = 0; k < 500; ++k) REQUIRE(std::abs(segments[0].samples(k, 0) - value(k)) < 1.0e-4);
  CHECK(faults.all().size() == 2);
}

TEST_CASE("uneven sampling is put on an even grid") {
  FaultList faults("made");
  GridSettings settings;
  settings.period = 0.001;
  settings.resample = true;
  UniformBuilder builder(settings, 1, faults);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> shift(-3.0e-4, 3.0e-4);
  for (long k = 0; k < 2000; ++k) {
    const double t = 0.001 * static_cast<double>(k) + shift(random);
    builder.push(k + 2, t, {std::sin(20.0 * t)});
  }
  const auto segments = builder.finish();
  REQUIRE(segments.size() == 1);
  const Segment& s = segments[0];
  REQUIRE(s.samples.rows() > 1990);
  double even = 0.0;
  for (long k = 2; k < s.samples.rows() - 2; ++k) {  // the ends have fewer neighbours
    const double t = s.start + 0.001 * static_cast<double>(k);
    even = std::max(even, std::abs(s.samples(k, 0) - std::sin(20.0 * t)));
  }
  CHECK(even < 1.0e-5);  // taken as they stand, the rows would be off by 20 * 3e-4
}

TEST_CASE("measured logs read without a false alarm") {
  const std::string folder = std::string(SINEW_SOURCE_DIR) + "/../shared/data/";
  if (!std::filesystem::exists(folder + "emps/data_emps.csv"))
    return sinew::test::skip("../shared/data/emps is absent");
  ReadOptions options;
  options.map = {"x=q_meas_m", "x_ref=q_ref_m", "f=force_N"};
  const Log emps = read_csv(folder + "emps/data_emps.csv", linear_drive_channels(), options);
  for (const DataFault& fault : emps.faults) CHECK(fault.severity == Severity::note);
  CHECK(emps.channels[0].quantum == Approx(5.0e-8).epsilon(1.0e-3));
  options.map = {"x=q_ref_m", "x_ref=q_meas_m", "f=force_N"};
  CHECK_THROWS_WITH(read_csv(folder + "emps/data_emps.csv", linear_drive_channels(), options),
                    Catch::Contains("are exchanged"));
  options.map = {"theta=q1 [rad]", "omega=qd1 [rad/s]", "tau_m=tau1 [N·m]"};
  const Log cable =
      read_csv(folder + "dvrk_mtm/mtm_joint_test_cable.csv", rotary_drive_channels(), options);
  CHECK(cable.segments.size() == 1);
  options.map[0] = "theta=q1 [deg]";
  CHECK_THROWS_WITH(
      read_csv(folder + "dvrk_mtm/mtm_joint_test_cable.csv", rotary_drive_channels(), options),
      Catch::Contains("radians taken for degrees") || Catch::Contains("degrees taken for radians"));
}
