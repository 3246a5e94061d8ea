// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/reference_model.h"

#include <Eigen/QR>
#include <algorithm>
#include <functional>
#include <map>

#include "tests/reference/random_numbers.h"
#include "tests/reference/sampling.h"

namespace sinew::reference {
namespace {

using Inputs = std::vector<Eigen::VectorXd State::*>;

const std::map<std::string, Inputs>& signatures() {
  static const std::map<std::string, Inputs> table = {
      {"forward_kinematics", {&State::q}},
      {"tip_jacobian", {&State::q}},
      {"mass_matrix", {&State::q}},
      {"coriolis_matrix", {&State::q, &State::qd}},
      {"gravity", {&State::q}},
      {"bias", {&State::q, &State::qd}},
      {"inverse_dynamics", {&State::q, &State::qd, &State::qdd}},
      {"forward_dynamics", {&State::q, &State::qd, &State::tau}},
      {"tendon_lengths", {&State::q}},
      {"coupling_matrix", {&State::q}},
      {"joint_torque", {&State::q, &State::f}},
      {"joint_stiffness", {&State::q, &State::f, &State::kt}},
      {"link_position", {&State::h}},
  };
  return table;
}

template <class Scalar>
VectorX<Scalar> row_major(const MatrixX<Scalar>& matrix) {
  const MatrixX<Scalar> transposed = matrix.transpose();
  return Eigen::Map<const VectorX<Scalar>>(transposed.data(), transposed.size());
}

Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), std::ssize(values));
}

bool constant_radii(const Mechanism& mechanism) {
  return std::all_of(mechanism.tendons.begin(), mechanism.tendons.end(),
                     [](const Tendon& tendon) { return tendon.straights.empty(); });
}

bool reaches_every_joint(const Mechanism& mechanism) {
  const TendonPaths<double> tendons(mechanism);
  const int n = NewtonEuler<double>(mechanism).size();
  return tendons.coupling_matrix(Eigen::VectorXd::Zero(n)).colPivHouseholderQr().rank() == n;
}

}  // namespace

std::vector<std::string> offered_functions(const Mechanism& mechanism) {
  std::vector<std::string> names = {"mass_matrix", "coriolis_matrix",  "gravity",
                                    "bias",        "inverse_dynamics", "forward_dynamics"};
  if (!mechanism.frames.empty()) names.insert(names.end(), {"forward_kinematics", "tip_jacobian"});
  if (mechanism.tendons.empty()) return names;
  names.insert(names.end(),
               {"tendon_lengths", "coupling_matrix", "joint_torque", "joint_stiffness"});
  if (constant_radii(mechanism) && reaches_every_joint(mechanism))
    names.emplace_back("link_position");
  return names;
}

std::vector<double> inputs_of(const std::string& function, const State& state) {
  std::vector<double> inputs;
  for (const auto member : signatures().at(function))
    inputs.insert(inputs.end(), (state.*member).begin(), (state.*member).end());
  return inputs;
}

std::vector<State> sample_states(const Mechanism& mechanism, int count, std::uint64_t seed) {
  const ReferenceModel<double> model(mechanism);
  const auto q = sample_box(position_box(mechanism), count, seed);
  const auto qd = sample_box(velocity_box(mechanism), count, seed + 1);
  const auto qdd = sample_box(acceleration_box(mechanism), count, seed + 2);
  const auto m = static_cast<std::size_t>(model.tendons.size());
  const auto f =
      sample_box({std::vector<double>(m, 0.0), std::vector<double>(m, mechanism.tendon_force_high)},
                 count, seed + 3);
  const auto kt = sample_box({std::vector<double>(m, mechanism.tendon_stiffness_low),
                              std::vector<double>(m, mechanism.tendon_stiffness_high)},
                             count, seed + 4);
  RandomNumbers noise(seed + 5);
  std::vector<State> states;
  for (std::size_t i = 0; i < q.size(); ++i) {
    State state{vector_of(q[i]),
                vector_of(qd[i]),
                vector_of(qdd[i]),
                {},
                vector_of(f[i]),
                vector_of(kt[i]),
                {}};
    state.tau = model.dynamics.inverse_dynamics(state.q, state.qd, state.qdd);
    state.h = model.tendons.lengths(state.q).unaryExpr(
        [&](double length) { return length + noise.uniform(-1e-4, 1e-4); });
    states.push_back(state);
  }
  return states;
}

template <class Scalar>
VectorX<Scalar> ReferenceModel<Scalar>::evaluate(const std::string& function,
                                                 const State& state) const {
  using Evaluation =
      std::function<MatrixX<Scalar>(const ReferenceModel&, const std::vector<VectorX<Scalar>>&)>;
  using Model = const ReferenceModel&;
  using In = const std::vector<VectorX<Scalar>>&;
  static const std::map<std::string, Evaluation> table = {
      {"forward_kinematics", [](Model m, In x) { return m.dynamics.forward_kinematics(x[0]); }},
      {"tip_jacobian", [](Model m, In x) { return m.dynamics.tip_jacobian(x[0]); }},
      {"mass_matrix", [](Model m, In x) { return m.dynamics.mass_matrix(x[0]); }},
      {"coriolis_matrix", [](Model m, In x) { return m.dynamics.coriolis_matrix(x[0], x[1]); }},
      {"gravity", [](Model m, In x) { return m.dynamics.gravity(x[0]); }},
      {"bias", [](Model m, In x) { return m.dynamics.bias(x[0], x[1]); }},
      {"inverse_dynamics",
       [](Model m, In x) { return m.dynamics.inverse_dynamics(x[0], x[1], x[2]); }},
      {"forward_dynamics",
       [](Model m, In x) { return m.dynamics.forward_dynamics(x[0], x[1], x[2]); }},
      {"tendon_lengths", [](Model m, In x) { return m.tendons.lengths(x[0]); }},
      {"coupling_matrix", [](Model m, In x) { return m.tendons.coupling_matrix(x[0]); }},
      {"joint_torque", [](Model m, In x) { return m.tendons.joint_torque(x[0], x[1]); }},
      {"joint_stiffness",
       [](Model m, In x) { return m.tendons.joint_stiffness(x[0], x[1], x[2]); }},
      {"link_position", [](Model m, In x) { return m.tendons.link_position(x[0]); }},
  };
  std::vector<VectorX<Scalar>> arguments;
  for (const auto member : signatures().at(function))
    arguments.push_back((state.*member).template cast<Scalar>());
  return row_major<Scalar>(table.at(function)(*this, arguments));
}

template class ReferenceModel<double>;
template class ReferenceModel<long double>;
template class ReferenceModel<Real50>;

}  // namespace sinew::reference
