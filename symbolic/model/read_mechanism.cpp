// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/model/read_mechanism.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "symbolic/files/identifier.h"
#include "symbolic/files/read_text.h"
#include "symbolic/model/check_mechanism.h"
#include "symbolic/model/mechanism_draft.h"
#include "symbolic/model/order_bodies.h"
#include "symbolic/model/read_mass_properties.h"
#include "symbolic/model/source_names.h"

namespace sinew {
namespace {

/// Reports every thing that has the name of an earlier one.
template <typename Entries, typename NameOf>
void report_duplicates(const Entries& entries, const std::string& kind, NameOf name_of,
                       Findings& findings) {
  std::map<std::string, int> lines;
  for (const auto& entry : entries) {
    const auto& [name, where] = name_of(entry);
    if (name.empty()) continue;
    const auto [first, is_new] = lines.emplace(name, where.line);
    if (!is_new)
      findings.add(where,
                   fmt::format("{} '{}' is defined a second time, first in line {}", kind, name,
                               first->second),
                   "expected different names");
  }
}

class MechanismReader {
 public:
  MechanismReader(const MechanismText& text, Findings& findings)
      : text_(text),
        findings_(findings),
        file_{text.toml_name, findings, draft_.mechanism.provenance} {}

  Mechanism read() {
    const std::vector<MassProperties> masses =
        parse_mass_properties(text_.csv, text_.csv_name, findings_);
    has_whole_table_ = !findings_.any();
    const std::size_t before = findings_.count();
    const toml::table root = parse_toml(text_.toml, file_);
    if (findings_.count() > before) findings_.raise_if_any();
    read_sections(root, file_, draft_);
    report_all_duplicates();
    set_mass_properties(masses);
    sort_bodies();
    findings_.raise_if_any();
    if (coordinate_count(draft_.mechanism) == 0)
      findings_.add(draft_.where, "the mechanism has no moving joint", "expected at least one");
    findings_.raise_if_any();
    check_mechanism(draft_.mechanism, findings_);
    set_source_names(text_.names, text_.names_name, draft_.mechanism, findings_);
    findings_.raise_if_any();
    return std::move(draft_.mechanism);
  }

 private:
  void report_all_duplicates() {
    const auto named = [](const auto& each) { return std::pair(each.name, each.where); };
    report_duplicates(
        draft_.bodies, "body", [&](const BodyEntry& each) { return named(each.body); }, findings_);
    report_duplicates(
        draft_.joints, "joint", [&](const JointEntry& each) { return named(each.joint); },
        findings_);
    report_duplicates(draft_.mechanism.frames, "frame", named, findings_);
    report_duplicates(draft_.mechanism.tendons, "tendon", named, findings_);
    report_duplicates(
        draft_.mechanism.couplings, "the coupling of",
        [](const JointCoupling& each) { return std::pair(each.dependent, each.where); }, findings_);
    for (const JointCoupling& coupling : draft_.mechanism.couplings)
      for (const JointCoupling& other : draft_.mechanism.couplings)
        if (!coupling.independent.empty() && coupling.dependent != coupling.independent &&
            coupling.independent == other.dependent)
          findings_.add(coupling.where,
                        fmt::format("joint '{}' depends on '{}', which depends on '{}'",
                                    coupling.dependent, other.dependent, other.independent),
                        "expected couplings to independent joints");
    report_duplicates(
        draft_.mechanism.four_bars, "the four-bar of",
        [](const FourBarCoupling& each) { return std::pair(each.dependent, each.where); },
        findings_);
  }

