// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that may be wrong with a model, in one form: a block of columns for each shape.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "identification/diagnosis/deviation_terms.h"

namespace sinew::diagnosis {

/// A cause of the library or a value of the model's own at one place. At coefficients of zero the
/// model is as it is.
struct Hypothesis {
  int candidate = 0;  ///< index into the library; deviation i of the problem is -1 - i
  const Candidate* source = nullptr;  ///< name, place, limits
  bool named = true;                  ///< false: structure without a physical name
  bool is_law = true;                 ///< of a form of its own, which is off by kFormError
  double log_prior = 0.0;             ///< log prior odds of all its shapes together
  std::vector<int> shapes;
  std::optional<double> body_within;  ///< as a candidate's: its coefficients are a body's
};

/// A hypothesis at one value of its nonlinear parameters.
struct Shape {
  int hypothesis = 0;
  Eigen::VectorXd nonlinear;
  BandColumns columns;          ///< as Design::columns gives them
  std::vector<int> neighbours;  ///< shapes one step of the grid further
  double log_share = 0.0;  ///< of its part of the prior, what the logs leave to it (shape_share.h)
};

/// All hypotheses of a problem beside a model of which only what is always free is fitted.
struct Hypotheses {
  DeviationTerms parts;  ///< the model; owns what hypotheses point to
  std::vector<Hypothesis> list;
  std::vector<Shape> shapes;
  /// Per segment, in its recording's samples: what the model says, which a delay moves.
  std::vector<Eigen::VectorXd> said;
};

/// `baseline`: of baseline_model(), its nonlinear parameters fitted. Where the problem has no
/// deviations its coefficients are free.
Hypotheses make_hypotheses(const Design& design, const Model& baseline);

/// One more shape of a hypothesis; its columns are evaluated where none are given.
void add_shape(const Design& design, int hypothesis, const Eigen::VectorXd& nonlinear,
               Hypotheses& all);

/// Whether no law of one form stands for it: values of the model and masses have the model's form,
/// splines and series follow any.
bool has_any_form(const Candidate& source, bool of_model);

/// A term of the model for a shape.
Term term_of(const Hypotheses& all, int shape);

}  // namespace sinew::diagnosis
