// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blind/truth/draw_trial.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <stdexcept>

#include "tests/blind/truth/chain.h"
#include "tests/blind/truth/compared.h"
#include "tests/blind/truth/limits.h"
#include "tests/blind/truth/log_files.h"

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
    Course course;
    try {
      course = plant_.course({hidden}, 0);
    } catch (const std::runtime_error&) {
      return too_large();  // no controller holds the machine with it
    }
    course.command.resize(0, 0);
    const Log with = plant_.replay(course, {hidden}, 0), without = plant_.replay(course, {}, 0);
    Log measured = without;
    plant_.measure(measured, 0);
    const auto a = plant_.left_over(with), b = plant_.left_over(without),
               noisy = plant_.left_over(measured);
    const auto fitted = plant_.fitted(without, which);
    // The samples that count are those of the log that is given.
    const auto moving = plant_.moving(with);
    const auto bands = plant_.bands(without, measured);
    std::vector<Channel> channels;
    for (std::size_t c = 0; c < a.size(); ++c) {
      VectorXd added = a[c] - b[c];
      const VectorXd noise = noisy[c] - b[c];
      if (!added.allFinite()) return too_large();
      if (!plant_.shows(hidden, c)) added.setZero();
      channels.push_back({std::move(added), noise, moving[c], fitted[c], bands[c]});
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
  static Size too_large() {
    return {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), -1};
  }

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
            {"plain", sized.size.plain}, {"channel", sized.size.channel},
            {"nats", sized.size.nats}};
  if (offer.order > 0) j["order"] = offer.order;
  if (!offer.parameter.empty())
    j["parameter"] = {{"name", offer.parameter}, {"value", parameter_of(offer, h)}};
  return j;
}

