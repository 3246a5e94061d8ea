// SPDX-License-Identifier: GPL-3.0-or-later
// Every command that writes, ended by force at each step of its writing and on a full disk: its
// outputs are all old or all new.
#include <sys/mount.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "tests/cli/program.h"
#include "tests/skip.h"

using namespace sinew;
namespace fs = std::filesystem;

namespace {

const std::string source = SINEW_SOURCE_DIR;
const std::string runtime = " --runtime " + source + "/runtime";

using Files = std::map<std::string, std::string>;

/// A command, and how the outputs of an earlier one come to be there. All go below out/, and the
/// diagnosed model is there, too.
struct Command {
  std::string name, before, run;
  /// That puts right what an end by force left, by reading or writing the same folders.
  std::string next;
};

const std::string short_run =
    "[scenario]\nduration = { value = 0.05, unit = \"s\" }\n"
    "output_rate = { value = 1000, unit = \"Hz\" }\n"
    "[[command]]\nchannel = \"tau_m\"\nshape = \"constant\"\nvalue = { value = 0.5, unit = \"N*m\" "
    "}\n";
const std::string robot =
    "<robot name=\"arm\"><link name=\"base\"/><link name=\"tip\"><inertial><mass value=\"1\"/>"
    "<inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>"
    "<joint name=\"q1\" type=\"continuous\"><parent link=\"base\"/><child link=\"tip\"/>"
    "<axis xyz=\"0 0 1\"/></joint></robot>";

const std::vector<Command>& commands() {
  static const std::string
      generate = "sinew generate models --out out/c",
      import = "sinew import arm.urdf --out out/arm --force",
      simulate = "sinew simulate models/motor --scenario short.toml --out out/run.csv" + runtime,
      report = "sinew report models/motor --out out/motor.html",
      identify =
          "sinew identify models/guiding --experiment guiding --log table.csv "
          "--out out/result.json --tables out/tables",
      figures = "sinew figures --chapter 4 --out out/figures --models " + source +
                "/models --generated " + source + "/generated" + runtime,
      summarise =
          "sinew diagnose models/motor --log run.csv --reference run.csv "
          "--summarise out/run.sums" +
          runtime;
  static const std::vector<Command> all{
      {"generate", generate + " --scalar float", generate, "sinew check models --out out/c"},
      {"import", import + " --gravity 0 0 0", import, "sinew cost out/arm"},
      {"simulate", "mkdir -p out; echo old > out/run.csv", simulate, simulate},
      {"channels",
       "mkdir -p out; echo old > out/channels.toml; echo 'time [s],theta [rad],tau_m [N*m]' > "
       "log.csv",
       "sinew channels models/motor --log log.csv --out out/channels.toml",
       "sinew channels models/motor --log log.csv --out out/channels.toml"},
      {"report", "mkdir -p out; echo old > out/motor.html", report, report},
      {"identify",
       "mkdir -p out/tables; echo old > out/result.json; echo old > out/tables/"
       "friction_by_angle.csv",
       identify, "sinew identify models/guiding --experiment guiding --log none --out out/x.json"},
      {"figures",
       "mkdir -p out/figures; echo old > out/figures/index.html; echo old > "
       "out/figures/figure_4_10.csv",
       figures, figures},
      {"summarise",
       "mkdir -p out; echo old > out/run.sums; sinew simulate models/motor --scenario " + source +
           "/examples/fleet/motion.toml --out run.csv" + runtime,
       summarise, summarise}};
  return all;
}

struct Bench : Workplace {
  explicit Bench(const Command& command) {
    fs::remove_all(path("models/index"));
    for (const char* model : {"guiding", "motor"})
      fs::copy(source + "/models/" + model, path("models/") / model, fs::copy_options::recursive);
    fs::copy_file(source + "/models/guiding/assumed_measurements.csv", path("table.csv"));
    reference::write_text(path("short.toml"), short_run);
    reference::write_text(path("arm.urdf"), robot);
    INFO(command.name);
    REQUIRE(shell(command.before).status == 0);
    old_ = outputs();
  }
  Files outputs() const {
    Files files;
    for (const auto& entry : fs::recursive_directory_iterator(path("out")))
      if (entry.is_regular_file() && entry.path().string().find("/.") == std::string::npos)
        files[entry.path().lexically_relative(path("out")).string()] =
            reference::read_text(entry.path());
    return files;
  }
  bool is_old() const { return outputs() == old_; }
  /// Nothing of what was there is there any more, except what is the same in both.
  bool is_new(const Files& after) const {
    const Files now = outputs();
    if (now.size() != after.size()) return false;
    for (const auto& [name, text] : now) {
      const auto was = old_.find(name);
      if (!after.count(name)) return false;
      if (was != old_.end() && was->second == text && after.at(name) != text) return false;
    }
    return true;
  }
  bool is_clean() const {
    for (const auto& entry : fs::recursive_directory_iterator(path("out"))) {
      const std::string name = entry.path().filename().string();
      if (name.front() == '.') return false;
    }
    return true;
  }
  void reset() const {
    fs::remove_all(path("out"));
    for (const auto& [name, text] : old_) {
      fs::create_directories(path("out/" + name).parent_path());
      reference::write_text(path("out/" + name), text);
    }
  }
  /// The command under strace, which acts on one call of the program's own thread.
  Ended traced(const Command& command, const std::string& inject) const {
    std::string run = command.run;
    run.replace(0, 5, SINEW_PROGRAM);
    const std::string call = inject.substr(0, inject.find(':'));
    return shell("strace -o trace -e trace=" + call + " -e inject=" + inject + " " + run);
  }
  bool injected() const {
    const std::string trace = text("trace");
    return trace.find("INJECTED") != std::string::npos ||
           trace.find("killed by SIGKILL") != std::string::npos;
  }

