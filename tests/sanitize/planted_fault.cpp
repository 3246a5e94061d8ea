// SPDX-License-Identifier: GPL-3.0-or-later
// planted_fault <address|undefined|leak>: makes that mistake; the preset sanitize has to stop it.
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>

int main(int argc, char** argv) {
  const char* kind = argc > 1 ? argv[1] : "";
  const auto beyond = static_cast<std::size_t>(argc + 2);
  if (std::strcmp(kind, "address") == 0) {
    const auto values = std::make_unique<int[]>(beyond);
    return values[beyond] == 7 ? 2 : 0;
  }
  if (std::strcmp(kind, "undefined") == 0) {
    int most = std::numeric_limits<int>::max();
    most += argc;
    return most == 7 ? 2 : 0;
  }
  if (std::strcmp(kind, "leak") == 0) {
    void* volatile kept = std::malloc(beyond);
    kept = nullptr;
    return kept != nullptr ? 2 : 0;
  }
  return 0;
}
