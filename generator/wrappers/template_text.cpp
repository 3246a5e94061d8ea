// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/wrappers/template_text.h"

#include <fmt/format.h>

#include <stdexcept>

namespace sinew {
namespace {

bool is_place(const std::string& name) {
  return !name.empty() && name.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ_") == name.npos;
}

}  // namespace

std::string filled(const std::string& text, const WrappedModel& model,
                   const std::map<std::string, std::string>& values) {
  std::map<std::string, std::string> all{{"MODEL", model.name},
                                         {"HASH", model.hash},
                                         {"SCALAR", model.scalar},
                                         {"DESCRIPTION", model.description}};
  for (const auto& [name, value] : values) all[name] = value;
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text[at] == '@' ? text.find('@', at + 1) : text.npos;
    const std::string name = end == text.npos ? "" : text.substr(at + 1, end - at - 1);
    if (!is_place(name)) {
      result += text[at++];
      continue;
    }
    const auto found = all.find(name);
    if (found == all.end()) throw std::logic_error("a template has no value for " + name);
    result += found->second;
    at = end + 1;
  }
  return result;
}

void add_sources(FileSet& files, const WrappedModel& model, const std::string& folder, bool batch) {
  for (const auto& [name, text] : model.sources)
    if (batch || !name.starts_with(host_sources)) files[folder + name] = text;
  for (const auto& [name, text] : model.runtime) files[folder + name] = text;
}

std::string shape_text(const WrappedArray& array) {
  return array.is_vector() ? fmt::format("{}", array.rows)
                           : fmt::format("{}x{}", array.rows, array.cols);
}

std::string array_text(const WrappedArray& array) {
  std::string text = shape_text(array);
  if (!array.unit.empty()) text += " [" + array.unit + "]";
  if (!array.doc.empty()) text += " " + array.doc;
  if (array.order == "joints_and_wrist")
    text += ", in the order of joints, then wrist";
  else if (!array.order.empty())
    text += ", in the order of " + array.order;
  return text;
}

std::string number_text(double value) {
  return fmt::format("{}", value);
}

}  // namespace sinew