 private:
  Files old_;
};

Files written_by(const Command& command) {
  const Bench bench(command);
  const Ended ended = bench.shell(command.run);
  INFO(ended.output);
  REQUIRE(ended.status == 0);
  REQUIRE(bench.is_clean());
  return bench.outputs();
}

/// What a command compiles is kept for all runs of one test: compiling it for each would be most of
/// the test's time, and is no writing of outputs.
class CompiledOnce {
 public:
  CompiledOnce() { ::setenv("SINEW_CACHE_DIR", (folder_.path() / "cache").c_str(), 1); }
  ~CompiledOnce() { ::setenv("SINEW_CACHE_DIR", "", 1); }
  CompiledOnce(const CompiledOnce&) = delete;
  CompiledOnce& operator=(const CompiledOnce&) = delete;

 private:
  reference::TemporaryFolder folder_;
};

bool can_trace(const Workplace& here) {
  if (here.shell("strace -o /dev/null true").status == 0) return true;
  sinew::test::skip("strace cannot trace here");
  return false;
}

/// Kills the command at the first `most` of each of these calls, at `least` so many in all.
void check_killed(const Command& command, const std::vector<std::string>& calls, int most,
                  int least) {
  const Files after = written_by(command);
  const Bench bench(command);
  int killed = 0;
  for (const std::string& call : calls)
    for (int count = 1; count <= most; ++count) {
      bench.reset();
      bench.traced(command, call + ":signal=SIGKILL:when=" + std::to_string(count));
      if (!bench.injected()) break;
      INFO(command.name << " " << call << " " << count);
      ++killed;
      int again = bench.shell(command.next).status;
      if (command.next != command.run) {
        CHECK((bench.is_old() || bench.is_new(after)));
        again = bench.shell(command.run).status;
      }
      CHECK(again == 0);
      CHECK(bench.is_new(after));
      CHECK(bench.is_clean());
    }
  INFO(command.name);
  CHECK(killed >= least);
}

}  // namespace

