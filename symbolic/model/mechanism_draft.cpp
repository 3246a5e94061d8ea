// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "symbolic/files/identifier.h"
#include "symbolic/model/mechanism_draft.h"
#include "symbolic/model/rotation.h"

namespace sinew {
namespace {

// More than any motor or gear has.
constexpr int kMostTeeth = 1000;

/// Of length 1 to rounding: such an axis is taken as it is written, so that it reads back the same.
bool is_unit(const Eigen::Vector3d& axis) {
  return std::abs(axis.squaredNorm() - 1.0) <= 1e-15;
}

class SectionReader {
 public:
  SectionReader(TomlFile& file, MechanismDraft& draft)
      : file_(file), findings_(file.findings), draft_(draft) {}

  void read(const toml::table& table) {
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
    for (TomlTable& bars : root.tables("four_bar")) read_four_bar(bars);
    if (auto defaults = root.table("tendon_defaults", false)) read_tendon_defaults(*defaults);
    if (root.has("tendon") || root.has("tendon_defaults")) {
      assume("tendon_defaults.stiffness");
      assume("tendon_defaults.max_force");
    }
    root.finish();
    check_values();
  }

 private:
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
      draft_.mechanism.provenance.erase("values." + name);
    }
  }

  void read_header(TomlTable& table) {
    draft_.where = table.where();
    draft_.mechanism.name = table.model_name("name").value_or("");
    draft_.mechanism.description = table.text("description", false).value_or("");
    if (const auto gravity =
            table.quantity("gravity", Shape::vector, Dimension::acceleration, true))
      draft_.mechanism.gravity = Eigen::Vector3d(gravity->values.data());
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
    draft_.bodies.push_back(std::move(entry));
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
    draft_.joints.push_back(std::move(entry));
  }

  void read_motion(TomlTable& table, Joint& joint) {
    const bool turns = joint.type == JointType::revolute;
    if (const auto axis = table.direction("axis", true)) {
      joint.axis = Eigen::Vector3d(axis->values.data());
      if (joint.axis.isZero(0.0))
        findings_.add(axis->where, table.path() + ".axis is zero", "expected a direction");
      else if (!is_unit(joint.axis))
        joint.axis = unit_axis(joint.axis);
    }
    if (const auto range = table.quantity("range", Shape::pair,
                                          turns ? Dimension::angle : Dimension::length, true)) {
      joint.low = range->values[0];
      joint.high = range->values[1];
      if (!(joint.low < joint.high))
        findings_.add(range->where, table.path() + ".range is empty", "expected low < high");
    }
    if (const auto reference = table.quantity(
            "reference", Shape::scalar, turns ? Dimension::angle : Dimension::length, false)) {
      joint.reference = reference->values[0];
      if (*joint.reference < joint.low || *joint.reference > joint.high)
        findings_.add(reference->where, table.path() + ".reference is outside the joint's range",
                      fmt::format("expected {} to {}", joint.low, joint.high));
    }
    read_positive(table, "max_velocity", turns ? Dimension::angular_velocity : Dimension::velocity,
                  joint.max_velocity);
    read_positive(table, "max_acceleration",
                  turns ? Dimension::angular_acceleration : Dimension::acceleration,
                  joint.max_acceleration);
    if (!read_not_negative(table, "damping",
                           turns ? Dimension::angular_damping : Dimension::damping, joint.damping))
      assume(table.path() + ".damping");
    read_drive(table, turns, joint);
  }

  void read_drive(TomlTable& table, bool turns, Joint& joint) {
    read_not_negative(table, "friction", turns ? Dimension::torque : Dimension::force,
                      joint.friction);
    read_not_negative(table, "friction_speed",
                      turns ? Dimension::angular_velocity : Dimension::velocity,
                      joint.friction_speed);
    read_not_negative(table, "armature", turns ? Dimension::inertia : Dimension::mass,
                      joint.armature);
    read_not_negative(table, "motor_turn", turns ? Dimension::angle : Dimension::length,
                      joint.motor_turn);
    read_count(table, "motor_poles", joint.motor_poles);
    read_count(table, "motor_slots", joint.motor_slots);
    read_count(table, "gear_teeth", joint.gear_teeth);
  }

  void read_count(TomlTable& table, const char* key, int& value) {
    const auto quantity = table.quantity(key, Shape::scalar, Dimension::none, false);
    if (!quantity) return;
    const double given = quantity->values[0];
    if (given >= 1.0 && given <= kMostTeeth && given == std::floor(given))
      value = static_cast<int>(given);
    else
      findings_.add(quantity->where, fmt::format("{}.{} is no count", table.path(), key),
                    fmt::format("expected a whole number from 1 to {}", kMostTeeth));
  }

  /// False where the key is not there.
  bool read_not_negative(TomlTable& table, const char* key, Dimension dimension, double& value) {
    const auto quantity = table.quantity(key, Shape::scalar, dimension, false);
    if (!quantity) return false;
    value = quantity->values[0];
    if (value < 0.0)
      findings_.add(quantity->where, fmt::format("{}.{} is negative", table.path(), key),
                    fmt::format("expected a {} >= 0", key));
    return true;
  }

  void read_positive(TomlTable& table, std::string_view key, Dimension dimension, double& value) {
    const auto quantity = table.quantity(key, Shape::scalar, dimension, false);
    if (!quantity) return assume(fmt::format("{}.{}", table.path(), key));
    value = quantity->values[0];
    if (!(value > 0.0))
      findings_.add(quantity->where, fmt::format("{}.{} is not positive", table.path(), key),
                    "expected a number > 0");
  }

