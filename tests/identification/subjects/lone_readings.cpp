// SPDX-License-Identifier: GPL-3.0-or-later
// A single joint whose position or effort is in another unit than the header says: told by the
// model. A joint that only lacks something is not taken for a faulty log.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "identification/subjects/driven_channels.h"
#include "identification/subjects/driven_readings.h"
#include "symbolic/extension/driven_model.h"
#include "tests/identification/subjects/arm_logs.h"
#include "tests/reference/random_numbers.h"
#include "tests/reference/temporary_folder.h"

namespace {

using namespace sinew;
using diagnosis::EffortModel;
using diagnosis::Recording;
using Eigen::Index;
using std::numbers::pi;

/// The first joint of the arm, about a vertical axis: inertia, friction and damping alone.
Mechanism lone_joint() {
  Mechanism lone = test::arm_of_five();
  lone.joints.resize(1);
  lone.bodies.resize(1);
  Joint& joint = lone.joints.front();
  joint.armature = 0.03;
  joint.damping = 0.05;
  joint.friction = 0.6;
  joint.friction_speed = 0.05;
  joint.motor_turn = 2.0 * pi / 50.0;
  return lone;
}

/// Friction is most of its effort.
Mechanism light_joint() {
  Mechanism light = lone_joint();
  light.bodies[0].inertia *= 1e-3;
  light.bodies[0].mass *= 1e-3;
  Joint& joint = light.joints[0];
  joint.armature = 7e-4;
  joint.damping = 0.034;
  joint.friction = 0.25;
  return light;
}

/// Strokes, fast at a pace of 1, and the effort of this joint with a hundredth of noise.
Recording stroke_log(const Mechanism& truth, double pace = 1.0) {
  const DrivenModel driven = driven_model(truth);
  const Index n = 10000;
  Recording r;
  r.step = 0.001;
  r.time = Eigen::VectorXd::LinSpaced(n, 0.0, r.step * static_cast<double>(n - 1));
  r.q = r.qd = r.qdd = Eigen::MatrixXd::Zero(n, 1);
  for (const double hz : {0.3, 0.71, 1.9}) {
    const double w = 2.0 * pi * hz * pace, size = 0.8 / std::sqrt(hz);
    r.q.col(0).array() += size * (w * r.time.array()).sin();
    r.qd.col(0).array() += size * w * (w * r.time.array()).cos();
    r.qdd.col(0).array() -= size * w * w * (w * r.time.array()).sin();
  }
  Eigen::VectorXd effort = EffortModel(driven, {}, SINEW_SOURCE_DIR "/runtime")(r).col(0);
  reference::RandomNumbers random(7);
  for (double& value : effort) value += random.uniform(-0.02, 0.02);
  r.target = {effort};
  return r;
}

/// The same by a clock that is so many times too slow.
Recording clocked(Recording log, double factor) {
  log.step *= factor;
  log.time *= factor;
  log.qd /= factor;
  log.qdd /= factor * factor;
  return log;
}

/// The model that a log is judged against.
struct Judged {
  explicit Judged(const Mechanism& mechanism, const Identified& learnt = {})
      : nominal(driven_model(mechanism)),
        effort(nominal, learnt, SINEW_SOURCE_DIR "/runtime"),
        rigid(mechanism, SINEW_SOURCE_DIR "/runtime") {}
  DrivenModel nominal;
  EffortModel effort;
  diagnosis::RigidColumns rigid;
};

std::vector<DataFault> stops_by(const Judged& model, const Recording& logged) {
  Log log;
  log.channels.resize(3);
  log.channels[0].name = "theta";
  log.channels[1].name = "tau_m";
  log.channels[2].name = "load";
  log.channels[0].unit = "rad";
  log.channels[1].unit = log.channels[2].unit = "N*m";
  log.segments.resize(1);
  FaultList faults("log.csv");
  const int load = logged.load.size() > 0 ? 2 : -1;
  judge_driven_columns(log, {{0}, {1}, {}, load, -1, {}}, logged, model.nominal, model.effort,
                       &model.rigid, SINEW_SOURCE_DIR "/runtime", faults);
  return faults.all();
}

/// What stops the log, judged against the nominal joint.
std::vector<DataFault> lone_stops(const Recording& logged) {
  static const Judged nominal(lone_joint());
  return stops_by(nominal, logged);
}

}  // namespace

