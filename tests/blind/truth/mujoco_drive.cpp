// SPDX-License-Identifier: GPL-3.0-or-later
// The drive once more, with MuJoCo's mechanics and integrator in place of ours. Its own dry
// friction holds a body fast at rest, which no law of speed alone follows; the smooth law is
// applied instead.
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "tests/blind/truth/drive_truth.h"

#ifdef SINEW_HAVE_MUJOCO
#include <mujoco/mujoco.h>

#include <array>
#include <cstring>
#include <deque>
#include <memory>
#endif

namespace sinew::truth {

#ifdef SINEW_HAVE_MUJOCO

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr size_t steps_a_row = 4;

struct DeleteModel {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
struct DeleteData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};

// A turning (or sliding) body; with a compliance a second one behind a spring.
std::string drive_text(const DriveModel& m, const DriveHidden& h, const DriveRun& run) {
  const double inertia = m.inertia + h.inertia_more;
  const bool two = h.compliance > 0.0;
  const double first = two ? run.motor_share * inertia : inertia;
  const auto body = [&](double value, const std::string& joint, const std::string& inner) {
    const std::string inertial =
        m.linear
            ? fmt::format("<inertial pos=\"0 0 0\" mass=\"{:.17g}\" diaginertia=\"1 1 1\"/>", value)
            : fmt::format(
                  "<inertial pos=\"0 0 0\" mass=\"1\" "
                  "diaginertia=\"{0:.17g} {0:.17g} {0:.17g}\"/>",
                  value);
    return fmt::format("<body>{}<joint type=\"{}\" axis=\"0 0 1\" {}/>{}</body>", inertial,
                       m.linear ? "slide" : "hinge", joint, inner);
  };
  const std::string motor_joint = fmt::format("damping=\"{:.17g}\"", m.viscous + h.viscous_more);
  std::string behind;
  if (two) {
    const double stiffness = 1.0 / h.compliance, second = inertia - first;
    behind = body(second,
                  fmt::format("stiffness=\"{:.17g}\" damping=\"{:.17g}\"", stiffness,
                              0.1 * std::sqrt(stiffness * second)),
                  "");
  }
  return fmt::format(
      "<mujoco><compiler angle=\"radian\" inertiafromgeom=\"false\" boundmass=\"0\" "
      "boundinertia=\"0\"/><option timestep=\"{:.17g}\" gravity=\"0 0 0\" iterations=\"50\"/>"
      "<size nconmax=\"1\" njmax=\"8\"/><worldbody>{}</worldbody></mujoco>",
      run.period / steps_a_row, body(first, motor_joint, behind));
}

std::unique_ptr<mjModel, DeleteModel> load_text(const std::string& text) {
  mjVFS files;
  mj_defaultVFS(&files);
  mj_makeEmptyFileVFS(&files, "drive.xml", static_cast<int>(text.size()));
  std::memcpy(files.filedata[0], text.data(), text.size());
  std::array<char, 1000> error{};
  std::unique_ptr<mjModel, DeleteModel> model(
      mj_loadXML("drive.xml", &files, error.data(), static_cast<int>(error.size())));
  mj_deleteVFS(&files);
  if (!model) throw std::runtime_error(fmt::format("MuJoCo: {}", error.data()));
  return model;
}

double extra_effort(const DriveModel& m, const DriveHidden& h, double x) {
  double f = h.offset;
  if (h.output_ripple != 0.0)
    f += h.output_ripple * std::sin(h.output_order * 2.0 * pi * x / m.output_turn + h.output_phase);
  if (h.input_ripple != 0.0)
    f += h.input_ripple * std::sin(h.input_order * 2.0 * pi * x / m.motor_turn + h.input_phase);
  return f;
}

// Steep near rest: the slope becomes MuJoCo's damping, which it takes implicitly, and only what
// is left is applied.
double dry_friction(mjModel& model, const DriveModel& m, const DriveHidden& h, double v) {
  const double level = m.level * (1.0 + h.friction_scale), s = m.shape * v;
  const double slope = level * m.shape / (1.0 + s * s);
  model.dof_damping[0] = m.viscous + h.viscous_more + slope;
  return level * std::atan(s) - slope * v;
}

}  // namespace

bool mujoco_is_there() {
  return true;
}

DriveSamples run_drive_in_mujoco(const DriveModel& m, const DriveHidden& h, const DriveRun& run,
                                 const DriveCommand& command) {
  const auto model = load_text(drive_text(m, h, run));
  const std::unique_ptr<mjData, DeleteData> data(mj_makeData(model.get()));
  data->qpos[0] = command.reference[0].position;
  data->qvel[0] = command.reference[0].velocity;
  const auto rows = static_cast<size_t>(run.seconds / run.period);
  const size_t stride = command.reference.size() / (rows * steps_a_row);
  const double step = run.period / steps_a_row;
  const auto late = static_cast<size_t>(std::lround(h.delay / step));
  std::deque<double> waiting;
  DriveSamples out;
  for (size_t k = 0; k < rows * steps_a_row; ++k) {
    const size_t at = k * stride;
    const Reference& r = command.reference[at];
    const double x = data->qpos[0], v = data->qvel[0];
    const double effort = command.stiffness * (r.position - x) +
                          command.damping * (r.velocity - v) + m.inertia * r.acceleration +
                          command.help[at] + command.load[at];
    if (k % steps_a_row == 0) {
      out.time.push_back(static_cast<double>(k / steps_a_row) * run.period);
      out.position.push_back(x);
      out.effort.push_back(effort);
      out.reference.push_back(r.position);
      out.load.push_back(command.load[at]);
    }
    waiting.push_back(effort);
    const double acting = (1.0 + h.torque_gain) * waiting.front();
    if (waiting.size() > late) waiting.pop_front();
    // The load pulls at the last body, whose motion is the sum of both joints'.
    data->qfrc_applied[0] =
        acting - extra_effort(m, h, x) - command.load[at] - dry_friction(*model, m, h, v);
    if (model->nv > 1) data->qfrc_applied[1] = -command.load[at];
    mj_step(model.get(), data.get());
  }
  return out;
}

#else

bool mujoco_is_there() {
  return false;
}

DriveSamples run_drive_in_mujoco(const DriveModel&, const DriveHidden&, const DriveRun&,
                                 const DriveCommand&) {
  throw std::runtime_error(
      "this build has no MuJoCo; expected libmujoco-dev when it was configured");
}

#endif

}  // namespace sinew::truth
