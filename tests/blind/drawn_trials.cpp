// SPDX-License-Identifier: GPL-3.0-or-later
// What scripts/study rests on: that a trial is what its seal says, by one definition for every
// plant.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/blind/seals.h"
#include "tests/blind/truth/jointed.h"
#include "tests/blind/truth/limits.h"
#include "tests/reference/temporary_folder.h"
#include "tests/skip.h"

namespace {

using namespace sinew::trials;
using nlohmann::json;
namespace fs = std::filesystem;

const char* const plants[] = {"drive", "joint", "arm", "finger", "hand", "lever", "wrist"};

std::set<std::string> files_in(const fs::path& folder) {
  std::set<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.insert(fs::relative(entry.path(), folder).string());
  return files;
}

}  // namespace

TEST_CASE("the list of every plant's causes has what is offered") {
  // Planted defect: a line less of the list is named.
  std::set<std::string> listed;
  std::ifstream file(SINEW_SOURCE_DIR "/tests/blind/study/causes.csv");
  for (std::string line; std::getline(file, line);) listed.insert(line);
  for (const char* name : plants)
    for (std::uint64_t seed = 1; seed < 3; ++seed) {
      const std::unique_ptr<TrialPlant> plant = plant_of(name, seed);
      for (const Offer& offer : plant->offers()) {
        if (offer.outside) continue;
        const std::string line = std::string(name) + "," + offer.cause;
        INFO(line);
        CHECK((listed.count(line) == 1 ||
               listed.count(line + " " + std::to_string(offer.order)) == 1));
      }
    }
}

TEST_CASE("a light joint sticks, and is not thrown to and fro by its friction") {
  // Planted defect: friction of the step before, as it was: at the last joint 5,324 of 20,000 steps
  // are thrown back by it.
  const std::unique_ptr<TrialPlant> finger = plant_of("finger", 5028);
  const Course course = finger->course({}, 0);
  for (Index j = 0; j < course.v.cols(); ++j) {
    int thrown = 0;
    for (Index k = 1; k + 1 < course.v.rows(); ++k)
      thrown +=
          course.v(k - 1, j) * course.v(k, j) < 0.0 && course.v(k, j) * course.v(k + 1, j) < 0.0;
    INFO("joint " << j << ": " << thrown << " of " << course.v.rows());
    CHECK(thrown * 1000 < course.v.rows());
  }
}

TEST_CASE("position, speed and effort of a simulated motion are of one instant") {
  // Planted defect: positions as semi-implicit steps leave them, half a step behind the speed, as
  // it was: 0.5 of a step at every plant. It was a delay of 0.13 ms that programs rightly told.
  for (const char* name : {"drive", "joint", "finger", "hand"}) {
    const Course course = plant_of(name, 5)->course({}, 0);
    const Index inside = course.q.rows() - 2;
    for (Index j = 0; j < course.q.cols(); ++j) {
      const VectorXd q = course.q.col(j), v = course.v.col(j), a = course.a.col(j);
      const VectorXd late = (q.tail(inside) - q.head(inside)) / (2.0 * course.step);
      const VectorXd centred = 0.5 * (a.head(inside) + a.segment(1, inside));
      const double delay =
          (late - v.segment(1, inside)).dot(centred) / centred.squaredNorm() / course.step;
      INFO(name << ", axis " << j << ": position " << delay << " steps before the speed");
      CHECK(std::abs(delay) < 0.05);
    }
  }
}

TEST_CASE("what a pair's log does not tell, the motion that is played does") {
  // Planted defect: on a drawn motion, without draw_drive's `pairing->course`, it is told apart
  // by the log: not reachable.
  const sinew::reference::TemporaryFolder folder;
  TrialRequest request;
  request.family = "pair";
  request.plant = "drive";
  request.cause = "viscous_level";
  const json seal = seal_of(request, folder.path() / "trial");
  REQUIRE(seal.at("reachable"));
  CHECK(seal.at("hidden").at(0).at("cause") == "viscous_level");
  CHECK(seal.at("hidden").at(0).at("excess") == Approx(1.0).epsilon(0.045));
  CHECK(seal.at("admissible").size() == 2);
  CHECK(seal.at("apart").get<double>() < 0.3);
  // A ramp of the speed, two rows for each row of rest.
  const fs::path motion = folder.path() / "motion.csv", log = folder.path() / "trial/train2.csv";
  std::ifstream first(folder.path() / "trial/train.csv");
  std::string head, row, second;
  std::getline(first, head);
  std::getline(first, row);
  std::getline(first, second);
  const double step = std::stod(second);
  {
    std::ofstream out(motion);
    out << "# strokes\ntime [s],theta_ref [rad]\n";
    for (int k = 0; k < 500; ++k)
      out << step * k << "," << std::pow(std::sin(0.002 * k), 2.0) << "\n";
  }
  play_motion(request, motion, log);
  std::ifstream played(log);
  std::string columns;
  std::getline(played, columns);
  CHECK(columns == head);
  std::string last, line;
  for (; std::getline(played, line);) last = line;
  const double reached = std::stod(last.substr(last.find(',') + 1));
  CHECK(reached == Approx(std::pow(std::sin(0.998), 2.0)).epsilon(0.1));
  std::ofstream(motion) << "time [s],theta_ref [rad]\n0,0\n1,0,0\n";
  CHECK_THROWS_WITH(play_motion(request, motion, log), Catch::Contains(":3:0: 3 cells of 2"));
}

