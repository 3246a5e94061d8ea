// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/dynamics/dynamics_functions.h"

#include <optional>
#include <stdexcept>

#include "symbolic/dynamics/coordinates.h"
#include "symbolic/dynamics/coriolis.h"
#include "symbolic/dynamics/forward_dynamics.h"
#include "symbolic/dynamics/mass_matrix.h"
#include "symbolic/dynamics/recursive_lagrangian.h"
#include "symbolic/dynamics/runtime_parameters.h"
#include "symbolic/dynamics/symbols.h"
#include "symbolic/model/singular_mass_matrix.h"

namespace sinew {
namespace {

using GiNaC::ex;
using Symbols = std::vector<GiNaC::symbol>;

std::vector<ex> expressions(const Symbols& symbols) {
  return {symbols.begin(), symbols.end()};
}
std::vector<ex> zeros(std::size_t n) {
  return std::vector<ex>(n, ex(0));
}

/// One mechanism's arguments and the ways to write its dynamics.
class DynamicsFunctions {
 public:
  DynamicsFunctions(const Mechanism& mechanism, CostOf cost, bool runtime_parameters)
      : mechanism_(mechanism),
        search_(mechanism, std::move(cost)),
        q_(joint_positions(mechanism)),
        qd_(joint_velocities(mechanism)),
        qdd_(joint_accelerations(mechanism)),
        coordinates_(mechanism),
        n_(q_.rows) {
    if (!runtime_parameters) return;
    parameters_ = parameter_argument(build_joint_tree(mechanism));
    search_.keep_masses_open();
  }

  Function inverse_dynamics_function() {
    return cheapest([this](const JointTree& tree, const DynamicsPlan& plan) {
      Function f =
          begin("inverse_dynamics", "Joint torques for a motion: M(q) qdd + C(q,qd) qd + g(q).",
                "(2.1)", {q_, qd_, qdd_});
      DefinitionList list;
      const auto tau =
          torques(list, tree, plan, expressions(qd_.symbols), expressions(qdd_.symbols));
      return finish(f, list, {output("tau", n_, 1, tau, torque_unit(mechanism_), "joint torques")});
    });
  }

  Function bias_function() {
    return cheapest([this](const JointTree& tree, const DynamicsPlan& plan) {
      Function f = begin("bias", "Joint torques at zero acceleration: C(q,qd) qd + g(q).", "(2.1)",
                         {q_, qd_});
      DefinitionList list;
      return finish(
          f, list,
          {output("h", n_, 1, bias(list, tree, plan), torque_unit(mechanism_), "bias torques")});
    });
  }

  Function gravity_function() {
    return cheapest([this](const JointTree& tree, const DynamicsPlan& plan) {
      Function f =
          begin("gravity", "Joint torques that hold the mechanism still: g(q).", "(2.1)", {q_});
      DefinitionList list;
      const auto none = zeros(static_cast<std::size_t>(n_));
      const auto g = torques(list, tree, plan, none, none);
      return finish(f, list, {output("g", n_, 1, g, torque_unit(mechanism_), "gravity torques")});
    });
  }

  Function mass_matrix_function() {
    return cheapest([this](const JointTree& tree, const DynamicsPlan& plan) {
      Function f = begin("mass_matrix", "Mass matrix M(q), symmetric.", "(2.1)", {q_});
      DefinitionList list;
      return finish(f, list,
                    {output("M", n_, n_, reduced_mass_matrix(list, tree, plan), inertia_unit(),
                            "mass matrix")});
    });
  }

  Function mass_matrix_and_bias_function() {
    return cheapest([this](const JointTree& tree, const DynamicsPlan& plan) {
      Function f = begin("mass_matrix_and_bias",
                         "Mass matrix and bias at once, with what they share computed once.",
                         "(2.1)", {q_, qd_});
      DefinitionList list;
      const auto M = reduced_mass_matrix(list, tree, plan);
      const auto h = bias(list, tree, plan);
      return finish(f, list,
                    {output("M", n_, n_, M, inertia_unit(), "mass matrix"),
                     output("h", n_, 1, h, torque_unit(mechanism_), "bias torques")});
    });
  }

  Function forward_dynamics_function() {
    const Argument tau = joint_torques(mechanism_);
    return cheapest([this, &tau](const JointTree& tree, const DynamicsPlan& plan) {
      Function f =
          begin("forward_dynamics", "Joint accelerations M(q)^-1 (tau - C(q,qd) qd - g(q)).",
                "(2.1)", {q_, qd_, tau});
      DefinitionList list;
      const auto M = reduced_mass_matrix(list, tree, plan);
      std::vector<ex> rest = bias(list, tree, plan);
      for (std::size_t i = 0; i < rest.size(); ++i)
        rest[i] = list.define("y" + std::to_string(i + 1), tau.symbols[i] - rest[i]);
      const auto qdd = solve_mass_matrix(list, M, rest);
      return finish(f, list, {output("qdd", n_, 1, qdd, qdd_.unit, "joint accelerations")});
    });
  }