  /// A value left out is one assumed.
  void assume(const std::string& path) { draft_.mechanism.provenance.emplace(path, "assumed"); }

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
    draft_.mechanism.frames.push_back(std::move(frame));
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
    draft_.mechanism.tendons.push_back(std::move(tendon));
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
    if (table.has("independent_radius") || table.has("dependent_radius"))
      read_loop(table, coupling);
    else if (const auto ratio = table.quantity("ratio", Shape::scalar, Dimension::none, true)) {
      coupling.ratio = ratio->values[0];
      if (coupling.ratio == 0.0)
        findings_.add(ratio->where, table.path() + ".ratio is zero", "expected another number");
    }
    if (const auto offset = table.quantity(
            "offset", Shape::scalar,
            slides(coupling.dependent) ? Dimension::length : Dimension::angle, false))
      coupling.offset = offset->values[0];
    table.finish();
    draft_.mechanism.couplings.push_back(std::move(coupling));
  }

  /// A tendon loop of constant length over two pulleys: r_independent q = r_dependent q_dependent.
  void read_loop(TomlTable& table, JointCoupling& coupling) {
    const auto radius = [&](const char* key) {
      const auto value = table.quantity(key, Shape::scalar, Dimension::length, true);
      if (!value) return 1.0;
      if (value->values[0] == 0.0)
        findings_.add(value->where, fmt::format("{}.{} is zero", table.path(), key),
                      "expected a radius, positive or negative");
      return value->values[0];
    };
    const double independent = radius("independent_radius"), dependent = radius("dependent_radius");
    if (table.has("ratio"))
      table.report("ratio", table.path() + " has both radii and a ratio", "expected one of them");
    if (independent == 0.0 || dependent == 0.0) return;
    coupling.ratio = independent / dependent;
    if (!std::isfinite(coupling.ratio) || coupling.ratio == 0.0)
      table.report("independent_radius", table.path() + " has radii of which no ratio is left",
                   "expected radii of similar size");
    const auto from = draft_.mechanism.provenance.find(table.path() + ".independent_radius");
    if (from != draft_.mechanism.provenance.end())
      draft_.mechanism.provenance.emplace(table.path() + ".ratio", from->second);
  }

  void read_four_bar(TomlTable& table) {
    FourBarCoupling bars;
    bars.where = table.where();
    bars.dependent = table.text("dependent", true).value_or("");
    bars.independent = table.text("independent", true).value_or("");
    if (!bars.dependent.empty()) table.set_path("four_bar." + bars.dependent);
    require_moving_joint(table, "dependent", bars.dependent);
    require_moving_joint(table, "independent", bars.independent);
    if (!bars.dependent.empty() && bars.dependent == bars.independent)
      table.report("independent", fmt::format("joint '{}' is coupled to itself", bars.dependent),
                   "expected two joints");
    for (const auto& [key, length] :
         {std::pair{"ground", &bars.ground}, std::pair{"crank", &bars.crank},
          std::pair{"coupler", &bars.coupler}, std::pair{"rocker", &bars.rocker}}) {
      *length = 1.0;
      if (!table.has(key))
        table.quantity(key, Shape::scalar, Dimension::length, true);
      else
        read_positive(table, key, Dimension::length, *length);
    }
    if (table.word("branch", {"open", "crossed"}, "") == "crossed") bars.branch = 1;
    if (table.word("follows", {"rocker", "coupler"}, "rocker") == "coupler")
      bars.follows = FourBarCoupling::Follows::coupler;
    if (const auto angle = table.quantity("crank_angle", Shape::scalar, Dimension::angle, true))
      bars.crank_angle = angle->values[0];
    table.finish();
    draft_.mechanism.four_bars.push_back(std::move(bars));
  }

  void read_tendon_defaults(TomlTable& table) {
    if (const auto stiffness =
            table.quantity("stiffness", Shape::pair, Dimension::stiffness, false)) {
      draft_.mechanism.tendon_stiffness_low = stiffness->values[0];
      draft_.mechanism.tendon_stiffness_high = stiffness->values[1];
      if (!(stiffness->values[0] > 0.0) || !(stiffness->values[0] < stiffness->values[1]))
        findings_.add(stiffness->where, "tendon_defaults.stiffness is no range of stiffnesses",
                      "expected 0 < low < high");
    }
    read_positive(table, "max_force", Dimension::force, draft_.mechanism.tendon_force_high);
    table.finish();
  }

  bool slides(const std::string& name) const {
    for (const JointEntry& entry : draft_.joints)
      if (entry.joint.name == name) return entry.joint.type == JointType::prismatic;
    return false;
  }

  void require_moving_joint(TomlTable& table, std::string_view key, const std::string& name) {
    if (name.empty()) return;
    std::vector<std::string> names;
    for (const JointEntry& entry : draft_.joints) {
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
    for (const BodyEntry& entry : draft_.bodies) {
      if (entry.body.name == name) return;
      names.push_back(entry.body.name);
    }
    table.report(key,
                 fmt::format("{}.{} names the unknown body '{}'{}", table.path(), key, name,
                             did_you_mean(name, names)),
                 or_base ? "expected 'base' or the name of a body" : "expected the name of a body");
  }

  TomlFile& file_;
  Findings& findings_;
  MechanismDraft& draft_;
};

}  // namespace

void read_sections(const toml::table& root, TomlFile& file, MechanismDraft& draft) {
  SectionReader(file, draft).read(root);
}

}  // namespace sinew
