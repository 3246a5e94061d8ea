// SPDX-License-Identifier: GPL-3.0-or-later
// The motion in torque control once more by MuJoCo's mechanics and integrator.
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "tests/blind/truth/torque_control.h"

#ifdef SINEW_HAVE_MUJOCO
#include <mujoco/mujoco.h>

#include <array>
#include <cstring>
#endif

namespace sinew::trials {

#ifdef SINEW_HAVE_MUJOCO

namespace {

struct DeleteModel {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
struct DeleteData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};

std::string body_text(const Chain& chain, std::size_t i) {
  const Link& l = chain.links[i];
  const Eigen::Matrix3d& I = l.inertia;
  std::string inner;
  for (std::size_t k = 0; k < chain.links.size(); ++k)
    if (chain.links[k].parent == static_cast<int>(i)) inner += body_text(chain, k);
  if (i + 1 == chain.links.size() && chain.payload > 0.0)
    inner += fmt::format(
        "<body pos=\"{:.17g} {:.17g} {:.17g}\"><inertial pos=\"0 0 0\" mass=\"{:.17g}\" "
        "diaginertia=\"1e-12 1e-12 1e-12\"/></body>",
        chain.tip.x(), chain.tip.y(), chain.tip.z(), chain.payload);
  return fmt::format(
      "<body pos=\"{:.17g} {:.17g} {:.17g}\" euler=\"{:.17g} {:.17g} {:.17g}\"><inertial "
      "pos=\"{:.17g} {:.17g} {:.17g}\" mass=\"{:.17g}\" fullinertia=\"{:.17g} {:.17g} {:.17g} "
      "{:.17g} "
      "{:.17g} {:.17g}\"/><joint type=\"{}\" axis=\"{:.17g} {:.17g} {:.17g}\" "
      "armature=\"{:.17g}\"/>{}</body>",
      l.xyz.x(), l.xyz.y(), l.xyz.z(), l.rpy.x(), l.rpy.y(), l.rpy.z(), l.com.x(), l.com.y(),
      l.com.z(), l.mass, I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2),
      l.slides ? "slide" : "hinge", l.axis.x(), l.axis.y(), l.axis.z(), l.armature, inner);
}

std::string model_text(const Chain& chain, double step) {
  std::string bodies;
  for (std::size_t i = 0; i < chain.links.size(); ++i)
    if (chain.links[i].parent < 0) bodies += body_text(chain, i);
  return fmt::format(
      "<mujoco><compiler angle=\"radian\" eulerseq=\"XYZ\" inertiafromgeom=\"false\" "
      "boundmass=\"0\" "
      "boundinertia=\"0\" balanceinertia=\"true\"/><option timestep=\"{:.17g}\" gravity=\"{:.17g} "
      "{:.17g} {:.17g}\" integrator=\"Euler\"/><size nconmax=\"1\" njmax=\"16\"/><worldbody>{}"
      "</worldbody></mujoco>",
      step, chain.gravity.x(), chain.gravity.y(), chain.gravity.z(), bodies);
}

std::unique_ptr<mjModel, DeleteModel> load_text(const std::string& text) {
  mjVFS files;
  mj_defaultVFS(&files);
  mj_makeEmptyFileVFS(&files, "trial.xml", static_cast<int>(text.size()));
  std::memcpy(files.filedata[0], text.data(), text.size());
  std::array<char, 1000> error{};
  std::unique_ptr<mjModel, DeleteModel> model(
      mj_loadXML("trial.xml", &files, error.data(), static_cast<int>(error.size())));
  mj_deleteVFS(&files);
  if (!model) throw std::runtime_error(fmt::format("MuJoCo: {}", error.data()));
  return model;
}

}  // namespace

bool mujoco_is_there() {
  return true;
}

namespace {

class InMujoco : public Integrator {
 public:
  InMujoco(Chain chain, double step) {
    // MuJoCo refuses a negative armature: an inertia that is less stays the model's in the motion.
    for (Link& link : chain.links) link.armature = std::max(link.armature, 0.0);
    mju_user_warning = [](const char*) {};  // else they stand in the seal and in a file
    model_ = load_text(model_text(chain, step));
    data_.reset(mj_makeData(model_.get()));
  }
  void start(const VectorXd& q, const VectorXd& v) override {
    VectorXd::Map(data_->qpos, q.size()) = q;
    VectorXd::Map(data_->qvel, v.size()) = v;
  }
  VectorXd q() const override { return VectorXd::Map(data_->qpos, model_->nv); }
  VectorXd v() const override { return VectorXd::Map(data_->qvel, model_->nv); }
  VectorXd speed_after(const VectorXd& effort) override {
    VectorXd::Map(data_->qfrc_applied, effort.size()) = effort;
    mj_forward(model_.get(), data_.get());
    return v() + model_->opt.timestep * VectorXd::Map(data_->qacc, model_->nv);
  }
  /// Of the masses where mj_forward was last.
  MatrixXd mobility() override {
    const Index n = model_->nv;
    MatrixXd columns = MatrixXd::Identity(n, n);
    mj_solveM(model_.get(), data_.get(), columns.data(), columns.data(), static_cast<int>(n));
    return model_->opt.timestep * columns;
  }
  void advance(const VectorXd& effort) override {
    VectorXd::Map(data_->qfrc_applied, effort.size()) = effort;
    mj_step(model_.get(), data_.get());
    // MuJoCo starts anew where it has lost the motion, and goes on.
    for (const int lost : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC})
      if (data_->warning[lost].number > 0)
        throw std::runtime_error("MuJoCo: the simulation is unstable");
  }

 private:
  std::unique_ptr<mjModel, DeleteModel> model_;
  std::unique_ptr<mjData, DeleteData> data_;
};

}  // namespace

Course in_mujoco(const Jointed& jointed, const std::vector<Hidden>& hidden, const Rhythm& rhythm,
                 const VectorXd& load, truth::Draw draw) {
  const Course wanted = commanded(jointed, rhythm, draw);
  InMujoco integrator(chain_in_motion(jointed, hidden), wanted.step);
  const double bandwidth = 2.0 * pi * draw.fork().uniform(6.0, 10.0);
  return in_torque_control(jointed, hidden, wanted, load, bandwidth, integrator);
}

#else

bool mujoco_is_there() {
  return false;
}

Course in_mujoco(const Jointed&, const std::vector<Hidden>&, const Rhythm&, const VectorXd&,
                 truth::Draw) {
  throw std::runtime_error("this build has no MuJoCo");
}

#endif

}  // namespace sinew::trials
