// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "cli/report/model_report.h"

namespace sinew {
namespace {

std::optional<long> count_of(const std::string& cell, const std::string& where) {
  if (cell.empty()) return std::nullopt;
  long value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size() || value < 0)
    throw std::runtime_error(
        fmt::format("{}: '{}' is no count; expected a whole number", where, cell));
  return value;
}

}  // namespace

std::vector<BoardCost> read_board_costs(const std::string& file, const std::string& name) {
  std::ifstream in(file, std::ios::binary);
  std::vector<BoardCost> costs;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    if (++number == 1 || line.empty()) continue;
    const std::string where = fmt::format("{}:{}", file, number);
    std::vector<std::string> cells;
    std::istringstream row(line + ",");
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    if (cells.size() < 4)
      throw std::runtime_error(where + ": expected board,function,instructions,bytes");
    if (cells[1].rfind(name + "_", 0) != 0) continue;
    costs.push_back({cells[0], cells[1], count_of(cells[2], where), count_of(cells[3], where)});
  }
  return costs;
}

}  // namespace sinew
