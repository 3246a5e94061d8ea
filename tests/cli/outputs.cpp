// SPDX-License-Identifier: GPL-3.0-or-later
// What --out may be: a file, a link, a device, a pipe, standard output; never one of the inputs.
#include <fcntl.h>
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/cli/program.h"
#include "tests/skip.h"

using namespace sinew;
namespace fs = std::filesystem;

namespace {

const std::string source = SINEW_SOURCE_DIR;
const std::string table = source + "/models/guiding/assumed_measurements.csv";

/// A model of a guide with its table of measurements, and a motor with a short scenario.
struct Bench : Workplace {
  Bench() {
    for (const char* model : {"guiding", "motor"})
      fs::copy(source + "/models/" + model, path("models/") / model, fs::copy_options::recursive);
    fs::copy_file(table, path("table.csv"));
    reference::write_text(path("short.toml"),
                          "[scenario]\nduration = { value = 0.3, unit = \"s\" }\n"
                          "output_rate = { value = 1000, unit = \"Hz\" }\n"
                          "[[command]]\nchannel = \"tau_m\"\nshape = \"sine\"\n"
                          "amplitude = { value = 0.5, unit = \"N*m\" }\n"
                          "frequency = { value = 30, unit = \"Hz\" }\n");
  }
};

const std::string identify = "sinew identify models/guiding --experiment guiding --log table.csv";
const std::string simulate =
    "sinew simulate models/motor --scenario short.toml --runtime " + source + "/runtime";
const std::vector<std::string> both{identify, simulate};

bool is_result(const std::string& text) {
  return text.rfind("{\n  \"model\"", 0) == 0 || text.rfind("time [s],", 0) == 0;
}

}  // namespace

TEST_CASE("a device is written into, never replaced, and what it refuses is told", "[outputs]") {
  // Planted defect, with devices of its own mounted over /dev: output_place() that takes every
  // place for a file: both commands end with 0, /dev/full and /dev/null are regular files.
  const Bench here;
  for (const std::string& command : both) {
    INFO(command);
    const Ended full = here.shell(command + " --out /dev/full");
    INFO(full.output);
    CHECK(full.status == 2);
    CHECK(full.says("/dev/full: cannot be written: No space left on device"));
    CHECK(fs::is_character_file("/dev/full"));
    CHECK(here.shell(command + " --out /dev/null").status == 0);
    CHECK(fs::is_character_file("/dev/null"));
  }
}

TEST_CASE("a pipe gets the output, and its end is told", "[outputs]") {
  const Bench here;
  REQUIRE(::mkfifo(here.path("pipe").c_str(), 0600) == 0);
  for (const std::string& command : both) {
    INFO(command);
    const Ended read =
        here.shell("cat pipe > read.txt & " + command + " --out pipe; s=$?; wait; exit $s");
    INFO(read.output);
    CHECK(read.status == 0);
    CHECK(is_result(here.text("read.txt")));
    CHECK(fs::is_fifo(here.path("pipe")));
    const Ended broken =
        here.shell("( : < pipe ) & " + command + " --out pipe; s=$?; wait; exit $s");
    CHECK((broken.status == 0 || broken.says("Broken pipe")));  // the reader may leave too late
  }
}

TEST_CASE("a link stays, what it leads to is replaced", "[outputs]") {
  const Bench here;
  fs::create_directory(here.path("elsewhere"));
  for (const std::string& command : both) {
    INFO(command);
    reference::write_text(here.path("elsewhere/old"), "old");
    for (const char* leads_to : {"elsewhere/old", "elsewhere/new"}) {
      fs::remove(here.path("link"));
      fs::create_symlink(leads_to, here.path("link"));
      CHECK(here.shell(command + " --out link").status == 0);
      CHECK(fs::is_symlink(here.path("link")));
      CHECK(is_result(here.text(leads_to)));
      fs::remove(here.path(leads_to));
    }
    fs::remove(here.path("link"));
    fs::create_symlink("link", here.path("link"));
    const Ended circle = here.shell(command + " --out link");
    CHECK(circle.status == 2);
    CHECK(circle.says("circle"));
    fs::remove(here.path("link"));
  }
}

