// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/model/urdf_outline.h"

#include <fmt/format.h>
#include <tinyxml.h>

#include <algorithm>
#include <map>

#include "symbolic/files/identifier.h"
#include "symbolic/files/limits.h"
#include "symbolic/files/readable.h"
#include "symbolic/files/xml_checks.h"
#include "symbolic/files/xml_nesting.h"
#include "symbolic/model/unexpanded_xacro.h"
#include "symbolic/model/urdf_mimics.h"

namespace sinew {
namespace {

using Names = std::vector<std::string>;

class OutlineReader {
 public:
  OutlineReader(const std::string& file, Findings& findings, const UrdfRemarks& remarks)
      : file_(file), findings_(findings), remarks_(remarks), xml_(file, findings, remarks.notes) {}

  UrdfOutline read(std::string_view text) {
    if (!parse(text)) return outline_;
    TiXmlElement* robot = robot_element();
    if (robot == nullptr) return outline_;
    if (const TiXmlBase* macro = unexpanded_xacro(*robot)) {
      xml_.report(*macro, "this is a xacro file, which is not expanded", how_to_expand(file_));
      return outline_;
    }
    outline_.robot = name_of(*robot);
    outline_.robot_where = xml_.place(*robot);
    if (!read_children(*robot)) return outline_;
    if (outline_.links.empty())
      xml_.report(*robot, "the robot has no link", "expected at least one <link>");
    report_duplicates();
    find_root();
    if (findings_.any()) return outline_;
    resolve_mimics(outline_, findings_);
    if (findings_.any()) return outline_;
    TiXmlPrinter printer;
    document_.Accept(&printer);
    outline_.essence = printer.CStr();
    return outline_;
  }

 private:
  bool parse(std::string_view text) {
    const std::size_t zero = text.find('\0');
    if (zero != std::string_view::npos || nesting_depth(text) > limits::xml_nesting) {
      findings_.add({file_, 1, 1},
                    zero != std::string_view::npos
                        ? std::string("the file contains a zero byte")
                        : fmt::format("elements are nested more than {} deep", limits::xml_nesting),
                    "expected a URDF file");
      return false;
    }
    document_.SetTabSize(1);  // columns count characters
    const std::string copy(text);
    const char* end = document_.Parse(copy.c_str(), nullptr, TIXML_ENCODING_UTF8);
    if (!document_.Error()) return is_read_to_the_end(end == nullptr ? "" : end, copy);
    const bool is_placed = document_.ErrorRow() > 0;
    findings_.add(
        {file_, is_placed ? document_.ErrorRow() : 1, is_placed ? document_.ErrorCol() : 1},
        fmt::format("not well-formed XML: {}", document_.ErrorDesc()), "expected a URDF file");
    return false;
  }

  /// TinyXML stops silently at text outside the root element.
  bool is_read_to_the_end(std::string_view rest, std::string_view text) {
    const std::size_t skipped = rest.find_first_not_of(" \t\r\n");
    if (skipped == std::string_view::npos) return true;
    const std::string_view before = text.substr(0, text.size() - rest.size() + skipped);
    const std::size_t line_start = before.rfind('\n') + 1;  // 0 where there is none
    const auto lines = std::count(before.begin(), before.end(), '\n');
    findings_.add(
        {file_, static_cast<int>(lines) + 1, static_cast<int>(before.size() - line_start) + 1},
        "not well-formed XML: text outside the root element", "expected a URDF file");
    return false;
  }

  TiXmlElement* robot_element() {
    TiXmlElement* robot = document_.RootElement();
    if (robot == nullptr) {
      findings_.add({file_, 1, 1}, "the file has no element", "expected <robot name=\"...\">");
      return nullptr;
    }
    if (robot->ValueStr() != "robot") {
      xml_.report(*robot, fmt::format("the root element is <{}>", robot->ValueStr()),
                  "expected <robot name=\"...\">");
      return nullptr;
    }
    for (const TiXmlNode* next = robot->NextSibling(); next != nullptr; next = next->NextSibling())
      if (next->ToElement() != nullptr || next->ToText() != nullptr) {
        xml_.report(*next, "the document goes on after </robot>", "expected one <robot>");
        break;
      }
    return robot;
  }

