// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/read_mechanism.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "symbolic/check_mechanism.h"
#include "symbolic/identifier.h"
#include "symbolic/order_bodies.h"
#include "symbolic/read_mass_properties.h"
#include "symbolic/rotation.h"
#include "symbolic/toml_reader.h"

namespace sinew {
namespace {

struct BodyEntry {
  Body body;
  bool is_massless = false;
  InertiaCheck check = InertiaCheck::physical;
};

struct JointEntry {
  Joint joint;
  TreeJoint ends;
};

/// A named thing already read: its place, to report a second one of the same name.
template <typename Entries, typename NameOf>
void report_duplicates(const Entries& entries, const std::string& kind, NameOf name_of,
                       Findings& findings) {
  for (auto entry = entries.begin(); entry != entries.end(); ++entry) {
    const auto& [name, where] = name_of(*entry);
    for (auto earlier = entries.begin(); earlier != entry; ++earlier) {
      if (name.empty() || name_of(*earlier).first != name) continue;
      findings.add(where,
                   fmt::format("{} '{}' is defined a second time, first in line {}", kind, name,
                               name_of(*earlier).second.line),
                   "expected different names");
      break;
    }
  }
}

class MechanismReader {
 public:
  MechanismReader(const MechanismText& text, Findings& findings)
      : text_(text), findings_(findings), file_{text.toml_name, findings, mechanism_.provenance} {}

  Mechanism read() {
    const std::vector<MassProperties> masses =
        parse_mass_properties(text_.csv, text_.csv_name, findings_);
    has_whole_table_ = !findings_.any();
    toml::table root;
    try {
      root = toml::parse(text_.toml, text_.toml_name);
    } catch (const toml::parse_error& error) {
      findings_.add(locate(file_, error.source()), std::string(error.description()),
                    "expected TOML 1.0");
      findings_.raise_if_any();
    }
    read_sections(root);
    report_all_duplicates();
    set_mass_properties(masses);
    sort_bodies();
    findings_.raise_if_any();
    check_mechanism(mechanism_, findings_);
    findings_.raise_if_any();
    return std::move(mechanism_);
  }

 private:
  void read_sections(const toml::table& table) {
    TomlTable root(table, "", file_);
    const auto values = root.table("values", false);
    if (values) file_.values = table["values"].as_table();
    if (auto header = root.table("mechanism", true)) read_header(*header);
    for (TomlTable& body : root.tables("body")) read_body(body);
    for (TomlTable& joint : root.tables("joint")) read_joint(joint);
    if (!root.has("body") || !root.has("joint"))
      findings_.add({file_.name, 1, 1}, "the mechanism has no body or no joint",
                    "expected at least one [[body]] and one [[joint]]");
    for (TomlTable& frame : root.tables("frame")) read_frame(frame);
    for (TomlTable& tendon : root.tables("tendon")) read_tendon(tendon);
    for (TomlTable& coupling : root.tables("coupling")) read_coupling(coupling);
    if (auto defaults = root.table("tendon_defaults", false)) read_tendon_defaults(*defaults);
    root.finish();
    check_values();
  }

  void check_values() {
    if (file_.values == nullptr) return;
    for (const auto& [key, node] : *file_.values) {
      const std::string name(key.str());
      if (!node.is_table())
        findings_.add(locate(file_, node.source()),
                      fmt::format("values.{} is not a quantity", name),
                      "expected { value = ..., unit = ..., from = ... }");
      else if (!file_.used_values.contains(name))
        findings_.add(locate(file_, key.source()), fmt::format("values.{} is never used", name),
                      "expected a use, or no such value");
      mechanism_.provenance.erase("values." + name);
    }
  }

  void read_header(TomlTable& table) {
    mechanism_.name = table.identifier("name").value_or("");
    mechanism_.description = table.text("description", false).value_or("");
    if (const auto gravity =
            table.quantity("gravity", Shape::vector, Dimension::acceleration, true))
      mechanism_.gravity = Eigen::Vector3d(gravity->values.data());
    table.finish();
  }

  void read_body(TomlTable& table) {
    BodyEntry entry;
    entry.body.where = table.where();
    entry.body.name = table.identifier("name").value_or("");
    if (entry.body.name == "base")
      table.report("name", "a body is called 'base'",
                   "expected another name: 'base' is the fixed frame");
    if (!entry.body.name.empty()) table.set_path("body." + entry.body.name);
    entry.is_massless = table.truth("massless").value_or(false);
    const auto check =
        table.word("inertia_check", {"physical", "idealised", "as_given"}, "physical");
    if (check == "idealised") entry.check = InertiaCheck::idealised;
    if (check == "as_given") entry.check = InertiaCheck::as_given;
    table.text("note", false);
    table.finish();
    bodies_.push_back(std::move(entry));
  }