TEST_CASE("a folder, a folder that is missing and a socket are no place for a file", "[outputs]") {
  const Bench here;
  for (const std::string& command : both)
    for (const auto& [out, says] : std::vector<std::pair<std::string, std::string>>{
             {"models", "is a folder; expected a file"},
             {"models/", "is a folder; expected a file"},
             {"none/run", "there is no folder"},
             {"new/", "expected a file"}}) {
      INFO(command << " --out " << out);
      const Ended ended = here.shell(command + " --out " + out);
      INFO(ended.output);
      CHECK(ended.status == 2);
      CHECK(ended.says(says));
    }
  CHECK(!fs::exists(here.path("none")));
}

TEST_CASE("standard output is - and every path to it", "[outputs]") {
  const Bench here;
  for (const std::string& command : both) {
    INFO(command);
    for (const char* out : {"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1", "into.txt"}) {
      INFO(out);
      const Ended ended = here.shell(command + " --out " + out + " > into.txt 2> told.txt");
      CHECK(ended.status == 0);
      CHECK(is_result(here.text("into.txt")));
      CHECK(here.text("into.txt").find("written to") == std::string::npos);
      CHECK(here.text("told.txt").find("written to") != std::string::npos);
    }
    // What the shell opened to append to keeps what it has.
    reference::write_text(here.path("all.txt"), "years\n");
    CHECK(here.shell(command + " --out /dev/stdout >> all.txt 2> told.txt").status == 0);
    CHECK(here.text("all.txt").rfind("years\n", 0) == 0);
    CHECK(here.shell(command + " --out - > /dev/full").status == 2);
    const Ended twice = here.shell(command + " --json --out -");
    CHECK(twice.status == 2);
    CHECK(twice.says("--json writes to as well"));
  }
}

TEST_CASE("a folder's place is no standard output", "[outputs]") {
  const Bench here;
  for (const char* command : {"generate models/index", "check models/index", "figures",
                              "import a.urdf", "diagnose models/motor --log table.csv"}) {
    INFO(command);
    const Ended ended = here.shell("sinew " + std::string(command) + " --out -");
    INFO(ended.output);
    CHECK(ended.status == 2);
    CHECK(ended.says("is standard output, which takes no folder"));
    CHECK(!fs::exists(here.path("-")));
  }
}

TEST_CASE("an input is never the output, however it is spelled", "[outputs]") {
  // Planted defect: Inputs::refuse() that refuses nothing: every case is red.
  const Bench here;
  fs::create_symlink("table.csv", here.path("link.csv"));
  fs::create_hard_link(here.path("table.csv"), here.path("second.csv"));
  const std::string before = here.text("table.csv"), part = here.text("models/guiding/part.toml");
  for (const char* out : {"table.csv", "./table.csv", "models/../table.csv", "link.csv",
                          "second.csv", "models/guiding/part.toml"}) {
    INFO(out);
    const Ended ended = here.shell(identify + " --out " + out);
    INFO(ended.output);
    CHECK(ended.status == 2);
    CHECK(ended.says("which the command reads"));
  }
  CHECK(here.text("table.csv") == before);
  CHECK(here.text("models/guiding/part.toml") == part);
  for (const char* out : {"short.toml", "models/motor/part.toml"}) {
    INFO(out);
    CHECK(here.shell(simulate + " --out " + out).says("which the command reads"));
  }
  CHECK(here.text("short.toml").rfind("[scenario]", 0) == 0);
  fs::rename(here.path("table.csv"), here.path("friction_by_angle.csv"));
  CHECK(here.shell("sinew identify models/guiding --experiment guiding --log friction_by_angle.csv "
                   "--out result.json --tables .")
            .says("which the command reads"));
  CHECK(here.text("friction_by_angle.csv") == before);
  CHECK(!fs::exists(here.path("result.json")));
}