  std::string name_of(const TiXmlElement& element) {
    const char* name = element.Attribute("name");
    if (name != nullptr && *name != '\0') return name;
    xml_.report(element, fmt::format("<{}> has no name", element.ValueStr()),
                fmt::format("expected <{} name=\"...\">", element.ValueStr()));
    return "";
  }

  Eigen::Vector3d origin_rpy(TiXmlElement& parent) {
    TiXmlElement* origin = xml_.only_child(parent, "origin", false);
    if (origin == nullptr) return Eigen::Vector3d::Zero();
    xml_.check_attributes(*origin, {"xyz", "rpy"});
    xml_.numbers(*origin, "xyz", 3, false);
    const auto rpy = xml_.numbers(*origin, "rpy", 3, false);
    return rpy ? Eigen::Vector3d(rpy->data()) : Eigen::Vector3d::Zero();
  }

  /// False where there are more of them than can be meant.
  bool read_children(TiXmlElement& robot) {
    xml_.keep_children(
        robot, {"link", "joint"},
        {"material", "gazebo", "transmission", "sensor", "ros2_control", "safety_controller"});
    std::size_t count = 0;
    for (TiXmlElement* each = robot.FirstChildElement(); each != nullptr;
         each = each->NextSiblingElement()) {
      if (++count > 2 * limits::entries) {
        xml_.report(*each, fmt::format("more than {} links and joints", 2 * limits::entries),
                    "expected a smaller robot");
        return false;
      }
      each->ValueStr() == "link" ? read_link(*each) : read_joint(*each);
    }
    return true;
  }

  void read_link(TiXmlElement& element) {
    UrdfLink link;
    link.name = name_of(element);
    link.where = link.mass_where = link.inertia_where = xml_.place(element);
    link.has_shape = element.FirstChildElement("visual") || element.FirstChildElement("collision");
    xml_.keep_children(element, {"inertial"},
                       {"visual", "collision", "contact", "sensor", "self_collision_checking"});
    if (TiXmlElement* inertial = xml_.only_child(element, "inertial", false))
      read_inertial(*inertial, link);
    outline_.links.push_back(std::move(link));
  }