TEST_CASE("a wrong unit of a single joint is found by the model and named") {
  // Seen to fail where a drive that the model has was as free as one that it lacks (turns).
  struct Planted {
    const char* channel;
    double factor;
    const char* named;
  };
  const Planted all[] = {{"theta", 180.0 / pi, "degrees"}, {"theta", 0.5 / pi, "turns"},
                         {"theta", 50.0, "motor's angle"}, {"tau_m", 1000.0, "N·mm"},
                         {"tau_m", 0.001, "N·m"},          {"tau_m", 0.02, "motor's torque"}};
  const Recording right = stroke_log(lone_joint());
  for (const Planted& planted : all) {
    INFO(planted.channel << " times " << planted.factor);
    Recording wrong = right;
    if (planted.channel == std::string("theta"))
      wrong.q *= planted.factor;
    else
      wrong.target.front() *= planted.factor;
    const std::vector<DataFault> faults = lone_stops(wrong);
    REQUIRE(faults.size() == 1);
    CHECK(faults.front().severity == Severity::stop);
    CHECK(faults[0].channel == planted.channel);
    CHECK(faults[0].kind == FaultKind::unit_slip);
    CHECK(faults[0].meaning.find(planted.named) != std::string::npos);
  }
}

TEST_CASE("a reversed sign of a single joint, or its two columns exchanged, is told") {
  // Seen red without the exchanges, and without signs among the slips and the free factors: both
  // are told as a unit then. Signs as free factors alone are told, too.
  const Recording right = stroke_log(lone_joint());
  Recording position = right, effort = right, exchanged = right;
  position.q *= -1.0;
  effort.target.front() *= -1.0;
  exchanged.q.swap(exchanged.target.front());
  const std::pair<const Recording&, FaultKind> all[] = {{position, FaultKind::reversed_sign},
                                                        {effort, FaultKind::reversed_sign},
                                                        {exchanged, FaultKind::swapped_columns}};
  for (const auto& [wrong, kind] : all) {
    const std::vector<DataFault> faults = lone_stops(wrong);
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].severity == Severity::stop);
    CHECK(faults[0].kind == kind);
    // What is reversed is not to be told. Seen red without add_other_signs().
    if (kind == FaultKind::reversed_sign)
      CHECK(faults[0].meaning.find("or that of 'tau_") != std::string::npos);
  }
}

TEST_CASE("a wrong factor of the load or of the clock is found by the model and named") {
  // Seen to fail where a force that does something unknown could be a load, too (load times -1),
  // and with a load of half the size (a third of it): 0 == 1.
  const Recording right = stroke_log(lone_joint());
  Recording loaded = right;
  loaded.load = (1.0 + 0.8 * (1.7 * loaded.time.array()).sin()).matrix();
  loaded.target.front() += loaded.load.col(0);
  CHECK(lone_stops(loaded).empty());
  for (const double factor : {-1.0, 0.001, 1.0 / 3.0, 3.0}) {
    INFO("load times " << factor);
    Recording wrong = loaded;
    wrong.load *= factor;
    const std::vector<DataFault> faults = lone_stops(wrong);
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].channel == "load");
    CHECK(faults[0].severity == Severity::stop);
  }
  // An effort that is too small as a whole is no wrong load.
  Recording half = loaded;
  half.target.front() *= 0.5;
  for (const DataFault& fault : lone_stops(half)) CHECK(fault.channel != "load");
  // A clock changes inertia by the square of what it changes damping by.
  Mechanism damped = lone_joint();
  damped.joints[0].damping = 0.4;
  const Judged of_damped(damped);
  const Recording steady = stroke_log(damped);
  CHECK(stops_by(of_damped, steady).empty());
  for (const double factor : {0.5, 2.0, 3.0}) {
    INFO("time times " << factor);
    const std::vector<DataFault> faults = stops_by(of_damped, clocked(steady, factor));
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].channel == "time");
    CHECK(faults[0].meaning.find(factor > 1.0 ? "too slow" : "too fast") != std::string::npos);
  }
}

