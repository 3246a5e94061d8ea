// SPDX-License-Identifier: GPL-3.0-or-later
// One physical effect that a model may lack, written once: its symbolic term, limits, what it looks
// like and the experiment that shows it alone. The emitted regressors (generated/effects), the term
// in an extended model, the firmware's compensation and the manual's line all come from here.
#pragma once

#include <ginac/ginac.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace sinew {

/// What an effect may depend on at its place, SI units; the one owner of these symbols. `effort` is
/// a torque [N m] or a force [N], counted positive where it has to be provided to overcome the
/// effect. At a tendon position is its bending [rad], velocity the rate of its length [m/s], load
/// its force [N], direction the soft sign of that rate, and effort the force lost on the way to the
/// joints; it acts on them with the tendon's moment arms.
struct EffectSignals {
  GiNaC::symbol position{"q"}, velocity{"qd"}, acceleration{"qdd"};
  GiNaC::symbol jounce{"qdddd"};         ///< second derivative of the acceleration
  GiNaC::symbol load{"load"};            ///< external load against positive motion
  GiNaC::symbol time{"t"};               ///< s since the log's start
  GiNaC::symbol direction{"direction"};  ///< of friction, -1..1: soft sign of the velocity
  GiNaC::symbol step{"step"};            ///< s to the next sample, for states
  // At a joint that carries links; the others' motion goes on meanwhile.
  GiNaC::symbol parting{"parting"};  ///< joint's acceleration against its links', were they let go
  GiNaC::symbol carried_inertia{"carried_inertia"};  ///< of the links about the joint
  GiNaC::symbol carried_jounce{"carried_jounce"};    ///< parting of a motion by its jounces alone
};
const EffectSignals& effect_signals();

/// All signals, in the order in which emitted regressors take them.
std::vector<GiNaC::symbol> signal_list();

/// What a range of a shape parameter is measured in; mobility: the reciprocal of the inertia that
/// the efforts show; turning: a share, 1 where the model's friction turns on bristles.
enum class Scale { none, reach, speed, duration, mobility, turning };

/// What a value of a parameter may be, SI units.
struct ValueLimits {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool above_low = false;  ///< `low` itself is not among them
  bool hold(double value) const {
    return (above_low ? value > low : value >= low) && value <= high;
  }
};

/// A parameter that enters nonlinearly. `low` and `high` are in units of the log's own scale.
struct ShapeParameter {
  GiNaC::symbol symbol;
  std::string name, unit;  ///< unit: {position}, {velocity}, ... stand for the place's own
  Scale scale = Scale::none;
  double low = 0.0, high = 1.0;
  int grid = 5;         ///< starting values of a search
  bool inside = false;  ///< a fit that ends at `high` is not this effect
  bool above = false;   ///< nor one that ends at `low`
  /// What it may be physically; `low` and `high` say where it is looked for.
  ValueLimits limits{0.0, std::numeric_limits<double>::infinity(), true};
  std::optional<double> before{};  ///< its value where an identified.toml of old does not have it
};

enum class Sign { any, positive, negative };

/// coefficient * term, linear in the coefficient.
struct EffectColumn {
  GiNaC::symbol symbol;
  std::string name, unit;
  Sign sign = Sign::any;
  bool per_log = false;  ///< a nuisance: an incremental encoder's phase differs from log to log
  GiNaC::ex term;
  double most = std::numeric_limits<double>::infinity();  ///< beyond it is not this effect
  double share = 1.0;  ///< how large it is expected to be beside the effect's first one
};

/// As its sign and `most` say.
ValueLimits limits_of(const EffectColumn& column);

/// "{effort}/{velocity}" as "N*m*s/rad" or "N*s/m".
std::string unit_at(const std::string& pattern, bool revolute);

/// An internal state, updated once a sample; zero at a log's first one.
struct EffectState {
  GiNaC::symbol symbol;
  GiNaC::ex next;
};

struct Effect {
  Effect(std::string identifier, std::string physical_name)
      : id(std::move(identifier)), name(std::move(physical_name)) {}

  /// Adds a shape parameter and gives its symbol.
  GiNaC::ex shape(const std::string& parameter, const std::string& unit, Scale scale, double low,
                  double high, int grid = 5);
  EffectColumn& column(const std::string& parameter, const std::string& unit, Sign sign,
                       const GiNaC::ex& term, bool per_log = false);

  std::string id;    ///< C identifier, as identified.toml has it
  std::string name;  ///< physical name, as a report says it
  std::vector<ShapeParameter> shapes;
  std::vector<EffectColumn> columns;
  std::vector<EffectState> states;
  bool at_tendon = false;    ///< its places are tendons, else joints
  bool of_one_make = false;  ///< likely to be the same at all its places
  bool unlikely = false;     ///< named only where no other law of its name explains as much
  bool motor_side = false;   ///< at a tendon: it moves there as its motor does
  /// At a tendon: its force is not as measured, so that its motor carries something else, too.
  bool felt_by_motor = false;
  /// At a tendon: its term is the force times a change of the moment arm [m], at every joint that
  /// the tendon passes; position is the joint's angle.
  bool changes_arm = false;
  /// At a tendon: its term is a share of the force however the tendon moves, so that forces with
  /// which the joints move as the model says go in, and not those that were measured.
  bool scales_force = false;
  bool baseline_only = false;  ///< how the model's own friction turns: fitted, never named
  /// The links behind the joint's gear move otherwise than its sensor says. Other joints that carry
  /// them feel that, in the ratio of their column of the mass matrix.
  bool links_react = false;
  bool compensable = false;  ///< known from what the firmware measures, and safe to feed forward
  std::string signature;     ///< what it leaves over
  std::string excitation;    ///< what has to happen for it to be seen
  std::string experiment;    ///< what isolates it
  std::string limit;         ///< what a violated sign says
};

/// Effort of an effect: sum of coefficient * term.
GiNaC::ex effort(const Effect& effect);

}  // namespace sinew
