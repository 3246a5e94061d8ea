// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <stdexcept>

#include "symbolic/effects/effects.h"
#include "symbolic/expressions/argument.h"
#include "symbolic/expressions/definition_list.h"
#include "symbolic/expressions/exact_number.h"
#include "symbolic/expressions/inline_function.h"
#include "symbolic/extension/driven_model.h"
#include "symbolic/extension/identified_mechanism.h"

namespace sinew {
namespace {

using GiNaC::ex;

/// Writes the effort down: signals of every joint, then the terms.
class EffortWriter {
 public:
  EffortWriter(const DrivenModel& model, const Identified& identified)
      : model_(model), identified_(identified), n_(static_cast<int>(model.joints.size())) {
    q_ = joint_argument("q", "", [](const DrivenJoint& j) { return j.position; });
    qd_ = joint_argument("qd", "/s", [](const DrivenJoint& j) { return j.velocity; });
    qdd_ = joint_argument("qdd", "/s^2", [](const DrivenJoint& j) { return j.acceleration; });
    load_ = array_argument("load", n_, 1, effort_unit(), {-10.0, 10.0},
                           "external load against positive motion");
    if (!model_.tendons.names.empty())
      tension_ = array_argument("tension", static_cast<int>(model_.tendons.names.size()), 1, "N",
                                {0.0, 100.0}, "measured force of the tendons");
    jerk_ = joint_argument("qddd", "/s^3", [](const DrivenJoint&) { return Range{-1e3, 1e3}; });
    jounce_ = joint_argument("qdddd", "/s^4", [](const DrivenJoint&) { return Range{-1e4, 1e4}; });
    time_ = scalar_argument("time", "s", {0.0, 100.0}, "since the start");
    step_ = scalar_argument("step", "s", {1e-4, 1e-2}, "to the next call");
    advance_motion();
    make_states();
    make_directions();
    make_tendon_signals();
  }

  Function effort() {
    std::vector<ex> inputs(q_at_);
    inputs.insert(inputs.end(), qd_at_.begin(), qd_at_.end());
    inputs.insert(inputs.end(), qdd_at_.begin(), qdd_at_.end());
    std::vector<ex> tau = inlined(list_, model_.rigid, inputs).front();
    if (!model_.joints.empty() && model_.joints.front().carries_links) carried_ = tau;
    for (std::size_t i = 0; i < tau.size(); ++i) tau[i] += drive(i) + load_.symbols[i];
    for (const IdentifiedEffect& each : identified_.effects)
      if (is_term(each)) add_term(each, tau);
    for (const IdentifiedEffect& each : identified_.effects)
      if (each.effect == "torque_constant" || each.effect == "pulley_radius")
        tau[joint_of(each.place)] /= 1 + exact_number(each.coefficient("gain_change"));
    Function f{"effort",      "Effort that the drives have to give for a motion against a load.",
               "(3.5)",       {q_, qd_, qdd_, load_},
               list_.items(), {{"tau", n_, 1, tau, effort_unit(), "effort of the drives"}}};
    if (!next_.empty())
      f.outputs.push_back(
          {"next", static_cast<int>(next_.size()), 1, next_, "1", "states for the next call"});
    if (!tension_.symbols.empty()) f.inputs.push_back(tension_);
    f.inputs.push_back(jerk_);
    f.inputs.push_back(jounce_);
    f.inputs.push_back(time_);
    f.inputs.push_back(step_);
    if (states_.rows > 0) f.inputs.push_back(states_);
    return without_unused(f);
  }

  Function compensation(double share) {
    std::vector<ex> tau(static_cast<std::size_t>(n_), ex(0));
    bool any = false;
    for (const IdentifiedEffect& each : identified_.effects) {
      if (!is_term(each) || tendon_of(each.place) || !is_measurable(find_effect(each.effect)) ||
          depends_on_links(each))
        continue;
      tau[joint_of(each.place)] += exact_number(share) * term(each);
      any = true;
    }
    Function f{"compensation",
               fmt::format("Feedforward of {} % of the identified effects that depend on what is "
                           "measured.",
                           100.0 * share),
               "",
               {q_, qd_, load_},
               list_.items(),
               {}};
    if (any) f.outputs.push_back({"tau", n_, 1, tau, effort_unit(), "to be added to the command"});
    return without_unused(f);
  }

