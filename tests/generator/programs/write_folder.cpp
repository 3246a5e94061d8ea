// SPDX-License-Identifier: GPL-3.0-or-later
// write_folder <folder> <letter> [<byte limit>]: replaces the folder by files full of the letter.
// With a limit no file may grow beyond it, as on a disk that is full.
#include <signal.h>
#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <exception>

#include "tests/generator/lettered_files.h"

int main(int argc, char** argv) try {
  if (argc < 3) return 2;
  if (argc > 3) {
    ::signal(SIGXFSZ, SIG_IGN);
    const auto limit = static_cast<rlim_t>(std::atol(argv[3]));
    const rlimit limits{limit, limit};
    if (::setrlimit(RLIMIT_FSIZE, &limits) != 0) return 3;
  }
  sinew::replace_folder(argv[1], sinew::lettered_files(argv[2][0]));
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
