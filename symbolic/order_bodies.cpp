// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/order_bodies.h"

#include <fmt/format.h>

#include <map>
#include <set>

#include "symbolic/identifier.h"

namespace sinew {
namespace {

using Carriers = std::map<std::string, std::size_t>;  // body name -> index of the joint carrying it

void check_ends(const std::string& base, const std::vector<TreeBody>& bodies,
                const std::vector<TreeJoint>& joints, Findings& findings) {
  std::vector<std::string> names;
  for (const TreeBody& body : bodies) names.push_back(body.name);
  const std::set<std::string> known(names.begin(), names.end());
  names.push_back(base);
  for (const TreeJoint& joint : joints) {
    if (!known.contains(joint.parent) && joint.parent != base)
      findings.add(joint.parent_where,
                   fmt::format("joint '{}' has the unknown parent '{}'{}", joint.name, joint.parent,
                               did_you_mean(joint.parent, names)),
                   fmt::format("expected '{}' or the name of a body", base));
    if (joint.child == base)
      findings.add(joint.child_where,
                   fmt::format("joint '{}' carries the base '{}'", joint.name, base),
                   "expected the base to be fixed");
    else if (!known.contains(joint.child))
      findings.add(joint.child_where,
                   fmt::format("joint '{}' has the unknown child '{}'{}", joint.name, joint.child,
                               did_you_mean(joint.child, names)),
                   "expected the name of a body");
  }
}

Carriers find_carriers(const std::vector<TreeJoint>& joints, Findings& findings) {
  Carriers carriers;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto [first, is_new] = carriers.emplace(joints[i].child, i);
    if (!is_new)
      findings.add(joints[i].child_where,
                   fmt::format("body '{}' is carried by joint '{}' and by joint '{}'",
                               joints[i].child, joints[first->second].name, joints[i].name),
                   "expected one joint for each body");
  }
  return carriers;
}

/// The chain of parents of a body that never reaches the base, up to its repetition.
std::string cycle_through(const std::string& body, const std::vector<TreeJoint>& joints,
                          const Carriers& carriers) {
  std::string text = body;
  std::set<std::string> seen{body};
  for (std::string at = body;;) {
    const auto carrier = carriers.find(at);
    if (carrier == carriers.end()) return "";
    at = joints[carrier->second].parent;
    text += " <- " + at;
    if (!seen.insert(at).second) return text;
  }
}

void report_unreached(const TreeBody& body, const std::vector<TreeJoint>& joints,
                      const Carriers& carriers, Findings& findings) {
  if (!carriers.contains(body.name)) {
    findings.add(body.where, fmt::format("body '{}' is not connected", body.name),
                 "expected a joint with it as child");
    return;
  }
  const std::string cycle = cycle_through(body.name, joints, carriers);
  const SourceLocation& where = joints[carriers.at(body.name)].where;
  if (!cycle.empty())
    findings.add(where, fmt::format("body '{}' hangs on a cycle: {}", body.name, cycle),
                 "expected a tree from the base");
}

}  // namespace

std::vector<std::size_t> order_depth_first(const std::string& base,
                                           const std::vector<TreeBody>& bodies,
                                           const std::vector<TreeJoint>& joints,
                                           Findings& findings) {
  check_ends(base, bodies, joints, findings);
  const Carriers carriers = find_carriers(joints, findings);
  std::map<std::string, std::vector<std::size_t>> children;
  for (const auto& [child, joint] : carriers) children[joints[joint].parent];
  for (std::size_t i = 0; i < joints.size(); ++i)
    if (carriers.at(joints[i].child) == i) children[joints[i].parent].push_back(i);

  std::vector<std::size_t> order;
  std::set<std::string> reached{base};
  std::vector<std::string> open{base};  // a stack: last in, first visited
  while (!open.empty()) {
    const std::string body = open.back();
    open.pop_back();
    if (body != base) order.push_back(carriers.at(body));
    const std::vector<std::size_t>& next = children[body];
    for (auto joint = next.rbegin(); joint != next.rend(); ++joint)
      if (reached.insert(joints[*joint].child).second) open.push_back(joints[*joint].child);
  }
  for (const TreeBody& body : bodies)
    if (!reached.contains(body.name)) report_unreached(body, joints, carriers, findings);
  return order;
}

}  // namespace sinew
