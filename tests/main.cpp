// SPDX-License-Identifier: GPL-3.0-or-later
// The main function of the test programs. Its status is 0, a failure's, or 77 where a test was
// skipped, which CTest takes for skipped (tests/CMakeLists.txt).
#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>
#include <iostream>

#include "identification/regression/block_sizes.h"
#include "tests/skip.h"

namespace {

constexpr int skipped_status = 77;
bool any_skipped = false;

}  // namespace

void sinew::test::skip(const std::string& reason) {
  any_skipped = true;
  std::cout << "skipped: " << reason << std::endl;
  SUCCEED(reason);
}

int main(int argc, char** argv) {
  sinew::diagnosis::fix_block_sizes();  // as the program does
  Catch::Session session;
  if (const int wrong_usage = session.applyCommandLine(argc, argv)) return wrong_usage;
  // The number of failures, or, where tests are listed, of tests.
  const int status = session.run();
  if (status == 0 && any_skipped) return skipped_status;
  return status == skipped_status ? skipped_status + 1 : status;
}