 private:
  template <class RangeOf>
  Argument joint_argument(const std::string& name, const std::string& suffix, RangeOf range) {
    Argument argument = array_argument(name, n_, 1, "", {}, "");
    argument.ranges.clear();
    bool turns = false, slides = false;
    for (const DrivenJoint& joint : model_.joints) {
      argument.ranges.push_back(range(joint));
      (joint.revolute ? turns : slides) = true;
    }
    argument.unit = (turns ? "rad" + suffix : "") + (turns && slides ? " | " : "") +
                    (slides ? "m" + suffix : "");
    return argument;
  }

  std::string effort_unit() const {
    const bool turns = std::any_of(model_.joints.begin(), model_.joints.end(),
                                   [](const DrivenJoint& j) { return j.revolute; });
    const bool slides = std::any_of(model_.joints.begin(), model_.joints.end(),
                                    [](const DrivenJoint& j) { return !j.revolute; });
    return turns && slides ? "N m | N" : turns ? "N m" : "N";
  }

  std::size_t joint_of(const std::string& place) const {
    for (std::size_t i = 0; i < model_.joints.size(); ++i)
      if (model_.joints[i].name == place) return i;
    throw std::invalid_argument("identified.toml: model '" + model_.name + "' has no joint '" +
                                place + "'");
  }

  /// "tendon <name>" -> its number.
  std::optional<std::size_t> tendon_of(const std::string& place) const {
    for (std::size_t t = 0; t < model_.tendons.names.size(); ++t)
      if (place == tendon_place(model_.tendons.names[t])) return t;
    return {};
  }

  static bool is_term(const IdentifiedEffect& each) {
    return each.effect != "delay" && each.effect != "direction" &&
           each.effect != "torque_constant" && each.effect != "pulley_radius" &&
           !changes_mechanism(each);
  }

  const IdentifiedEffect* special(const std::string& effect, std::size_t joint) const {
    for (const IdentifiedEffect& each : identified_.effects)
      if (each.effect == effect && joint_of(each.place) == joint) return &each;
    return nullptr;
  }

  /// What is logged now acts later: the motion it belongs to lies ahead.
  void advance_motion() {
    for (std::size_t i = 0; i < model_.joints.size(); ++i) {
      ex q = q_.symbols[i], qd = qd_.symbols[i], qdd = qdd_.symbols[i];
      if (const IdentifiedEffect* delay = special("delay", i)) {
        const ex d = exact_number(delay->coefficient("delay"));
        q = list_.define("q_ahead", q + d * qd + d * d / 2 * qdd);
        qd = list_.define("qd_ahead", qd + d * qdd + d * d / 2 * jerk_.symbols[i]);
        qdd =
            list_.define("qdd_ahead", qdd + d * jerk_.symbols[i] + d * d / 2 * jounce_.symbols[i]);
      }
      q_at_.push_back(q);
      qd_at_.push_back(qd);
      qdd_at_.push_back(qdd);
    }
  }

  void make_states() {
    std::size_t count = 0;
    for (const IdentifiedEffect& each : identified_.effects)
      count += each.effect == "direction" ? 1
               : is_term(each)            ? find_effect(each.effect).states.size()
                                          : 0;
    if (count > 0)
      states_ = array_argument("memory", static_cast<int>(count), 1, "1", {-1.0, 1.0},
                               "of the effects with memory");
    else
      states_.rows = 0;
  }

  void make_directions() {
    for (std::size_t i = 0; i < model_.joints.size(); ++i) {
      const DrivenJoint& joint = model_.joints[i];
      if (const IdentifiedEffect* law = special("direction", i)) {
        directions_.push_back(bristle(*law, i));
        continue;
      }
      const double speed =
          joint.friction_speed > 0.0 ? joint.friction_speed : assumed_friction_speed(joint);
      directions_.push_back(soft_sign(qd_at_[i], speed));
    }
  }

