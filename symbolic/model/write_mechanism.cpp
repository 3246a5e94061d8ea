// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/model/write_mechanism.h"

#include <fmt/format.h>

#include <stdexcept>

#include "symbolic/files/origin.h"
#include "symbolic/files/toml_reader.h"
#include "symbolic/files/units.h"
#include "symbolic/model/check_mechanism.h"
#include "symbolic/model/read_mechanism.h"
#include "symbolic/model/rotation.h"
#include "symbolic/model/source_names.h"

namespace sinew {
namespace {

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\t\r\n#") == std::string::npos && !text.starts_with(' ') &&
      !text.ends_with(' '))
    return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + '"';
}

/// The shortest text that reads as the same double. TOML's -0 is the integer 0, so zero has no
/// sign.
std::string number(double value) {
  return fmt::format("{}", value + 0.0);
}

std::string list(const Eigen::Vector3d& v) {
  return fmt::format("[{}, {}, {}]", number(v[0]), number(v[1]), number(v[2]));
}

std::string range(double low, double high) {
  return fmt::format("[{}, {}]", number(low), number(high));
}

struct OriginAndReference {
  std::string from;
  std::string ref;
};

/// "text: Table 5.1" taken apart; anything else is "assumed".
OriginAndReference split_provenance(const std::string& provenance) {
  const std::size_t colon = provenance.find(": ");
  const std::string from = provenance.substr(0, colon);
  const std::string ref = colon == std::string::npos ? "" : provenance.substr(colon + 2);
  if (is_origin(from) && (from != "text" || !ref.empty())) return {from, ref};
  return {"assumed", provenance == "assumed" ? "" : provenance};
}

class Describer {
 public:
  explicit Describer(const Mechanism& mechanism) : mechanism_(mechanism) {}

  std::string toml() {
    header();
    for (const Body& each : mechanism_.bodies) body(each);
    for (std::size_t i = 0; i < mechanism_.joints.size(); ++i) joint(i);
    for (const Frame& each : mechanism_.frames) frame(each);
    for (const Tendon& each : mechanism_.tendons) tendon(each);
    for (const JointCoupling& each : mechanism_.couplings) coupling(each);
    for (const FourBarCoupling& each : mechanism_.four_bars) four_bar(each);
    if (!mechanism_.tendons.empty() || is_known("tendon_defaults.stiffness")) tendon_defaults();
    return std::move(text_);
  }

 private:
  bool is_known(const std::string& path) const { return mechanism_.provenance.contains(path); }

  std::string quantity(const std::string& path, const std::string& value,
                       Dimension dimension) const {
    const auto found = mechanism_.provenance.find(path);
    const auto [from, ref] =
        split_provenance(found == mechanism_.provenance.end() ? "assumed" : found->second);
    const std::string unit =
        dimension == Dimension::none ? "" : fmt::format(", unit = \"{}\"", si_unit(dimension));
    const std::string reference = ref.empty() ? "" : ", ref = " + toml_string(ref);
    return fmt::format("{{ value = {}{}, from = \"{}\"{} }}", value, unit, from, reference);
  }

  void line(const std::string& key, const std::string& value) {
    text_ += fmt::format("{} = {}\n", key, value);
  }

  void line(const std::string& key, const std::string& path, const std::string& value,
            Dimension dimension) {
    line(key, quantity(path, value, dimension));
  }

  void header() {
    text_ += "[mechanism]\n";
    line("name", toml_string(mechanism_.name));
    if (!mechanism_.description.empty()) line("description", toml_string(mechanism_.description));
    line("gravity", "mechanism.gravity", list(mechanism_.gravity), Dimension::acceleration);
  }

  void body(const Body& body) {
    text_ += fmt::format("\n[[body]]\nname = {}\n", toml_string(body.name));
    if (body.mass == 0.0) return line("massless", "true");
    const auto check = strictest_check(body.inertia);
    if (check && check != InertiaCheck::physical)
      line("inertia_check", toml_string(to_text(*check)));
  }

  void pose(const std::string& key, const std::string& path, const Transform& pose) {
    if (!pose.translation.isZero(0.0) || is_known(path + ".xyz"))
      line(key + ".xyz", path + ".xyz", list(pose.translation), Dimension::length);
    const auto rpy = exact_rpy(pose.rotation);
    if (rpy && !is_known(path + ".rotation")) {
      if (pose.rotation != Eigen::Matrix3d::Identity() || is_known(path + ".rpy"))
        line(key + ".rpy", path + ".rpy", list(*rpy), Dimension::angle);
      return;
    }
    const Eigen::Matrix3d& r = pose.rotation;
    const std::string known = is_known(path + ".rotation") ? path + ".rotation" : path + ".rpy";
    line(key + ".rotation", known,
         fmt::format("[{}, {}, {}]", list(r.row(0)), list(r.row(1)), list(r.row(2))),
         Dimension::none);
  }

