// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/extension/wrist_effects.h"

#include <string>

#include "symbolic/extension/late_sensor.h"

namespace sinew {
namespace {

using GiNaC::ex;

/// What both angles' sensors may have.
void name(ObservationEffect& a, ObservationEffect& b, const char* parameter, const char* unit,
          double step, const char* experiment) {
  for (ObservationEffect* e : {&a, &b}) {
    e->deviations = {observation_parameter(parameter, unit, -0.5, 0.5, step)};
    e->experiment = experiment;
    e->excitation = "both wrist angles over their range";
    e->limit = "it would be more than half a radian, or half the angle";
  }
}

}  // namespace

WristEffects::WristEffects(std::size_t tendons) {
  describe_wrist();
  describe_angles();
  for (std::size_t i = 0; i < tendons; ++i) add_radius(i);
  write_equations();
}

std::vector<ObservationEffect> WristEffects::all() const {
  std::vector<ObservationEffect> list{coupling, zero71,     zero73,     contact, scale71,
                                      scale73,  low_pass71, low_pass73, play71,  play73};
  list.insert(list.end(), radii.begin(), radii.end());
  return list;
}

void WristEffects::describe_wrist() {
  coupling.deviations = {observation_parameter("share", "1", 0.0, 1.0, 1e-4)};
  coupling.limit = "more than the coupling would be compensated";
  coupling.signature = "motor angles left over in proportion to the tendons' lengths";
  coupling.excitation = "motion of the wrist";
  coupling.experiment = "the fingers watched while the wrist moves";
  contact.deviations = {observation_parameter("radius", "m", 0.0, 0.02, 1e-6)};
  contact.limit = "the tendon would leave its pulley inwards";
  contact.signature = "tendons longer the farther they are bent from the reference pose";
  contact.excitation = "flexion and abduction far from the reference pose";
  contact.experiment = "one wrist angle at a time, over its whole range";
}

void WristEffects::describe_angles() {
  name(zero71, zero73, "offset", "rad", 1e-5, "the palm set parallel to the forearm with a gauge");
  name(scale71, scale73, "scale_error", "1", 1e-5, "the angle between two stops, with a gauge");
  for (ObservationEffect* e : {&zero71, &zero73})
    e->signature = "lengths off by their slope over the angle";
  for (ObservationEffect* e : {&scale71, &scale73})
    e->signature = "lengths off in proportion to the angle";
  const char* shows = "motor angles off as by another angle of the wrist";
  describe_late_sensor({"q71", "rad", 0.5, 1e-5, shows, "wrist"}, low_pass71, play71);
  describe_late_sensor({"q73", "rad", 0.5, 1e-5, shows, "wrist"}, low_pass73, play73);
}

void WristEffects::add_radius(std::size_t i) {
  ObservationEffect e{
      "pulley_radius",      "pulley radius", "motor " + std::to_string(i + 1), {}, {},
      {static_cast<int>(i)}};
  e.deviations = {observation_parameter("change", "1", -0.5, 1.0, 1e-4)};
  e.signature = "one motor's angle off by a constant share";
  e.excitation = "motion of the wrist";
  e.experiment = "the pulley measured";
  e.limit = "the pulley would be less than half or more than twice as large";
  radii.push_back(e);
}

void WristEffects::write_equations() {
  const GiNaC::symbol theta("theta"), h("h"), q71("q71"), q73("q73"), turned("turned");
  const auto say = [](ObservationEffect& effect, const char* left, const ex& term) {
    effect.left = left;
    effect.term = term;
  };
  say(coupling, "theta", theta * (1 - coupling.deviation()));
  say(zero71, "q71", q71 + zero71.deviation());
  say(zero73, "q73", q73 + zero73.deviation());
  say(contact, "h", h + contact.deviation() * turned);
  say(scale71, "q71", q71 / (1 + scale71.deviation()));
  say(scale73, "q73", q73 / (1 + scale73.deviation()));
  for (ObservationEffect& r : radii) say(r, "theta", theta / (1 + r.deviation()));
}

}  // namespace sinew
