// SPDX-License-Identifier: GPL-3.0-or-later
// A mechanism in the drawing. Of a pulley the model knows the moment arm alone: the tendon is drawn
// around a pulley of that radius on the joint's axis, through the axis of joints that it does not
// act on, and ends on the link behind its last pulley.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "cli/report/scene_parts.h"
#include "symbolic/dynamics/coordinates.h"

namespace sinew {
namespace {

using Eigen::Vector3d;

class MechanismWriter {
 public:
  MechanismWriter(SceneWriter& scene, const Mechanism& mechanism, const MechanismPlace& place)
      : scene_(scene), mechanism_(mechanism), place_(place) {}

  void run() {
    base_ = scene_.moving_frames(place_.group.empty() ? mechanism_.name : place_.group,
                                 place_.parent, place_.base, place_.poses, place_.arguments,
                                 static_cast<int>(mechanism_.bodies.size()), 3);
    for (std::size_t i = 0; i < mechanism_.bodies.size(); ++i) add_link(i);
    for (std::size_t i = 0; i < mechanism_.frames.size(); ++i) add_frame(mechanism_.frames[i], i);
    if (mechanism_.frames.empty() && !mechanism_.bodies.empty()) add_frame({}, 0);
    for (std::size_t t = 0; t < mechanism_.tendons.size(); ++t) add_tendon(t);
  }

 private:
  const Joint& joint(int body) const { return mechanism_.joints[static_cast<std::size_t>(body)]; }
  int frame_of(int body) const { return base_ + 1 + body; }
  std::string named(const std::string& name) const {
    return place_.group.empty() ? name : place_.group + " " + name;
  }

  int body_named(const std::string& name) const {
    for (std::size_t i = 0; i < mechanism_.bodies.size(); ++i)
      if (mechanism_.bodies[i].name == name) return static_cast<int>(i);
    return -1;
  }

  /// From the base's to its end the longest way that links reach [m]; for sizes of what is drawn.
  double reach() const {
    double sum = 0.0;
    for (const Joint& each : mechanism_.joints) sum += each.origin.translation.norm();
    for (const Frame& each : mechanism_.frames) sum += each.pose.translation.norm();
    return sum > 0.0 ? sum : 0.1;
  }

  void add_link(std::size_t index) {
    const int i = static_cast<int>(index);
    const Joint& own = joint(i);
    const Body& body = mechanism_.bodies[index];
    scene_.body(body, named(body.source_name.empty() ? body.name : body.source_name), frame_of(i));
    if (own.origin.translation.norm() > 0.0)
      scene_.bone(named(own.name), own.parent < 0 ? base_ : frame_of(own.parent), Vector3d::Zero(),
                  own.parent < 0 ? base_ : frame_of(own.parent), own.origin.translation);
    if (own.type != JointType::fixed)
      scene_.joint(named(own.source_name.empty() ? own.name : own.source_name), frame_of(i),
                   own.axis.normalized(), 0.06 * std::min(reach(), 0.5) + 0.02 * reach());
  }

  void add_frame(const Frame& frame, std::size_t number) {
    const bool last = mechanism_.frames.empty();
    const int body = last ? static_cast<int>(mechanism_.bodies.size()) - 1 : body_named(frame.body);
    const int carrier = body < 0 ? base_ : frame_of(body);
    scene_.bone(named(frame.name), carrier, Vector3d::Zero(), carrier, frame.pose.translation);
    if (number == 0)
      scene_.tip(
          place_.group.empty() ? (last ? mechanism_.bodies.back().name : frame.name) : place_.group,
          carrier, frame.pose.translation, place_.jacobian, place_.arguments, base_);
  }

  /// Where a body leads on from its joint, in its frame: to the next joint on the way to `towards`,
  /// to its frame, or to its centre of mass.
  Vector3d onward(int body, int towards) const {
    for (int at = towards; at >= 0; at = joint(at).parent)
      if (joint(at).parent == body) return joint(at).origin.translation;
    for (std::size_t i = 0; i < mechanism_.joints.size(); ++i)
      if (mechanism_.joints[i].parent == body && mechanism_.joints[i].origin.translation.norm() > 0)
        return mechanism_.joints[i].origin.translation;
    for (const Frame& frame : mechanism_.frames)
      if (body_named(frame.body) == body) return frame.pose.translation;
    return mechanism_.bodies[static_cast<std::size_t>(body)].centre_of_mass;
  }

  static Vector3d across(const Vector3d& v, const Vector3d& axis) { return v - v.dot(axis) * axis; }

