// SPDX-License-Identifier: GPL-3.0-or-later
// TOML tables read with every mistake located: unknown and missing keys, wrong types, units,
// values that are not finite. Included by the readers of TOML files only.
#pragma once

#include <toml++/toml.h>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "symbolic/files/description_error.h"
#include "symbolic/files/units.h"

namespace sinew {

/// What all tables of one file share.
struct TomlFile {
  std::string name;
  Findings& findings;
  std::map<std::string, std::string>& provenance;  ///< value path -> "text: Table 5.1", "assumed"
  const toml::table* values = nullptr;             ///< [values]: quantities used by name
  std::set<std::string> used_values = {};
};

SourceLocation locate(const TomlFile& file, const toml::source_region& region);

/// A text as TOML writes it, quotation marks and escapes included.
std::string toml_string(std::string_view text);

/// The text as a table; empty, with the mistake reported, where it is no TOML 1.0 or is nested too
/// deep (limits::toml_nesting).
toml::table parse_toml(std::string_view text, const TomlFile& file);

enum class Shape { scalar, pair, vector, matrix };

/// The numbers of a quantity in SI units, row-major, and where they stand.
struct Quantity {
  std::vector<double> values;
  SourceLocation where;
};

/// One table of a file. Asking for a key makes it known; finish() reports the others.
class TomlTable {
 public:
  TomlTable(const toml::table& table, std::string path, TomlFile& file);

  const std::string& path() const { return path_; }
  /// "joint" becomes "joint.q20" once the name is known.
  void set_path(std::string path) { path_ = std::move(path); }
  SourceLocation where() const;
  /// The place of the key's value, or of the table where the key is absent.
  SourceLocation where(std::string_view key) const;
  bool has(std::string_view key);

  std::optional<std::string> text(std::string_view key, bool required);
  std::optional<std::string> identifier(std::string_view key);
  /// A name whose emitted files hide no header, too (symbolic/files/model_name.h).
  std::optional<std::string> model_name(std::string_view key);
  std::optional<bool> truth(std::string_view key);
  /// A bare number, finite; required.
  std::optional<double> number(std::string_view key);
  /// One of the words, or nothing with the mistake reported; `otherwise` where the key is absent
  /// ("" makes it required).
  std::optional<std::string> word(std::string_view key, const std::vector<std::string>& words,
                                  const std::string& otherwise);
  /// A table { value, unit, from, ref }, or the name of one in [values] with an optional sign.
  std::optional<Quantity> quantity(std::string_view key, Shape shape, Dimension dimension,
                                   bool required);
  /// Like quantity, of a dimensionless value, which may also be given as the bare array.
  std::optional<Quantity> direction(std::string_view key, bool required);
  std::optional<TomlTable> table(std::string_view key, bool required);
  /// An array of tables; empty where absent.
  std::vector<TomlTable> tables(std::string_view key);
  /// Reports every key that nobody asked for.
  void finish();
  void report(std::string_view key, const std::string& wrong, std::string_view expected);
  TomlFile& file() { return *file_; }

 private:
  const toml::node* find(std::string_view key, bool required, std::string_view expected);
  std::optional<Quantity> resolve(const toml::node& node, const std::string& path, Shape shape,
                                  Dimension dimension);
  std::optional<Quantity> resolve_name(const toml::node& node, const std::string& path, Shape shape,
                                       Dimension dimension);

  const toml::table* table_;
  std::string path_;
  TomlFile* file_;
  std::vector<std::string> known_;
};

}  // namespace sinew
