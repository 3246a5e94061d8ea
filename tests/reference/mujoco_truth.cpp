// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/mujoco_truth.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <stdexcept>
#include <vector>

#ifdef SINEW_HAVE_MUJOCO
#include <mujoco/mujoco.h>

#include <cstring>
#endif

namespace sinew::reference {
namespace {

std::string numbers(const Eigen::Vector3d& v) {
  return fmt::format("{} {} {}", v[0], v[1], v[2]);
}

std::string joint_text(const Joint& joint) {
  if (joint.type == JointType::fixed) return {};
  return fmt::format("<joint type=\"{}\" axis=\"{}\"/>",
                     joint.type == JointType::revolute ? "hinge" : "slide", numbers(joint.axis));
}

std::string turn_text(const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond turn(rotation);
  return fmt::format("{} {} {} {}", turn.w(), turn.x(), turn.y(), turn.z());
}

/// Principal axes are found here: MuJoCo's own search stops at a tilt of 1e-6 rad.
std::string inertial_text(const Body& body) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(body.inertia);
  Eigen::Matrix3d axes = principal.eigenvectors();
  if (axes.determinant() < 0) axes.col(0) *= -1.0;
  return fmt::format("<inertial mass=\"{}\" pos=\"{}\" quat=\"{}\" diaginertia=\"{}\"/>", body.mass,
                     numbers(body.centre_of_mass), turn_text(axes),
                     numbers(principal.eigenvalues()));
}

std::string body_text(const Mechanism& mechanism, int index) {
  const Body& body = mechanism.bodies[static_cast<std::size_t>(index)];
  const Joint& joint = mechanism.joints[static_cast<std::size_t>(index)];
  std::string text =
      fmt::format("<body name=\"{}\" pos=\"{}\" quat=\"{}\">\n", body.name,
                  numbers(joint.origin.translation), turn_text(joint.origin.rotation));
  text += inertial_text(body) + joint_text(joint) + "\n";
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i)
    if (mechanism.joints[i].parent == index) text += body_text(mechanism, static_cast<int>(i));
  return text + "</body>\n";
}

}  // namespace

std::string mujoco_text(const Mechanism& mechanism) {
  std::string bodies;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i)
    if (mechanism.joints[i].parent < 0) bodies += body_text(mechanism, static_cast<int>(i));
  return fmt::format(
      "<mujoco><compiler angle=\"radian\" inertiafromgeom=\"false\" boundmass=\"0\" "
      "boundinertia=\"0\"/>\n<option gravity=\"{}\"/>\n<worldbody>\n{}</worldbody></mujoco>\n",
      numbers(mechanism.gravity), bodies);
}

#ifdef SINEW_HAVE_MUJOCO

bool mujoco_available() {
  return true;
}

struct MujocoTruth::Simulation {
  mjModel* model = nullptr;
  mjData* data = nullptr;
};

MujocoTruth::MujocoTruth(const Mechanism& mechanism) : simulation_(std::make_unique<Simulation>()) {
  const std::string text = mujoco_text(mechanism);
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "mechanism.xml", static_cast<int>(text.size()));
  std::memcpy(files->filedata[0], text.data(), text.size());
  char error[1000] = "";
  simulation_->model = mj_loadXML("mechanism.xml", files.get(), error, sizeof error);
  mj_deleteVFS(files.get());
  if (simulation_->model == nullptr) throw std::runtime_error(error);
  simulation_->data = mj_makeData(simulation_->model);
}

MujocoTruth::~MujocoTruth() {
  mj_deleteData(simulation_->data);
  mj_deleteModel(simulation_->model);
}

void MujocoTruth::set_state(const Eigen::VectorXd& q, const Eigen::VectorXd& qd) {
  Eigen::Map<Eigen::VectorXd>(simulation_->data->qpos, q.size()) = q;
  Eigen::Map<Eigen::VectorXd>(simulation_->data->qvel, qd.size()) = qd;
  mj_fwdPosition(simulation_->model, simulation_->data);
  mj_fwdVelocity(simulation_->model, simulation_->data);
}

Eigen::MatrixXd MujocoTruth::mass_matrix(const Eigen::VectorXd& q) {
  set_state(q, Eigen::VectorXd::Zero(q.size()));
  Eigen::MatrixXd mass(q.size(), q.size());
  mj_fullM(simulation_->model, mass.data(), simulation_->data->qM);
  return mass;
}

Eigen::VectorXd MujocoTruth::bias(const Eigen::VectorXd& q, const Eigen::VectorXd& qd) {
  set_state(q, qd);
  Eigen::VectorXd torque(q.size());
  mj_rne(simulation_->model, simulation_->data, 0, torque.data());
  return torque;
}

Eigen::VectorXd MujocoTruth::inverse_dynamics(const Eigen::VectorXd& q, const Eigen::VectorXd& qd,
                                              const Eigen::VectorXd& qdd) {
  set_state(q, qd);
  Eigen::Map<Eigen::VectorXd>(simulation_->data->qacc, q.size()) = qdd;
  Eigen::VectorXd torque(q.size());
  mj_rne(simulation_->model, simulation_->data, 1, torque.data());
  return torque;
}

#else

bool mujoco_available() {
  return false;
}

struct MujocoTruth::Simulation {};

MujocoTruth::MujocoTruth(const Mechanism&) {
  throw std::runtime_error("this build found no MuJoCo; install libmujoco-dev and configure again");
}
MujocoTruth::~MujocoTruth() = default;
void MujocoTruth::set_state(const Eigen::VectorXd&, const Eigen::VectorXd&) {}
Eigen::MatrixXd MujocoTruth::mass_matrix(const Eigen::VectorXd&) {
  return {};
}
Eigen::VectorXd MujocoTruth::bias(const Eigen::VectorXd&, const Eigen::VectorXd&) {
  return {};
}
Eigen::VectorXd MujocoTruth::inverse_dynamics(const Eigen::VectorXd&, const Eigen::VectorXd&,
                                              const Eigen::VectorXd&) {
  return {};
}

#endif

}  // namespace sinew::reference