  void make_tendon_signals() {
    const DrivenTendons& tendons = model_.tendons;
    if (tendons.names.empty()) return;
    const auto n = static_cast<std::ptrdiff_t>(tendons.coordinates());
    std::vector<ex> inputs(q_at_.begin(), q_at_.begin() + n);
    inputs.insert(inputs.end(), qd_at_.begin(), qd_at_.begin() + n);
    std::vector<std::vector<ex>> motion = inlined(list_, tendons.motion, inputs);
    moment_arms_ = std::move(motion[0]);
    tendon_rates_ = std::move(motion[1]);
    bending_ = std::move(motion[2]);
  }

  /// dh/dt of a taut tendon, from its motor's end.
  ex rate_at_motor(const IdentifiedEffect& each, std::size_t tendon) const {
    const DrivenTendons& tendons = model_.tendons;
    if (!tendons.motor)
      throw std::invalid_argument("identified.toml: '" + each.effect + "' at '" + each.place +
                                  "' needs the motors, which model '" + model_.name +
                                  "' is without");
    const std::size_t motor = static_cast<std::size_t>(tendons.coordinates()) + tendon;
    return -exact_number(tendons.motor->pulley_radius) * qd_at_[motor];
  }

  /// Signals of an effect at a tendon.
  GiNaC::exmap tendon_replacements(const IdentifiedEffect& each, std::size_t tendon) {
    const EffectSignals& s = effect_signals();
    const ex rate = list_.define("tendon_rate", find_effect(each.effect).motor_side
                                                    ? rate_at_motor(each, tendon)
                                                    : tendon_rates_[tendon]);
    GiNaC::exmap map{{s.position, list_.define("bending", bending_[tendon])},
                     {s.velocity, rate},
                     {s.load, tension_.symbols[tendon]},
                     {s.step, step_.symbols[0]},
                     {s.direction, tendon_direction(rate)}};
    take_form(find_effect(each.effect), each.shape, map);
    return map;
  }

  /// The effect's term, at its joint or with the moment arms of its tendon.
  void add_term(const IdentifiedEffect& each, std::vector<ex>& tau) {
    const std::optional<std::size_t> tendon = tendon_of(each.place);
    if (!tendon) {
      const std::size_t joint = joint_of(each.place);
      const ex effort = term(each);
      tau[joint] += effort;
      if (find_effect(each.effect).links_react) react(joint, effort, tau);
      return;
    }
    const Effect& effect = find_effect(each.effect);
    const auto n = static_cast<std::size_t>(model_.tendons.coordinates());
    if (effect.changes_arm) {
      add_arms(each, *tendon, tau);
      return;
    }
    const ex lost = sum_of_columns(effect, each, tendon_replacements(each, *tendon));
    for (std::size_t j = 0; j < n; ++j) tau[j] += moment_arms_[*tendon * n + j] * lost;
    if (effect.felt_by_motor && model_.tendons.motor)
      tau[n + *tendon] += exact_number(model_.tendons.motor->pulley_radius) * lost;
  }

  /// Where the tendon passes a joint its moment arm changes with that joint's angle.
  void add_arms(const IdentifiedEffect& each, std::size_t tendon, std::vector<ex>& tau) {
    const auto n = static_cast<std::size_t>(model_.tendons.coordinates());
    GiNaC::exmap map = tendon_replacements(each, tendon);
    for (std::size_t j = 0; j < n; ++j) {
      if (moment_arms_[tendon * n + j].is_zero()) continue;
      map[effect_signals().position] = q_at_[j];
      tau[j] += sum_of_columns(find_effect(each.effect), each, map);
    }
  }

  ex soft_sign(const ex& velocity, double speed) {
    return list_.define("direction", 2 / exact_number(std::numbers::pi) *
                                         GiNaC::atan(velocity / exact_number(speed)));
  }

  /// As the models of guides have it (4.1): beyond a few times that speed independent of it.
  ex tendon_direction(const ex& rate) {
    const ex turns = exact_number(model_.tendons.slip_speed);
    return list_.define("direction", rate / GiNaC::sqrt(rate * rate + turns * turns));
  }

