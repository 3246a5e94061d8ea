// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/model/source_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "symbolic/files/identifier.h"
#include "symbolic/files/toml_reader.h"

namespace sinew {
namespace {

template <typename Things>
std::string names_section(const char* section, const Things& things) {
  std::string text;
  for (const auto& each : things)
    if (!each.source_name.empty())
      text += fmt::format("{} = {}\n", each.name, toml_string(each.source_name));
  return text.empty() ? text : fmt::format("\n[{}]\n{}", section, text);
}

class SourceNames {
 public:
  SourceNames(const TomlFile& file) : file_(file) {}

  void read(std::string_view text, Mechanism& mechanism) {
    for (const auto& [key, node] : parse_toml(text, file_)) {
      const toml::table* table = node.as_table();
      if (table && key.str() == "joint")
        set(*table, "joint", mechanism.joints);
      else if (table && key.str() == "link")
        set(*table, "link", mechanism.bodies);
      else
        file_.findings.add(locate(file_, node.source()), fmt::format("'{}' is unknown", key.str()),
                           "expected the tables [joint] and [link]");
    }
  }

 private:
  template <typename Things>
  void set(const toml::table& table, const char* kind, Things& things) {
    std::vector<std::string> names;
    for (const auto& each : things) names.push_back(each.name);
    std::set<std::string> seen(names.begin(), names.end());
    for (const auto& [key, node] : table) {
      const std::string name(key.str());
      const auto thing = std::find(names.begin(), names.end(), name);
      const toml::value<std::string>* text = node.as_string();
      const SourceLocation where = locate(file_, node.source());
      if (thing == names.end())
        file_.findings.add(
            where, fmt::format("the model has no {} '{}'{}", kind, name, did_you_mean(name, names)),
            fmt::format("expected the name of a {} of mechanism.toml", kind));
      else if (text == nullptr || text->get().empty())
        file_.findings.add(where, fmt::format("{}.{} is no text", kind, name),
                           fmt::format("expected {} = \"its name in the source\"", name));
      else if (!seen.insert(text->get()).second)
        file_.findings.add(where, fmt::format("two {}s are called '{}'", kind, text->get()),
                           "expected different names");
      else
        things[static_cast<std::size_t>(thing - names.begin())].source_name = text->get();
    }
  }

  const TomlFile& file_;
};

}  // namespace

std::string source_names_text(const Mechanism& mechanism) {
  const std::string text =
      names_section("joint", mechanism.joints) + names_section("link", mechanism.bodies);
  return text.empty() ? text
                      : "# Names in the file that the model was imported from; logs and scenarios "
                        "may use them.\n" +
                            text;
}

void set_source_names(std::string_view text, const std::string& file, Mechanism& mechanism,
                      Findings& findings) {
  if (text.empty()) return;
  std::map<std::string, std::string> provenance;
  const TomlFile toml{file, findings, provenance};
  SourceNames(toml).read(text, mechanism);
}

}  // namespace sinew