  void joint(std::size_t index) {
    static constexpr const char* types[] = {"revolute", "prismatic", "fixed"};
    const Joint& joint = mechanism_.joints[index];
    const std::string path = "joint." + joint.name;
    text_ += fmt::format("\n[[joint]]\nname = {}\ntype = \"{}\"\n", toml_string(joint.name),
                         types[static_cast<int>(joint.type)]);
    line("parent",
         toml_string(joint.parent < 0
                         ? "base"
                         : mechanism_.bodies[static_cast<std::size_t>(joint.parent)].name));
    line("child", toml_string(mechanism_.bodies[index].name));
    pose("origin", path + ".origin", joint.origin);
    if (joint.type == JointType::fixed) return;
    const bool turns = joint.type == JointType::revolute;
    if (is_known(path + ".axis"))
      line("axis", path + ".axis", list(joint.axis), Dimension::none);
    else
      line("axis", list(joint.axis));
    line("range", path + ".range", range(joint.low, joint.high),
         turns ? Dimension::angle : Dimension::length);
    if (joint.reference)
      line("reference", path + ".reference", number(*joint.reference),
           turns ? Dimension::angle : Dimension::length);
    line("max_velocity", path + ".max_velocity", number(joint.max_velocity),
         turns ? Dimension::angular_velocity : Dimension::velocity);
    line("max_acceleration", path + ".max_acceleration", number(joint.max_acceleration),
         turns ? Dimension::angular_acceleration : Dimension::acceleration);
    line("damping", path + ".damping", number(joint.damping),
         turns ? Dimension::angular_damping : Dimension::damping);
    drive(joint, path, turns);
  }

  void drive(const Joint& joint, const std::string& path, bool turns) {
    const auto value = [&](const char* key, double of, Dimension dimension) {
      if (of != 0.0 || is_known(path + "." + key))
        line(key, path + "." + key, number(of), dimension);
    };
    value("friction", joint.friction, turns ? Dimension::torque : Dimension::force);
    value("friction_speed", joint.friction_speed,
          turns ? Dimension::angular_velocity : Dimension::velocity);
    value("armature", joint.armature, turns ? Dimension::inertia : Dimension::mass);
    value("motor_turn", joint.motor_turn, turns ? Dimension::angle : Dimension::length);
    value("motor_poles", joint.motor_poles, Dimension::none);
    value("motor_slots", joint.motor_slots, Dimension::none);
    value("gear_teeth", joint.gear_teeth, Dimension::none);
  }

  void frame(const Frame& frame) {
    text_ += fmt::format("\n[[frame]]\nname = {}\nbody = {}\n", toml_string(frame.name),
                         toml_string(frame.body));
    pose("pose", "frame." + frame.name + ".pose", frame.pose);
  }

  void tendon(const Tendon& tendon) {
    const std::string path = "tendon." + tendon.name;
    text_ += fmt::format("\n[[tendon]]\nname = {}\n", toml_string(tendon.name));
    if (tendon.h0 != 0.0 || is_known(path + ".h0"))
      line("h0", path + ".h0", number(tendon.h0), Dimension::length);
    if (!tendon.pulleys.empty()) pulleys(tendon, path);
    if (!tendon.straights.empty()) straights(tendon, path);
  }

  void pulleys(const Tendon& tendon, const std::string& path) {
    text_ += "pulleys = [\n";
    for (std::size_t i = 0; i < tendon.pulleys.size(); ++i) {
      const PulleyRouting& pulley = tendon.pulleys[i];
      text_ += fmt::format("  {{ joint = {}, radius = {} }},\n", toml_string(pulley.joint),
                           quantity(fmt::format("{}.pulleys[{}].radius", path, i),
                                    number(pulley.radius), Dimension::length));
    }
    text_ += "]\n";
  }

  void straights(const Tendon& tendon, const std::string& path) {
    text_ += "straights = [\n";
    for (std::size_t i = 0; i < tendon.straights.size(); ++i) {
      const StraightRouting& straight = tendon.straights[i];
      const std::string own = fmt::format("{}.straights[{}]", path, i);
      text_ +=
          fmt::format("  {{ from_body = {}, from_point = {}, to_body = {}, to_point = {} }},\n",
                      toml_string(straight.from_body),
                      quantity(own + ".from_point", list(straight.from), Dimension::length),
                      toml_string(straight.to_body),
                      quantity(own + ".to_point", list(straight.to), Dimension::length));
    }
    text_ += "]\n";
  }

