// SPDX-License-Identifier: GPL-3.0-or-later
// Input that means harm, or is broken beyond measure: nothing raw reaches the terminal, nothing
// runs for ever, and every refusal is short and says what the limit is.
#include <fmt/format.h>
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "tests/cli/hostile_text.h"

using namespace sinew;
namespace fs = std::filesystem;

namespace {

const std::string motor = SINEW_SOURCE_DIR "/models/motor";
constexpr const char* mechanism = "models/index/mechanism.toml";
constexpr const char* masses = "models/index/mass_properties.csv";

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

/// A model that is right but for one text.
void check_model(const std::string& file, const std::string& before, const std::string& after,
                 const std::string& words) {
  const Workplace here;
  here.change(file, before, after);
  check_refused(here, "generate models/index", words);
}

std::string joints(int count) {
  std::string text = "[mechanism]\nname = \"chain\"\n" +
                     std::string(
                         "gravity = { value = [0, 0, 0], unit = \"m/s^2\", from = "
                         "\"assumed\" }\n");
  for (int i = 0; i < count; ++i)
    text += fmt::format(
        "[[body]]\nname = \"b{}\"\nmassless = true\n[[joint]]\nname = \"q{}\"\ntype = "
        "\"revolute\"\nparent = \"{}\"\nchild = \"b{}\"\naxis = [0, 0, 1]\n"
        "range = {{ value = [-1, 1], unit = \"rad\", from = \"assumed\" }}\n",
        i, i, i == 0 ? "base" : fmt::format("b{}", i - 1), i);
  return text;
}

std::string scenario(const std::string& more) {
  return "[scenario]\nduration = { value = 1, unit = \"s\" }\n"
         "output_rate = { value = 100, unit = \"Hz\" }\n" +
         more;
}

std::string simulate(const std::string& file) {
  return "simulate " + motor + " --scenario " + file + " --out out.csv --runtime " +
         SINEW_SOURCE_DIR "/runtime";
}

}  // namespace

TEST_CASE("names, units, cells and paths reach the terminal escaped", "[hostile]") {
  check_model(mechanism, "name = \"medial\"", "name = \"\\u001b[31mmedial\"", "\\u001b[31mmedial");
  check_model(mechanism, "name = \"medial\"", "name = \"\\u202elaidem\\u009b\"",
              "\\u202elaidem\\u009b");
  check_model(mechanism, "parent = \"knuckle\"", "parent = \"a\\nsinew: all is well\"",
              "'a\\nsinew: all is well'");
  check_model(mechanism, "unit = \"m/s^2\"", "unit = \"\\u007f\\u0008m\"", "\\u007f\\u0008m");
  check_model(masses, "distal,0.003", "dis\x1b]0;title\atal,0.003", "dis\\u001b]0;title\\u0007tal");
  check_model(masses, "distal,0.003", "dis\xfftal,0.003", "dis\\xfftal");
  const Workplace here;
  check_refused(here, "generate \"$(printf 'models/\\033[31m\\377')\"", "models/\\u001b[31m\\xff");
  check_refused(here, "\"$(printf '\\033[31m')\"", "\\u001b[31m");
  check_refused(here, "generate models/index \"$(printf -- '--a\\033[31m')\"", "\\u001b[31m");
  fs::create_directory(here.path("\x1b[31m\xff"));
  check_refused(here,
                "identify " + motor +
                    " --experiment friction --out o.json --log "
                    "\"$(printf '\\033[31m\\377')\"",
                "\\u001b[31m\\xff");
}

TEST_CASE("what is written is escaped, too: comments of the emitted C and JSON", "[hostile]") {
  const Workplace here;
  here.change(mechanism, "description = \"", "description = \"\\u202e\\u001b[2J*/ ");
  const std::string out = "\"$(printf 'out\\033\\377')\"";
  const Ended ended = here.shell("sinew generate models/index --json --out " + out);
  INFO(ended.output);
  REQUIRE(ended.status == 0);
  CHECK(first_raw(ended.output) == "");
  const Ended code = here.shell("cat " + out + "/index.c " + out + "/index.h");
  CHECK(first_raw(code.output) == "");
  CHECK(code.says("u202e"));
}

TEST_CASE("long cells and long lists are cut", "[hostile]") {
  check_model(masses, "distal,0.003", std::string(1'000'000, 'x') + ",0.003", "bytes left out");
  check_model(mechanism, "name = \"medial\"", "name = \"" + std::string(1'000'000, 'x') + "\"",
              "bytes left out");
  const Workplace here;
  std::string header = "time [s]";
  for (int i = 0; i < 5000; ++i) header += fmt::format(",column_{} [rad]", i);
  reference::write_text(here.path("log.csv"), header + "\n");
  check_refused(here, "identify " + motor + " --experiment friction --out o.json --log log.csv",
                " more");
}

