// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/model/order_bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "symbolic/files/identifier.h"

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

/// Follows parents from a body and reports the cycle they end in, once for each cycle.
void report_cycle(const std::string& body, const std::vector<TreeJoint>& joints,
                  const Carriers& carriers, std::set<std::string>& visited, Findings& findings) {
  std::vector<std::string> path;
  std::string at = body;
  while (carriers.contains(at) && visited.insert(at).second) {
    path.push_back(at);
    at = joints[carriers.at(at)].parent;
  }
  auto member = std::find(path.begin(), path.end(), at);
  if (member == path.end()) return;  // ends at an unknown or unconnected body, or is known
  constexpr std::ptrdiff_t longest = 8;
  const bool is_long = path.end() - member > longest;
  const std::string chain =
      fmt::format("{}", fmt::join(member, is_long ? member + longest : path.end(), " <- "));
  findings.add(joints[carriers.at(at)].where,
               fmt::format("body '{}' is on a cycle: {} <- {}", at, chain, is_long ? "..." : at),
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
  std::set<std::string> visited;
  for (const TreeBody& body : bodies) {
    if (reached.contains(body.name)) continue;
    if (!carriers.contains(body.name))
      findings.add(body.where, fmt::format("body '{}' is not connected", body.name),
                   "expected a joint with it as child");
    report_cycle(body.name, joints, carriers, visited, findings);
  }
  return order;
}

}  // namespace sinew
