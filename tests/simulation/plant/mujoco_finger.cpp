// SPDX-License-Identifier: GPL-3.0-or-later
// The finger on its tendons against MuJoCo, which gets bodies, joints and tendons from the same
// description and the force of each tendon from its own tendon length and the table of the lever.
#include <catch2/catch.hpp>

#ifdef SINEW_HAVE_MUJOCO
#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <cmath>
#include <cstring>

#include "symbolic/model/read_mechanism.h"
#include "tests/reference/mujoco_truth.h"
#include "tests/simulation/scenario_run.h"

using namespace sinew_tests;

namespace {

constexpr double pretension = 20.0;  // N
constexpr double duration = 1.0;     // s
constexpr int outputs = 200;         // along the run

/// The mechanism's MJCF with fixed tendons of its moment arms and a motor on each.
std::string with_tendons(const sinew::Mechanism& mechanism, double step, double damping) {
  std::string text = sinew::reference::mujoco_text(mechanism);
  std::size_t at = 0;
  for (const sinew::Joint& joint : mechanism.joints) {
    at = text.find("<joint ", at) + 7;
    text.insert(at, fmt::format("name=\"{}\" damping=\"{}\" ", joint.name, damping));
  }
  std::string tendons = "<tendon>\n", motors = "<actuator>\n";
  for (const sinew::Tendon& tendon : mechanism.tendons) {
    tendons += fmt::format("<fixed name=\"{}\">", tendon.name);
    for (const sinew::PulleyRouting& pulley : tendon.pulleys)
      tendons += fmt::format("<joint joint=\"{}\" coef=\"{}\"/>", pulley.joint, pulley.radius);
    tendons += "</fixed>\n";
    motors += fmt::format("<motor tendon=\"{}\" gear=\"1\"/>\n", tendon.name);
  }
  text.insert(text.find("</mujoco>"), tendons + "</tendon>\n" + motors + "</actuator>\n");
  const std::string option = "<option ";
  text.replace(text.find(option), option.size(),
               fmt::format("<option timestep=\"{}\" integrator=\"RK4\" ", step));
  return text;
}

/// Force over elongation by the lever's own geometry, from parts that are not simulated.
struct LeverCurve {
  sinew::TendonModel tendon;
  double start;
  double force(double elongation) const { return tendon.force_at(elongation); }
};

LeverCurve lever_curve() {
  const sinew::Part part = sinew::read_part(source + "/models/tendon");
  sinew::TendonModel tendon(std::get<sinew::TendonWithLever>(part.parameters), source + "/runtime");
  const double start = tendon.elongation_at(pretension);
  return {std::move(tendon), start};
}

const LeverCurve* curve_in_use = nullptr;
double initial_length[16];

void pull(const mjModel* model, mjData* data) {
  for (int i = 0; i < model->nu; ++i)
    data->ctrl[i] =
        -curve_in_use->force(curve_in_use->start + data->ten_length[i] - initial_length[i]);
}

/// Joint angles at every output, the start included, from q0 at rest.
std::vector<std::vector<double>> mujoco_run(const sinew::Mechanism& mechanism,
                                            const LeverCurve& curve, const std::vector<double>& q0,
                                            double step, double damping) {
  const std::string text = with_tendons(mechanism, step, damping);
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "finger.xml", static_cast<int>(text.size()));
  std::memcpy(files->filedata[0], text.data(), text.size());
  char error[1000] = "";
  mjModel* model = mj_loadXML("finger.xml", files.get(), error, sizeof error);
  mj_deleteVFS(files.get());
  INFO(error);
  REQUIRE(model != nullptr);
  mjData* data = mj_makeData(model);
  std::copy(q0.begin(), q0.end(), data->qpos);
  mj_fwdPosition(model, data);
  std::copy(data->ten_length, data->ten_length + model->ntendon, initial_length);
  curve_in_use = &curve;
  mjcb_control = pull;
  const long between = std::lround(duration / outputs / step);
  std::vector<std::vector<double>> rows{q0};
  for (int k = 0; k < outputs; ++k) {
    for (long i = 0; i < between; ++i) mj_step(model, data);
    rows.emplace_back(data->qpos, data->qpos + model->nq);
  }
  mjcb_control = nullptr;
  mj_deleteData(data);
  mj_deleteModel(model);
  return rows;
}

/// Anywhere along the run.
double largest_difference(const std::vector<std::vector<double>>& a,
                          const std::vector<std::vector<double>>& b) {
  REQUIRE(a.size() == b.size());
  double largest = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k)
    for (std::size_t i = 0; i < a[k].size(); ++i)
      largest = std::max(largest, std::abs(a[k][i] - b[k][i]));
  return largest;
}

}  // namespace

TEST_CASE("a finger on its tendons moves as in MuJoCo all along the run", "[mujoco]") {
  const sinew::Mechanism index = sinew::read_mechanism(source + "/models/index");
  const std::vector<double> q0{0.1, 0.3, 0.4, 0.2};
  // Gravity and the tip's weight start a swing about the pretensioned pose.
  const Run ours = run("index", scenario_text(duration, outputs / duration, R"(
[drive]
mode = "prescribed"
pretension = { value = 20, unit = "N" }
[initial]
q20 = { value = 0.1, unit = "rad" }
q21 = { value = 0.3, unit = "rad" }
q22 = { value = 0.4, unit = "rad" }
q23 = { value = 0.2, unit = "rad" }
[integrator]
relative_tolerance = { value = 1e-10, unit = "1" }
absolute_tolerance = { value = 1e-12, unit = "1" }
)"));
  std::vector<std::vector<double>> our_rows;
  for (std::size_t k = 0; k < ours.rows.size(); ++k) {
    our_rows.emplace_back();
    for (const char* joint : {"q20", "q21", "q22", "q23"})
      our_rows.back().push_back(ours.at(k, joint));
  }
  const LeverCurve curve = lever_curve();
  const double damping = index.joints.front().damping;
  const auto coarse = mujoco_run(index, curve, q0, 1e-4, damping),
             theirs = mujoco_run(index, curve, q0, 5e-5, damping);
  const std::vector<std::vector<double>> at_rest(theirs.size(), q0);
  CAPTURE(largest_difference(coarse, theirs), largest_difference(our_rows, theirs));
  CHECK(largest_difference(coarse, theirs) < 1e-6);
  CHECK(largest_difference(our_rows, theirs) < 1e-4);
  CHECK(largest_difference(our_rows, at_rest) > 1e-3);
  // Ten per cent more damping in MuJoCo would be seen.
  CHECK(largest_difference(our_rows, mujoco_run(index, curve, q0, 1e-4, 1.1 * damping)) > 1e-4);
}
#else
#include "tests/skip.h"

TEST_CASE("a finger on its tendons moves as in MuJoCo all along the run", "[mujoco]") {
  sinew::test::skip("MuJoCo is not installed (libmujoco-dev)");
}
#endif