  void read_inertial(TiXmlElement& inertial, UrdfLink& link) {
    link.has_inertial = true;
    xml_.keep_children(inertial, {"origin", "mass", "inertia"}, {});
    link.inertial_rpy = origin_rpy(inertial);
    if (TiXmlElement* mass = xml_.only_child(inertial, "mass", true)) {
      link.mass_where = xml_.place(*mass);
      xml_.check_attributes(*mass, {"value"});
      xml_.numbers(*mass, "value", 1, true);
    }
    if (TiXmlElement* inertia = xml_.only_child(inertial, "inertia", true)) {
      link.inertia_where = xml_.place(*inertia);
      xml_.check_attributes(*inertia, {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"});
      for (const char* name : {"ixx", "iyy", "izz"}) xml_.numbers(*inertia, name, 1, true);
      for (const char* name : {"ixy", "ixz", "iyz"}) read_product(*inertia, name);
    }
  }

  void read_product(TiXmlElement& inertia, const char* name) {
    xml_.numbers(inertia, name, 1, false);
    if (inertia.Attribute(name) != nullptr) return;
    xml_.note(inertia, fmt::format("<inertia> has no {}: 0 is assumed", name));
    inertia.SetAttribute(name, "0");
  }

  std::string end_of(TiXmlElement& joint, const char* name, SourceLocation& where) {
    where = xml_.place(joint);
    TiXmlElement* end = xml_.only_child(joint, name, true);
    if (end == nullptr) return "";
    where = xml_.place(*end);
    const char* link = end->Attribute("link");
    if (link != nullptr) return link;
    xml_.report(*end, fmt::format("<{}> has no link", name),
                fmt::format("expected <{} link=\"...\"/>", name));
    return "";
  }

  void read_joint(TiXmlElement& element) {
    UrdfJoint joint;
    joint.name = joint.ends.name = name_of(element);
    joint.ends.where = joint.limit_where = xml_.place(element);
    joint.type = type_of(element);
    xml_.keep_children(element, {"origin", "parent", "child", "axis", "limit", "mimic", "dynamics"},
                       {"calibration", "safety_controller"});
    joint.ends.parent = end_of(element, "parent", joint.ends.parent_where);
    joint.ends.child = end_of(element, "child", joint.ends.child_where);
    joint.rpy = origin_rpy(element);
    if (joint.type != "fixed") read_motion(element, joint);
    outline_.joints.push_back(std::move(joint));
  }

  /// Joints with several degrees of freedom are bases that move (a ship, a cart): here the base
  /// rests, and what they carry is a mechanism all the same.
  std::string held_type(TiXmlElement& joint, const std::string& type) {
    const char* name = joint.Attribute("name");
    remarks_.warnings.push_back(fmt::format(
        "{}: {}", to_text(xml_.place(joint)),
        message_part(fmt::format(
            "the {} joint '{}' is held where its origin puts it: a mechanism "
            "here has joints with one degree of freedom. To let it move, "
            "write it as {} joints in a row",
            type, name == nullptr ? "" : name,
            type == "planar" ? "2 prismatic and 1 continuous" : "3 prismatic and 3 revolute"))));
    joint.SetAttribute("type", "fixed");
    return "fixed";
  }

  std::string type_of(TiXmlElement& joint) {
    static const Names moving{"revolute", "continuous", "prismatic", "fixed"};
    const char* given = joint.Attribute("type");
    const std::string type = given == nullptr ? "" : given;
    const std::string expected = fmt::format("expected one of: {}", listed(moving));
    if (type == "floating" || type == "planar") return held_type(joint, type);
    if (std::find(moving.begin(), moving.end(), type) == moving.end())
      xml_.report(joint,
                  given == nullptr
                      ? "the joint has no type"
                      : fmt::format("unknown joint type '{}'{}", type, did_you_mean(type, moving)),
                  expected);
    return type;
  }

  void read_motion(TiXmlElement& element, UrdfJoint& joint) {
    if (TiXmlElement* axis = xml_.only_child(element, "axis", false)) {
      xml_.check_attributes(*axis, {"xyz"});
      const auto xyz = xml_.numbers(*axis, "xyz", 3, true);
      if (xyz && (*xyz)[0] == 0.0 && (*xyz)[1] == 0.0 && (*xyz)[2] == 0.0)
        xml_.report(*axis, fmt::format("the axis of joint '{}' is zero", joint.name),
                    "expected a direction");
    }
    read_limit(element, joint);
    if (TiXmlElement* dynamics = xml_.only_child(element, "dynamics", false))
      read_dynamics(*dynamics);
    if (TiXmlElement* mimic = xml_.only_child(element, "mimic", false)) read_mimic(*mimic, joint);
  }

  /// urdfdom wants a complete limit where sinew can do without: what is missing is filled in.
  void read_limit(TiXmlElement& element, UrdfJoint& joint) {
    TiXmlElement* limit = xml_.only_child(element, "limit", false);
    if (limit == nullptr) {
      TiXmlElement empty("limit");
      limit = element.InsertEndChild(empty)->ToElement();
    } else {
      joint.limit_where = xml_.place(*limit);
      xml_.check_attributes(*limit, {"lower", "upper", "effort", "velocity"});
    }
    const auto lower = xml_.numbers(*limit, "lower", 1, false);
    const auto upper = xml_.numbers(*limit, "upper", 1, false);
    const auto velocity = xml_.numbers(*limit, "velocity", 1, false);
    xml_.numbers(*limit, "effort", 1, false);
    joint.has_velocity = velocity && (*velocity)[0] > 0.0;
    set_range(lower ? lower->front() : 0.0, upper ? upper->front() : 0.0, *limit, joint);
    for (const char* name : {"effort", "velocity"})
      if (limit->Attribute(name) == nullptr) limit->SetAttribute(name, "0");
  }

  /// 0 to 0 is the format's default and what exporters write where no limit was set, and a range
  /// beyond all use is no limit either. Any other single value is where the joint stands.
  void set_range(double lower, double upper, TiXmlElement& limit, UrdfJoint& joint) {
    constexpr double no_limit = 1e4;  // rad or m
    if (joint.type == "continuous" || (lower == 0.0 && upper == 0.0)) return;
    if (upper - lower > no_limit) {
      xml_.note(limit, fmt::format("the range of joint '{}', {} to {}, is taken as none",
                                   joint.name, lower, upper));
      return;
    }
    if (lower == upper) {
      joint.held = lower;
      xml_.note(limit,
                fmt::format("the range of joint '{}' is one value: the joint stands at {} {}",
                            joint.name, lower, joint.type == "prismatic" ? "m" : "rad"));
      return;
    }
    if (lower > upper)
      xml_.note(limit, fmt::format("the limits of joint '{}' are swapped: {} to {} is taken",
                                   joint.name, upper, lower));
    joint.has_range = true;
    joint.low = std::min(lower, upper);
    joint.high = std::max(lower, upper);
  }

  void read_dynamics(TiXmlElement& dynamics) {
    xml_.check_attributes(dynamics, {"damping", "friction"});
    const auto damping = xml_.numbers(dynamics, "damping", 1, false);
    const auto friction = xml_.numbers(dynamics, "friction", 1, false);
    if (damping && (*damping)[0] < 0.0)
      xml_.report(dynamics, "the damping is negative", "expected a damping >= 0");
    if (friction && (*friction)[0] < 0.0)
      xml_.report(dynamics, "the friction is negative", "expected a friction >= 0");
    if (!damping && !friction) dynamics.SetAttribute("damping", "0");  // urdfdom wants one of them
  }

  void read_mimic(TiXmlElement& mimic, UrdfJoint& joint) {
    joint.mimic_where = xml_.place(mimic);
    xml_.check_attributes(mimic, {"joint", "multiplier", "offset"});
    const char* other = mimic.Attribute("joint");
    if (other == nullptr)
      xml_.report(mimic, "<mimic> has no joint",
                  "expected <mimic joint=\"...\" multiplier=\"...\"/>");
    else
      joint.mimics = other;
    const auto multiplier = xml_.numbers(mimic, "multiplier", 1, false);
    const auto offset = xml_.numbers(mimic, "offset", 1, false);
    if (multiplier) joint.multiplier = multiplier->front();
    if (offset) joint.offset = offset->front();
  }

  void report_duplicates() {
    std::map<std::string, int> links, joints;
    for (const UrdfLink& link : outline_.links)
      if (!link.name.empty() && ++links[link.name] > 1)
        findings_.add(link.where, fmt::format("link '{}' is defined a second time", link.name),
                      "expected different names");
    for (const UrdfJoint& joint : outline_.joints)
      if (!joint.name.empty() && ++joints[joint.name] > 1)
        findings_.add(joint.ends.where,
                      fmt::format("joint '{}' is defined a second time", joint.name),
                      "expected different names");
  }

  void find_root() {
    std::map<std::string, int> carriers;
    for (const UrdfLink& link : outline_.links) carriers[link.name] = 0;
    bool is_plain = !findings_.any();  // every child is a link, and of one joint only
    Names roots;
    SourceLocation second;
    for (const UrdfJoint& joint : outline_.joints) {
      const auto child = carriers.find(joint.ends.child);
      is_plain = is_plain && child != carriers.end() && ++child->second == 1;
    }
    for (const UrdfLink& link : outline_.links) {
      if (carriers.at(link.name) > 0 || link.name.empty()) continue;
      if (outline_.root.empty()) outline_.root = link.name;
      if (roots.size() == 1) second = link.where;
      roots.push_back(link.name);
    }
    if (roots.size() > 1 && is_plain)
      findings_.add(
          second,
          fmt::format("{} root links: {}", roots.size() == 2 ? "two" : "several", listed(roots)),
          "expected one link that is no joint's child: add a link, and a fixed joint "
          "from it to each of these that says where it stands");
    if (outline_.root.empty() && !outline_.links.empty() && !findings_.any())
      findings_.add(outline_.links[0].where,
                    "no root link: every link is some joint's child, so there is a cycle",
                    "expected one link that is no joint's child");
  }

  const std::string& file_;
  Findings& findings_;
  const UrdfRemarks& remarks_;
  XmlChecks xml_;
  TiXmlDocument document_;
  UrdfOutline outline_;
};

}  // namespace

UrdfOutline outline_urdf(std::string_view text, const std::string& file, Findings& findings,
                         const UrdfRemarks& remarks) {
  return OutlineReader(file, findings, remarks).read(text);
}

}  // namespace sinew
