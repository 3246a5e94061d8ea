// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blind/truth/spoil.h"

#include <algorithm>
#include <cmath>

namespace sinew::truth {
namespace {

void scale(std::vector<double>& x, double factor) {
  for (double& v : x) v *= factor;
}

std::string name_of(const std::string& header) {
  return header.substr(0, header.find(' '));
}

// A row in the middle from where on the channel changes for `length` rows.
size_t moving_row(const std::vector<double>& x, size_t length, Draw& draw) {
  double largest = 0.0;
  for (size_t k = 0; k + length < x.size(); k += 5)
    largest = std::max(largest, std::abs(x[k + length] - x[k]));
  for (int tries = 0; tries < 10000; ++tries) {
    const auto k = static_cast<size_t>(draw.uniform(0.1, 0.85) * static_cast<double>(x.size()));
    if (std::abs(x[k + length] - x[k]) > 0.4 * largest) return k;
  }
  return x.size() / 2;
}

// Replaces the cell at (row, column) of the text; both from 0, the header is row 0.
void put_cell(std::string& text, size_t row, size_t column, const std::string& cell) {
  size_t at = 0;
  for (size_t i = 0; i < row; ++i) at = text.find('\n', at) + 1;
  for (size_t i = 0; i < column; ++i) at = text.find(',', at) + 1;
  const size_t end = text.find_first_of(",\n", at);
  text.replace(at, end - at, cell);
}

}  // namespace

Spoiled spoil(const Table& given, Draw draw) {
  constexpr double pi = 3.14159265358979323846;
  Table log = given;
  const size_t rows = log.columns[0].size();
  const int fault = draw.below(13);
  // Position and effort of one coordinate.
  int p = log.column("theta"), e = log.column("tau_m");
  if (p < 0) p = log.column("x"), e = log.column("f");
  if (p < 0) p = log.column("theta_1"), e = log.column("tau_1");
  if (p < 0) p = 1, e = 2;
  const auto pc = static_cast<size_t>(p), ec = static_cast<size_t>(std::max(e, 1));
  const bool angle = log.header[pc].find("rad") != std::string::npos;
  const auto row = static_cast<size_t>(draw.uniform(0.1, 0.9) * static_cast<double>(rows));
  const long line = static_cast<long>(row) + 2;
  const std::string pn = name_of(log.header[pc]), en = name_of(log.header[ec]);
  const auto finish = [&](const char* name, const std::string& channel, long where) {
    return Spoiled{csv_text(log), name, channel, where};
  };
  switch (fault) {
    case 0:
      scale(log.columns[pc], angle ? 180.0 / pi : 1000.0);
      return finish("unit slip", pn, 0);
    case 1:
      scale(log.columns[ec], 1000.0);
      return finish("unit slip", en, 0);
    case 2:
      std::swap(log.columns[pc], log.columns[ec]);
      return finish("swapped columns", pn, 0);
    case 3:
      scale(log.columns[0], 1000.0);
      return finish("time unit", "time", 0);
    case 4: {
      const long missing = draw.chance(0.5) ? 1 + draw.below(5) : 20 + draw.below(200);
      for (auto& column : log.columns)
        column.erase(column.begin() + static_cast<long>(row),
                     column.begin() +
                         std::min(static_cast<long>(rows) - 100, static_cast<long>(row) + missing));
      return finish("gap", "time", line);
    }
    case 5:
      log.columns[0][row] = log.columns[0][row - 1];
      return finish("duplicate time", "time", line);
    case 6:
      std::swap(log.columns[0][row], log.columns[0][row - 4]);
      return finish("backward time", "time", 0);
    case 7: {
      const double period = log.columns[0][1] - log.columns[0][0];
      for (double& t : log.columns[0]) t += period * draw.uniform(-0.25, 0.25);
      return finish("jitter", "time", 0);
    }
    case 8: {
      const auto length = static_cast<size_t>(0.01 * static_cast<double>(rows)) + 10;
      const size_t from = moving_row(log.columns[pc], length, draw);
      for (size_t k = 1; k <= length; ++k) log.columns[pc][from + k] = log.columns[pc][from];
      return finish("stuck value", pn, static_cast<long>(from) + 2);
    }
    case 9: {
      const auto [low, high] = std::minmax_element(log.columns[ec].begin(), log.columns[ec].end());
      const double way = draw.sign();
      log.columns[ec][row] += way * draw.uniform(0.6, 3.0) * (*high - *low);
      return finish("spike", en, line);
    }
    case 10:
      std::fill(log.columns[ec].begin(), log.columns[ec].end(), log.columns[ec][0]);
      return finish("constant channel", en, 0);
    case 11: {
      const auto [low, high] = std::minmax_element(log.columns[ec].begin(), log.columns[ec].end());
      const double share = draw.uniform(0.08, 0.2), range = *high - *low,
                   top = *high - share * range, bottom = *low + share * range;
      for (double& x : log.columns[ec]) x = std::clamp(x, bottom, top);
      return finish("clipping", en, 0);
    }
    default: {
      const bool empty = draw.chance(0.5);
      Spoiled spoiled = finish(empty ? "missing cell" : "not a number", en, line);
      put_cell(spoiled.text, row + 1, ec, empty ? "" : "NaN");
      return spoiled;
    }
  }
}

}  // namespace sinew::truth
