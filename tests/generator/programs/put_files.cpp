// SPDX-License-Identifier: GPL-3.0-or-later
// put_files <folder> <letter>: puts files full of the letter into the folder, as `sinew import`
// does.
#include "symbolic/files/put_files.h"

#include <cstdio>
#include <exception>

#include "tests/generator/lettered_files.h"

int main(int argc, char** argv) try {
  if (argc < 3) return 2;
  sinew::put_files(argv[1], sinew::lettered_files(argv[2][0]), true);
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
