// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blind/truth/trials/draw_trial.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "tests/blind/truth/trials/chain.h"
#include "tests/blind/truth/trials/compared.h"
#include "tests/blind/truth/trials/limits.h"
#include "tests/blind/truth/trials/log_files.h"

namespace sinew::trials {
namespace {

using nlohmann::json;
using truth::Draw;

/// Causes of one name and order are one cause, at several places.
std::string key_of(const Offer& offer) {
  return offer.order > 0 ? fmt::format("{} {}", offer.cause, offer.order) : offer.cause;
}

Hidden drawn_shape(const Offer& offer, Draw& draw) {
  Hidden h;
  h.cause = offer.cause;
  h.at = offer.at;
  h.law = offer.order > 0 ? offer.order : draw.below(3);
  h.phase = draw.uniform(0.0, 2.0 * pi);
  h.seed = draw.bits();
  // Wider than any grid a program is likely to search.
  const double wide = draw.unit();
  h.width = offer.cause == "stribeck"           ? 0.005 * std::pow(60.0, wide)
            : offer.cause == "concave_friction" ? 0.03 * std::pow(30.0, wide)
            : offer.cause == "friction_drift"   ? 2.0 * std::pow(30.0, wide)
                                                : wide;
  return h;
}

struct Sized {
  Hidden hidden;
  Size size;
  bool reached = false;
  std::string why;
};

class Sizer {
 public:
  explicit Sizer(const TrialPlant& plant) : plant_(plant) {}

  /// What the cause adds on the training log: both runs replay one motion.
  Size of(const Hidden& hidden, unsigned which) const {
    Course course = plant_.course({hidden}, 0);
    course.command.resize(0, 0);
    const Log with = plant_.replay(course, {hidden}, 0), without = plant_.replay(course, {}, 0);
    Log measured = without;
    plant_.measure(measured, 0);
    const auto a = plant_.left_over(with), b = plant_.left_over(without),
               noisy = plant_.left_over(measured);
    const auto fitted = plant_.fitted(without, which);
    const auto moving = plant_.moving(without);
    const auto bands = plant_.bands(without, measured);
    std::vector<Channel> channels;
    for (std::size_t c = 0; c < a.size(); ++c) {
      const VectorXd added = a[c] - b[c], noise = noisy[c] - b[c];
      channels.push_back({added, noise, moving[c], fitted[c], bands[c]});
      if (!added.allFinite()) return {};
    }
    return size_of(channels, without.step);
  }

  Sized dose_for(const Offer& offer, Hidden hidden, double size, double sign) const {
    const Limit& limit = limit_of(offer.cause);
    const double most = (sign > 0.0 ? limit.most : -limit.least) * offer.scale;
    Sized result{hidden, {}, false, "the largest dose is too small"};
    double value = 0.05 * most, low = 0.0, high = most;
    for (int i = 0; i < 12; ++i) {
      result.hidden.dose = sign * value;
      result.size = of(result.hidden, offer.fitted);
      const double reached = result.size.excess;
      if (std::abs(reached / size - 1.0) < 0.04) {
        result.reached = true;
        result.why.clear();
        return result;
      }
      if (reached < size) {
        low = value;
        if (value >= most * 0.999) return result;
      } else {
        high = value;
      }
      const double guess =
          reached > 0.0 ? value * std::clamp(size / reached, 0.05, 20.0) : 20.0 * value;
      value = std::min(guess, most);
      if (value <= low || value >= high)
        value = high < most || low > 0.0 ? 0.5 * (low + high) : most;
      if (i > 6 && value < most) value = 0.5 * (low + high);
    }
    result.why = "no dose has this size";
    return result;
  }

