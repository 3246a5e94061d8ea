// SPDX-License-Identifier: GPL-3.0-or-later
// What mechanics demands of emitted functions among themselves, without any second model.
#pragma once

#include <string>
#include <vector>

#include "tests/reference/emitted_model.h"
#include "tests/reference/reference_model.h"

namespace sinew::reference {

/// A law and how far it is violated; `limit` follows from rounding and from the differences used.
struct LawCheck {
  std::string law;
  double violation;
  double limit;
  bool holds() const { return violation <= limit; }  ///< false for NaN too
};

/// M symmetric and positive definite, Mdot = C + C^T, C qd + g = bias, M and bias within inverse
/// dynamics, forward dynamics its inverse, J the tip's derivative. Over `states`.
std::vector<LawCheck> rigid_body_laws(const EmittedModel& emitted,
                                      const std::vector<State>& states);

/// P = dh/dq, tau = -P^T f and virtual work, K symmetric and -dtau/dq with elastic tendons, and
/// link positions recovered from tendon lengths where the model offers that.
std::vector<LawCheck> tendon_laws(const EmittedModel& emitted, const std::vector<State>& states);

/// Kinetic energy from the emitted M, potential energy from the mechanism's masses: relative drift
/// over `seconds` of free motion by the emitted forward dynamics, integrated with a relative
/// tolerance of 1e-12.
LawCheck energy_law(const EmittedModel& emitted, const Mechanism& mechanism, const State& start,
                    double seconds);

std::string describe(const std::vector<LawCheck>& checks);

}  // namespace sinew::reference
