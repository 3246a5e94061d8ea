// SPDX-License-Identifier: GPL-3.0-or-later
// The motion once more by MuJoCo's mechanics and integrator, in closed loop: friction and what is
// hidden at the axes are applied, the controller knows the model under test only.
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "tests/blind/truth/trials/jointed.h"
#include "tests/blind/truth/trials/signal_path.h"

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

Course in_mujoco(const Jointed& jointed, const std::vector<Hidden>& hidden, const Rhythm& rhythm,
                 const VectorXd& load, truth::Draw draw) {
  Course course = commanded(jointed, rhythm, draw);
  course.load = load;
  const Course wanted = course;
  const Index n = jointed.chain.size();
  course.command.resize(course.rows(), n);
  Chain real = true_chain(jointed.chain, hidden);
  std::vector<double> extra(static_cast<std::size_t>(n), 0.0);
  for (const Hidden& h : hidden)
    if (h.cause == "inertia")
      real.links[static_cast<std::size_t>(h.at)].armature +=
          std::max(h.dose, -0.8 * jointed.axes[static_cast<std::size_t>(h.at)].inertia);
  // MuJoCo refuses a negative armature: an inertia that is less stays the model's in the motion.
  for (Link& link : real.links) link.armature = std::max(link.armature, 0.0);
  const auto model = load_text(model_text(real, course.step));
  const std::unique_ptr<mjData, DeleteData> data(mj_makeData(model.get()));
  std::vector<Axis> axes;
  for (Index j = 0; j < n; ++j) {
    const auto i = static_cast<std::size_t>(j);
    auto here = only_at(hidden, static_cast<int>(j));
    std::erase_if(here, [](const Hidden& h) { return h.cause == "inertia"; });
    axes.emplace_back(jointed.axes[i], jointed.bristles[i], here);
    data->qpos[j] = wanted.q(0, j);
    data->qvel[j] = wanted.v(0, j);
  }
  truth::Draw tuned = draw.fork();
  const double bandwidth = 2.0 * pi * tuned.uniform(6.0, 10.0);
  VectorXd asked(n), resisting = VectorXd::Zero(n), before = VectorXd::Zero(n);
  for (Index k = 0; k < course.q.rows(); ++k) {
    const VectorXd q = VectorXd::Map(data->qpos, n), v = VectorXd::Map(data->qvel, n);
    const VectorXd pursued = wanted.a.row(k).transpose() +
                             bandwidth * bandwidth * (wanted.q.row(k).transpose() - q) +
                             1.8 * bandwidth * (wanted.v.row(k).transpose() - v);
    asked = jointed.chain.torque(q, v, pursued);
    const double known = load.size() > 0 ? load(k) : 0.0;
    for (Index j = 0; j < n; ++j) {
      const auto i = static_cast<std::size_t>(j);
      const AxisModel& m = jointed.axes[i];
      const double turning = m.turning > 0.0 ? m.turning : 0.02 * m.top_speed;
      const double command = asked(j) + jointed.chain.links[i].armature * pursued(j) +
                             0.8 * m.level * std::tanh(wanted.v(k, j) / turning) +
                             m.viscous * wanted.v(k, j) + known;
      // At a row's instant: the mean of what was given in the steps before and behind it.
      if (k % course.inner == 0)
        course.command(k / course.inner, j) = k > 0 ? 0.5 * (before(j) + command) : command;
      before(j) = command;
      // Friction is steep near rest: its slope becomes MuJoCo's damping, taken implicitly.
      const double slope = axes[i].slope(v(j), course.step);
      model->dof_damping[j] = slope;
      data->qfrc_applied[j] = command - known - resisting(j) + slope * v(j);
    }
    course.q.row(k) = q.transpose();
    course.v.row(k) = v.transpose();
    mj_step(model.get(), data.get());
    for (Index j = 0; j < n; ++j) {
      course.a(k, j) = (data->qvel[j] - v(j)) / course.step;
      const double carried = jointed.carries ? asked(j) : 0.0;
      resisting(j) = axes[static_cast<std::size_t>(j)].resist(
          {course.step * static_cast<double>(k + 1), data->qpos[j], data->qvel[j], course.a(k, j),
           carried + known},
          course.step);
    }
  }
  if (!course.q.allFinite())
    throw std::runtime_error("MuJoCo: the controlled motion is not finite");
  return course;
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