  ex sum_of_columns(const Effect& effect, const IdentifiedEffect& each, const GiNaC::exmap& map) {
    ex sum = 0;
    for (std::size_t k = 0; k < effect.columns.size(); ++k)
      sum += exact_number(each.coefficients.at(k).value) * effect.columns[k].term.subs(map);
    return list_.define(each.effect, sum);
  }

  /// Direction of friction as the presliding effect's state.
  ex bristle(const IdentifiedEffect& law, std::size_t joint) {
    const Effect& effect = find_effect("presliding");
    return list_.define("direction",
                        effect.columns.front().term.subs(replacements(effect, law.shape, joint)));
  }

  ex drive(std::size_t i) {
    const DrivenJoint& joint = model_.joints[i];
    return exact_number(joint.armature) * qdd_at_[i] + exact_number(joint.damping) * qd_at_[i] +
           exact_number(joint.friction) * directions_[i];
  }

  /// The effect's symbols at a joint; its state is updated.
  GiNaC::exmap replacements(const Effect& effect, const std::vector<IdentifiedValue>& shape,
                            std::size_t joint) {
    const EffectSignals& s = effect_signals();
    GiNaC::exmap map{{s.position, q_at_[joint]},       {s.velocity, qd_at_[joint]},
                     {s.acceleration, qdd_at_[joint]}, {s.jounce, jounce_.symbols[joint]},
                     {s.load, load_at(joint)},         {s.time, time_.symbols[0]},
                     {s.step, step_.symbols[0]}};
    if (joint < directions_.size()) map[s.direction] = directions_[joint];
    if (acts_by_links(effect)) add_link_signals(joint, map);
    take_form(effect, shape, map);
    return map;
  }

  /// Values of the shapes, and the states, which are updated.
  void take_form(const Effect& effect, const std::vector<IdentifiedValue>& shape,
                 GiNaC::exmap& map) {
    for (std::size_t k = 0; k < effect.shapes.size(); ++k)
      map[effect.shapes[k].symbol] = exact_number(shape.at(k).value);
    const std::size_t first = next_.size();
    for (std::size_t k = 0; k < effect.states.size(); ++k)
      map[effect.states[k].symbol] = states_.symbols[first + k];
    for (const EffectState& state : effect.states)
      next_.push_back(list_.define("next_state", state.next.subs(map)));
  }

  static bool acts_by_links(const Effect& effect) {
    return std::any_of(effect.columns.begin(), effect.columns.end(), [](const EffectColumn& c) {
      return c.term.has(effect_signals().carried_inertia);
    });
  }

  /// Column `joint` of the links' mass matrix: what they ask for its unit acceleration from rest.
  const std::vector<ex>& links_column(std::size_t joint) {
    std::vector<ex>& column = links_columns_[joint];
    if (!column.empty()) return column;
    const auto asked = [&](bool moved) {
      std::vector<ex> inputs(q_at_);
      inputs.resize(3 * q_at_.size(), ex(0));
      if (moved) inputs[2 * q_at_.size() + joint] = 1;
      return inlined(list_, model_.rigid, inputs).front();
    };
    const std::vector<ex> at_rest = asked(false);
    column = asked(true);
    for (std::size_t i = 0; i < column.size(); ++i)
      column[i] = list_.define("links_column", column[i] - at_rest[i]);
    return column;
  }

  void add_link_signals(std::size_t joint, GiNaC::exmap& map) {
    if (carried_.empty())
      throw std::invalid_argument("identified.toml: joint '" + model_.joints[joint].name +
                                  "' carries no links, which an effect at it needs");
    const EffectSignals& s = effect_signals();
    const std::vector<ex>& column = links_column(joint);
    ex jounce = 0;
    for (std::size_t i = 0; i < column.size(); ++i) jounce += column[i] * jounce_.symbols[i];
    const ex inertia = column[joint];
    map[s.carried_inertia] = inertia;
    map[s.parting] = list_.define("parting", load_at(joint) / inertia);
    map[s.carried_jounce] = list_.define("carried_jounce", jounce) / inertia;
  }

