// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effect.h"

namespace sinew {

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
  shapes.push_back({GiNaC::symbol(parameter), parameter, unit, scale, low, high, grid});
  return shapes.back().symbol;
}

EffectColumn& Effect::column(const std::string& parameter, const std::string& unit, Sign sign,
                             const GiNaC::ex& term, bool per_log) {
  return columns.emplace_back(
      EffectColumn{GiNaC::symbol(parameter), parameter, unit, sign, per_log, term});
}

GiNaC::ex effort(const Effect& effect) {
  GiNaC::ex sum = 0;
  for (const EffectColumn& column : effect.columns) sum += column.symbol * column.term;
  return sum;
}

}  // namespace sinew
