// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/local_names.h"

#include <fmt/format.h>

#include <array>

#include "generator/runtime_calls.h"

namespace sinew {
namespace {

/// Words that no variable may be called by.
constexpr std::array c_words{
    "_Bool",    "_Complex", "_Imaginary", "asm",      "auto",     "bool",    "break",  "case",
    "char",     "const",    "continue",   "default",  "do",       "double",  "else",   "enum",
    "errno",    "extern",   "false",      "float",    "for",      "goto",    "if",     "inline",
    "int",      "long",     "NULL",       "register", "restrict", "return",  "short",  "signed",
    "sizeof",   "static",   "struct",     "switch",   "true",     "typedef", "typeof", "union",
    "unsigned", "void",     "volatile",   "while"};

}  // namespace

LocalNames::LocalNames(const Graph& graph, const Target& target)
    : taken_(c_words.begin(), c_words.end()) {
  for (const Port& port : graph.inputs) taken_.insert(port.name);
  for (const Port& port : graph.outputs) taken_.insert(port.name);
  taken_.insert({"count", "state"});
  for (int op = 0; op <= static_cast<int>(Op::choose); ++op)
    if (const char* function = runtime_function(static_cast<Op>(op)))
      taken_.insert(function + std::string(target.suffix()));
  for (const char* angles : {"", "2", "4"})
    for (const char* stem : {"sinew_sincos", "sinew_one_sincos"})
      taken_.insert(fmt::format("{}{}{}", stem, angles, target.suffix()));
  taken_.insert(fmt::format("sinew_fma{}", target.suffix()));
  for (const Node& node : graph.nodes())
    if (const std::string name = shared_name(node.op, target); !name.empty()) taken_.insert(name);
}

std::string LocalNames::labelled(const std::string& label) {
  std::string name = label;
  for (int i = 2; !taken_.insert(name).second; ++i) name = fmt::format("{}_{}", label, i);
  return name;
}

std::string LocalNames::numbered(const std::string& prefix) {
  std::string name;
  do name = fmt::format("{}{}", prefix, ++number_);
  while (!taken_.insert(name).second);
  return name;
}

}  // namespace sinew