  /// What the links do otherwise than their joint says, where other joints feel it.
  void react(std::size_t joint, const ex& effort, std::vector<ex>& tau) {
    const std::vector<ex>& column = links_column(joint);
    const ex by_inertia = list_.define("reaction", effort / column[joint]);
    for (std::size_t i = 0; i < column.size(); ++i)
      if (i != joint) tau[i] += column[i] * by_inertia;
  }

  /// A compensation has no terms that need what the links ask.
  ex load_at(std::size_t joint) const {
    const ex external = load_.symbols[joint];
    return carried_.empty() ? external : carried_[joint] + external;
  }

  ex term(const IdentifiedEffect& each) {
    const Effect& effect = find_effect(each.effect);
    const std::size_t joint = joint_of(each.place);
    return sum_of_columns(effect, each, replacements(effect, each.shape, joint));
  }

  /// Follows from what the firmware knows before it acts.
  static bool is_measurable(const Effect& effect) {
    const EffectSignals& s = effect_signals();
    return effect.compensable && effect.states.empty() &&
           std::none_of(effect.columns.begin(), effect.columns.end(), [&](const EffectColumn& c) {
             return c.term.has(s.acceleration) || c.term.has(s.jounce) || c.term.has(s.time);
           });
  }

  /// Needs the joint's torque and with it the acceleration.
  bool depends_on_links(const IdentifiedEffect& each) const {
    const std::vector<EffectColumn>& columns = find_effect(each.effect).columns;
    return model_.joints[joint_of(each.place)].carries_links &&
           std::any_of(columns.begin(), columns.end(),
                       [](const EffectColumn& c) { return c.term.has(effect_signals().load); });
  }

  /// Arguments nothing depends on are no arguments, but for the motion.
  static Function without_unused(Function f) {
    const auto used = [&](const Argument& argument) {
      return std::any_of(argument.symbols.begin(), argument.symbols.end(), [&](const auto& s) {
        const auto in = [&](const ex& value) { return value.has(s); };
        return std::any_of(f.definitions.begin(), f.definitions.end(),
                           [&](const Definition& d) { return in(d.value); }) ||
               std::any_of(f.outputs.begin(), f.outputs.end(), [&](const Output& o) {
                 return std::any_of(o.values.begin(), o.values.end(), in);
               });
      });
    };
    std::erase_if(f.inputs, [&](const Argument& argument) {
      return argument.name != "q" && argument.name != "qd" && argument.name != "qdd" &&
             !used(argument);
    });
    return f;
  }

  const DrivenModel& model_;
  const Identified& identified_;
  int n_;
  Argument q_, qd_, qdd_, load_, tension_, jerk_, jounce_, time_, step_, states_;
  DefinitionList list_;
  std::vector<ex> carried_;                               ///< what the links ask of every joint
  std::map<std::size_t, std::vector<ex>> links_columns_;  ///< by joint
  std::vector<ex> q_at_, qd_at_, qdd_at_, directions_, next_;
  std::vector<ex> moment_arms_, tendon_rates_, bending_;
};

}  // namespace

Function effort_function(const DrivenModel& model, const Identified& identified) {
  return EffortWriter(model, identified).effort();
}

Function motor_effort_function(const DrivenModel& model, const Identified& identified) {
  Function f = effort_function(model, identified);
  f.name = "motor_effort";
  f.doc = "Effort of the tendons' motors; 0 for the joints.";
  for (std::size_t i = 0; i < model.joints.size(); ++i)
    if (!model.joints[i].motor) f.outputs.front().values[i] = 0;
  return f;
}

Function compensation_function(const DrivenModel& model, const Identified& identified,
                               double share) {
  // Ahead of the motion there is nothing to delay, and a bristle's state is not measured:
  // friction's direction follows from the velocity alone.
  Identified measurable = identified;
  std::erase_if(measurable.effects, [](const IdentifiedEffect& each) {
    return each.effect == "delay" || each.effect == "direction";
  });
  return EffortWriter(model, measurable).compensation(share);
}

}  // namespace sinew
