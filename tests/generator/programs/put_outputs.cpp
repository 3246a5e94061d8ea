// SPDX-License-Identifier: GPL-3.0-or-later
// put_outputs <place> <letter>: puts outputs full of the letter into several folders in one step.
#include "tests/generator/put_outputs.h"

#include <cstdio>
#include <exception>

int main(int argc, char** argv) try {
  if (argc < 3) return 2;
  sinew::put_outputs(argv[1], argv[2][0]);
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