TEST_CASE("a slow clock is found where friction is most of the effort") {
  // Seen red where an inertia that the model has might also be off by a few per cent of the whole
  // effort: nine times a small inertia is that.
  const Recording right = stroke_log(lone_joint(), 0.12);
  CHECK(lone_stops(right).empty());
  const std::vector<DataFault> faults = lone_stops(clocked(right, 3.0));
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].channel == "time");
}

TEST_CASE("a slow clock is found where a friction quadratic in speed was learnt") {
  // Seen red where friction a hundred times faster was read as if it rose in proportion to speed:
  // of this one both parts were that huge that a small share of them could be anything.
  Mechanism light = light_joint();
  light.joints[0].damping = 0.0;
  const Identified learnt{
      {{"quadratic_friction", "j1", {}, {{"coefficient", 0.3, 0.001, ""}}, {}}}, {}, {}};
  Recording right = stroke_log(light, 0.3);
  right.target.front().array() += 0.3 * right.qd.col(0).array() * right.qd.col(0).array().abs();
  const Judged model(light, learnt);
  CHECK(stops_by(model, right).empty());
  const std::vector<DataFault> faults = stops_by(model, clocked(right, 3.0));
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].channel == "time");
}

TEST_CASE("friction that turns sooner than the model's is no fast clock") {
  // Seen red with the model's own law of its speed alone: at twice the speed it has turned.
  Mechanism sudden = lone_joint(), late = lone_joint();
  sudden.joints[0].friction_speed = 1e-4;
  late.joints[0].friction_speed = 0.5;
  CHECK(stops_by(Judged(late), stroke_log(sudden, 0.08)).empty());
}

TEST_CASE("a strongly concave friction beside a load is no motor's angle") {
  // Seen red where a friction that the model has may be off by shares of itself alone: this is no
  // sum of its viscous and its Coulomb part.
  const Mechanism light = light_joint();
  Recording log = stroke_log(light, 0.2);
  log.load = (0.3 + 0.3 * (1.7 * log.time.array()).sin()).matrix();
  const Eigen::ArrayXd speed = log.qd.col(0) / log.qd.cwiseAbs().maxCoeff();
  log.target.front() += log.load.col(0) + (4.0 * speed.sign() * speed.abs().pow(0.4)).matrix();
  CHECK(stops_by(Judged(light), log).empty());
}

TEST_CASE("a single joint whose model is far off is no faulty log") {
  // A sixfold inertia is no turns. Planted defect: with all that a machine may have otherwise kept
  // within 1e-4 (kAnyway, kMassOrFriction) three of them are told.
  const std::function<void(Mechanism&)> lacks[] = {
      [](Mechanism&) {},
      [](Mechanism& m) { m.bodies[0].inertia *= 5.0; },
      [](Mechanism& m) { m.joints[0].armature = 0.735; },
      [](Mechanism& m) { m.joints[0].armature *= 7.0; },
      [](Mechanism& m) { m.joints[0].friction *= 6.0; },
      [](Mechanism& m) { m.joints[0].friction *= 0.05; },
      [](Mechanism& m) { m.joints[0].damping *= 30.0; }};
  for (const auto& lack : lacks) {
    Mechanism truth = lone_joint();
    lack(truth);
    CHECK(lone_stops(stroke_log(truth)).empty());
  }
}

TEST_CASE("a single joint logged as a drive keeps its range") {
  // Seen to fail where drive_log_channels() gets no limits.
  Mechanism lone = lone_joint();
  lone.joints[0].low = -2.0;
  lone.joints[0].high = 2.5;
  lone.joints[0].max_velocity = 9.0;
  const reference::TemporaryFolder folder;
  const std::string path = (folder.path() / "log.csv").string();
  reference::write_text(path, "time [s],theta [rad],tau_m [N*m]\n0,0,0\n");
  const auto channels = diagnosis::robot_log_channels(lone, path, {});
  CHECK(channels.specs.at(0).low == -2.0);
  CHECK(channels.specs.at(0).high == 2.5);
  CHECK(channels.specs.at(0).max_rate == 9.0);
}
