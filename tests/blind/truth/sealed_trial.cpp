// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blind/truth/sealed_trial.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "tests/blind/truth/spoil.h"

namespace sinew::truth {
namespace {

struct Pair {
  DriveCourse course;
  const char* hidden;
  std::array<const char*, 2> names;
};

// Each pair explains the same log under its course, and no longer in the follow-up.
constexpr std::array<Pair, 5> pairs = {{
    {DriveCourse::one_speed, "coulomb_level", {"coulomb_level", "viscous_level"}},
    {DriveCourse::one_speed, "viscous_level", {"coulomb_level", "viscous_level"}},
    {DriveCourse::constant_load, "load_friction", {"load_friction", "coulomb_level"}},
    {DriveCourse::constant_load, "load_ripple", {"load_ripple", "input_ripple"}},
    {DriveCourse::one_way, "offset", {"offset", "coulomb_level"}},
}};

std::unique_ptr<Plant> draw_plant(const std::string& kind, Draw draw) {
  if (kind == "drive") return draw_drive(draw);
  if (kind == "mujoco_drive") {
    if (auto plant = draw_mujoco_drive(draw)) return plant;
    throw std::runtime_error("this build has no MuJoCo");
  }
  if (kind == "lever") return draw_lever(draw);
  if (kind == "finger") return draw_finger(draw);
  if (kind == "wrist") return draw_wrist(draw);
  throw std::invalid_argument("no plant is called '" + kind +
                              "'; expected drive, mujoco_drive, lever, finger, wrist");
}

// Size of what changes between two residuals: of the channel where it is largest.
double size_between(const std::vector<std::vector<double>>& with,
                    const std::vector<std::vector<double>>& without) {
  double largest = 0.0;
  for (size_t c = 0; c < with.size(); ++c) {
    double sum = 0.0;
    for (size_t k = 0; k < with[c].size(); ++k) {
      const double d = with[c][k] - without[c][k];
      sum += d * d;
    }
    largest = std::max(largest, std::sqrt(sum / static_cast<double>(with[c].size())));
  }
  return largest;
}

}  // namespace

size_t wanted_causes(Family family) {
  switch (family) {
    case Family::one:
    case Family::outside:
    case Family::inseparable:
      return 1;
    case Family::two:
      return 2;
    case Family::three:
      return 3;
    default:
      return 0;
  }
}

SealedTrial::SealedTrial(const TrialRequest& request) : draw_(request.seed) {
  static constexpr std::array<double, 5> sizes = {0.1, 0.2, 0.3, 0.5, 1.0};
  static constexpr std::array<const char*, 4> kinds = {"drive", "lever", "finger", "wrist"};
  const double drawn_size = sizes[static_cast<size_t>(draw_.below(5))];
  const double size = request.size > 0.0 ? request.size : drawn_size;
  const std::string kind =
      request.plant == "any" ? kinds[static_cast<size_t>(draw_.below(4))] : request.plant;
  seal_.family = request.family;
  const Pair& pair = pairs[static_cast<size_t>(draw_.below(static_cast<int>(pairs.size())))];
  const bool inseparable = request.family == Family::inseparable;
  plant_ = inseparable ? draw_drive(draw_.fork(), pair.course) : draw_plant(kind, draw_.fork());
  if (inseparable) {
    seal_.admissible.assign(pair.names.begin(), pair.names.end());
    const auto name = [&](int cause) { return plant_->causes()[static_cast<size_t>(cause)].name; };
    for (const int cause : eligible(false))
      if (name(cause) == pair.names[0] || name(cause) == pair.names[1])
        rivals_.push_back({cause, 0.0});
    for (const int cause : eligible(false))
      if (name(cause) == pair.hidden) hide(cause, size);
  } else {
    hide_drawn(wanted_causes(request.family), request.family == Family::outside, size);
  }
  trial_.plant = plant_->kind();
  trial_.nominal = plant_->nominal();
  Table train = plant_->simulate(doses_, 0);
  plant_->measure(train, 0);
  if (request.family == Family::data_fault) {
    const Spoiled spoiled = spoil(train, draw_.fork());
    seal_.fault = spoiled.fault;
    seal_.channel = spoiled.channel;
    seal_.row = spoiled.row;
    trial_.train = spoiled.text;
  } else {
    trial_.train = csv_text(train);
  }
  trial_.holdout = log_text(1);
}

std::string SealedTrial::log_text(int number) const {
  Table log = plant_->simulate(doses_, number);
  plant_->measure(log, number);
  return csv_text(log);
}

std::string SealedTrial::follow_up() const {
  return log_text(2);
}

std::string SealedTrial::play(const std::string& motion) const {
  Table log = plant_->play(doses_, table_of(motion));
  plant_->measure(log, 3);
  return csv_text(log);
}

std::vector<int> SealedTrial::eligible(bool outside) const {
  std::vector<int> list;
  const auto& causes = plant_->causes();
  for (size_t i = 0; i < causes.size(); ++i)
    if (causes[i].outside == outside) list.push_back(static_cast<int>(i));
  return list;
}

void SealedTrial::hide_drawn(size_t count, bool outside, double size) {
  std::vector<int> from = eligible(outside);
  while (doses_.size() < count && !from.empty()) {
    const auto at = static_cast<size_t>(draw_.below(static_cast<int>(from.size())));
    const int cause = from[at];
    if (!hide(cause, size)) {
      from.erase(from.begin() + static_cast<long>(at));
      continue;
    }
    // Two variants of one name would be one cause.
    const std::string name = plant_->causes()[static_cast<size_t>(cause)].name;
    std::erase_if(
        from, [&](int other) { return plant_->causes()[static_cast<size_t>(other)].name == name; });
  }
}

bool SealedTrial::hide(int cause, double size) {
  const Cause& info = plant_->causes()[static_cast<size_t>(cause)];
  if (info.fixed) return hide_fixed(cause, size);
  double sign = info.least < 0.0 ? draw_.sign() : 1.0;
  HiddenCause found = dose_for(cause, size, sign);
  if (found.size < 0.85 * size && sign < 0.0) found = dose_for(cause, size, 1.0);
  if (found.size < 0.85 * size || found.size > 1.2 * size) return false;
  doses_.push_back({cause, found.value});
  seal_.hidden.push_back(found);
  return true;
}

// What is either there or not is as large as it is: the noise is made to fit.
bool SealedTrial::hide_fixed(int cause, double size) {
  if (!doses_.empty()) return false;
  const Cause& info = plant_->causes()[static_cast<size_t>(cause)];
  const std::vector<Dose> dose{{cause, info.guess}};
  const double reached = size_between(plant_->left_over(plant_->simulate(dose, 0), dose),
                                      plant_->left_over(plant_->simulate({}, 0), dose));
  if (!(reached > 0.0)) return false;
  plant_->scale_noise(reached / size);
  doses_ = dose;
  seal_.hidden.push_back({info.name, info.place, info.unit, info.guess, size});
  return true;
}

// The dose whose trace has the size wanted, by itself: a trace grows about in proportion.
HiddenCause SealedTrial::dose_for(int cause, double size, double sign) const {
  const Cause& info = plant_->causes()[static_cast<size_t>(cause)];
  const double limit = sign > 0.0 ? info.most : -info.least;
  HiddenCause result{info.name, info.place, info.unit, 0.0, 0.0};
  // What a rival explains too still counts.
  std::vector<Dose> own = rivals_;
  own.push_back({cause, 0.0});
  const auto without = plant_->left_over(plant_->simulate({}, 0), own);
  double value = std::min(info.guess, limit);
  for (int i = 0; i < 5; ++i) {
    const std::vector<Dose> dose{{cause, sign * value}};
    const double reached = size_between(plant_->left_over(plant_->simulate(dose, 0), own), without);
    if (!(reached > 0.0) || !std::isfinite(reached)) break;
    result.value = sign * value;
    result.size = reached;
    if (std::abs(reached / size - 1.0) < 0.05 || (value >= limit && reached < size)) break;
    value = std::min(limit, value * std::clamp(size / reached, 0.05, 20.0));
  }
  return result;
}

std::string family_name(Family family) {
  static constexpr std::array<const char*, 7> names = {
      "nothing", "one", "two", "three", "outside", "inseparable", "data fault"};
  return names[static_cast<size_t>(family)];
}

std::string seal_text(const Seal& seal) {
  std::string hidden;
  for (const HiddenCause& h : seal.hidden)
    hidden += fmt::format(
        "{}{{\"name\": \"{}\", \"place\": \"{}\", \"unit\": \"{}\", \"value\": {:.9g}, \"size\": "
        "{:.4g}}}",
        hidden.empty() ? "" : ", ", h.name, h.place, h.unit, h.value, h.size);
  std::string admissible;
  for (const std::string& name : seal.admissible)
    admissible += fmt::format("{}\"{}\"", admissible.empty() ? "" : ", ", name);
  return fmt::format(
      "{{\"family\": \"{}\", \"hidden\": [{}], \"admissible\": [{}], \"fault\": \"{}\", "
      "\"channel\": \"{}\", \"row\": {}}}\n",
      family_name(seal.family), hidden, admissible, seal.fault, seal.channel, seal.row);
}

void write_trial(const SealedTrial& trial, const std::string& folder,
                 const std::string& seal_file) {
  namespace fs = std::filesystem;
  fs::create_directories(folder);
  const auto write = [](const fs::path& path, const std::string& text) {
    std::ofstream out(path, std::ios::binary);
    out << text;
    if (!out) throw std::runtime_error(path.string() + ":0:0: cannot be written");
  };
  write(fs::path(folder) / "train.csv", trial.open().train);
  write(fs::path(folder) / "holdout.csv", trial.open().holdout);
  write(fs::path(folder) / "nominal.json", trial.open().nominal + "\n");
  write(seal_file, seal_text(trial.seal()));
}

}  // namespace sinew::truth
