// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/adoption/motion_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace sinew::diagnosis {
namespace {

std::string unit_of(const DrivenChannels& channels, const std::string& name) {
  const auto spec = std::find_if(channels.specs.begin(), channels.specs.end(),
                                 [&](const ChannelSpec& s) { return s.name == name; });
  return spec == channels.specs.end() ? "1" : spec->unit;
}

}  // namespace

std::string motion_text(const PlannedMotion& motion, const DrivenChannels& channels) {
  std::string text = fmt::format("# {}\ntime [s]", motion.name);
  for (const std::string& name : channels.positions)
    text += fmt::format(",{}_ref [{}]", name, unit_of(channels, name));
  const bool loaded = motion.load.size() > 0 && !channels.load.empty();
  if (loaded) text += fmt::format(",{} [{}]", channels.load, unit_of(channels, channels.load));
  text += '\n';
  for (Eigen::Index k = 0; k < motion.position.rows(); ++k) {
    fmt::format_to(std::back_inserter(text), "{:.9g}", motion.step * static_cast<double>(k));
    for (const double q : motion.position.row(k))
      fmt::format_to(std::back_inserter(text), ",{:.9g}", q);
    if (loaded) fmt::format_to(std::back_inserter(text), ",{:.9g}", motion.load(k));
    text += '\n';
  }
  return text;
}

}  // namespace sinew::diagnosis