TEST_CASE("every plant offers eight causes outside the library, and every cause has its limits") {
  for (const char* name : plants) {
    std::set<std::string> outside;
    for (std::uint64_t seed = 1; seed < 4; ++seed) {
      const std::unique_ptr<TrialPlant> plant = plant_of(name, seed);
      for (const Offer& offer : plant->offers()) {
        INFO(name << ", " << offer.cause << " at " << offer.place);
        CHECK_NOTHROW(limit_of(offer.cause));
        CHECK(offer.scale > 0.0);
        if (offer.outside) outside.insert(offer.cause);
      }
    }
    INFO(name);
    CHECK(outside.size() >= 8);
  }
}

TEST_CASE("what is hidden at an axis acts there", "[slow]") {
  // Planted defect, seen to fail: a cause that outside_of() knows and on_axis (axis.cpp) does not.
  for (const char* name : {"drive", "joint"}) {
    std::map<std::string, bool> reached;
    for (std::uint64_t seed = 1; seed < 6; ++seed) {
      const std::unique_ptr<TrialPlant> plant = plant_of(name, seed);
      for (const Offer& offer : plant->offers()) {
        if (!offer.outside && offer.cause != "unlogged_force") continue;
        bool& some = reached[offer.cause];
        if (some) continue;
        const sinew::reference::TemporaryFolder folder;
        TrialRequest request;
        request.plant = name;
        request.seed = seed;
        request.family = offer.outside ? "outside" : "one";
        request.cause = offer.cause;
        some = seal_of(request, folder.path() / "trial").at("reachable");
      }
    }
    for (const auto& [cause, some] : reached) {
      INFO(name << ", " << cause);
      CHECK(some);
    }
  }
}

TEST_CASE(
    "a request draws the same trial again, of the size asked for, and nothing but model and logs") {
  for (const char* name : {"joint", "lever", "wrist", "finger"}) {
    const sinew::reference::TemporaryFolder folder;
    TrialRequest request;
    request.plant = name;
    request.seed = 12;
    request.family = "null";
    seal_of(request, folder.path() / "0");
    request.family = "one";
    request.cause = name == std::string("lever")    ? "spring_constant"
                    : name == std::string("wrist")  ? "wrist_zero"
                    : name == std::string("finger") ? "force_sensor_scale"
                                                    : "viscous_asymmetry";
    const json seal = seal_of(request, folder.path() / "1");
    INFO(name << " " << seal.dump());
    REQUIRE(seal.at("reachable"));
    CHECK(seal.at("hidden").at(0).at("excess") == Approx(1.0).margin(0.04));
    CHECK(seal.at("hidden").at(0).at("plain") >=
          seal.at("hidden").at(0).at("excess").get<double>() * 0.999);
    CHECK(seal_of(request, folder.path() / "2") == seal);
    for (const std::string& file : files_in(folder.path() / "1")) {
      INFO(file);
      CHECK((file == "train.csv" || file == "holdout.csv" ||
             fs::path(file).extension() == ".toml" ||
             fs::path(file).filename() == "mass_properties.csv"));
    }
  }
}