  void read_joint(TomlTable& table) {
    JointEntry entry;
    Joint& joint = entry.joint;
    joint.where = table.where();
    joint.name = table.identifier("name").value_or("");
    if (!joint.name.empty()) table.set_path("joint." + joint.name);
    const auto type = table.word("type", {"revolute", "prismatic", "fixed"}, "");
    entry.ends = {joint.name,
                  table.text("parent", true).value_or(""),
                  table.text("child", true).value_or(""),
                  joint.where,
                  table.where("parent"),
                  table.where("child")};
    if (auto origin = table.table("origin", false)) joint.origin = read_pose(*origin);
    if (type == "prismatic") joint.type = JointType::prismatic;
    if (type == "fixed") joint.type = JointType::fixed;
    if (type && joint.type != JointType::fixed) read_motion(table, joint);
    if (type) table.finish();
    joints_.push_back(std::move(entry));
  }

  void read_motion(TomlTable& table, Joint& joint) {
    const bool turns = joint.type == JointType::revolute;
    if (const auto axis = table.direction("axis", true)) {
      joint.axis = Eigen::Vector3d(axis->values.data());
      const double length = joint.axis.stableNorm();
      if (length == 0.0)
        findings_.add(axis->where, table.path() + ".axis is zero", "expected a direction");
      else if (length != 1.0)
        joint.axis = unit_axis(joint.axis);
    }
    if (const auto range = table.quantity("range", Shape::pair,
                                          turns ? Dimension::angle : Dimension::length, true)) {
      joint.low = range->values[0];
      joint.high = range->values[1];
      if (!(joint.low < joint.high))
        findings_.add(range->where, table.path() + ".range is empty", "expected low < high");
    }
    read_positive(table, "max_velocity", turns ? Dimension::angular_velocity : Dimension::velocity,
                  joint.max_velocity);
    read_positive(table, "max_acceleration",
                  turns ? Dimension::angular_acceleration : Dimension::acceleration,
                  joint.max_acceleration);
    if (const auto damping =
            table.quantity("damping", Shape::scalar,
                           turns ? Dimension::angular_damping : Dimension::damping, false)) {
      joint.damping = damping->values[0];
      if (joint.damping < 0.0)
        findings_.add(damping->where, table.path() + ".damping is negative",
                      "expected a damping >= 0");
    }
  }

  void read_positive(TomlTable& table, std::string_view key, Dimension dimension, double& value) {
    const auto quantity = table.quantity(key, Shape::scalar, dimension, false);
    if (!quantity) return;
    value = quantity->values[0];
    if (!(value > 0.0))
      findings_.add(quantity->where, fmt::format("{}.{} is not positive", table.path(), key),
                    "expected a number > 0");
  }

  Transform read_pose(TomlTable& table) {
    Transform pose;
    if (const auto xyz = table.quantity("xyz", Shape::vector, Dimension::length, false))
      pose.translation = Eigen::Vector3d(xyz->values.data());
    const auto rpy = table.quantity("rpy", Shape::vector, Dimension::angle, false);
    const auto rotation = table.quantity("rotation", Shape::matrix, Dimension::none, false);
    if (rpy) pose.rotation = rotation_from_rpy(Eigen::Vector3d(rpy->values.data()));
    if (rotation) {
      const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows(rotation->values.data());
      pose.rotation = snapped(rows);
      if (!is_rotation(pose.rotation))
        findings_.add(rotation->where, table.path() + ".rotation is not a rotation matrix",
                      "expected orthonormal rows and determinant 1");
    }
    if (rpy && rotation)
      findings_.add(rotation->where, table.path() + " has both rpy and rotation",
                    "expected one of them");
    table.finish();
    return pose;
  }

  void read_frame(TomlTable& table) {
    Frame frame;
    frame.where = table.where();
    frame.name = table.identifier("name").value_or("");
    if (!frame.name.empty()) table.set_path("frame." + frame.name);
    frame.body = table.text("body", true).value_or("");
    require_body(table, "body", frame.body, false);
    if (auto pose = table.table("pose", false)) frame.pose = read_pose(*pose);
    table.finish();
    mechanism_.frames.push_back(std::move(frame));
  }