TEST_CASE("a diagnosis does not write its report over the model or a log", "[outputs]") {
  const Bench here;
  fs::create_directory(here.path("found"));
  fs::rename(here.path("table.csv"), here.path("found/report.html"));
  const std::string before = here.text("found/report.html");
  const Ended log = here.shell("sinew diagnose models/motor --log found/report.html --out found");
  CHECK(log.status == 2);
  CHECK(log.says("which the command reads"));
  CHECK(here.text("found/report.html") == before);
  const Ended model = here.shell("sinew diagnose models/motor --log t.csv --out models/./motor/");
  CHECK(model.status == 2);
  CHECK(model.says("is the model's folder"));
}

TEST_CASE("an import over its own source is refused", "[outputs]") {
  const Bench here;
  fs::create_directory(here.path("arm"));
  const std::string robot =
      "<robot name=\"arm\"><link name=\"base\"/><link name=\"tip\"><inertial><mass value=\"1\"/>"
      "<inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>"
      "<joint name=\"q1\" type=\"continuous\"><parent link=\"base\"/><child link=\"tip\"/>"
      "<axis xyz=\"0 0 1\"/></joint></robot>";
  reference::write_text(here.path("arm/mechanism.toml"), robot);
  const Ended ended = here.shell("sinew import arm/mechanism.toml --out arm --force");
  INFO(ended.output);
  CHECK(ended.status == 2);
  CHECK(ended.says("which the command reads"));
  CHECK(here.text("arm/mechanism.toml") == robot);
  CHECK(here.sinew({"import", "arm/mechanism.toml", "--out", "new/arm"}).status == 0);
  fs::create_directories(here.path("bad/mechanism.toml"));
  reference::write_text(here.path("bad/mass_properties.csv"), "old");
  const Ended half = here.shell("sinew import arm/mechanism.toml --out bad --force");
  CHECK(half.status == 2);
  CHECK(half.says("cannot be written"));
  CHECK(here.text("bad/mass_properties.csv") == "old");
  CHECK(
      here.shell("sinew import arm/mechanism.toml --out arm/mechanism.toml").says("not a folder"));
}

TEST_CASE("a log that cannot be read to its end gives no result", "[outputs]") {
  const Bench here;
  if (here.shell("strace -o /dev/null true").status != 0) {
    sinew::test::skip("strace cannot trace here");
    return;
  }
  // Planted defect: CsvReader::on_bytes() that does not ask for std::ferror(): the fourth read
  // fails, the next one does not, and the command ends with 1 and a result.
  REQUIRE(here.shell(simulate + " --out run.csv").status == 0);
  const std::string command =
      "identify models/motor --experiment friction --log run.csv --out o.json";
  REQUIRE(here.shell("sinew " + command).status == 1);  // too short a log to identify anything
  fs::remove(here.path("o.json"));
  int failed = 0;
  for (int count = 1; count <= 20; ++count) {
    const Ended ended = here.shell(
        "strace -o trace -P run.csv -e trace=read -e inject=read:error=EIO"
        ":when=" +
        std::to_string(count) + " " SINEW_PROGRAM " " + command);
    if (here.text("trace").find("INJECTED") == std::string::npos) break;
    INFO(count << ": " << ended.output);
    CHECK(ended.status == 2);
    CHECK(!fs::exists(here.path("o.json")));
    ++failed;
  }
  CHECK(failed > 3);
}

TEST_CASE("a model's digest is that of what was read, or there is none", "[outputs]") {
  const Bench here;
  if (here.shell("strace -o /dev/null true").status != 0) {
    sinew::test::skip("strace cannot trace here");
    return;
  }
  // Planted defect: the model's files read by an ifstream whose state nobody looks at: status 0
  // with the digest of an empty file at the third read, which follows the parser's.
  int failed = 0;
  for (int count = 1; count <= 20; ++count) {
    const Ended ended = here.shell(
        "strace -o trace -P models/guiding/part.toml -e trace=read,pread64,readv -e "
        "inject=read,readv:error=EIO:when=" +
        std::to_string(count) + " " SINEW_PROGRAM " generate models/guiding --out c");
    if (here.text("trace").find("INJECTED") == std::string::npos) break;
    INFO(count << ": " << ended.output);
    CHECK(ended.status == 2);
    CHECK(!fs::exists(here.path("c")));
    ++failed;
  }
  CHECK(failed > 1);
}