  void coupling(const JointCoupling& coupling) {
    text_ += fmt::format("\n[[coupling]]\ndependent = {}\nindependent = {}\n",
                         toml_string(coupling.dependent), toml_string(coupling.independent));
    line("ratio", fmt::format("coupling.{}.ratio", coupling.dependent), number(coupling.ratio),
         Dimension::none);
    const std::string path = fmt::format("coupling.{}.offset", coupling.dependent);
    if (coupling.offset != 0.0 || is_known(path))
      line("offset", path, number(coupling.offset),
           slides(coupling.dependent) ? Dimension::length : Dimension::angle);
  }

  bool slides(const std::string& name) const {
    for (const Joint& each : mechanism_.joints)
      if (each.name == name) return each.type == JointType::prismatic;
    return false;
  }

  void four_bar(const FourBarCoupling& bars) {
    const std::string path = "four_bar." + bars.dependent;
    text_ += fmt::format("\n[[four_bar]]\ndependent = {}\nindependent = {}\n",
                         toml_string(bars.dependent), toml_string(bars.independent));
    line("ground", path + ".ground", number(bars.ground), Dimension::length);
    line("crank", path + ".crank", number(bars.crank), Dimension::length);
    line("coupler", path + ".coupler", number(bars.coupler), Dimension::length);
    line("rocker", path + ".rocker", number(bars.rocker), Dimension::length);
    line("branch", toml_string(bars.branch < 0 ? "open" : "crossed"));
    line("follows",
         toml_string(bars.follows == FourBarCoupling::Follows::rocker ? "rocker" : "coupler"));
    line("crank_angle", path + ".crank_angle", number(bars.crank_angle), Dimension::angle);
  }

  void tendon_defaults() {
    text_ += "\n[tendon_defaults]\n";
    line("stiffness", "tendon_defaults.stiffness",
         range(mechanism_.tendon_stiffness_low, mechanism_.tendon_stiffness_high),
         Dimension::stiffness);
    line("max_force", "tendon_defaults.max_force", number(mechanism_.tendon_force_high),
         Dimension::force);
  }

  const Mechanism& mechanism_;
  std::string text_;
};

std::string csv_row(const Body& body, const std::string& provenance) {
  const auto [from, ref] = split_provenance(provenance);
  const Eigen::Vector3d& c = body.centre_of_mass;
  const Eigen::Matrix3d& i = body.inertia;
  std::string row = body.name;
  for (const double value :
       {body.mass, c[0], c[1], c[2], i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(0, 2), i(1, 2)})
    row += "," + number(value);
  return fmt::format("{},{},{}\n", row, from, csv_cell(ref));
}

std::string csv_table(const Mechanism& mechanism) {
  std::string text =
      "link,mass [kg],com_x [m],com_y [m],com_z [m],ixx [kg*m^2],iyy [kg*m^2],izz [kg*m^2],"
      "ixy [kg*m^2],ixz [kg*m^2],iyz [kg*m^2],from,ref\n";
  for (const Body& body : mechanism.bodies) {
    if (body.mass == 0.0) continue;
    const auto found = mechanism.provenance.find("body." + body.name + ".mass_properties");
    text += csv_row(body, found == mechanism.provenance.end() ? "assumed" : found->second);
  }
  return text;
}

/// What is written must say exactly what was to be written; else nothing is.
void require_round_trip(const Mechanism& mechanism, const ModelText& text) {
  const Mechanism again = parse_mechanism(
      {text.toml, text.csv, "mechanism.toml", "mass_properties.csv", text.names, "names.toml"});
  const ModelText second = describe_mechanism(again, "");
  const ModelText first = describe_mechanism(mechanism, "");
  if (first.toml != second.toml || first.csv != second.csv || first.names != second.names)
    throw std::runtime_error(
        "the mechanism does not read back as it was written; expected the same values");
}

}  // namespace

ModelText describe_mechanism(const Mechanism& mechanism, const std::string& comment) {
  const std::string head = comment.empty() ? "" : fmt::format("# {}\n", comment);
  const std::string names = source_names_text(mechanism);
  return {head + Describer(mechanism).toml(), head + csv_table(mechanism),
          names.empty() ? names : head + names};
}

std::map<std::string, std::string> mechanism_files(const Mechanism& mechanism,
                                                   const std::string& comment) {
  const ModelText text = describe_mechanism(mechanism, comment);
  require_round_trip(mechanism, text);
  std::map<std::string, std::string> files{{"mechanism.toml", text.toml},
                                           {"mass_properties.csv", text.csv}};
  if (!text.names.empty()) files["names.toml"] = text.names;
  return files;
}

}  // namespace sinew
