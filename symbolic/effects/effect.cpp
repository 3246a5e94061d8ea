// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effect.h"

namespace sinew {
namespace {

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at))
    text.replace(at, from.size(), to);
}

}  // namespace

const EffectSignals& effect_signals() {
  static const EffectSignals signals;
  return signals;
}

std::vector<GiNaC::symbol> signal_list() {
  const EffectSignals& s = effect_signals();
  return {s.position,  s.velocity, s.acceleration, s.jounce,          s.load,          s.time,
          s.direction, s.step,     s.parting,      s.carried_inertia, s.carried_jounce};
}

GiNaC::ex Effect::shape(const std::string& parameter, const std::string& unit, Scale scale,
                        double low, double high, int grid) {
  ShapeParameter p{GiNaC::symbol(parameter), parameter, unit, scale, low, high, grid};
  shapes.push_back(std::move(p));
  return shapes.back().symbol;
}

EffectColumn& Effect::column(const std::string& parameter, const std::string& unit, Sign sign,
                             const GiNaC::ex& term, bool per_log) {
  return columns.emplace_back(
      EffectColumn{GiNaC::symbol(parameter), parameter, unit, sign, per_log, term});
}

ValueLimits limits_of(const EffectColumn& column) {
  return {column.sign == Sign::positive ? 0.0 : -column.most,
          column.sign == Sign::negative ? 0.0 : column.most};
}

std::string unit_at(const std::string& pattern, bool revolute) {
  const std::string length = revolute ? "rad" : "m";
  std::string unit = pattern;
  // A quotient by a quotient reads better with the seconds above.
  replace_all(unit, "/{velocity}^2", "*s^2/" + length + "^2");
  replace_all(unit, "/{velocity}", "*s/" + length);
  replace_all(unit, "{effort}/{acceleration}", revolute ? "kg*m^2" : "kg");
  replace_all(unit, "{acceleration}/{effort}", revolute ? "1/(kg*m^2)" : "1/kg");
  replace_all(unit, "*s^2/{acceleration}", "*s^4/" + length);
  replace_all(unit, "{effort}", revolute ? "N*m" : "N");
  replace_all(unit, "{position}", length);
  replace_all(unit, "{velocity}", length + "/s");
  return unit;
}

GiNaC::ex effort(const Effect& effect) {
  GiNaC::ex sum = 0;
  for (const EffectColumn& column : effect.columns) sum += column.symbol * column.term;
  return sum;
}

}  // namespace sinew
