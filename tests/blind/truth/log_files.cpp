// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blind/truth/log_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "tests/blind/truth/chain.h"

namespace sinew::trials {
namespace {

std::string column_name(const Log& log, std::size_t i, bool own) {
  return own ? fmt::format("ch{:02d} [{}]", i + 1, log.units[i])
             : fmt::format("{} [{}]", log.names[i], log.units[i]);
}

}  // namespace

Index Log::column(const std::string& name) const {
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end()) throw std::out_of_range("a log has no '" + name + "'");
  return at - names.begin();
}

void write_log(const Log& log, bool own_names, const std::filesystem::path& file) {
  std::string text = "time [s]";
  for (std::size_t i = 0; i < log.names.size(); ++i) text += "," + column_name(log, i, own_names);
  std::vector<int> digits;
  for (Index c = 0; c < log.columns.cols(); ++c) {
    const double largest = log.columns.col(c).cwiseAbs().maxCoeff();
    digits.push_back(largest > 0.0
                         ? std::clamp(8 - static_cast<int>(std::floor(std::log10(largest))), 1, 15)
                         : 1);
  }
  auto out = std::back_inserter(text);
  for (Index k = 0; k < log.columns.rows(); ++k) {
    fmt::format_to(out, "\n{:.6f}", log.step * static_cast<double>(k));
    for (Index c = 0; c < log.columns.cols(); ++c)
      fmt::format_to(out, ",{:.{}f}", log.columns(k, c), digits[static_cast<std::size_t>(c)]);
  }
  write_file(file, text + "\n");
}

void write_channel_names(const Log& log, const std::filesystem::path& file) {
  std::string text = "[channels]\n";
  for (std::size_t i = 0; i < log.names.size(); ++i)
    text += fmt::format("\"{}\" = \"{}\"\n", log.names[i], column_name(log, i, true));
  write_file(file, text);
}

PlannedMotion read_motion(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;
  int line = 0;
  for (std::string text; std::getline(in, text);) {
    ++line;
    if (text.empty() || text.front() == '#') continue;
    std::vector<std::string> cells;
    std::stringstream stream(text);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    if (names.empty()) {
      names = cells;
      continue;
    }
    if (cells.size() != names.size())
      throw std::invalid_argument(
          fmt::format("{}:{}:0: {} cells of {}", file.string(), line, cells.size(), names.size()));
    rows.emplace_back();
    for (const std::string& cell : cells) rows.back().push_back(std::stod(cell));
  }
  if (rows.size() < 2) throw std::invalid_argument(file.string() + ":0:0: no planned motion");
  const auto is_load = [&](const std::string& name) {
    return name.find("_ref") == std::string::npos;
  };
  const bool loaded = is_load(names.back());
  const auto axes = static_cast<Index>(names.size()) - (loaded ? 2 : 1);
  PlannedMotion motion{rows[1][0] - rows[0][0], MatrixXd(rows.size(), axes), {}};
  if (loaded) motion.load.resize(motion.reference.rows());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto row = static_cast<Index>(k);
    for (Index j = 0; j < axes; ++j)
      motion.reference(row, j) = rows[k][static_cast<std::size_t>(j) + 1];
    if (loaded) motion.load(row) = rows[k].back();
  }
  return motion;
}

nlohmann::json spoil_log(Log& log, truth::Draw& draw) {
  const auto count = static_cast<int>(log.names.size());
  const int at = draw.below(count);
  const auto c = static_cast<std::size_t>(at);
  const bool angle = log.units[c] == "rad", effort = log.units[c] == "N*m" || log.units[c] == "N";
  const auto told = [&](const char* fault, double factor) {
    return nlohmann::json{{"fault", fault}, {"channel", log.names[c]}, {"factor", factor}};
  };
  const auto times = [&](const char* fault, double factor) {
    log.columns.col(at) *= factor;
    return told(fault, factor);
  };
  switch (draw.below(5)) {
    case 0: {  // the clock
      const double factor = draw.chance(0.5) ? 2.0 : 3.0;
      log.step *= factor;
      return {{"fault", "clock"}, {"channel", "time"}, {"factor", factor}};
    }
    case 1:
      return times("sign", -1.0);
    case 2: {
      const int other = (at + 1 + draw.below(std::max(1, count - 1))) % count;
      const VectorXd kept = log.columns.col(at);
      log.columns.col(at) = log.columns.col(other);
      log.columns.col(other) = kept;
      auto j = told("exchanged", 1.0);
      j["other"] = log.names[static_cast<std::size_t>(other)];
      return j;
    }
    case 3:
      // The motor's current instead of the torque behind the gear, or a small factor.
      if (effort) {
        const double factors[] = {2.0, 3.0, 1.0 / 0.85, 0.5};
        return times("small factor", factors[draw.below(4)]);
      }
      [[fallthrough]];
    default:
      return times("unit", angle ? 180.0 / pi : draw.chance(0.5) ? 1000.0 : 0.001);
  }
}

}  // namespace sinew::trials
