// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/files/toml_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "symbolic/files/identifier.h"
#include "symbolic/files/limits.h"
#include "symbolic/files/model_name.h"
#include "symbolic/files/origin.h"
#include "symbolic/files/readable.h"
#include "symbolic/files/toml_nesting.h"

namespace sinew {
namespace {

std::string_view type_name(const toml::node& node) {
  if (node.is_table()) return "a table";
  if (node.is_array()) return "an array";
  if (node.is_string()) return "a string";
  if (node.is_integer()) return "an integer";
  if (node.is_floating_point()) return "a number";
  if (node.is_boolean()) return "a truth value";
  return "a date or time";
}

std::string_view shape_text(Shape shape) {
  switch (shape) {
    case Shape::scalar:
      return "a number";
    case Shape::pair:
      return "an array of 2 numbers [low, high]";
    case Shape::vector:
      return "an array of 3 numbers";
    case Shape::matrix:
      return "3 rows of 3 numbers";
  }
  return "a number";
}

/// Reads numbers out of nodes; reports what is none.
class NumberReader {
 public:
  NumberReader(TomlFile& file, std::string path, Shape shape)
      : file_(file), path_(std::move(path)), shape_(shape) {}

  std::optional<std::vector<double>> read(const toml::node& node) {
    const bool fine = shape_ == Shape::scalar   ? number(node)
                      : shape_ == Shape::matrix ? matrix(node)
                                                : list(node, shape_ == Shape::pair ? 2 : 3);
    if (!fine) return std::nullopt;
    return values_;
  }

 private:
  bool number(const toml::node& node) {
    if (!node.is_number()) return fail(node, fmt::format("is {}", type_name(node)));
    const auto* integer = node.as_integer();
    values_.push_back(integer != nullptr ? static_cast<double>(integer->get())
                                         : node.as_floating_point()->get());
    if (!std::isfinite(values_.back())) {
      file_.findings.add(locate(file_, node.source()), fmt::format("{} is not finite", path_),
                         "expected a finite number");
      return false;
    }
    return true;
  }

  bool list(const toml::node& node, std::size_t size) {
    const toml::array* array = node.as_array();
    if (array == nullptr) return fail(node, fmt::format("is {}", type_name(node)));
    if (array->size() != size) return fail(node, fmt::format("has {} entries", array->size()));
    bool fine = true;
    for (const toml::node& entry : *array) fine = number(entry) && fine;
    return fine;
  }

  bool matrix(const toml::node& node) {
    const toml::array* rows = node.as_array();
    if (rows == nullptr) return fail(node, fmt::format("is {}", type_name(node)));
    if (rows->size() != 3) return fail(node, fmt::format("has {} rows", rows->size()));
    bool fine = true;
    for (const toml::node& row : *rows) fine = list(row, 3) && fine;
    return fine;
  }

  bool fail(const toml::node& node, const std::string& what) {
    file_.findings.add(locate(file_, node.source()), fmt::format("{} {}", path_, what),
                       fmt::format("expected {}", shape_text(shape_)));
    return false;
  }