  Function coriolis_function() {
    const Derivation derive = [this](const JointTree& tree, const DynamicsPlan& plan) {
      Function f =
          begin("coriolis_matrix",
                "Coriolis matrix C(q,qd) in Christoffel form: dM/dt - 2 C is skew-symmetric.",
                "(2.1)", {q_, qd_});
      DefinitionList list;
      const JointMap joints = coordinates_.at(list, expressions(q_.symbols));
      const std::vector<ex> qd = expressions(qd_.symbols);
      const CoriolisAndMass of_joints =
          coriolis_matrix(list, tree, plan, joints.positions(), joints.velocities(qd));
      const auto C = joints.projected_coriolis(of_joints.C, of_joints.M, qd);
      return finish(f, list, {output("C", n_, n_, C, inertia_unit() + "/s", "Coriolis matrix")});
    };
    // the plan of the mass matrix, whose composites and columns these are: no search of its own
    return search_.by_last_plan(opened(derive));
  }

 private:
  /// Generalised forces of the coordinates for a motion.
  std::vector<ex> torques(DefinitionList& list, const JointTree& tree, const DynamicsPlan& plan,
                          const std::vector<ex>& qd, const std::vector<ex>& qdd) const {
    const JointMap joints = coordinates_.at(list, expressions(q_.symbols));
    const JointState state{joints.positions(), joints.velocities(qd),
                           joints.accelerations(list, qd, qdd)};
    return joints.projected(inverse_dynamics(list, tree, plan, state));
  }

  std::vector<ex> reduced_mass_matrix(DefinitionList& list, const JointTree& tree,
                                      const DynamicsPlan& plan) const {
    const JointMap joints = coordinates_.at(list, expressions(q_.symbols));
    return joints.projected_matrix(mass_matrix(list, tree, plan, joints.positions()));
  }

  std::vector<ex> bias(DefinitionList& list, const JointTree& tree,
                       const DynamicsPlan& plan) const {
    return torques(list, tree, plan, expressions(qd_.symbols), zeros(static_cast<std::size_t>(n_)));
  }

  std::string inertia_unit() const {
    const std::string unit = coordinate_unit(mechanism_, "");
    return unit == "rad" ? "kg m^2" : unit == "m" ? "kg" : "kg m^2 | kg m | kg";
  }

  static Function begin(const std::string& name, const std::string& doc,
                        const std::string& equation, std::vector<Argument> inputs) {
    return {name, doc, equation, std::move(inputs), {}, {}};
  }

  static Output output(const std::string& name, int rows, int cols, std::vector<ex> values,
                       const std::string& unit, const std::string& doc) {
    return {name, rows, cols, std::move(values), unit, doc};
  }

  static Function finish(Function f, const DefinitionList& list, std::vector<Output> outputs) {
    f.definitions = list.items();
    f.outputs = std::move(outputs);
    return f;
  }

  Function cheapest(const Derivation& derive) { return search_.cheapest(opened(derive)); }

  /// The derivation with masses and gravity as arguments, where they are.
  Derivation opened(const Derivation& derive) const {
    if (!parameters_) return derive;
    return [this, derive](const JointTree& numbers, const DynamicsPlan& plan) {
      return with_parameters(derive, numbers, plan);
    };
  }

  Function with_parameters(const Derivation& derive, JointTree tree,
                           const DynamicsPlan& plan) const {
    use_parameters(tree, *parameters_);
    Function f = derive(tree, plan);
    f.inputs.push_back(*parameters_);
    return f;
  }

  const Mechanism& mechanism_;
  PlanSearch search_;
  Argument q_, qd_, qdd_;
  Coordinates coordinates_;
  std::optional<Argument> parameters_;
  int n_;
};

}  // namespace

std::vector<Function> dynamics_functions(const Mechanism& mechanism, const CostOf& cost,
                                         bool runtime_parameters) {
  if (is_massless(mechanism)) return {};
  DynamicsFunctions write(mechanism, cost, runtime_parameters);
  // written out: the order of the searches is part of the result
  std::vector<Function> functions;
  if (runtime_parameters) functions.push_back(base_parameters_function(mechanism));
  functions.push_back(write.mass_matrix_function());
  functions.push_back(write.coriolis_function());
  functions.push_back(write.gravity_function());
  functions.push_back(write.bias_function());
  functions.push_back(write.mass_matrix_and_bias_function());
  if (!joint_without_inertia(mechanism)) functions.push_back(write.forward_dynamics_function());
  functions.push_back(write.inverse_dynamics_function());
  return functions;
}

Function inverse_dynamics_function(const Mechanism& mechanism, const CostOf& cost,
                                   bool runtime_parameters) {
  if (is_massless(mechanism)) throw std::invalid_argument(why_no_dynamics(mechanism));
  return DynamicsFunctions(mechanism, cost, runtime_parameters).inverse_dynamics_function();
}

}  // namespace sinew
