// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "tests/identification/logs/planted_log.h"
#include "tests/reference/temporary_folder.h"

namespace sinew::test {
namespace {

constexpr double pi = 3.14159265358979323846;

double uniform(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
double normal(std::mt19937_64& random, double sigma) {
  return std::normal_distribution<double>(0.0, sigma)(random);
}
long between(std::mt19937_64& random, long low, long high) {
  return std::uniform_int_distribution<long>(low, high)(random);
}

struct Kind {
  double dt, seconds;
  double inertia, viscous, coulomb;
  double size;     // of the motion
  double quantum;  // of the position
  double effort_noise;
  bool rests, velocity, linear;
  int time_decimals;
};

constexpr std::array<Kind, clean_kinds> kinds = {{
    {0.001, 10.0, 2.0e-3, 0.0356, 0.4, 0.8, 2.0e-5, 0.01, false, false, false, 6},
    {0.001, 12.0, 0.02, 0.05, 0.3, 1.2, 1.5e-3, 0.02, true, false, false, 6},
    {0.001, 8.0, 0.01, 0.1, 0.2, 1.0, 0.0, 0.0, true, true, false, 9},
    {1.0 / 3000.0, 5.0, 2.0e-3, 0.03, 0.5, 0.7, 1.0e-5, 0.01, false, true, false, 6},
    {0.005, 40.0, 0.05, 0.2, 0.3, 1.4, 1.0e-4, 0.02, false, true, false, 4},
    {0.001, 12.0, 95.0, 200.0, 20.0, 0.12, 5.0e-8, 1.5, true, false, true, 6},
}};

// Sum of sines, or smooth strokes with rests between them.
class Reference {
 public:
  Reference(const Kind& kind, std::mt19937_64& random) : rests_(kind.rests), size_(kind.size) {
    for (int i = 0; i < 4; ++i) {
      frequency_.push_back(uniform(random, 0.15, 1.6));
      phase_.push_back(uniform(random, 0.0, 2.0 * pi));
    }
    for (int i = 0; i < 64; ++i) stops_.push_back(uniform(random, -1.0, 1.0));
  }

  double operator()(double t) const {
    t = std::max(t, 0.0);
    if (rests_) {
      const double stroke = 1.3, rest = 0.35, cycle = stroke + rest;
      const auto i = static_cast<size_t>(t / cycle) % 63;
      const double s = std::min(1.0, (t - std::floor(t / cycle) * cycle) / stroke);
      const double blend = s * s * s * (10.0 + s * (6.0 * s - 15.0));
      return size_ * (stops_[i] + (stops_[i + 1] - stops_[i]) * blend);
    }
    double sum = 0.0;
    for (size_t i = 0; i < frequency_.size(); ++i)
      sum += std::sin(2.0 * pi * frequency_[i] * t + phase_[i]);
    return 0.35 * size_ * sum;
  }

 private:
  bool rests_;
  double size_;
  std::vector<double> frequency_, phase_, stops_;
};

std::string number(double value, int digits = 9) {
  return fmt::format("{:.{}g}", value, digits);
}

double value_of(const std::string& cell) {
  double value = std::nan("");
  std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return value;
}

// A row in the moving middle of the log: the position changes there.
long moving_row(const PlantedLog& log, std::mt19937_64& random, long room) {
  const auto p = static_cast<size_t>(1);
  const long n = static_cast<long>(log.cells.size());
  const auto at = [&](long k) { return value_of(log.cells[static_cast<size_t>(k)][p]); };
  double largest = 0.0;
  for (long k = 0; k + room < n; k += 7)
    largest = std::max(largest, std::abs(at(k + room) - at(k)));
  for (int tries = 0; tries < 5000; ++tries) {
    const long k = between(random, n / 10, n * 9 / 10 - room);
    if (std::abs(at(k + room) - at(k)) > 0.4 * largest) return k;
  }
  return n / 2;
}

long line_of(long row) {
  return row + 2;
}

void scale(PlantedLog& log, int column, double factor) {
  for (auto& row : log.cells) {
    std::string& cell = row[static_cast<size_t>(column)];
    cell = number(value_of(cell) * factor);
  }
}

void exchange(PlantedLog& log, int a, int b) {
  for (auto& row : log.cells) std::swap(row[static_cast<size_t>(a)], row[static_cast<size_t>(b)]);
}

double spread(const PlantedLog& log, int column, double& low, double& high) {
  low = 1.0e300, high = -1.0e300;
  for (const auto& row : log.cells) {
    const double v = value_of(row[static_cast<size_t>(column)]);
    low = std::min(low, v);
    high = std::max(high, v);
  }
  return high - low;
}

void clip(PlantedLog& log, int column, double share) {
  double low = 0.0, high = 0.0;
  const double range = spread(log, column, low, high);
  for (auto& row : log.cells) {
    std::string& cell = row[static_cast<size_t>(column)];
    cell = number(std::clamp(value_of(cell), low + share * range, high - share * range));
  }
}

std::string channel_at(const PlantedLog& log, int column) {
  const std::string& cell = log.header[static_cast<size_t>(column)];
  return cell.substr(0, cell.find(' '));
}

}  // namespace

int PlantedLog::column(const std::string& begins) const {
  for (size_t i = 0; i < header.size(); ++i)
    if (header[i].starts_with(begins)) return static_cast<int>(i);
  return -1;
}

std::string PlantedLog::text() const {
  std::string out;
  const auto line = [&](const std::vector<std::string>& row) {
    for (size_t i = 0; i < row.size(); ++i) {
      if (i > 0) out += delimiter;
      out += row[i];
    }
    out += '\n';
  };
  line(header);
  for (const auto& row : cells) line(row);
  return out;
}

PlantedLog clean_log(int number_of_kind, std::mt19937_64& random) {
  const Kind& kind = kinds[static_cast<size_t>(number_of_kind)];
  const Reference reference(kind, random);
  PlantedLog log;
  const DriveLimits limits{-1.6 * kind.size, 1.6 * kind.size, 25.0 * kind.size,
                           120.0 * kind.coulomb};
  log.specs = kind.linear ? linear_drive_channels(limits) : rotary_drive_channels(limits);
  log.header = kind.linear ? std::vector<std::string>{"time [s]", "x [m]", "f [N]", "x_ref [m]"}
                           : std::vector<std::string>{"time [s]", "theta [rad]", "tau_m [N·m]",
                                                      "theta_ref [rad]"};
  if (kind.velocity) log.header.push_back("omega [rad/s]");
  const int inner = std::max(4, static_cast<int>(std::lround(kind.dt / 2.5e-4)));
  const double h = kind.dt / inner, bandwidth = 2.0 * pi * 12.0;
  const double kp = kind.inertia * bandwidth * bandwidth, kd = 2.0 * 0.8 * kind.inertia * bandwidth;
  double q = reference(0.0), coloured = 0.0;
  double v = (reference(2.0e-4) - reference(0.0)) / 2.0e-4;
  const auto rows = static_cast<long>(kind.seconds / kind.dt);
  for (long k = 0; k < rows; ++k) {
    const double t = static_cast<double>(k) * kind.dt;
    coloured = 0.9 * coloured + normal(random, kind.effort_noise);
    double effort = 0.0;
    const double q0 = q, v0 = v;
    for (int i = 0; i < inner; ++i) {
      const double now = t + i * h;
      const double rate = (reference(now + 1.0e-4) - reference(now - 1.0e-4)) / 2.0e-4;
      const double control = kp * (reference(now) - q) + kd * (rate - v) +
                             0.8 * kind.coulomb * std::tanh(rate / (0.02 * kind.size));
      if (i == 0) effort = control;
      const double friction = kind.viscous * v + kind.coulomb * std::tanh(v / (0.005 * kind.size));
      // The friction's slope is taken implicitly: it is stiff near rest.
      const double cosine = std::cosh(std::min(30.0, std::abs(v) / (0.005 * kind.size)));
      const double slope = kind.viscous + kind.coulomb / (0.005 * kind.size * cosine * cosine);
      v += h * (control - friction) / (kind.inertia + h * slope);
      q += h * v;
    }
    const double measured = kind.quantum > 0.0 ? kind.quantum * std::round(q0 / kind.quantum) : q0;
    std::vector<std::string> row{fmt::format("{:.{}f}", t, kind.time_decimals), number(measured),
                                 number(effort + coloured + normal(random, kind.effort_noise)),
                                 number(reference(t))};
    if (kind.velocity)
      row.push_back(number(v0 + normal(random, 0.02 * kind.size * (kind.quantum > 0.0))));
    log.cells.push_back(std::move(row));
  }
  return log;
}

std::string planted_name(int fault) {
  static constexpr std::array<const char*, planted_kinds> names = {"empty cell",
                                                                   "NaN",
                                                                   "text in a cell",
                                                                   "short row",
                                                                   "long rows",
                                                                   "duplicate time",
                                                                   "backward time",
                                                                   "time restarts",
                                                                   "short gap",
                                                                   "long gap",
                                                                   "jitter",
                                                                   "coarse stamps",
                                                                   "time in ms",
                                                                   "position in deg",
                                                                   "position in mm",
                                                                   "effort x 1000",
                                                                   "velocity in deg/s",
                                                                   "velocity in rpm",
                                                                   "reference in deg",
                                                                   "position, velocity",
                                                                   "position, effort",
                                                                   "position, reference",
                                                                   "constant channel",
                                                                   "clipped effort",
                                                                   "clipped position",
                                                                   "stuck position",
                                                                   "stuck effort",
                                                                   "spike"};
  return names[static_cast<size_t>(fault)];
}

Planted plant(int fault, PlantedLog& log, std::mt19937_64& random) {
  const long n = static_cast<long>(log.cells.size());
  const bool linear = log.column("x [") >= 0;
  const int p = 1, e = 2, r = 3, v = log.column("omega");
  const long k = between(random, n / 10, n * 9 / 10);
  const int c = static_cast<int>(between(random, 1, static_cast<long>(log.header.size()) - 1));
  auto& cells = log.cells;
  const auto cell = [&](long row, int column) -> std::string& {
    return cells[static_cast<size_t>(row)][static_cast<size_t>(column)];
  };
  const auto named = [&](FaultKind kind, int column, long row, bool either = false) {
    return Planted{kind, column == 0 ? "time" : channel_at(log, column), row, either};
  };
  const double radians = linear ? 1000.0 : 180.0 / pi;
  switch (fault) {
    case 0:
      cell(k, c) = "";
      return named(FaultKind::missing_cell, c, line_of(k));
    case 1:
      cell(k, c) = "NaN";
      return named(FaultKind::not_a_number, c, line_of(k));
    case 2:
      cell(k, c) = "ERR";
      return named(FaultKind::not_numeric, c, line_of(k));
    case 3:
      cells[static_cast<size_t>(k)].pop_back();
      return named(FaultKind::row_length, static_cast<int>(log.header.size()) - 1, line_of(k));
    case 4:
      for (auto& row : cells) row.insert(row.begin() + 2, "5");
      return Planted{FaultKind::row_length, "", 2, false};
    case 5:
      cell(k, 0) = cell(k - 1, 0);
      return named(FaultKind::duplicate_time, 0, line_of(k));
    case 6:
      std::swap(cell(k, 0), cell(k - 3, 0));
      return Planted{FaultKind::backward_time, "time", 0, false};
    case 7: {
      const std::string base = cell(k / 2, 0);
      const long from = k / 2;
      for (long i = n - 1; i >= k; --i) cell(i, 0) = cell(i - k + from / 2, 0);
      return named(FaultKind::time_restart, 0, line_of(k));
    }
    case 8:
    case 9: {
      const long missing = fault == 8 ? between(random, 1, 5) : between(random, 20, 200);
      cells.erase(cells.begin() + k, cells.begin() + std::min(n - 100, k + missing));
      return named(FaultKind::gap, 0, line_of(k));
    }
    case 10: {
      const double dt = value_of(cell(1, 0)) - value_of(cell(0, 0));
      for (long i = 0; i < n; ++i)
        cell(i, 0) =
            fmt::format("{:.9f}", value_of(cell(i, 0)) + uniform(random, -0.25, 0.25) * dt);
      return named(FaultKind::jitter, 0, 0);
    }
    case 11: {
      const double dt = value_of(cell(n - 1, 0)) / static_cast<double>(n - 1);
      const int decimals = static_cast<int>(std::floor(-std::log10(1.6 * dt)));
      for (long i = 0; i < n; ++i)
        cell(i, 0) = fmt::format("{:.{}f}", value_of(cell(i, 0)), decimals);
      return named(FaultKind::coarse_time, 0, 0);
    }
    case 12:
      scale(log, 0, 1000.0);
      return named(FaultKind::time_unit, 0, 0);
    case 13:
    case 14:
      scale(log, p, radians);
      return named(FaultKind::unit_slip, p, 0, true);
    case 15:
      scale(log, e, 1000.0);
      return named(FaultKind::unit_slip, e, 0, true);
    case 16:
      if (v >= 0)
        scale(log, v, 180.0 / pi);
      else
        scale(log, p, radians);
      return named(FaultKind::unit_slip, v >= 0 ? v : p, 0, true);
    case 17:
      if (v >= 0)
        scale(log, v, 30.0 / pi);
      else
        scale(log, p, 1.0 / radians);
      return named(FaultKind::unit_slip, v >= 0 ? v : p, 0, true);
    case 18:
      scale(log, r, radians);
      return named(FaultKind::unit_slip, r, 0, true);
    case 19:
      exchange(log, p, v >= 0 ? v : e);
      return named(FaultKind::swapped_columns, p, 0, true);
    case 20:
      exchange(log, p, e);
      return named(FaultKind::swapped_columns, p, 0, true);
    case 21:
      exchange(log, p, r);
      return named(FaultKind::swapped_columns, p, 0, true);
    case 22:
      for (long i = 0; i < n; ++i) cell(i, c) = cell(0, c);
      return named(FaultKind::constant_channel, c, 0);
    case 23:
      clip(log, e, uniform(random, 0.05, 0.2));
      return named(FaultKind::clipping, e, 0);
    case 24:
      clip(log, p, uniform(random, 0.05, 0.2));
      return named(FaultKind::clipping, p, 0);
    case 25:
    case 26: {
      const int column = fault == 25 ? p : e;
      const long length = between(random, n / 200, n / 60);
      const long from = moving_row(log, random, length);
      for (long i = 1; i <= length; ++i) cell(from + i, column) = cell(from, column);
      return named(FaultKind::stuck, column, line_of(from));
    }
    default: {
      double low = 0.0, high = 0.0;
      const double range = spread(log, c, low, high);
      const double sign = uniform(random, 0.0, 1.0) < 0.5 ? -1.0 : 1.0;
      cell(k, c) = number(value_of(cell(k, c)) + sign * uniform(random, 0.3, 3.0) * range);
      return named(FaultKind::spike, c, line_of(k));
    }
  }
}

std::string write_file(const std::string& name, const std::string& text) {
  // Tests run side by side: each process has a folder of its own, gone at its end.
  static const reference::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / name;
  reference::write_text(path, text);
  return path.string();
}

}  // namespace sinew::test