 private:
  const TrialPlant& plant_;
};

/// What the finding's parameter should hold.
double parameter_of(const Offer& offer, const Hidden& h) {
  const bool of_scale = offer.parameter == "scale_error" || offer.parameter == "force_excess";
  return offer.factor * (of_scale ? h.dose / (1.0 + h.dose) : h.dose);
}

json text_of(const Offer& offer, const Sized& sized) {
  const Hidden& h = sized.hidden;
  json j = {{"cause", offer.cause},      {"place", offer.place},
            {"value", h.dose},           {"law", h.law},
            {"width", h.width},          {"excess", sized.size.excess},
            {"plain", sized.size.plain}, {"channel", sized.size.channel}};
  if (offer.order > 0) j["order"] = offer.order;
  if (!offer.parameter.empty())
    j["parameter"] = {{"name", offer.parameter}, {"value", parameter_of(offer, h)}};
  return j;
}

std::size_t wanted_causes(const std::string& family) {
  if (family == "one" || family == "outside") return 1;
  if (family == "two") return 2;
  if (family == "null" || family == "fault") return 0;
  throw std::invalid_argument("no family is called '" + family +
                              "'; expected null, one, two, outside, fault");
}

/// A cause of those left, uniformly; one of its places, uniformly.
const Offer& pick(const std::vector<const Offer*>& from, Draw& draw) {
  std::set<std::string> keys;
  for (const Offer* offer : from) keys.insert(key_of(*offer));
  auto key = keys.begin();
  std::advance(key, draw.below(static_cast<int>(keys.size())));
  std::vector<const Offer*> places;
  for (const Offer* offer : from)
    if (key_of(*offer) == *key) places.push_back(offer);
  return *places[static_cast<std::size_t>(draw.below(static_cast<int>(places.size())))];
}

}  // namespace

std::unique_ptr<TrialPlant> draw_plant(const TrialRequest& request, Draw draw) {
  const std::string& plant = request.plant;
  const bool mujoco = plant.rfind("mujoco_", 0) == 0;
  if (mujoco && !mujoco_is_there()) throw std::runtime_error("this build has no MuJoCo");
  const Mechanics mechanics = mujoco ? Mechanics::mujoco : Mechanics::own;
  const std::string kind = mujoco ? plant.substr(7) : plant;
  if (kind == "drive") return draw_drive(draw, mechanics);
  if (kind == "arm") return draw_arm(draw, mechanics);
  if (kind == "finger") return draw_finger(draw, mechanics);
  if (plant == "joint") return draw_joint(draw);
  // The same joints with twenty times the inertia and all that goes with it.
  if (plant == "heavy_joint") return draw_joint(draw, 20.0);
  if (plant == "hand") return draw_hand(draw);
  if (plant == "lever") return draw_lever(draw);
  if (plant == "wrist") return draw_wrist(draw);
  throw std::invalid_argument("no plant is called '" + plant +
                              "'; expected drive, joint, arm, finger, hand, lever, wrist, "
                              "mujoco_drive, mujoco_arm, mujoco_finger");
}

std::string draw_trial(const TrialRequest& request, const std::filesystem::path& folder) {
  Draw draw(request.seed);
  const std::size_t count = wanted_causes(request.family);
  const std::unique_ptr<TrialPlant> plant = draw_plant(request, draw.fork());
  std::vector<const Offer*> from;
  for (const Offer& offer : plant->offers())
    if (offer.outside == (request.family == "outside") &&
        (request.cause.empty() || key_of(offer) == request.cause || offer.cause == request.cause))
      from.push_back(&offer);
  if (count > 0 && from.empty())
    throw std::invalid_argument(request.plant + " offers no such cause: " + request.cause);
  json seal = {{"plant", request.plant},    {"family", request.family}, {"size", request.size},
               {"traits", plant->traits()}, {"hidden", json::array()},  {"reachable", true}};
  std::vector<Hidden> hidden;
  const Sizer sizer(*plant);
  while (hidden.size() < count && !from.empty()) {
    const Offer& offer = pick(from, draw);
    Hidden shape = drawn_shape(offer, draw);
    const double drawn = limit_of(offer.cause).least < 0.0 ? draw.sign() : 1.0;
    const double sign = offer.sign != 0 ? offer.sign : drawn;
    const Sized sized = sizer.dose_for(offer, shape, request.size, sign);
    json told = text_of(offer, sized);
    if (!sized.reached) {
      // Counted, and never replaced by another cause.
      seal["reachable"] = false;
      told["unreachable"] = sized.why;
    }
    seal["hidden"].push_back(told);
    hidden.push_back(sized.hidden);
    // A second effect is another cause at another place, where there is one.
    const std::string key = key_of(offer), place = offer.place;
    std::erase_if(from, [&](const Offer* o) { return o->cause == offer.cause; });
    const bool elsewhere =
        std::any_of(from.begin(), from.end(), [&](const Offer* o) { return o->place != place; });
    if (elsewhere) std::erase_if(from, [&](const Offer* o) { return o->place == place; });
  }
  if (!seal["reachable"].get<bool>()) return seal.dump();
  plant->write_model(folder);
  const bool own_names = draw.chance(0.5);
  Draw faulty = draw.fork();
  if (request.logs < 1 || request.logs > 3)
    throw std::invalid_argument("a trial has one to three logs for training");
  // Log 1 is held out, however many there are for training.
  for (int number = 0; number <= request.logs; ++number) {
    Log log = plant->replay(plant->course(hidden, number), hidden, number);
    const Log perfect = log;
    plant->measure(log, number);
    if (number == 0) {
      seal["bands_hz"] = plant->bands(perfect, log);
      seal["channels"] = log.names;
    }
    if (number == 0 && request.family == "fault") seal["fault"] = spoil_log(log, faulty);
    const std::string file = number == 0   ? "train.csv"
                             : number == 1 ? "holdout.csv"
                                           : fmt::format("train{}.csv", number);
    write_log(log, own_names, folder / file);
    if (number == 0 && own_names) write_channel_names(log, folder / "model" / "channels.toml");
  }
  return seal.dump();
}

}  // namespace sinew::trials