TEST_CASE("descriptions without measure are refused with the limit", "[hostile]") {
  const Workplace here;
  const std::string original = here.text(mechanism);
  const auto refuse = [&](const std::string& text, const std::string& words) {
    reference::write_text(here.path(mechanism), text);
    check_refused(here, "generate models/index", words);
  };
  refuse(repeated("a.", 100000) + "a = 1\n" + original, "nested deeper than 32 levels");
  refuse("a = " + repeated("[", 100000) + "\n" + original, "nested deeper than 32 levels");
  const std::string table = here.text(masses);
  reference::write_text(here.path(masses), table.substr(0, table.find("\nknuckle") + 1));
  refuse(joints(5000), "expected at most 1000");
  refuse(joints(500), "the mechanism has 500 coordinates; expected at most 100");
  refuse(original + std::string(5'000'000, '#'), "expected at most 4194304");
  reference::write_text(here.path(mechanism), original);
  reference::write_text(here.path(masses),
                        here.text(masses) + repeated("nobody,1,0,0,0,1,1,1,0,0,0\n", 1'000'000));
  check_refused(here, "generate models/index", "expected at most 4194304");
  reference::write_text(here.path(masses), "link,mass\n" + repeated("x,1\n", 100'000));
  check_refused(here, "generate models/index", "the table has 100000 rows; expected at most 1000");
  fs::remove(here.path(mechanism));
  REQUIRE(::mkfifo(here.path(mechanism).c_str(), 0600) == 0);
  check_refused(here, "generate models/index", "cannot be read; expected a readable file");
}

TEST_CASE("URDF without measure is refused with the limit", "[hostile]") {
  const Workplace here;
  const auto refuse = [&](const std::string& text, const std::string& words) {
    reference::write_text(here.path("robot.urdf"), text);
    check_refused(here, "import robot.urdf --out models/robot", words);
  };
  const std::string deep = "nested more than 200 deep";
  refuse("<robot name=\"r\">" + repeated("<a>", 100000), deep);
  refuse("<robot name=\"r\">" + repeated("<a x=\"/>\">", 100000), deep);
  refuse("<robot name=\"r\">" + repeated("<a><!-- </a> -->", 100000), deep);
  refuse("<robot name=\"r\">" + repeated("<link name=\"l\"/>", 100000) + "</robot>",
         "more than 2000 links and joints");
  refuse("<robot name=\"r\">" + repeated("<mystery/>", 100000) + "</robot>", "no link");
}

TEST_CASE("a log that is no file, or has no end, is refused", "[hostile]") {
  const Workplace here;
  const std::string identify = "identify " + motor + " --experiment friction --out o.json --log ";
  REQUIRE(::mkfifo(here.path("pipe.csv").c_str(), 0600) == 0);
  check_refused(here, identify + "pipe.csv", "pipe.csv:0:0: is no file but a pipe or a device");
  check_refused(here, identify + "/dev/zero", "is no file but a pipe or a device");
  check_refused(here, identify + "models", "is a folder without metadata.yaml");
  check_refused(here, "diagnose " + motor + " --out o --log pipe.csv", "is no file but a pipe");
  check_refused(here, simulate("/dev/zero"), "cannot be read; expected a readable file");
  check_refused(here, "identify " + motor + " --experiment guiding --out o.json --log pipe.csv",
                "expected");
  std::ofstream(here.path("huge.csv")).close();
  fs::resize_file(here.path("huge.csv"), 200ULL << 30);  // without a byte of it on the disk
  check_refused(here, identify + "huge.csv", "expected at most 107374182400");
  fs::resize_file(here.path("huge.csv"), 1ULL << 30);
  check_refused(here, identify + "huge.csv", "a line longer than 16777216 bytes");
  reference::write_text(here.path("wide.csv"), repeated("a,", 20000) + "a\n");
  check_refused(here, identify + "wide.csv", "20001 columns; expected at most 10000");
}

TEST_CASE("a run that would not end is refused, or given up", "[hostile][slow]") {
  const Workplace here;
  const auto refuse = [&](const std::string& text, const std::string& words) {
    reference::write_text(here.path("run.toml"), scenario(text));
    check_refused(here, simulate("run.toml"), words);
  };
  const std::string sine =
      "[[command]]\nchannel = \"tau_m\"\nshape = \"sine\"\n"
      "amplitude = { value = 1, unit = \"N*m\" }\nfrequency = { value = 1e12, unit = \"Hz\" }\n";
  refuse(sine, "more than 1e+06 periods in the run");
  refuse("[integrator]\nmethod = \"runge_kutta_4\"\nstep = { value = 1e-12, unit = \"s\" }\n",
         "more than 1e+09 steps");
  refuse(
      "[drive]\nmode = \"servo\"\ngain = { value = 1e12, unit = \"N*m\" }\n"
      "rate_gain = { value = 0, unit = \"N*m*s/rad\" }\n"
      "[[command]]\nchannel = \"theta_ref\"\nshape = \"sine\"\n"
      "amplitude = { value = 1, unit = \"rad\" }\nfrequency = { value = 1, unit = \"Hz\" }\n",
      "took the run only");
  reference::write_text(here.path("run.toml"),
                        "[scenario]\nduration = { value = 1e12, unit = \"s\" }\n"
                        "output_rate = { value = 1e-6, unit = \"Hz\" }\n");
  check_refused(here, simulate("run.toml"), "expected at most 86400 s");
}

TEST_CASE("the program speaks through cli/terminal/ alone", "[hostile]") {
  const fs::path source = SINEW_SOURCE_DIR;
  std::string speaking;
  int files = 0;
  for (const char* folder : {"cli", "symbolic", "generator", "simulation", "identification"})
    for (const auto& entry : fs::recursive_directory_iterator(source / folder)) {
      const fs::path& file = entry.path();
      if (file.extension() != ".cpp" && file.extension() != ".h") continue;
      if (file.parent_path() == source / "cli/terminal") continue;
      ++files;
      const std::string text = reference::read_text(file);
      for (const char* way : {"fmt::print(", "std::cout", "std::cerr", "std::clog", "printf(",
                              "std::puts(", "fputs(", "stderr", "stdout,"})
        if (text.find(way) != std::string::npos) speaking += file.string() + ": " + way + "\n";
    }
  INFO(speaking);
  CHECK(files > 100);
  CHECK(speaking.empty());
}
