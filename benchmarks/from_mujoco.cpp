// SPDX-License-Identifier: GPL-3.0-or-later
#include <mujoco/mujoco.h>

#include <cstring>
#include <stdexcept>

#include "benchmarks/contestant.h"
#include "tests/reference/mujoco_truth.h"

namespace sinew::benchmarks {
namespace {

/// Model and data of one robot, and the least that MuJoCo has to run for each quantity.
class Robot {
 public:
  explicit Robot(const Mechanism& mechanism) : n_(coordinate_count(mechanism)) {
    const std::string text = reference::mujoco_text(mechanism);
    const auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    mj_makeEmptyFileVFS(files.get(), "robot.xml", static_cast<int>(text.size()));
    std::memcpy(files->filedata[0], text.data(), text.size());
    char error[1000] = "";
    model_ = mj_loadXML("robot.xml", files.get(), error, sizeof error);
    mj_deleteVFS(files.get());
    if (model_ == nullptr) throw std::runtime_error(error);
    data_ = mj_makeData(model_);
  }
  Robot(const Robot&) = delete;
  Robot& operator=(const Robot&) = delete;
  ~Robot() {
    mj_deleteData(data_);
    mj_deleteModel(model_);
  }

  void inverse_dynamics(const double* q, const double* qd, const double* qdd, double* out) {
    place(q, qd);
    std::memcpy(data_->qacc, qdd, bytes());
    mj_rne(model_, data_, 1, out);
  }

  void bias(const double* q, const double* qd, double* out) {
    place(q, qd);
    mj_rne(model_, data_, 0, out);
  }

  void mass_matrix(const double* q, double* out) {
    std::memcpy(data_->qpos, q, bytes());
    mj_kinematics(model_, data_);
    mj_comPos(model_, data_);
    mj_crb(model_, data_);
    mj_fullM(model_, out, data_->qM);
  }

  void both(const double* q, const double* qd, double* out) {
    mass_matrix(q, out);
    std::memcpy(data_->qvel, qd, bytes());
    mj_comVel(model_, data_);
    mj_rne(model_, data_, 0, out + n_ * n_);
  }

  void forward_dynamics(const double* q, const double* qd, const double* tau, double* out) {
    place(q, qd);
    mj_crb(model_, data_);
    mj_factorM(model_, data_);
    mj_rne(model_, data_, 0, data_->qfrc_bias);
    for (int i = 0; i < n_; ++i) out[i] = tau[i] - data_->qfrc_bias[i];
    mj_solveM(model_, data_, out, out, 1);
  }

 private:
  std::size_t bytes() const { return static_cast<std::size_t>(n_) * sizeof(double); }

  void place(const double* q, const double* qd) {
    std::memcpy(data_->qpos, q, bytes());
    std::memcpy(data_->qvel, qd, bytes());
    mj_kinematics(model_, data_);
    mj_comPos(model_, data_);
    mj_comVel(model_, data_);
  }

  int n_;
  mjModel* model_ = nullptr;
  mjData* data_ = nullptr;
};

}  // namespace

std::vector<Contestant> from_mujoco(const Mechanism& mechanism) {
  const auto robot = std::make_shared<Robot>(mechanism);
  using In = const double*;
  const std::string maker = "MuJoCo";
  return {
      {maker, Quantity::inverse_dynamics,
       [robot](In q, In qd, In u, double* out) { robot->inverse_dynamics(q, qd, u, out); }},
      {maker, Quantity::bias, [robot](In q, In qd, In, double* out) { robot->bias(q, qd, out); }},
      {maker, Quantity::mass_matrix,
       [robot](In q, In, In, double* out) { robot->mass_matrix(q, out); }},
      {maker, Quantity::both, [robot](In q, In qd, In, double* out) { robot->both(q, qd, out); }},
      {maker, Quantity::forward_dynamics,
       [robot](In q, In qd, In u, double* out) { robot->forward_dynamics(q, qd, u, out); }},
  };
}

}  // namespace sinew::benchmarks
