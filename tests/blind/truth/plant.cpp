// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blind/truth/plant.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace sinew::truth {
namespace {

std::vector<double> moving_mean(const std::vector<double>& x, int m) {
  const long n = static_cast<long>(x.size());
  std::vector<double> sum(x.size() + 1, 0.0), y(x.size());
  for (size_t i = 0; i < x.size(); ++i) sum[i + 1] = sum[i] + x[i];
  for (long i = 0; i < n; ++i) {
    // The window stays centred, so that the ends are not shifted.
    const long w = std::min({static_cast<long>(m), i, n - 1 - i});
    y[static_cast<size_t>(i)] =
        (sum[static_cast<size_t>(i + w + 1)] - sum[static_cast<size_t>(i - w)]) /
        static_cast<double>(2 * w + 1);
  }
  return y;
}

// Nine digits of the largest value.
int decimals_for(const std::vector<double>& column) {
  double largest = 0.0;
  for (const double x : column) largest = std::max(largest, std::abs(x));
  if (largest <= 0.0) return 1;
  return std::clamp(8 - static_cast<int>(std::floor(std::log10(largest))), 1, 15);
}

// As a whole number with a point set in: much faster than the shortest-digits search.
void append_fixed(std::string& text, double value, int decimals) {
  static constexpr std::array<double, 16> powers = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                    1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  const long long whole = std::llround(std::abs(value) * powers[static_cast<size_t>(decimals)]);
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), whole);
  const auto count = static_cast<int>(end.ptr - digits.data());
  if (value < 0.0 && whole != 0) text += '-';
  if (count <= decimals) {
    text += "0.";
    text.append(static_cast<size_t>(decimals - count), '0');
    text.append(digits.data(), end.ptr);
  } else {
    text.append(digits.data(), static_cast<size_t>(count - decimals));
    text += '.';
    text.append(digits.data() + count - decimals, end.ptr);
  }
  const size_t last = text.find_last_not_of('0');
  text.resize(text[last] == '.' ? last + 2 : last + 1);
}

}  // namespace

int Table::column(const std::string& name) const {
  for (size_t i = 0; i < header.size(); ++i)
    if (header[i].substr(0, header[i].find(' ')) == name) return static_cast<int>(i);
  return -1;
}

Table Plant::play(const std::vector<Dose>&, const Table&) const {
  throw std::runtime_error("a " + kind() + " of these trials follows no motions");
}

Table table_of(const std::string& csv) {
  Table table;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream cells(line);
    std::vector<std::string> row;
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
    if (table.header.empty()) {
      table.header = row;
      table.columns.resize(row.size());
      continue;
    }
    for (size_t c = 0; c < row.size(); ++c) table.columns.at(c).push_back(std::stod(row[c]));
  }
  return table;
}

std::string csv_text(const Table& log) {
  std::string text;
  const size_t rows = log.columns.front().size();
  text.reserve(rows * log.columns.size() * 14 + 256);
  for (size_t c = 0; c < log.header.size(); ++c) {
    if (c > 0) text += ',';
    text += log.header[c];
  }
  text += '\n';
  std::vector<int> decimals;
  for (const auto& column : log.columns) decimals.push_back(decimals_for(column));
  for (size_t k = 0; k < rows; ++k) {
    for (size_t c = 0; c < log.columns.size(); ++c) {
      if (c > 0) text += ',';
      append_fixed(text, log.columns[c][k], decimals[c]);
    }
    text += '\n';
  }
  return text;
}

std::vector<double> smoothed(const std::vector<double>& x, int m) {
  return moving_mean(moving_mean(x, m), m);
}

std::vector<double> derivative(const std::vector<double>& x, double period) {
  std::vector<double> d(x.size(), 0.0);
  for (size_t i = 2; i + 2 < x.size(); ++i)
    d[i] = (8.0 * (x[i + 1] - x[i - 1]) - (x[i + 2] - x[i - 2])) / (12.0 * period);
  if (x.size() > 4) {
    d[0] = d[1] = d[2];
    d[x.size() - 1] = d[x.size() - 2] = d[x.size() - 3];
  }
  return d;
}

std::vector<double> without_columns(const std::vector<double>& y,
                                    const std::vector<std::vector<double>>& columns) {
  const auto n = static_cast<long>(y.size());
  const auto p = static_cast<long>(columns.size());
  if (p == 0) return y;
  std::vector<double> scale;
  Eigen::MatrixXd normal(p, p);
  Eigen::VectorXd right(p);
  const auto map = [&](const std::vector<double>& v) {
    return Eigen::Map<const Eigen::VectorXd>(v.data(), n);
  };
  for (const auto& c : columns) scale.push_back(std::max(map(c).norm(), 1.0e-300));
  for (long i = 0; i < p; ++i) {
    const auto a = map(columns[static_cast<size_t>(i)]);
    right(i) = a.dot(map(y)) / scale[static_cast<size_t>(i)];
    for (long j = 0; j < p; ++j)
      normal(i, j) = a.dot(map(columns[static_cast<size_t>(j)])) /
                     (scale[static_cast<size_t>(i)] * scale[static_cast<size_t>(j)]);
  }
  normal += 1.0e-12 * Eigen::MatrixXd::Identity(p, p);
  const Eigen::VectorXd x = normal.ldlt().solve(right);
  std::vector<double> left = y;
  Eigen::Map<Eigen::VectorXd> rest(left.data(), n);
  for (long i = 0; i < p; ++i)
    rest -= (x(i) / scale[static_cast<size_t>(i)]) * map(columns[static_cast<size_t>(i)]);
  return left;
}

}  // namespace sinew::truth
