// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/emitted/compiled_model.h"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <optional>

#include "tests/reference/temporary_folder.h"

using namespace sinew;
using reference::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

const fs::path runtime = SINEW_SOURCE_DIR "/runtime";
const fs::path motor = SINEW_SOURCE_DIR "/generated/motor";

/// CC for as long as it lives.
class Compiler {
 public:
  explicit Compiler(const std::string& name) {
    if (const char* before = std::getenv("CC")) before_ = before;
    ::setenv("CC", name.c_str(), 1);
  }
  ~Compiler() { before_ ? ::setenv("CC", before_->c_str(), 1) : ::unsetenv("CC"); }

 private:
  std::optional<std::string> before_;
};

}  // namespace

TEST_CASE("a model is called by name, with the numbers that its catalogue asks for") {
  const CompiledModel model(motor, runtime);
  CHECK(model.name() == "motor");
  CHECK(model.has("friction_torque"));
  CHECK_FALSE(model.has("no_such_torque"));
  CHECK_THROWS_WITH(model.find("no_such_torque"),
                    Catch::Contains("motor_no_such_torque is not in the catalogue"));
  const auto inputs = static_cast<std::size_t>(model.find("friction_torque").input_size);
  CHECK_THROWS_WITH(model("friction_torque", std::vector<double>(inputs + 1)),
                    Catch::Contains("numbers"));
  CHECK(model("friction_torque", std::vector<double>(inputs)).size() ==
        static_cast<std::size_t>(model.find("friction_torque").output_size));
}

TEST_CASE("a folder's name is the model's, however its path is written") {
  CHECK(CompiledModel(motor / "", runtime).name() == "motor");
}

TEST_CASE("a machine without a C compiler is told so") {
  // Planted defect: the status 127 taken for any other: "the emitted C does not compile".
  const Compiler none("no-such-compiler");
  CHECK_THROWS_WITH(CompiledModel(motor, runtime),
                    Catch::Contains("no C compiler: 'no-such-compiler' cannot be started"));
}

TEST_CASE("C that does not compile is told with its folder") {
  const TemporaryFolder place;
  fs::copy(motor, place.path() / "motor");
  reference::write_text(place.path() / "motor" / "motor.c", "this is no C\n");
  CHECK_THROWS_WITH(
      CompiledModel(place.path() / "motor", runtime),
      Catch::Contains((place.path() / "motor").string()) && Catch::Contains("does not compile"));
}
