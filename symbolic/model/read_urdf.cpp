// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/model/read_urdf.h"

#include <console_bridge/console.h>
#include <fmt/format.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <map>
#include <set>

#include "symbolic/files/identifier.h"
#include "symbolic/files/model_name.h"
#include "symbolic/files/read_text.h"
#include "symbolic/files/readable.h"
#include "symbolic/model/check_mechanism.h"
#include "symbolic/model/held_joints.h"
#include "symbolic/model/rotation.h"
#include "symbolic/model/singular_mass_matrix.h"
#include "symbolic/model/urdf_outline.h"

namespace sinew {
namespace {

/// While it lives, urdfdom's messages are collected instead of printed.
class CollectedMessages : public console_bridge::OutputHandler {
 public:
  CollectedMessages() { console_bridge::useOutputHandler(this); }
  ~CollectedMessages() override { console_bridge::restorePreviousOutputHandler(); }
  CollectedMessages(const CollectedMessages&) = delete;
  CollectedMessages& operator=(const CollectedMessages&) = delete;
  void log(const std::string& text, console_bridge::LogLevel, const char*, int) override {
    text_ += (text_.empty() ? "" : ", ") + text;
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// C identifiers made from the names of a file, different from each other. What is an identifier in
/// the file keeps its name, so that no name stands for two things.
class Renaming {
 public:
  explicit Renaming(std::set<std::string> taken) : taken_(std::move(taken)) {}

  void keep(const std::string& original) {
    if (make_identifier(original) == original && !taken_.contains(original)) kept_.insert(original);
  }

  std::string operator()(const std::string& original, std::string_view kind,
                         const SourceLocation& where, std::vector<std::string>& notes) {
    if (kept_.contains(original)) return original;
    const std::string made = make_identifier(original);
    const bool says_nothing = made == make_identifier("") && made != original;
    const std::string start = says_nothing ? std::string(kind) : made;
    std::string name = start;
    for (int i = 1; kept_.contains(name) || !taken_.insert(name).second; ++i)
      name = fmt::format("{}_{}", start.substr(0, 58), i);
    notes.push_back(message_part(
        fmt::format("{}: {} '{}' is called {}", to_text(where), kind, original, name)));
    return name;
  }

 private:
  std::set<std::string> taken_, kept_;
};

/// A name that another file may quote: readable text.
std::string source_name_of(const std::string& original, const std::string& name) {
  return original == name || readable_line(original) != original ? "" : original;
}

/// Text fit for any file: bytes outside printable ASCII become question marks.
std::string printable(std::string text) {
  for (char& c : text)
    if (c < ' ' || c > '~') c = '?';
  return text;
}

Eigen::Vector3d to_vector(const urdf::Vector3& v) {
  return {v.x, v.y, v.z};
}

class UrdfReader {
 public:
  UrdfReader(const std::string& file, Findings& findings, const UrdfRemarks& remarks)
      : file_(file), findings_(findings), remarks_(remarks), notes_(remarks.notes) {}

  Mechanism read(std::string_view text, const Eigen::Vector3d& gravity) {
    outline_ = outline_urdf(text, file_, findings_, remarks_);
    findings_.raise_if_any();
    order_joints();
    read_model();
    findings_.raise_if_any();
    name_mechanism();
    mechanism_.gravity = gravity;
    mechanism_.provenance["mechanism.gravity"] = "assumed";
    for (const std::size_t at : order_) add(outline_.joints[at]);
    for (const std::size_t at : order_) add_coupling(outline_.joints[at]);
    add_frames();
    findings_.raise_if_any();
    check_mechanism(mechanism_, findings_);
    findings_.raise_if_any();
    note_masses();
    return std::move(mechanism_);
  }

 private:
  void note(const SourceLocation& where, const std::string& what) {
    notes_.push_back(fmt::format("{}: {}", to_text(where), message_part(what)));
  }

  void note_masses() {
    if (is_massless(mechanism_)) return note(outline_.robot_where, why_no_dynamics(mechanism_));
    for (std::size_t i = 0; i < mechanism_.bodies.size(); ++i) {
      const UrdfLink& link = *links_.at(outline_.joints[order_[i]].ends.child);
      if (link.has_shape && !link.has_inertial)
        note(link.where,
             fmt::format("link '{}' has a shape and no <inertial>: it is taken as massless",
                         link.name));
    }
    const auto joint = joint_without_inertia(mechanism_);
    if (joint) note(mechanism_.joints[*joint].where, *note_of_singular_mass_matrix(mechanism_));
  }

  void order_joints() {
    std::vector<TreeBody> bodies;
    std::vector<TreeJoint> joints;
    for (const UrdfLink& link : outline_.links) {
      links_[link.name] = &link;
      if (link.name != outline_.root) bodies.push_back({link.name, link.where});
    }
    for (const UrdfJoint& joint : outline_.joints) {
      joints.push_back(joint.ends);
      rename_joint_.keep(joint.name);
      rename_body_.keep(joint.ends.child);
    }
    order_ = order_depth_first(outline_.root, bodies, joints, findings_);
    findings_.raise_if_any();
    const auto moves = [&](std::size_t at) {
      return outline_.joints[at].type != "fixed" && !outline_.joints[at].held;
    };
    if (std::none_of(order_.begin(), order_.end(), moves))
      findings_.add(outline_.robot_where, "the robot has no moving joint",
                    "expected at least one <joint> that is not fixed");
    findings_.raise_if_any();
  }

  void read_model() {
    CollectedMessages messages;
    model_ = urdf::parseURDF(outline_.essence);
    if (!model_)
      findings_.add({file_, 0, 0}, fmt::format("urdfdom refuses the file: {}", messages.text()),
                    "expected a robot urdfdom can read");
  }

  void name_mechanism() {
    mechanism_.name = make_model_name(outline_.robot);
    if (mechanism_.name != outline_.robot)
      note(outline_.robot_where,
           fmt::format("robot '{}' is called {}", outline_.robot, mechanism_.name));
    mechanism_.description =
        fmt::format("Robot '{}', imported from URDF", printable(outline_.robot));
    body_names_[outline_.root] = -1;
    const UrdfLink& root = *links_.at(outline_.root);
    if (root.has_inertial)
      note(root.where,
           fmt::format("the mass of the root link '{}' is ignored: the base is fixed", root.name));
  }

  void add(const UrdfJoint& outline) {
    const urdf::Joint& source = *model_->getJoint(outline.name);
    Joint joint;
    joint.where = outline.ends.where;
    joint.name = rename_joint_(outline.name, "joint", outline.ends.where, notes_);
    joint.source_name = source_name_of(outline.name, joint.name);
    joint.parent = body_names_.at(outline.ends.parent);
    joint.origin.rotation = rotation_from_rpy(outline.rpy);
    joint.origin.translation = to_vector(source.parent_to_joint_origin_transform.position);
    if (outline.type == "fixed") joint.type = JointType::fixed;
    if (outline.held) hold(outline, source, joint);
    set_origin_provenance("joint." + joint.name + ".origin", joint.origin);
    if (joint.type != JointType::fixed) set_motion(outline, source, joint);
    joint_names_[outline.name] = joint.name;
    body_names_[outline.ends.child] = static_cast<int>(mechanism_.bodies.size());
    mechanism_.joints.push_back(std::move(joint));
    add_body(*links_.at(outline.ends.child));
  }

  void set_from(const std::string& path) { mechanism_.provenance[path] = "urdf"; }

  void set_origin_provenance(const std::string& path, const Transform& origin) {
    if (!origin.translation.isZero(0.0)) set_from(path + ".xyz");
    if (origin.rotation != Eigen::Matrix3d::Identity())
      set_from(path + (exact_rpy(origin.rotation) ? ".rpy" : ".rotation"));
  }

  static JointType moving_type(const UrdfJoint& outline) {
    return outline.type == "prismatic" ? JointType::prismatic : JointType::revolute;
  }

  static void hold(const UrdfJoint& outline, const urdf::Joint& source, Joint& joint) {
    joint.type = moving_type(outline);
    joint.axis = unit_axis(to_vector(source.axis));
    fix_at(joint, *outline.held);
    joint.origin.rotation = snapped(joint.origin.rotation);
    joint.axis = Eigen::Vector3d::UnitZ();  // says nothing
  }

  void set_motion(const UrdfJoint& outline, const urdf::Joint& source, Joint& joint) {
    const std::string path = "joint." + joint.name;
    joint.type = moving_type(outline);
    joint.axis = unit_axis(to_vector(source.axis));
    if (outline.has_range) {
      joint.low = outline.low;
      joint.high = outline.high;
    } else if (outline.type == "prismatic") {
      joint.low = -1.0;
      joint.high = 1.0;
    }
    if (!outline.has_range && outline.type != "continuous")
      note(outline.limit_where,
           fmt::format("joint '{}' has no range: {} is assumed", outline.name,
                       outline.type == "prismatic" ? "-1 to 1 m" : "-pi to pi"));
    if (outline.has_velocity) joint.max_velocity = source.limits->velocity;
    if (source.dynamics) {
      joint.damping = source.dynamics->damping;
      joint.friction = source.dynamics->friction;
      if (joint.friction != 0.0) mechanism_.provenance[path + ".friction"] = "urdf";
    }
    mechanism_.provenance[path + ".range"] = outline.has_range ? "urdf" : "assumed";
    mechanism_.provenance[path + ".max_velocity"] = outline.has_velocity ? "urdf" : "assumed";
    mechanism_.provenance[path + ".max_acceleration"] = "assumed";
    mechanism_.provenance[path + ".damping"] = source.dynamics ? "urdf" : "assumed";
  }

  void add_body(const UrdfLink& outline) {
    Body body;
    body.where = outline.where;
    body.name = rename_body_(outline.name, "link", outline.where, notes_);
    body.source_name = source_name_of(outline.name, body.name);
    const auto inertial = model_->getLink(outline.name)->inertial;
    if (inertial) set_mass(outline, *inertial, body);
    mechanism_.bodies.push_back(std::move(body));
  }

  void set_mass(const UrdfLink& outline, const urdf::Inertial& source, Body& body) {
    body.mass = source.mass;
    body.centre_of_mass = to_vector(source.origin.position);
    Eigen::Matrix3d inertia;
    inertia << source.ixx, source.ixy, source.ixz, source.ixy, source.iyy, source.iyz, source.ixz,
        source.iyz, source.izz;
    const Eigen::Matrix3d turn = rotation_from_rpy(outline.inertial_rpy);
    const Eigen::Matrix3d turned = turn * inertia * turn.transpose();
    body.inertia =
        turn.isIdentity(0.0) ? inertia : Eigen::Matrix3d(0.5 * (turned + turned.transpose()));
    set_from("body." + body.name + ".mass_properties");
    check_mass(outline, body);
  }

  void check_mass(const UrdfLink& outline, Body& body) {
    if (body.mass < 0.0)
      findings_.add(outline.mass_where,
                    fmt::format("the mass of link '{}' is {} kg", outline.name, body.mass),
                    "expected a mass >= 0");
    const bool has_inertia = !body.inertia.isZero(0.0);
    if (body.mass == 0.0 && has_inertia)
      findings_.add(outline.mass_where,
                    fmt::format("link '{}' has inertia but no mass", outline.name),
                    "expected a mass > 0, or no <inertial>");
    if (body.mass == 0.0) body.centre_of_mass.setZero();  // says nothing
    if (const auto cleaned = without_negative_rounding(body.inertia, body.mass)) {
      note(outline.inertia_where,
           fmt::format("link '{}': {}; what is negative by rounding is taken as zero", outline.name,
                       principal_moments_text(body.inertia)));
      body.inertia = *cleaned;
    }
    const auto strictest = strictest_check(body.inertia);
    if (!strictest)
      findings_.add(outline.inertia_where,
                    fmt::format("link '{}': {}", outline.name,
                                *wrong_inertia(body.inertia, InertiaCheck::as_given)),
                    "expected no negative principal moment");
    else if (strictest != InertiaCheck::physical && body.mass > 0.0)
      note(outline.inertia_where,
           fmt::format("link '{}': {}; taken as it is", outline.name,
                       *wrong_inertia(body.inertia, InertiaCheck::physical)));
  }

  void add_coupling(const UrdfJoint& outline) {
    if (outline.mimics.empty()) return;
    const std::string& name = joint_names_.at(outline.name);
    mechanism_.couplings.push_back({name, joint_names_.at(outline.mimics), outline.multiplier,
                                    outline.offset, outline.mimic_where});
    if (outline.offset != 0.0) set_from("coupling." + name + ".offset");
    set_from("coupling." + name + ".ratio");
  }

  /// The end of a chain is its tip; the leaves of a tree carry their links' names.
  void add_frames() {
    std::vector<bool> is_leaf(mechanism_.bodies.size(), true);
    for (const Joint& joint : mechanism_.joints)
      if (joint.parent >= 0) is_leaf[static_cast<std::size_t>(joint.parent)] = false;
    const bool is_chain = std::count(is_leaf.begin(), is_leaf.end(), true) == 1;
    for (std::size_t i = 0; i < is_leaf.size(); ++i)
      if (is_leaf[i]) {
        const Body& body = mechanism_.bodies[i];
        mechanism_.frames.push_back({is_chain ? "tip" : body.name, body.name, {}, body.where});
      }
  }

  const std::string& file_;
  Findings& findings_;
  const UrdfRemarks& remarks_;
  std::vector<std::string>& notes_;
  UrdfOutline outline_;
  std::map<std::string, const UrdfLink*> links_;
  std::vector<std::size_t> order_;
  urdf::ModelInterfaceSharedPtr model_;
  Mechanism mechanism_;
  std::map<std::string, int> body_names_;           ///< link -> body index
  std::map<std::string, std::string> joint_names_;  ///< name in the file -> identifier
  Renaming rename_body_{{"base"}};
  Renaming rename_joint_{{}};
};

}  // namespace

Mechanism parse_urdf(std::string_view text, const std::string& name, const Eigen::Vector3d& gravity,
                     std::vector<std::string>* notes, std::vector<std::string>* warnings) {
  Findings findings;
  std::vector<std::string> ignored;
  std::vector<std::string>& told = notes == nullptr ? ignored : *notes;
  const UrdfRemarks remarks{told, warnings == nullptr ? told : *warnings};
  return UrdfReader(name, findings, remarks).read(text, gravity);
}

Mechanism read_urdf(const std::filesystem::path& file, const Eigen::Vector3d& gravity,
                    std::vector<std::string>* notes, std::vector<std::string>* warnings) {
  Findings findings;
  const std::string text = read_text(file, findings);
  findings.raise_if_any();
  return parse_urdf(text, file.string(), gravity, notes, warnings);
}

}  // namespace sinew
