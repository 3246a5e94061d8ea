// SPDX-License-Identifier: GPL-3.0-or-later
// Whether estimated parameters are those of some body.
#pragma once

#include <Eigen/Core>

namespace sinew::diagnosis {

/// True where a body within `reach` [m] of its frame may have these parameters, each within two
/// standard errors: mass [kg], first moments [kg m], and as far as there are more, moments of
/// inertia xx, yy, zz, xy, xz, yz [kg m^2]. Those that the logs say nothing about have error 0.
bool is_body(const Eigen::VectorXd& values, const Eigen::VectorXd& errors, double reach);

}  // namespace sinew::diagnosis