TEST_CASE("every command, killed as its outputs take their places: all old or all new",
          "[outputs][slow]") {
  // Planted defect: Outputs::commit() without a journal: neither old nor new are the outputs of
  // generate after "renameat2 2", those of identify after "rename 2" to "rename 7". import writes
  // one folder and simulate one file, which need none.
  // Planted defect: an interrupted run put right in commit(), after it was looked up what is there:
  // the run after figures was killed at "rename 2" ends with 2, for a file that is new no more.
  // Between two of these calls outputs are of two kinds; the calls at which they cannot be, and
  // later ones of each, are killed at in the test below.
  const Workplace tools;
  if (!can_trace(tools)) return;
  const CompiledOnce kept;
  for (const Command& command : commands())
    check_killed(command, {"rename", "renameat2", "link"}, 3, 1);
}

TEST_CASE("every command, killed at each step of its writing: all old or all new",
          "[outputs][slow][thorough]") {
  const Workplace tools;
  if (!can_trace(tools)) return;
  const CompiledOnce kept;
  for (const Command& command : commands())
    check_killed(command, {"fsync", "rename", "renameat2", "ftruncate", "link"}, 9, 2);
}

TEST_CASE("every command tells what of its writing fails, and leaves the old outputs",
          "[outputs][slow]") {
  const Workplace tools;
  if (!can_trace(tools)) return;
  const CompiledOnce kept;
  for (const Command& command : commands()) {
    const Files after = written_by(command);
    const Bench bench(command);
    int failed = 0;
    for (const char* inject : {"write:error=ENOSPC", "fsync:error=EIO", "rename:error=EBUSY",
                               "renameat2:error=EIO", "ftruncate:error=EIO"})
      for (const int count : {1, 2, 5}) {
        bench.reset();
        const Ended ended =
            bench.traced(command, std::string(inject) + ":when=" + std::to_string(count));
        if (!bench.injected()) break;
        INFO(command.name << " " << inject << " " << count << ": " << ended.output);
        CHECK((ended.status == 0 || ended.status == 2));
        // What cannot be said on standard output is an error as well; the files are there by then.
        const bool unsaid = ended.says("the output cannot be written");
        CHECK((ended.status == 2 && !unsaid ? bench.is_old() : bench.is_new(after)));
        CHECK(bench.is_clean());
        failed += ended.status == 2;
      }
    INFO(command.name);
    CHECK(failed >= 3);
  }
}

TEST_CASE("every command on a full disk ends with 2 and leaves the old outputs", "[outputs]") {
  const CompiledOnce kept;
  for (const Command& command : commands()) {
    const Bench bench(command);
    const fs::path disk = bench.path("out");
    fs::remove_all(disk);
    fs::create_directory(disk);
    if (::mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=4m") != 0) {
      sinew::test::skip("a small file system cannot be mounted here");
      return;
    }
    REQUIRE(bench.shell(command.before).status == 0);
    const Files before = bench.outputs();
    // Less and less room, from none: the first writes fail, then later ones.
    for (const char* room : {"0", "4", "12"}) {
      REQUIRE(bench
                  .shell("dd if=/dev/zero of=out/filler bs=4k 2> /dev/null; truncate -s -" +
                         std::string(room) + "k out/filler")
                  .status == 0);
      const Ended ended = bench.shell(command.run);
      fs::remove(bench.path("out/filler"));
      INFO(command.name << " with " << room << " kB: " << ended.output);
      CHECK((ended.status == 2 ? bench.outputs() == before : ended.status == 0));
      CHECK((ended.status == 0 || ended.says("No space left on device")));
      CHECK(bench.is_clean());
      if (std::string(room) == "0") CHECK(ended.status == 2);
    }
    CHECK(::umount(disk.c_str()) == 0);
  }
}

TEST_CASE("a file that may not grow further is an error of the write", "[outputs]") {
  for (const Command& command : commands()) {
    if (command.name == "figures") continue;  // its C is compiled into files, too
    const Bench bench(command);
    const Ended ended = bench.shell("ulimit -f 0; " + command.run + " 2> /dev/null > /dev/null");
    INFO(command.name << ": " << ended.output);
    CHECK(ended.status == 2);
    CHECK(bench.is_old());
    CHECK(bench.is_clean());
  }
}