  void set_mass_properties(const std::vector<MassProperties>& masses) {
    report_duplicates(
        masses, "the row of body",
        [](const MassProperties& row) { return std::pair(row.body, row.where); }, findings_);
    std::vector<std::string> names;
    for (const BodyEntry& entry : draft_.bodies) names.push_back(entry.body.name);
    for (const MassProperties& row : masses)
      if (std::find(names.begin(), names.end(), row.body) == names.end())
        findings_.add(row.where,
                      fmt::format("the mechanism has no body '{}'{}", row.body,
                                  did_you_mean(row.body, names)),
                      fmt::format("expected a [[body]] of {}", text_.toml_name));
    for (BodyEntry& entry : draft_.bodies) {
      const auto row = std::find_if(masses.begin(), masses.end(), [&](const MassProperties& each) {
        return each.body == entry.body.name;
      });
      if (row != masses.end())
        set_mass(entry, *row);
      else if (!entry.is_massless && !entry.body.name.empty() && has_whole_table_)
        findings_.add(entry.body.where,
                      fmt::format("body '{}' has no row in {}", entry.body.name, text_.csv_name),
                      "expected its mass properties there, or massless = true");
    }
  }

  void set_mass(BodyEntry& entry, const MassProperties& row) {
    Body& body = entry.body;
    body.mass = row.mass;
    body.centre_of_mass = row.centre_of_mass;
    body.inertia = row.inertia;
    draft_.mechanism.provenance["body." + body.name + ".mass_properties"] = row.provenance;
    if (entry.is_massless)
      findings_.add(row.where, fmt::format("body '{}' is massless but has a row", body.name),
                    fmt::format("expected no row, or no massless = true in {}", text_.toml_name));
    else if (!(row.mass > 0.0))
      findings_.add(row.mass_where, fmt::format("the mass of '{}' is {} kg", body.name, row.mass),
                    "expected a mass > 0, or massless = true and no row");
    if (const auto wrong = wrong_inertia(row.inertia, entry.check))
      findings_.add(row.inertia_where, fmt::format("body '{}': {}", body.name, *wrong),
                    "expected the inertia of a rigid body about its centre of mass");
  }

  void sort_bodies() {
    std::vector<TreeBody> bodies;
    std::vector<TreeJoint> joints;
    for (const BodyEntry& entry : draft_.bodies)
      if (!entry.body.name.empty()) bodies.push_back({entry.body.name, entry.body.where});
    for (const JointEntry& entry : draft_.joints) joints.push_back(entry.ends);
    const auto order = order_depth_first("base", bodies, joints, findings_);
    if (findings_.any()) return;
    std::map<std::string, int> index{{"base", -1}};
    for (const std::size_t at : order) {
      const TreeJoint& ends = joints[at];
      index[ends.child] = static_cast<int>(draft_.mechanism.bodies.size());
      draft_.mechanism.joints.push_back(draft_.joints[at].joint);
      draft_.mechanism.joints.back().parent = index.at(ends.parent);
      const auto body =
          std::find_if(draft_.bodies.begin(), draft_.bodies.end(),
                       [&](const BodyEntry& each) { return each.body.name == ends.child; });
      draft_.mechanism.bodies.push_back(body->body);
    }
  }

  const MechanismText& text_;
  Findings& findings_;
  MechanismDraft draft_;
  TomlFile file_;
  bool has_whole_table_ =
      true;  ///< rows with mistakes are left out: missing rows then prove nothing
};

}  // namespace

Mechanism parse_mechanism(const MechanismText& text) {
  Findings findings;
  return MechanismReader(text, findings).read();
}

Mechanism read_mechanism(const std::filesystem::path& model_folder) {
  const std::filesystem::path toml = model_folder / "mechanism.toml";
  const std::filesystem::path csv = model_folder / "mass_properties.csv";
  Findings findings;
  const std::string toml_text = read_text(toml, findings);
  const std::string csv_text = read_text(csv, findings);
  const std::filesystem::path names = model_folder / "names.toml";
  const std::string names_text =
      std::filesystem::exists(names) ? read_text(names, findings) : std::string();
  findings.raise_if_any();
  return parse_mechanism(
      {toml_text, csv_text, toml.string(), csv.string(), names_text, names.string()});
}

}  // namespace sinew
