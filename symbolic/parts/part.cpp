// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/parts/part.h"

#include "symbolic/effects/effect_functions.h"
#include "symbolic/files/read_text.h"
#include "symbolic/parts/part_sections.h"

namespace sinew {
namespace {

/// Reads the one section that says what kind of part it is.
class PartReader {
 public:
  PartReader(TomlTable root, TomlFile& file) : root_(std::move(root)), file_(file) {}

  Part read() {
    if (auto header = root_.table("part", true)) {
      part_.name = header->model_name("name").value_or("");
      part_.description = header->text("description", false).value_or("");
      header->finish();
    }
    int kinds = 0;
    const auto section = [&](const char* key, auto take) {
      if (!root_.has(key)) return;
      ++kinds;
      if (auto table = root_.table(key, true)) part_.parameters = take(*table);
    };
    section("wrist", [&](TomlTable& t) { return read_wrist(t, root_.tables("channel")); });
    section("four_bar", read_four_bar);
    section("motor", [&](TomlTable& t) { return read_motor(t, root_.tables("ripple")); });
    section("guiding_friction", [](TomlTable& t) { return FittedGuiding{read_fitted_guiding(t)}; });
    section("capstan", [](TomlTable& t) { return CapstanGuiding{read_capstan(t)}; });
    section("effects", [](TomlTable& t) {
      t.finish();
      return EffectLibrary{};
    });
    if (root_.has("tendon"))
      section("tendon", [&](TomlTable& t) { return TendonWithLever{read_tendon(t), lever()}; });
    else
      section("lever", [](TomlTable& t) { return read_lever(t); });
    root_.finish();
    if (kinds != 1)
      file_.findings.add(
          {file_.name, 1, 1}, "the file describes no part, or more than one",
          "expected one of [wrist], [four_bar], [lever], [motor], [guiding_friction], [capstan], "
          "[effects], [tendon] with [lever]");
    return part_;
  }

 private:
  LeverParameters lever() {
    auto table = root_.table("lever", true);
    return table ? read_lever(*table) : LeverParameters{};
  }

  TomlTable root_;
  TomlFile& file_;
  Part part_;
};

struct FunctionsOf {
  std::vector<Function> operator()(const WristParameters& p) const { return wrist_functions(p); }
  std::vector<Function> operator()(const FourBarParameters& p) const {
    return four_bar_functions(p);
  }
  std::vector<Function> operator()(const LeverParameters& p) const { return lever_functions(p); }
  std::vector<Function> operator()(const MotorParameters& p) const { return motor_functions(p); }
  std::vector<Function> operator()(const FittedGuiding& p) const {
    return {guiding_friction_force(p.parameters)};
  }
  std::vector<Function> operator()(const CapstanGuiding& p) const {
    return {capstan_friction_force(p.parameters), capstan_transmitted_force(p.parameters)};
  }
  std::vector<Function> operator()(const TendonWithLever& p) const {
    return tendon_force_functions(p.tendon, p.lever);
  }
  std::vector<Function> operator()(const EffectLibrary&) const { return effect_functions(); }
};

}  // namespace

bool is_part_folder(const std::filesystem::path& folder) {
  return std::filesystem::exists(folder / "part.toml");
}

Part read_part(const std::filesystem::path& folder) {
  const std::string name = (folder / "part.toml").string();
  Findings findings;
  const std::string text = read_text(name, findings);
  findings.raise_if_any();
  std::map<std::string, std::string> provenance;
  TomlFile file{name, findings, provenance};
  const toml::table root = parse_toml(text, file);
  findings.raise_if_any();
  Part part = PartReader(TomlTable(root, "", file), file).read();
  findings.raise_if_any();
  return part;
}

std::vector<Function> functions_of(const Part& part) {
  return std::visit(FunctionsOf{}, part.parameters);
}

}  // namespace sinew
