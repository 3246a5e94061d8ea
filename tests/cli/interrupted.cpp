// SPDX-License-Identifier: GPL-3.0-or-later
// A run that is interrupted ends by the signal and leaves nothing in the folder for temporary
// files.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "tests/cli/program.h"

using namespace sinew;
namespace fs = std::filesystem;

namespace {

struct Interrupted {
  std::string status;
  bool was_there = false, is_left = false;
};

/// `sinew simulate` with a compiler that waits until the signal has come, three seconds at most.
/// The program is started by `env <how>`.
Interrupted interrupt(const std::string& signal, const std::string& how = "--default-signal") {
  const Workplace here;
  fs::create_directory(here.path("tmp"));
  reference::write_text(here.path("slow_cc"), fmt::format("#!/bin/sh\ntouch {0}/started\n"
                                                          "for i in $(seq 60); do\n"
                                                          "[ -e {0}/signalled ] && exit 0\n"
                                                          "sleep 0.05\ndone\n",
                                                          here.path(".").string()));
  fs::permissions(here.path("slow_cc"), fs::perms::owner_all);
  const Ended ended = here.shell(fmt::format(
      "CC=$PWD/slow_cc TMPDIR=$PWD/tmp env {} " SINEW_PROGRAM
      " simulate {}/models/motor --scenario {}/models/motor/scenarios/friction.toml --out o.csv "
      "--runtime {}/runtime & pid=$!\n"
      "while [ ! -e started ]; do sleep 0.05; done\n"
      "[ -n \"$(ls tmp)\" ] && echo there\n"
      "kill -{} $pid; touch signalled; wait $pid; echo status $?",
      how, SINEW_SOURCE_DIR, SINEW_SOURCE_DIR, SINEW_SOURCE_DIR, signal));
  INFO(ended.output);
  Interrupted result;
  result.was_there = ended.says("there");
  result.status = ended.output.substr(ended.output.rfind("status ") + 7);
  result.is_left = !fs::is_empty(here.path("tmp"));
  CHECK(!fs::exists(here.path("o.csv")));
  return result;
}

}  // namespace

// Planted: a program without remove_when_interrupted() ended with 130 and left its folder.
TEST_CASE("an interrupted run leaves nothing behind and ends by the signal", "[interrupted]") {
  for (const auto& [signal, status] :
       {std::pair("INT", "130\n"), std::pair("TERM", "143\n"), std::pair("HUP", "129\n")}) {
    INFO(signal);
    const Interrupted result = interrupt(signal);
    CHECK(result.was_there);
    CHECK(!result.is_left);
    CHECK(result.status == status);
  }
}

TEST_CASE("a signal that is ignored from the start stays ignored", "[interrupted]") {
  const Interrupted result = interrupt("HUP", "--default-signal --ignore-signal=HUP");
  CHECK(result.status == "2\n");  // the compiler made nothing
  CHECK(!result.is_left);
}
