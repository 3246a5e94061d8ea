// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/identification/diagnosis/drive_logs.h"

#include <charconv>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "identification/logs/filter.h"

namespace sinew::test {
namespace {

/// Columns of a plain CSV with one header row; empty where the file is absent.
std::vector<std::vector<double>> read_columns(const std::string& path) {
  std::ifstream file(std::string(SINEW_SOURCE_DIR) + "/../shared/data/" + path);
  std::vector<std::vector<double>> columns;
  std::string line;
  if (!std::getline(file, line)) return columns;
  while (std::getline(file, line)) {
    const char* at = line.data();
    const char* const end = at + line.size();
    for (std::size_t c = 0; at < end; ++c) {
      double value = 0.0;
      at = std::from_chars(at, end, value).ptr;
      if (at < end) ++at;
      if (columns.size() <= c) columns.emplace_back();
      columns[c].push_back(value);
    }
  }
  return columns;
}

Recording make_recording(const std::string& name, const std::vector<double>& position,
                         const std::vector<double>& force, double step, double cutoff_hz) {
  Recording log;
  log.name = name;
  log.step = step;
  const auto n = static_cast<Eigen::Index>(position.size());
  log.time = Eigen::VectorXd::LinSpaced(n, 0.0, step * static_cast<double>(n - 1));
  const Motion motion = differentiate(Eigen::VectorXd::Map(position.data(), n), step, cutoff_hz);
  log.q = motion.q;
  log.qd = motion.qd;
  log.qdd = motion.qdd;
  log.target = {Eigen::VectorXd::Map(force.data(), n)};
  return log;
}

}  // namespace

std::optional<Recording> read_cable_joint() {
  const auto columns = read_columns("dvrk_mtm/mtm_joint_test_cable.csv");
  if (columns.size() < 4) return std::nullopt;
  return make_recording("cable joint", columns[1], columns[3], 5e-3, 20.0);
}

}  // namespace sinew::test