  void read_tendon(TomlTable& table) {
    Tendon tendon;
    tendon.where = table.where();
    tendon.name = table.identifier("name").value_or("");
    if (!tendon.name.empty()) table.set_path("tendon." + tendon.name);
    if (const auto h0 = table.quantity("h0", Shape::scalar, Dimension::length, false))
      tendon.h0 = h0->values[0];
    for (TomlTable& pulley : table.tables("pulleys")) read_pulley(pulley, tendon);
    for (TomlTable& straight : table.tables("straights")) read_straight(straight, tendon);
    if (!table.has("pulleys") && !table.has("straights"))
      table.report("name", table.path() + " has no path", "expected pulleys or straights");
    else if (tendon.pulleys.empty() && tendon.straights.empty())
      table.report(table.has("pulleys") ? "pulleys" : "straights",
                   table.path() + " has an empty path",
                   "expected at least one pulley or straight stretch");
    table.finish();
    mechanism_.tendons.push_back(std::move(tendon));
  }

  void read_pulley(TomlTable& table, Tendon& tendon) {
    PulleyRouting pulley;
    pulley.joint = table.text("joint", true).value_or("");
    require_moving_joint(table, "joint", pulley.joint);
    for (const PulleyRouting& other : tendon.pulleys)
      if (!pulley.joint.empty() && other.joint == pulley.joint)
        table.report("joint",
                     fmt::format("{} is a second pulley at joint '{}'", table.path(), pulley.joint),
                     "expected one with the sum of the radii");
    if (const auto radius = table.quantity("radius", Shape::scalar, Dimension::length, true)) {
      pulley.radius = radius->values[0];
      if (pulley.radius == 0.0)
        findings_.add(radius->where, table.path() + ".radius is zero",
                      "expected a radius, positive or negative");
    }
    table.finish();
    tendon.pulleys.push_back(std::move(pulley));
  }

  void read_straight(TomlTable& table, Tendon& tendon) {
    StraightRouting straight;
    straight.from_body = table.text("from_body", true).value_or("");
    straight.to_body = table.text("to_body", true).value_or("");
    require_body(table, "from_body", straight.from_body, true);
    require_body(table, "to_body", straight.to_body, true);
    if (!straight.from_body.empty() && straight.from_body == straight.to_body)
      table.report("to_body", fmt::format("{} stays on '{}'", table.path(), straight.to_body),
                   "expected two different bodies");
    if (const auto point = table.quantity("from_point", Shape::vector, Dimension::length, true))
      straight.from = Eigen::Vector3d(point->values.data());
    if (const auto point = table.quantity("to_point", Shape::vector, Dimension::length, true))
      straight.to = Eigen::Vector3d(point->values.data());
    table.finish();
    tendon.straights.push_back(std::move(straight));
  }

  void read_coupling(TomlTable& table) {
    JointCoupling coupling;
    coupling.where = table.where();
    coupling.dependent = table.text("dependent", true).value_or("");
    coupling.independent = table.text("independent", true).value_or("");
    if (!coupling.dependent.empty()) table.set_path("coupling." + coupling.dependent);
    require_moving_joint(table, "dependent", coupling.dependent);
    require_moving_joint(table, "independent", coupling.independent);
    if (!coupling.dependent.empty() && coupling.dependent == coupling.independent)
      table.report("independent",
                   fmt::format("joint '{}' is coupled to itself", coupling.dependent),
                   "expected two joints");
    if (const auto ratio = table.quantity("ratio", Shape::scalar, Dimension::none, true)) {
      coupling.ratio = ratio->values[0];
      if (coupling.ratio == 0.0)
        findings_.add(ratio->where, table.path() + ".ratio is zero", "expected another number");
    }
    table.finish();
    mechanism_.couplings.push_back(std::move(coupling));
  }

  void read_tendon_defaults(TomlTable& table) {
    if (const auto stiffness =
            table.quantity("stiffness", Shape::pair, Dimension::stiffness, false)) {
      mechanism_.tendon_stiffness_low = stiffness->values[0];
      mechanism_.tendon_stiffness_high = stiffness->values[1];
      if (!(stiffness->values[0] > 0.0) || !(stiffness->values[0] < stiffness->values[1]))
        findings_.add(stiffness->where, "tendon_defaults.stiffness is no range of stiffnesses",
                      "expected 0 < low < high");
    }
    read_positive(table, "max_force", Dimension::force, mechanism_.tendon_force_high);
    table.finish();
  }