  TomlFile& file_;
  std::string path_;
  Shape shape_;
  std::vector<double> values_;
};

/// The unit of a quantity table; reports a missing, unknown or wrong one.
std::optional<MeasureUnit> read_unit(TomlTable& table, Dimension dimension) {
  const std::string expected =
      fmt::format("expected a unit of {}: {}", name_of(dimension), units_of(dimension));
  if (!table.has("unit")) {
    if (dimension == Dimension::none) return find_unit("1");
    table.report("unit", fmt::format("{} has no unit", table.path()), expected);
    return std::nullopt;
  }
  const std::optional<std::string> spelling = table.text("unit", true);
  if (!spelling) return std::nullopt;
  const std::optional<MeasureUnit> unit = find_unit(*spelling);
  if (!unit)
    table.report("unit", fmt::format("{} has the unknown unit '{}'", table.path(), *spelling),
                 expected);
  else if (unit->dimension != dimension)
    table.report("unit",
                 fmt::format("{} has the unit '{}' of {}", table.path(), *spelling,
                             name_of(unit->dimension)),
                 expected);
  else
    return unit;
  return std::nullopt;
}

/// Where a value comes from: "text: Table 5.1", "assumed".
std::optional<std::string> read_provenance(TomlTable& table) {
  const std::optional<std::string> from = table.word("from", origins(), "");
  const std::optional<std::string> ref = table.text("ref", false);
  if (!from) return std::nullopt;
  if (*from == "text" && !ref && !table.has("ref")) {
    table.report("from", fmt::format("{} is from the text but does not say where", table.path()),
                 "expected a key ref = \"Table 5.1\" beside it");
    return std::nullopt;
  }
  return ref ? fmt::format("{}: {}", *from, *ref) : *from;
}

}  // namespace

SourceLocation locate(const TomlFile& file, const toml::source_region& region) {
  return {file.name, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

std::string toml_string(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      out += fmt::format("\\{}", c);
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      out += c;
  }
  return out + '"';
}

toml::table parse_toml(std::string_view text, const TomlFile& file) {
  if (const auto place = nested_deeper(text, limits::toml_nesting)) {
    file.findings.add({file.name, place->line, place->column},
                      fmt::format("nested deeper than {} levels", limits::toml_nesting),
                      "expected fewer dots in a key, and fewer brackets inside brackets");
    return {};
  }
  try {
    return toml::parse(text, file.name);
  } catch (const toml::parse_error& error) {
    file.findings.add(locate(file, error.source()), error.description(), "expected TOML 1.0");
    return {};
  }
}

TomlTable::TomlTable(const toml::table& table, std::string path, TomlFile& file)
    : table_(&table), path_(std::move(path)), file_(&file) {}

SourceLocation TomlTable::where() const {
  return locate(*file_, table_->source());
}

SourceLocation TomlTable::where(std::string_view key) const {
  const toml::node* node = table_->get(key);
  return node == nullptr ? where() : locate(*file_, node->source());
}

bool TomlTable::has(std::string_view key) {
  known_.emplace_back(key);
  return table_->get(key) != nullptr;
}

void TomlTable::report(std::string_view key, const std::string& wrong, std::string_view expected) {
  file_->findings.add(where(key), wrong, expected);
}

const toml::node* TomlTable::find(std::string_view key, bool required, std::string_view expected) {
  known_.emplace_back(key);
  const toml::node* node = table_->get(key);
  if (node == nullptr && required)
    file_->findings.add(where(), fmt::format("{} has no '{}'", path_, key),
                        fmt::format("expected {}", expected));
  return node;
}

std::optional<std::string> TomlTable::text(std::string_view key, bool required) {
  const toml::node* node = find(key, required, "a string");
  if (node == nullptr) return std::nullopt;
  if (const auto* string = node->as_string()) return string->get();
  report(key, fmt::format("{}.{} is {}", path_, key, type_name(*node)), "expected a string");
  return std::nullopt;
}

std::optional<std::string> TomlTable::identifier(std::string_view key) {
  std::optional<std::string> name = text(key, true);
  if (!name) return std::nullopt;
  if (const auto why = why_not_identifier(*name)) {
    report(key, fmt::format("{}.{} '{}' {}", path_, key, *name, *why), identifier_rule());
    return std::nullopt;
  }
  return name;
}

std::optional<std::string> TomlTable::model_name(std::string_view key) {
  std::optional<std::string> name = text(key, true);
  if (!name) return std::nullopt;
  if (const auto why = why_not_model_name(*name)) {
    report(key, fmt::format("{}.{} '{}' {}", path_, key, *name, *why), model_name_rule(*name));
    return std::nullopt;
  }
  return name;
}

std::optional<bool> TomlTable::truth(std::string_view key) {
  const toml::node* node = find(key, false, "true or false");
  if (node == nullptr) return std::nullopt;
  if (const auto* boolean = node->as_boolean()) return boolean->get();
  report(key, fmt::format("{}.{} is {}", path_, key, type_name(*node)), "expected true or false");
  return std::nullopt;
}

std::optional<double> TomlTable::number(std::string_view key) {
  const toml::node* node = find(key, true, "a number");
  if (node == nullptr) return std::nullopt;
  const std::optional<double> value = node->value<double>();
  if (value && node->is_number() && std::isfinite(*value)) return value;
  report(key, fmt::format("{}.{} is {}", path_, key, value ? "not finite" : type_name(*node)),
         "expected a finite number");
  return std::nullopt;
}

std::optional<std::string> TomlTable::word(std::string_view key,
                                           const std::vector<std::string>& words,
                                           const std::string& otherwise) {
  const std::string list = fmt::format("one of: {}", listed(words));
  const toml::node* node = find(key, otherwise.empty(), list);
  if (node == nullptr) return otherwise.empty() ? std::nullopt : std::optional(otherwise);
  const std::optional<std::string> given = text(key, true);
  if (!given || std::find(words.begin(), words.end(), *given) != words.end()) return given;
  report(key, fmt::format("{}.{} is '{}'{}", path_, key, *given, did_you_mean(*given, words)),
         fmt::format("expected {}", list));
  return std::nullopt;
}

std::optional<Quantity> TomlTable::resolve_name(const toml::node& node, const std::string& path,
                                                Shape shape, Dimension dimension) {
  std::string name = node.as_string()->get();
  const bool is_negative = name.starts_with('-');
  if (name.starts_with('-') || name.starts_with('+')) name.erase(0, 1);
  const toml::node* value = file_->values == nullptr ? nullptr : file_->values->get(name);
  if (value == nullptr) {
    std::vector<std::string> names;
    if (file_->values != nullptr)
      for (const auto& [key, ignored] : *file_->values) names.emplace_back(key.str());
    file_->findings.add(
        locate(*file_, node.source()),
        fmt::format("{} names the unknown value '{}'{}", path, name, did_you_mean(name, names)),
        "expected the name of a quantity in [values], or { value, unit, from, ref }");
    return std::nullopt;
  }
  file_->used_values.insert(name);
  if (!value->is_table()) return std::nullopt;  // reported where [values] is read
  std::optional<Quantity> quantity = resolve(*value, "values." + name, shape, dimension);
  if (!quantity) return std::nullopt;
  if (is_negative)
    for (double& entry : quantity->values) entry = 0.0 - entry;
  quantity->where = locate(*file_, node.source());
  const auto provenance = file_->provenance.find("values." + name);
  if (provenance != file_->provenance.end()) file_->provenance[path] = provenance->second;
  return quantity;
}

std::optional<Quantity> TomlTable::resolve(const toml::node& node, const std::string& path,
                                           Shape shape, Dimension dimension) {
  if (node.is_string()) return resolve_name(node, path, shape, dimension);
  if (!node.is_table()) {
    file_->findings.add(
        locate(*file_, node.source()), fmt::format("{} is {}", path, type_name(node)),
        fmt::format("expected {{ value = {}, unit = \"{}\", from = \"text\" or \"assumed\", ref = "
                    "\"where\" }} or a name in [values]",
                    shape == Shape::scalar ? "..." : "[...]", si_unit(dimension)));
    return std::nullopt;
  }
  TomlTable table(*node.as_table(), path, *file_);
  const toml::node* value = table.find("value", true, shape_text(shape));
  std::optional<std::vector<double>> numbers;
  if (value != nullptr) numbers = NumberReader(*file_, path + ".value", shape).read(*value);
  const std::optional<MeasureUnit> unit = read_unit(table, dimension);
  const std::optional<std::string> provenance = read_provenance(table);
  table.finish();
  if (!numbers || !unit) return std::nullopt;
  for (double& number : *numbers) {
    number = to_si(number, *unit);
    if (!std::isfinite(number)) {
      table.report("value", path + ".value is not finite in SI units", "expected a smaller number");
      return std::nullopt;
    }
  }
  if (provenance) file_->provenance[path] = *provenance;
  return Quantity{*numbers, locate(*file_, value->source())};
}

std::optional<Quantity> TomlTable::quantity(std::string_view key, Shape shape, Dimension dimension,
                                            bool required) {
  const toml::node* node =
      find(key, required,
           fmt::format("{} {} in {}", name_of(dimension).starts_with('a') ? "an" : "a",
                       name_of(dimension), units_of(dimension)));
  if (node == nullptr) return std::nullopt;
  return resolve(*node, fmt::format("{}.{}", path_, key), shape, dimension);
}

std::optional<Quantity> TomlTable::direction(std::string_view key, bool required) {
  const toml::node* node = find(key, required, "an array of 3 numbers");
  if (node == nullptr) return std::nullopt;
  const std::string path = fmt::format("{}.{}", path_, key);
  if (!node->is_array()) return resolve(*node, path, Shape::vector, Dimension::none);
  const auto numbers = NumberReader(*file_, path, Shape::vector).read(*node);
  if (!numbers) return std::nullopt;
  return Quantity{*numbers, locate(*file_, node->source())};
}

std::optional<TomlTable> TomlTable::table(std::string_view key, bool required) {
  const toml::node* node = find(key, required, fmt::format("a table [{}]", key));
  if (node == nullptr) return std::nullopt;
  const std::string path = path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
  if (const toml::table* found = node->as_table()) return TomlTable(*found, path, *file_);
  report(key, fmt::format("{} is {}", path, type_name(*node)), "expected a table");
  return std::nullopt;
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) {
  const toml::node* node = find(key, false, "tables");
  if (node == nullptr) return {};
  const std::string path = path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
  const std::string expected = fmt::format("expected an array of tables: [[{}]] or [{{...}}]", key);
  const toml::array* array = node->as_array();
  if (array == nullptr) {
    report(key, fmt::format("{} is {}", path, type_name(*node)), expected);
    return {};
  }
  if (array->size() > limits::entries) {
    report(key, fmt::format("{} has {} entries", path, array->size()),
           fmt::format("expected at most {}", limits::entries));
    return {};
  }
  std::vector<TomlTable> found;
  for (const toml::node& entry : *array) {
    const std::string name = fmt::format("{}[{}]", path, found.size());
    if (const toml::table* inner = entry.as_table())
      found.emplace_back(*inner, name, *file_);
    else
      file_->findings.add(locate(*file_, entry.source()),
                          fmt::format("an entry of {} is {}", path, type_name(entry)), expected);
  }
  return found;
}

void TomlTable::finish() {
  for (const auto& [key, node] : *table_) {
    const std::string name(key.str());
    if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
    std::vector<std::string> expected = known_;
    std::sort(expected.begin(), expected.end());
    expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
    file_->findings.add(
        locate(*file_, key.source()),
        fmt::format("unknown key '{}'{}{}", name, path_.empty() ? "" : " in " + path_,
                    did_you_mean(name, known_)),
        fmt::format("expected one of: {}", listed(expected)));
  }
}

}  // namespace sinew