TEST_CASE(
    "logs are of their own motions, and what is held out is the same however many there are") {
  const sinew::reference::TemporaryFolder folder;
  TrialRequest request;
  request.plant = "joint";
  request.seed = 12;
  request.cause = "viscous_asymmetry";
  const json seal = seal_of(request, folder.path() / "one");
  request.logs = 2;
  CHECK(seal_of(request, folder.path() / "two") == seal);
  const auto text = [&](const char* file) {
    std::ifstream in(folder.path() / file);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  CHECK(files_in(folder.path() / "two").count("train2.csv") == 1);
  CHECK(text("one/holdout.csv") == text("two/holdout.csv"));
  CHECK(text("one/train.csv") == text("two/train.csv"));
  // Planted defect: with the motion of log 0 in every log, course(hidden, 0), the noise alone
  // differs and this says that 0 is not above 0.1.
  const auto positions = [&](const char* file) {
    std::istringstream lines(text(file));
    std::string line;
    std::getline(lines, line);
    std::vector<double> q;
    while (std::getline(lines, line)) q.push_back(std::stod(line.substr(line.find(',') + 1)));
    return q;
  };
  const std::vector<double> second = positions("two/train2.csv");
  for (const char* other : {"two/train.csv", "two/holdout.csv"}) {
    const std::vector<double> first = positions(other);
    REQUIRE(first.size() == second.size());
    double apart = 0.0;
    for (std::size_t k = 0; k < first.size(); ++k)
      apart = std::max(apart, std::abs(first[k] - second[k]));
    CHECK(apart > 0.1);
  }
}

TEST_CASE("a coupled joint takes from the joint before it what its ratio gives: energy is kept") {
  // The power that the coordinates give is that of all joints. Planted defect: without the ratio,
  // result(n - 1) += each(n), the first seed says -7.89 == Approx( -8.18 ).
  for (std::uint64_t seed = 1; seed < 20; ++seed) {
    Chain chain;
    sinew::truth::Draw draw(seed);
    for (int i = 0; i < 3; ++i) {
      Link link;
      link.parent = i - 1;
      link.axis = Vector3d(0.1 * i, 1.0, 0.0).normalized();
      link.xyz = Vector3d(i == 0 ? 0.0 : 0.3, 0.0, 0.0);
      link.com = Vector3d(0.15, 0.01, 0.0);
      link.inertia *= 0.01;
      chain.links.push_back(link);
    }
    const double ratio = draw.uniform(0.5, 1.2);
    const auto some = [&] { return VectorXd(Eigen::Vector2d(draw.normal(), draw.normal())); };
    const VectorXd q = some(), v = some(), a = some();
    const auto all = [&](const VectorXd& x) {
      return VectorXd(Vector3d(x(0), x(1), ratio * x(1)));
    };
    const double of_all = chain.torque(all(q), all(v), all(a)).dot(all(v));
    chain.links.back().follows = ratio;
    REQUIRE(chain.size() == 2);
    CHECK(chain.torque(q, v, a).dot(v) == Approx(of_all).epsilon(1e-12));
  }
}

TEST_CASE("tendons of fingers and hands pull, none is cut off at a least force",
          "[slow][thorough]") {
  // Planted defect: a pretension of each tendon by itself, cut off at half a newton (seed 3).
  for (const char* name : {"finger", "hand"})
    for (std::uint64_t seed = 1; seed < 7; ++seed) {
      const std::unique_ptr<TrialPlant> plant = plant_of(name, seed);
      INFO(name << " " << seed);
      const Log log = plant->replay(plant->course({}, 0), {}, 0);
      for (std::size_t c = 0; c < log.names.size(); ++c)
        if (log.names[c].starts_with("force_"))
          CHECK(log.columns.col(static_cast<Eigen::Index>(c)).minCoeff() > 0.9);
    }
}

TEST_CASE("measurement noise has the size it says and a colour") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    sinew::truth::Noise noise{sinew::truth::Draw(seed)};
    Eigen::ArrayXd x(200000);
    for (double& v : x) v = noise.next();
    CHECK(std::sqrt(x.square().mean()) == Approx(1.0).epsilon(0.08));
    CHECK((x.tail(199999) * x.head(199999)).mean() > 0.02);
  }
}

TEST_CASE("MuJoCo's mechanics ask for the efforts that ours do") {
  if (!mujoco_is_there()) return sinew::test::skip("this build has no MuJoCo");
  // Planted defect: a drive's load that is logged and does not act, as it once was: 0.69 < 0.016 at
  // seed 2.
  int loaded = 0;
  for (const auto& [name, seed] :
       {std::pair("mujoco_arm", 4), std::pair("mujoco_drive", 1), std::pair("mujoco_drive", 2),
        std::pair("mujoco_drive", 3), std::pair("mujoco_drive", 4)}) {
    const auto plant = plant_of(name, static_cast<std::uint64_t>(seed));
    Course course = plant->course({}, 0);
    const Log given = plant->replay(course, {}, 0);
    loaded += given.names.back() == "load" ? 1 : 0;
    course.command.resize(0, 0);
    const Log ours = plant->replay(course, {}, 0);
    for (Index c = 0; c < given.columns.cols(); ++c) {
      INFO(name << " " << seed << " " << given.names[static_cast<std::size_t>(c)]);
      CHECK(rms(given.columns.col(c) - ours.columns.col(c)) <
            0.02 * rms(given.columns.col(c)) + 1e-12);
    }
  }
  CHECK(loaded > 0);
}
