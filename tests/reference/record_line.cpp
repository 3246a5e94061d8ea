// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/record_line.h"

#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace sinew::reference {

void record_line(const std::string& json) {
  const char* file = std::getenv("SINEW_RECORD");
  if (!file) return;
  std::ofstream out(file, std::ios::app);
  out << json << '\n';
  if (!out.flush()) throw std::runtime_error(std::string(file) + ": cannot be written");
}

}  // namespace sinew::reference
