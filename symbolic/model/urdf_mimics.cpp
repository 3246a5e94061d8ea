// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/model/urdf_mimics.h"

#include <fmt/format.h>

#include <map>

#include "symbolic/files/identifier.h"

namespace sinew {
namespace {

/// The position of a joint: ratio times that of `leader`, plus offset. Without leader it is the
/// offset alone.
struct Followed {
  std::string leader;
  double ratio = 1.0;
  double offset = 0.0;
};

class MimicResolver {
 public:
  MimicResolver(UrdfOutline& outline, Findings& findings) : outline_(outline), findings_(findings) {
    for (const UrdfJoint& joint : outline.joints) {
      joints_[joint.name] = &joint;
      names_.push_back(joint.name);
    }
  }

  void run() {
    std::vector<Followed> all;
    for (const UrdfJoint& joint : outline_.joints) all.push_back(follow(joint));
    for (std::size_t i = 0; i < all.size(); ++i) rewrite(outline_.joints[i], all[i]);
  }

 private:
  /// Along the mimics to what moves by itself, or stands still.
  Followed follow(const UrdfJoint& start) {
    Followed result{start.name, 1.0, 0.0};
    const UrdfJoint* at = &start;
    for (std::size_t steps = 0; moves(*at) && !at->mimics.empty(); ++steps) {
      const auto next = joints_.find(at->mimics);
      if (next == joints_.end())
        return wrong(*at, fmt::format("the unknown joint '{}'{}", at->mimics,
                                      did_you_mean(at->mimics, names_)));
      if (next->second == at) return wrong(*at, "itself");
      if (steps > outline_.joints.size()) return wrong(start, "itself, by way of other joints");
      result.offset += result.ratio * at->offset;
      result.ratio *= at->multiplier;
      at = next->second;
      result.leader = at->name;
    }
    if (moves(*at) && result.ratio != 0.0) return result;
    return {"", 0.0, result.offset + result.ratio * at->held.value_or(0.0)};
  }

  static bool moves(const UrdfJoint& joint) { return joint.type != "fixed" && !joint.held; }

  Followed wrong(const UrdfJoint& joint, const std::string& what) {
    findings_.add(joint.mimic_where, fmt::format("joint '{}' mimics {}", joint.name, what),
                  "expected another joint that moves by itself");
    return {joint.name, 1.0, 0.0};
  }

  static void rewrite(UrdfJoint& joint, const Followed& followed) {
    if (joint.type == "fixed") return;
    if (followed.leader.empty()) joint.held = followed.offset;
    joint.mimics = followed.leader == joint.name ? "" : followed.leader;
    joint.multiplier = followed.ratio;
    joint.offset = followed.offset;
  }

  UrdfOutline& outline_;
  Findings& findings_;
  std::map<std::string, const UrdfJoint*> joints_;
  std::vector<std::string> names_;
};

}  // namespace

void resolve_mimics(UrdfOutline& outline, Findings& findings) {
  MimicResolver(outline, findings).run();
}

}  // namespace sinew