  void require_moving_joint(TomlTable& table, std::string_view key, const std::string& name) {
    if (name.empty()) return;
    std::vector<std::string> names;
    for (const JointEntry& entry : joints_) {
      if (entry.joint.name == name) {
        if (entry.joint.type == JointType::fixed)
          table.report(key, fmt::format("{}.{} '{}' is a fixed joint", table.path(), key, name),
                       "expected a moving joint");
        return;
      }
      names.push_back(entry.joint.name);
    }
    table.report(key,
                 fmt::format("{}.{} names the unknown joint '{}'{}", table.path(), key, name,
                             did_you_mean(name, names)),
                 "expected the name of a joint");
  }

  void require_body(TomlTable& table, std::string_view key, const std::string& name, bool or_base) {
    if (name.empty() || (or_base && name == "base")) return;
    std::vector<std::string> names;
    for (const BodyEntry& entry : bodies_) {
      if (entry.body.name == name) return;
      names.push_back(entry.body.name);
    }
    table.report(key,
                 fmt::format("{}.{} names the unknown body '{}'{}", table.path(), key, name,
                             did_you_mean(name, names)),
                 or_base ? "expected 'base' or the name of a body" : "expected the name of a body");
  }

  void report_all_duplicates() {
    const auto named = [](const auto& each) { return std::pair(each.name, each.where); };
    report_duplicates(
        bodies_, "body", [&](const BodyEntry& each) { return named(each.body); }, findings_);
    report_duplicates(
        joints_, "joint", [&](const JointEntry& each) { return named(each.joint); }, findings_);
    report_duplicates(mechanism_.frames, "frame", named, findings_);
    report_duplicates(mechanism_.tendons, "tendon", named, findings_);
    report_duplicates(
        mechanism_.couplings, "the coupling of",
        [](const JointCoupling& each) { return std::pair(each.dependent, each.where); }, findings_);
    for (const JointCoupling& coupling : mechanism_.couplings)
      for (const JointCoupling& other : mechanism_.couplings)
        if (!coupling.independent.empty() && coupling.dependent != coupling.independent &&
            coupling.independent == other.dependent)
          findings_.add(coupling.where,
                        fmt::format("joint '{}' depends on '{}', which depends on '{}'",
                                    coupling.dependent, other.dependent, other.independent),
                        "expected couplings to independent joints");
  }

  void set_mass_properties(const std::vector<MassProperties>& masses) {
    report_duplicates(
        masses, "the row of body",
        [](const MassProperties& row) { return std::pair(row.body, row.where); }, findings_);
    std::vector<std::string> names;
    for (const BodyEntry& entry : bodies_) names.push_back(entry.body.name);
    for (const MassProperties& row : masses)
      if (std::find(names.begin(), names.end(), row.body) == names.end())
        findings_.add(row.where,
                      fmt::format("the mechanism has no body '{}'{}", row.body,
                                  did_you_mean(row.body, names)),
                      fmt::format("expected a [[body]] of {}", text_.toml_name));
    for (BodyEntry& entry : bodies_) {
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
    mechanism_.provenance["body." + body.name + ".mass_properties"] = row.provenance;
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
    for (const BodyEntry& entry : bodies_)
      if (!entry.body.name.empty()) bodies.push_back({entry.body.name, entry.body.where});
    for (const JointEntry& entry : joints_) joints.push_back(entry.ends);
    const auto order = order_depth_first("base", bodies, joints, findings_);
    if (findings_.any()) return;
    std::map<std::string, int> index{{"base", -1}};
    for (const std::size_t at : order) {
      const TreeJoint& ends = joints[at];
      index[ends.child] = static_cast<int>(mechanism_.bodies.size());
      mechanism_.joints.push_back(joints_[at].joint);
      mechanism_.joints.back().parent = index.at(ends.parent);
      const auto body = std::find_if(bodies_.begin(), bodies_.end(), [&](const BodyEntry& each) {
        return each.body.name == ends.child;
      });
      mechanism_.bodies.push_back(body->body);
    }
  }

  const MechanismText& text_;
  Findings& findings_;
  Mechanism mechanism_;
  TomlFile file_;
  std::vector<BodyEntry> bodies_;
  std::vector<JointEntry> joints_;
  bool has_whole_table_ =
      true;  ///< rows with mistakes are left out: missing rows then prove nothing
};

std::string read_text(const std::filesystem::path& path, Findings& findings) {
  std::ifstream stream(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!std::filesystem::is_regular_file(path) || stream.bad())
    findings.add({path.string(), 0, 0}, "cannot be read", "expected a readable file");
  return text;
}

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
  findings.raise_if_any();
  return parse_mechanism({toml_text, csv_text, toml.string(), csv.string()});
}

}  // namespace sinew