std::size_t wanted_causes(const std::string& family) {
  if (family == "one" || family == "outside" || family == "pair") return 1;
  if (family == "two") return 2;
  if (family == "null" || family == "fault" || family == "drives") return 0;
  throw std::invalid_argument("no family is called '" + family +
                              "'; expected null, one, two, outside, pair, fault, drives");
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

Course TrialPlant::played(const std::vector<Hidden>&, const MatrixXd&, const VectorXd&) const {
  throw std::invalid_argument("this plant plays no planned motion");
}

bool TrialPlant::shows(const Hidden&, std::size_t) const {
  return true;
}

std::unique_ptr<TrialPlant> draw_plant(const TrialRequest& request, Draw draw,
                                       const Pairing* pairing) {
  const std::string& plant = request.plant;
  const bool mujoco = plant.rfind("mujoco_", 0) == 0;
  if (mujoco && !mujoco_is_there()) throw std::runtime_error("this build has no MuJoCo");
  const Mechanics mechanics = mujoco ? Mechanics::mujoco : Mechanics::own;
  const std::string kind = mujoco ? plant.substr(7) : plant;
  if (kind == "drive") return draw_drive(draw, mechanics, pairing);
  if (kind == "arm") return draw_arm(draw, mechanics);
  if (kind == "bare_arm") return draw_bare_arm(draw, mechanics, false);
  if (kind == "bare_slide") return draw_bare_arm(draw, mechanics, true);
  if (kind == "finger") return draw_finger(draw, mechanics);
  if (plant == "joint") return draw_joint(draw, 1.0, pairing);
  // The same joints with twenty times the inertia and all that goes with it.
  if (plant == "heavy_joint") return draw_joint(draw, 20.0);
  if (plant == "hand") return draw_hand(draw);
  if (plant == "lever") return draw_lever(draw);
  if (plant == "wrist") return draw_wrist(draw);
  throw std::invalid_argument("no plant is called '" + plant +
                              "'; expected drive, joint, arm, finger, hand, lever, wrist, "
                              "bare_arm, bare_slide, or mujoco_ before drive, arm, finger, "
                              "bare_arm, bare_slide");
}

namespace {

/// A trial as its seed draws it: the same whenever it is asked for.
struct Drawn {
  std::unique_ptr<TrialPlant> plant;
  std::vector<Hidden> hidden;
  json seal;
  bool own_names = false;
  Draw faulty{0};
};

/// One of a pair hides another's trace: what is left of it where the others may take it up, in
/// units of the noise.
class PairOf {
 public:
  PairOf(const Pairing& pairing, const std::vector<Offer>& offers) {
    for (const PairMember& member : pairing.members)
      for (const Offer& offer : offers)
        if (!offer.outside && (key_of(offer) == member.cause || offer.cause == member.cause)) {
          offers_.push_back(offer);
          offers_.back().sign = member.sign;
          break;
        }
    if (offers_.size() != pairing.members.size())
      throw std::logic_error("the plant does not offer all of '" + pairing.name + "'");
    unsigned fitted = fits_all;
    for (const Offer& offer : offers_) fitted &= offer.fitted;
    for (Offer& offer : offers_) offer.fitted = fitted;
  }

  const std::vector<Offer>& offers() const { return offers_; }

  double apart(const TrialPlant& plant, const Hidden& hidden, const Offer& own) const {
    const Course course = plant.course({hidden}, 0);
    const Log without = plant.replay(course, {}, 0);
    Log measured = without;
    plant.measure(measured, 0);
    const auto clean = plant.left_over(without), noisy = plant.left_over(measured),
               with = plant.left_over(plant.replay(course, {hidden}, 0));
    MatrixXd columns = plant.fitted(without, own.fitted).front();
    for (const Offer& rival : offers_) {
      if (key_of(rival) == key_of(own)) continue;
      Hidden other = hidden;
      other.cause = rival.cause;
      if (rival.order > 0) other.law = rival.order;
      other.dose = 0.05 * rival.scale;
      // A ripple has a phase of its own.
      for (const double phase : {0.0, 0.5 * pi}) {
        if (rival.order > 0) other.phase = phase;
        columns.conservativeResize(Eigen::NoChange, columns.cols() + 1);
        columns.rightCols(1) =
            plant.left_over(plant.replay(course, {other}, 0)).front() - clean.front();
        if (rival.order == 0) break;
      }
    }
    return size_of(
               {{with.front() - clean.front(), noisy.front() - clean.front(),
                 plant.moving(without).front(), columns, plant.bands(without, measured).front()}},
               without.step)
        .excess;
  }

 private:
  std::vector<Offer> offers_;
};

json admissible(const std::vector<Offer>& offers) {
  json list = json::array();
  for (const Offer& offer : offers) {
    list.push_back({{"cause", offer.cause}, {"place", offer.place}});
    if (offer.order > 0) list.back()["order"] = offer.order;
  }
  return list;
}

/// A pair has to be one: what the log tells of it is told in the noise.
void judge_pair(const PairOf& pair, const Offer& own, const Hidden& hidden, Drawn& drawn) {
  constexpr double told = 0.3;
  const double apart = pair.apart(*drawn.plant, hidden, own);
  drawn.seal["admissible"] = admissible(pair.offers());
  drawn.seal["apart"] = apart;
  if (apart < told) return;
  drawn.seal["reachable"] = false;
  drawn.seal["hidden"].back()["unreachable"] = "this motion tells it from the others";
}

bool is_called(const Offer& offer, const std::string& cause) {
  return key_of(offer) == cause || offer.cause == cause;
}

bool offers_it(const TrialPlant& plant, const std::string& cause) {
  return std::any_of(plant.offers().begin(), plant.offers().end(),
                     [&](const Offer& offer) { return is_called(offer, cause); });
}

Drawn drawn_trial(const TrialRequest& request) {
  Draw draw(request.seed);
  const std::size_t count = wanted_causes(request.family);
  const bool is_pair = request.family == "pair";
  std::optional<Pairing> pairing;
  if (is_pair) pairing = draw_pairing(request.plant, request.cause, draw);
  Drawn drawn;
  drawn.plant = draw_plant(request, draw.fork(), pairing ? &*pairing : nullptr);
  // A cause that not every one of these plants offers is asked of one that does. A stream of its
  // own: seeds that follow each other would draw the same plants, one draw apart.
  if (!request.cause.empty() && !is_pair && !offers_it(*drawn.plant, request.cause)) {
    Draw again = draw.fork();
    for (int more = 60; more > 0 && !offers_it(*drawn.plant, request.cause); --more)
      drawn.plant = draw_plant(request, again.fork(), nullptr);
  }
  std::optional<PairOf> pair;
  if (pairing) pair.emplace(*pairing, drawn.plant->offers());
  std::vector<const Offer*> from;
  for (const Offer& offer : pair ? pair->offers() : drawn.plant->offers())
    if (offer.outside == (request.family == "outside") &&
        (request.cause.empty() || is_called(offer, request.cause)))
      from.push_back(&offer);
  if (count > 0 && from.empty())
    throw std::invalid_argument(request.plant + " offers no such cause: " + request.cause);
  json& seal = drawn.seal;
  seal = {{"plant", request.plant},          {"family", request.family}, {"size", request.size},
          {"traits", drawn.plant->traits()}, {"hidden", json::array()},  {"reachable", true}};
  if (pairing) seal["traits"]["motion"] = pairing->name;
  for (const DriveTruth& d : drawn.plant->drives())
    seal["drives"].push_back(
        {{"joint", d.joint}, {"armature", d.armature}, {"level", d.level}, {"viscous", d.viscous}});
  if ((request.family == "drives") == drawn.plant->drives().empty())
    throw std::invalid_argument(
        "the family drives, and no other, is one of bare_arm and bare_slide");
  const Sizer sizer(*drawn.plant);
  while (drawn.hidden.size() < count && !from.empty()) {
    const Offer& offer = pick(from, draw);
    Hidden shape = drawn_shape(offer, draw);
    const double drawn_sign = limit_of(offer.cause).least < 0.0 ? draw.sign() : 1.0;
    const double sign = offer.sign != 0 ? offer.sign : drawn_sign;
    const Sized sized = sizer.dose_for(offer, shape, request.size, sign);
    json told = text_of(offer, sized);
    if (!sized.reached) {
      // Counted, and never replaced by another cause.
      seal["reachable"] = false;
      told["unreachable"] = sized.why;
    }
    seal["hidden"].push_back(told);
    drawn.hidden.push_back(sized.hidden);
    if (pair && sized.reached) judge_pair(*pair, offer, sized.hidden, drawn);
    // A second effect is another cause at another place, where there is one.
    const std::string place = offer.place;
    std::erase_if(from, [&, cause = offer.cause](const Offer* o) { return o->cause == cause; });
    const bool elsewhere =
        std::any_of(from.begin(), from.end(), [&](const Offer* o) { return o->place != place; });
    if (elsewhere) std::erase_if(from, [&](const Offer* o) { return o->place == place; });
  }
  drawn.own_names = draw.chance(0.5);
  drawn.faulty = draw.fork();
  return drawn;
}

/// What a fault of a log adds to what the model leaves over, as a cause's size is told: a clock
/// shows in nothing where a model has no time.
Size size_of_fault(const TrialPlant& plant, const Log& perfect, const Log& good,
                   const Log& faulty) {
  const auto ideal = plant.left_over(perfect), noisy = plant.left_over(good),
             spoilt = plant.left_over(faulty);
  const auto fitted = plant.fitted(perfect, fits_turning);
  const auto moving = plant.moving(perfect);
  const auto bands = plant.bands(perfect, good);
  std::vector<Channel> channels;
  for (std::size_t c = 0; c < ideal.size(); ++c)
    channels.push_back({spoilt[c] - noisy[c], noisy[c] - ideal[c], moving[c], fitted[c], bands[c]});
  return size_of(channels, perfect.step);
}

}  // namespace

std::string draw_trial(const TrialRequest& request, const std::filesystem::path& folder) {
  if (request.logs < 1 || request.logs > 3)
    throw std::invalid_argument("a trial has one to three logs for training");
  Drawn drawn = drawn_trial(request);
  json& seal = drawn.seal;
  if (!seal["reachable"].get<bool>()) return seal.dump();
  drawn.plant->write_model(folder);
  // Log 1 is held out, however many there are for training.
  for (int number = 0; number <= request.logs; ++number) {
    Log log = drawn.plant->replay(drawn.plant->course(drawn.hidden, number), drawn.hidden, number);
    const Log perfect = log;
    drawn.plant->measure(log, number);
    if (number == 0) {
      seal["bands_hz"] = drawn.plant->bands(perfect, log);
      seal["channels"] = log.names;
    }
    if (number == 0 && request.family == "fault") {
      const Log good = log;
      seal["fault"] = spoil_log(log, drawn.faulty);
      // Not a number where a mechanism does not reach what is read.
      const double excess = size_of_fault(*drawn.plant, perfect, good, log).excess;
      seal["fault"]["excess"] = excess;
      seal["reachable"] = !(excess < 1.0);
      if (!seal["reachable"].get<bool>()) {
        seal["fault"]["unreachable"] = "no channel shows it";
        return seal.dump();
      }
    }
    const std::string file = number == 0   ? "train.csv"
                             : number == 1 ? "holdout.csv"
                                           : fmt::format("train{}.csv", number);
    write_log(log, drawn.own_names, folder / file);
    if (number == 0 && drawn.own_names)
      write_channel_names(log, folder / "model" / "channels.toml");
  }
  return seal.dump();
}

void play_motion(const TrialRequest& request, const std::filesystem::path& motion,
                 const std::filesystem::path& out) {
  constexpr int second = 2;
  const Drawn drawn = drawn_trial(request);
  const PlannedMotion planned = read_motion(motion);
  Log log = drawn.plant->replay(drawn.plant->played(drawn.hidden, planned.reference, planned.load),
                                drawn.hidden, second);
  if (std::abs(planned.step / log.step - 1.0) > 1e-6)
    throw std::invalid_argument(motion.string() + ": its period is not the logs'");
  drawn.plant->measure(log, second);
  write_log(log, drawn.own_names, out);
}

}  // namespace sinew::trials