  struct Bend {
    Vector3d axis;  ///< in the child's frame, which is the joint's
    Vector3d in;    ///< direction of the link before it, in the parent's frame
    Vector3d out;   ///< and of that behind it, in the child's
  };

  Bend bend_at(int body, int towards) const {
    const Joint& own = joint(body);
    Bend bend;
    bend.axis = own.axis.normalized();
    bend.out = across(onward(body, towards), bend.axis);
    if (bend.out.norm() < 1e-9) bend.out = bend.axis.unitOrthogonal();
    bend.out.normalize();
    const Vector3d axis_before = own.origin.rotation * bend.axis;
    bend.in =
        own.parent < 0 ? Vector3d(Vector3d::Zero()) : across(own.origin.translation, axis_before);
    if (bend.in.norm() < 1e-9) bend.in = own.origin.rotation * bend.out;
    bend.in.normalize();
    return bend;
  }

  double radius_at(const Tendon& tendon, int body) const {
    double radius = 0.0;
    for (const PulleyRouting& pulley : tendon.pulleys)
      if (pulley.joint == joint(body).name) radius += pulley.radius;
    return radius;
  }

  /// Bodies from behind `from` to the joint of the last pulley.
  std::vector<int> chain_of(const Tendon& tendon, int from) const {
    std::vector<int> longest;
    for (const PulleyRouting& pulley : tendon.pulleys)
      for (std::size_t i = 0; i < mechanism_.joints.size(); ++i) {
        if (mechanism_.joints[i].name != pulley.joint) continue;
        std::vector<int> chain;
        int at = static_cast<int>(i);
        for (; at >= 0 && at != from; at = joint(at).parent) chain.insert(chain.begin(), at);
        if (at == from && chain.size() > longest.size()) longest = chain;
      }
    return longest;
  }

  void add_tendon(std::size_t number) {
    const Tendon& tendon = mechanism_.tendons[number];
    const std::size_t channel = place_.channels.empty() ? number : place_.channels.at(number);
    const auto before = place_.before.find(channel);
    Json path = before == place_.before.end() ? Json(Json::array()) : before->second;
    int from = -1;
    for (const StraightRouting& straight : tendon.straights) {
      const int a = body_named(straight.from_body), b = body_named(straight.to_body);
      path.push_back(path_point(a < 0 ? base_ : frame_of(a), straight.from));
      path.push_back(path_point(b < 0 ? base_ : frame_of(b), straight.to));
      from = b;
    }
    const std::vector<int> chain = chain_of(tendon, from);
    if (!chain.empty()) add_pulleys(tendon, chain, path.empty(), path);
    scene_.tendon(channel, named(tendon.name), std::move(path));
  }

  void add_pulleys(const Tendon& tendon, const std::vector<int>& chain, bool starts, Json& path) {
    const int last = chain.back();
    if (starts) {
      const Bend bend = bend_at(chain.front(), last);
      const Joint& first = joint(chain.front());
      const Vector3d side = (first.origin.rotation * bend.axis).cross(bend.in);
      path.push_back(path_point(first.parent < 0 ? base_ : frame_of(first.parent),
                                first.origin.translation - 0.16 * reach() * bend.in -
                                    radius_at(tendon, chain.front()) * side));
    }
    for (const int body : chain) {
      const double radius = radius_at(tendon, body);
      const Bend bend = bend_at(body, last);
      if (radius == 0.0 || joint(body).type != JointType::revolute) {
        path.push_back(path_point(frame_of(body), Vector3d::Zero()));
        continue;
      }
      const int parent = joint(body).parent;
      path.push_back({{"in", parent < 0 ? base_ : frame_of(parent)},
                      {"out", frame_of(body)},
                      {"axis", numbers(bend.axis)},
                      {"din", numbers(bend.in)},
                      {"dout", numbers(bend.out)},
                      {"r", radius}});
    }
    const Bend end = bend_at(last, last);
    path.push_back(
        path_point(frame_of(last), 0.45 * across(onward(last, last), end.axis) -
                                       radius_at(tendon, last) * end.axis.cross(end.out)));
  }

  SceneWriter& scene_;
  const Mechanism& mechanism_;
  const MechanismPlace& place_;
  int base_ = 0;
};

}  // namespace

void add_mechanism(SceneWriter& scene, const Mechanism& mechanism, const MechanismPlace& place) {
  MechanismWriter(scene, mechanism, place).run();
}

}  // namespace sinew
