// SPDX-License-Identifier: GPL-3.0-or-later
// What every effect of the catalogue has to be: written in the signals of its place alone, called
// by one name, and, where it is friction, something that takes energy and gives none.
#include "symbolic/effects/effects.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "symbolic/effects/effect_functions.h"
#include "symbolic/effects/model_effects.h"

using namespace sinew;

namespace {

/// Effort where the coefficients are 1 and every shape lies in the middle of its grid.
double effort_at(const Effect& effect, double velocity, double load) {
  const EffectSignals& s = effect_signals();
  GiNaC::exmap at;
  for (const GiNaC::symbol& signal : signal_list()) at[signal] = GiNaC::numeric(3, 10);
  at[s.velocity] = velocity;
  at[s.direction] = velocity < 0 ? -1 : 1;
  at[s.load] = load;
  for (const ShapeParameter& shape : effect.shapes) at[shape.symbol] = (shape.low + shape.high) / 2;
  for (const EffectState& state : effect.states) at[state.symbol] = 0;
  for (const EffectColumn& column : effect.columns) at[column.symbol] = 1;
  const GiNaC::ex value = effort(effect).subs(at).evalf();
  INFO(effect.id << ": " << value);
  REQUIRE(GiNaC::is_a<GiNaC::numeric>(value));
  return GiNaC::ex_to<GiNaC::numeric>(value).to_double();
}

}  // namespace

TEST_CASE("an effect depends on its place's signals, its shapes and its states alone") {
  // Planted defect: load_friction with a symbol of its own for the load: "load" twice over, and
  // the regressor that is emitted would take a number that nobody gives.
  std::set<std::string> ids;
  for (const Effect& effect : effects()) {
    INFO(effect.id);
    CHECK(ids.insert(effect.id).second);
    CHECK(&find_effect(effect.id) == &effect);
    CHECK_FALSE(effect.columns.empty());
    GiNaC::exset known;
    for (const GiNaC::symbol& signal : signal_list()) known.insert(signal);
    for (const ShapeParameter& shape : effect.shapes) known.insert(shape.symbol);
    for (const EffectState& state : effect.states) known.insert(state.symbol);
    const auto check = [&](const GiNaC::ex& term) {
      for (auto part = term.preorder_begin(); part != term.preorder_end(); ++part)
        if (GiNaC::is_a<GiNaC::symbol>(*part)) {
          INFO(*part);
          CHECK(known.count(*part) == 1);
        }
    };
    for (const EffectColumn& column : effect.columns) check(column.term);
    for (const EffectState& state : effect.states) check(state.next);
  }
  for (const ModelEffect& effect : model_effects()) {
    INFO(effect.id);
    CHECK(ids.insert(effect.id).second);
  }
}

TEST_CASE("an effect's names differ, its limits hold something, and it says how it is seen") {
  for (const Effect& effect : effects()) {
    INFO(effect.id);
    std::set<std::string> names;
    for (const ShapeParameter& shape : effect.shapes) {
      CHECK(names.insert(shape.name).second);
      CHECK(shape.low <= shape.high);
      CHECK(shape.limits.low < shape.limits.high);
      CHECK(unit_at(shape.unit, true).find('{') == std::string::npos);
    }
    for (const EffectColumn& column : effect.columns) {
      CHECK(names.insert(column.name).second);
      CHECK(limits_of(column).low < limits_of(column).high);
      CHECK(unit_at(column.unit, false).find('{') == std::string::npos);
    }
    CHECK_FALSE(effect.name.empty());
    if (effect.baseline_only) continue;  // fitted, never told
    CHECK_FALSE(effect.signature.empty());
    CHECK_FALSE(effect.excitation.empty());
    CHECK_FALSE(effect.experiment.empty());
  }
}

TEST_CASE("friction is odd in the motion and takes energy") {
  // Planted defect: stribeck() with -exp(...): it drives.
  for (const char* id : {"viscous_level", "coulomb_level", "stribeck", "concave_friction",
                         "concave_power", "load_friction"}) {
    const Effect& effect = find_effect(id);
    INFO(id);
    for (const double velocity : {0.02, 0.4, 3.0})
      for (const double load : {2.0, -2.0}) {
        const double forward = effort_at(effect, velocity, load),
                     back = effort_at(effect, -velocity, load);
        CHECK(forward >= 0.0);
        CHECK(back == Approx(-forward));
      }
    CHECK(effort_at(effect, 0.4, 2.0) > 0.0);
  }
}

TEST_CASE("friction turns as the model's does, or sooner") {
  // Planted defects, seen to fail: the direction to the power of the share, which leaps at
  // standstill; a share that counts the other way round.
  const Effect& effect = find_effect("position_friction");
  const auto direction = [&](double of_model, double share) {
    const EffectSignals& s = effect_signals();
    const GiNaC::ex value = effect.columns.front().term.subs(GiNaC::exmap{
        {s.direction, of_model}, {s.position, 1.0}, {effect.shapes.front().symbol, share}});
    return GiNaC::ex_to<GiNaC::numeric>(value.evalf()).to_double();
  };
  for (const double d : {-1.0, -0.3, -1e-4, 0.0, 1e-4, 0.3, 1.0}) {
    CHECK(direction(d, 1.0) == Approx(d));
    CHECK(direction(-d, 0.1) == Approx(-direction(d, 0.1)));
    CHECK(std::abs(direction(d, 0.1)) <= 1.0);
  }
  CHECK(direction(1.0, 0.1) == Approx(1.0));
  CHECK(direction(1e-6, 0.1) == Approx(1e-5).epsilon(1e-4));
  CHECK(direction(0.3, 0.1) > 0.8);
}

TEST_CASE("an effect that does not exist is refused with those that do") {
  CHECK_THROWS_WITH(find_effect("friktion"), Catch::Contains("friktion") &&
                                                 Catch::Contains("coulomb_level") &&
                                                 Catch::Contains("load_friction"));
}

TEST_CASE("an emitted regressor takes signals, shapes and states, and gives terms and states") {
  for (const Effect& effect : effects()) {
    INFO(effect.id);
    const Function regressor = regressor_function(effect);
    CHECK(regressor.name == effect.id);
    std::size_t taken = 0;
    for (const Argument& argument : regressor.inputs) taken += argument.symbols.size();
    CHECK(taken == signal_list().size() + effect.shapes.size() + effect.states.size());
    REQUIRE(regressor.outputs.size() == (effect.states.empty() ? 1U : 2U));
    CHECK(regressor.outputs.front().values.size() == effect.columns.size());
    if (!effect.states.empty())
      CHECK(regressor.outputs.back().values.size() == effect.states.size());
  }
}
