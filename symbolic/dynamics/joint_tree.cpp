// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/dynamics/joint_tree.h"

#include <Eigen/Geometry>
#include <boost/math/constants/constants.hpp>

#include "symbolic/dynamics/base_parameters.h"

namespace sinew {
namespace {

/// Directions and offsets this close (relative to 1, or to the mechanism's size) count as equal:
/// far above the rounding of a printed description, far below anything built.
const Number alike = Number("1e-11");

struct Pose {
  NumberMatrix3 R = NumberMatrix3::Identity();
  NumberVector3 p = NumberVector3::Zero();
};

Pose composed(const Pose& a, const Pose& b) {
  return {a.R * b.R, a.R * b.p + a.p};
}

Pose inverse(const Pose& a) {
  return {a.R.transpose(), -(a.R.transpose() * a.p)};
}

NumberMatrix4 matrix(const Pose& pose) {
  NumberMatrix4 m = NumberMatrix4::Identity();
  m.block<3, 3>(0, 0) = pose.R;
  m.block<3, 1>(0, 3) = pose.p;
  return m;
}

NumberMatrix3 rotation_about_z(const Number& cosine, const Number& sine) {
  NumberMatrix3 R = NumberMatrix3::Identity();
  R(0, 0) = R(1, 1) = cosine;
  R(1, 0) = sine;
  R(0, 1) = -sine;
  return R;
}

/// Sets entries that are zero or one but for rounding to just that.
template <class Matrix>
void snap(Matrix& m, const Number& scale) {
  for (Eigen::Index i = 0; i < m.rows(); ++i)
    for (Eigen::Index j = 0; j < m.cols(); ++j)
      for (const Number& exact : {Number(0), Number(scale), Number(-scale)})
        if (abs(m(i, j) - exact) < alike * scale) m(i, j) = exact;
}

/// A rotation whose z axis is `axis`; a permutation with signs where that is possible.
NumberMatrix3 rotation_to_axis(const NumberVector3& axis) {
  int largest = 0;
  for (int i = 1; i < 3; ++i)
    if (abs(axis(i)) > abs(axis(largest))) largest = i;
  NumberVector3 x = NumberVector3::Zero();
  x((largest + 1) % 3) = 1;
  NumberMatrix3 R;
  R.col(2) = axis.normalized();
  R.col(0) = (x - R.col(2) * R.col(2).dot(x)).normalized();
  R.col(1) = R.col(2).cross(NumberVector3(R.col(0)));
  snap(R, 1);
  return R;
}

class TreeBuilder {
 public:
  TreeBuilder(const Mechanism& mechanism, const std::vector<FrameChoice>& choices)
      : mechanism_(mechanism), choices_(choices) {}

  JointTree run() {
    tree_.gravity = mechanism_.gravity.cast<Number>();
    merge_fixed_joints();
    measure();
    for (std::size_t i = 0; i < tree_.links.size(); ++i) align_axes(i);
    for (std::size_t i = 0; i < tree_.links.size(); ++i) choose_frame(i);
    for (std::size_t i = 0; i < tree_.links.size(); ++i) settle(i);
    fold_base_parameters(tree_);
    for (std::size_t i = 0; i < tree_.links.size(); ++i) turn_leaf(i);
    for (const TreeLink& link : tree_.links) tree_.inertias.push_back(to_expression(link.J));
    tree_.gravity_vector = to_expression(tree_.gravity);
    return std::move(tree_);
  }

 private:
  FrameChoice choice(std::size_t i) const {
    return i < choices_.size() ? choices_[i] : FrameChoice{};
  }

  /// Moving joints with z as axis; fixed bodies become part of the link that carries them.
  void merge_fixed_joints() {
    std::vector<int> link_of(mechanism_.bodies.size());
    std::vector<Pose> pose_in_link(mechanism_.bodies.size());
    for (std::size_t i = 0; i < mechanism_.joints.size(); ++i) {
      const Joint& joint = mechanism_.joints[i];
      const auto parent = static_cast<std::size_t>(std::max(joint.parent, 0));
      const int parent_link = joint.parent < 0 ? -1 : link_of[parent];
      Pose origin{joint.origin.rotation.cast<Number>(), joint.origin.translation.cast<Number>()};
      if (joint.parent >= 0) origin = composed(pose_in_link[parent], origin);
      if (joint.type == JointType::fixed) {
        link_of[i] = parent_link;
        pose_in_link[i] = origin;
      } else {
        const NumberMatrix3 to_axis = rotation_to_axis(joint.axis.cast<Number>());
        link_of[i] = static_cast<int>(tree_.links.size());
        pose_in_link[i] = {to_axis.transpose(), NumberVector3::Zero()};
        add_link(joint, parent_link, composed(origin, Pose{to_axis, NumberVector3::Zero()}));
      }
      tree_.bodies.push_back({link_of[i], pose_in_link[i].R, pose_in_link[i].p});
      if (link_of[i] >= 0) {
        const NumberMatrix4 T = matrix(pose_in_link[i]);
        tree_.links[static_cast<std::size_t>(link_of[i])].J +=
            T * pseudo_inertia(mechanism_.bodies[i]) * T.transpose();
      }
    }
  }

  void add_link(const Joint& joint, int parent, const Pose& origin) {
    TreeLink link;
    link.name = joint.name;
    link.type = joint.type;
    link.coordinate = static_cast<int>(tree_.links.size());
    link.parent = parent;
    link.R = origin.R;
    link.p = origin.p;
    link.J.setZero();
    if (parent >= 0)
      tree_.links[static_cast<std::size_t>(parent)].children.push_back(link.coordinate);
    tree_.links.push_back(link);
  }

  void measure() {
    size_ = Number("1e-3");
    for (const TreeLink& link : tree_.links)
      if (link.p.norm() > size_) size_ = link.p.norm();
    for (TreeLink& link : tree_.links) {
      snap(link.R, 1);
      for (int i = 0; i < 3; ++i)
        if (abs(link.p(i)) < alike * size_) link.p(i) = 0;
    }
  }

  /// Turns an antiparallel axis round, so that a run of parallel axes shares one z.
  void align_axes(std::size_t i) {
    TreeLink& link = tree_.links[i];
    if (link.parent < 0) return;
    const TreeLink& parent = tree_.links[static_cast<std::size_t>(link.parent)];
    if (link.type != JointType::revolute || parent.type != JointType::revolute) return;
    if (abs(link.R(2, 2)) < 1 - alike) return;
    link.parallel_to_parent = true;
    if (link.R(2, 2) > 0) return;
    NumberMatrix3 flip = NumberMatrix3::Identity();  // half a turn about x
    flip(1, 1) = flip(2, 2) = -1;
    link.sign = -1;
    const Pose turn{flip, NumberVector3::Zero()};
    set_origin(link, composed({link.R, link.p}, turn));
    move_contents(i, turn);
  }

  static void set_origin(TreeLink& link, const Pose& pose) {
    link.R = pose.R;
    link.p = pose.p;
    snap(link.R, 1);
  }

  /// The link's frame becomes frame * `turn`: children and inertia follow.
  void move_contents(std::size_t i, const Pose& turn) {
    const Pose back = inverse(turn);
    for (int c : tree_.links[i].children) {
      TreeLink& child = tree_.links[static_cast<std::size_t>(c)];
      set_origin(child, composed(back, {child.R, child.p}));
    }
    const NumberMatrix4 T = matrix(back);
    tree_.links[i].J = T * tree_.links[i].J * T.transpose();
    for (BodyPlace& body : tree_.bodies) {
      if (body.link != static_cast<int>(i)) continue;
      const Pose pose = composed(back, {body.R, body.p});
      body.R = pose.R;
      body.p = pose.p;
      snap(body.R, 1);
    }
  }

  /// Slides the frame along its axis and turns its x towards the first child's axis. The rotation
  /// about z that the joint's zero thereby takes up is extracted in `settle`.
  void choose_frame(std::size_t i) {
    TreeLink& link = tree_.links[i];
    const Number slide = slide_along_axis(i);
    Pose turn;
    turn.p(2) = slide;
    const Pose before{link.R, link.p};
    if (!link.children.empty())
      turn.R = turn_towards(tree_.links[static_cast<std::size_t>(link.children[0])]);
    set_origin(link, composed(before, turn));
    move_contents(i, turn);
    for (int k = 0; k < 3; ++k)
      if (abs(link.p(k)) < alike * size_) link.p(k) = 0;
  }

  /// Rotation about z that brings x onto the common normal from our axis to the child's.
  NumberMatrix3 turn_towards(const TreeLink& child) const {
    const NumberVector3 z_child = child.R.col(2);
    NumberVector3 normal = NumberVector3(0, 0, 1).cross(z_child);
    if (normal.norm() < alike) normal = NumberVector3(child.p(0), child.p(1), 0);  // parallel axes
    if (normal.norm() < alike * size_) return NumberMatrix3::Identity();  // one and the same axis
    normal.normalize();
    const NumberVector3 offset(child.p(0), child.p(1), 0);
    const Number along = normal.dot(offset);
    // of the two directions the one that needs no turn, else the one that points to the child
    const bool flip = abs(abs(normal(0)) - 1) < alike ? normal(0) < 0 : along < 0;
    if (flip) normal = -normal;
    return rotation_about_z(normal(0), normal(1));
  }

  Number slide_along_axis(std::size_t i) const {
    const TreeLink& link = tree_.links[i];
    if (link.type == JointType::prismatic) return 0;
    if (link.parallel_to_parent) return -link.p(2);  // a run of parallel axes lies in one plane
    if (choice(i).origin == OriginChoice::outgoing && !link.children.empty())
      return foot_of_outgoing(tree_.links[static_cast<std::size_t>(link.children[0])]);
    return link.parent < 0 ? Number(0) : foot_of_incoming(link);
  }

  /// Height on our z axis of the common normal to the child's axis.
  static Number foot_of_outgoing(const TreeLink& child) {
    const NumberVector3 d = child.R.col(2);
    const Number sine2 = d(0) * d(0) + d(1) * d(1);
    if (sine2 < alike) return 0;
    return child.p(2) - d(2) * (d(0) * child.p(0) + d(1) * child.p(1)) / sine2;
  }

  /// Distance along our own axis, from our origin, of the common normal from the parent's axis.
  static Number foot_of_incoming(const TreeLink& link) {
    const NumberVector3 d = link.R.col(2);
    const Number sine2 = d(0) * d(0) + d(1) * d(1);
    if (sine2 < alike) return 0;
    return -(d(0) * link.p(0) + d(1) * link.p(1)) / sine2;
  }

  /// Splits the origin's rotation into one about x (kept) and one about z (into the joint's zero).
  void settle(std::size_t i) {
    TreeLink& link = tree_.links[i];
    if (link.type != JointType::revolute) return;
    const NumberVector3 z = link.R.col(2);
    NumberMatrix3 kept = rotation_to_axis(z);
    if (abs(z(0)) < alike) {  // the axis is z turned about x: keep just that turn
      kept = NumberMatrix3::Identity();
      kept.col(2) = z;
      kept.col(1) = z.cross(NumberVector3(1, 0, 0));
      snap(kept, 1);
    }
    const NumberMatrix3 zero = kept.transpose() * link.R;
    link.R = kept;
    add_to_zero(link, atan2(zero(1, 0), zero(0, 0)));
  }

  static void add_to_zero(TreeLink& link, const Number& angle) {
    const Number quarter = boost::math::constants::half_pi<Number>();
    Number total = link.remainder + angle + link.quarter_turns * quarter;
    const Number turns = round(total / quarter);
    Number rest = total - turns * quarter;
    if (abs(rest) < alike) {
      link.quarter_turns = (static_cast<int>(turns) % 4 + 4) % 4;
      link.remainder = 0;
    } else {
      link.quarter_turns = 0;
      link.remainder = total;
    }
  }

  void turn_leaf(std::size_t i) {
    TreeLink& link = tree_.links[i];
    if (!link.children.empty() || link.type != JointType::revolute) return;
    const LeafTurn wanted = choice(i).leaf;
    Number angle = 0;
    if (wanted == LeafTurn::no_first_moment_y) angle = atan2(link.J(1, 3), link.J(0, 3));
    if (wanted == LeafTurn::no_product_of_inertia)
      angle = atan2(2 * link.J(0, 1), link.J(0, 0) - link.J(1, 1)) / 2;
    if (abs(angle) < alike) return;
    const Pose turn{rotation_about_z(cos(angle), sin(angle)), NumberVector3::Zero()};
    move_contents(i, turn);
    const int zeroed = wanted == LeafTurn::no_first_moment_y ? 3 : 0;
    link.J(1, zeroed) = link.J(zeroed, 1) = 0;
    add_to_zero(link, angle);
  }

  const Mechanism& mechanism_;
  const std::vector<FrameChoice>& choices_;
  JointTree tree_;
  Number size_ = 1;
};

}  // namespace

NumberMatrix4 pseudo_inertia(const Body& body) {
  const NumberVector3 c = body.centre_of_mass.cast<Number>();
  const NumberMatrix3 I = body.inertia.cast<Number>();
  const Number m = body.mass;
  NumberMatrix4 J;
  J.block<3, 3>(0, 0) = NumberMatrix3::Identity() * (I.trace() / 2) - I + m * c * c.transpose();
  J.block<3, 1>(0, 3) = m * c;
  J.block<1, 3>(3, 0) = m * c.transpose();
  J(3, 3) = m;
  return J;
}

JointTree build_joint_tree(const Mechanism& mechanism, const std::vector<FrameChoice>& choices) {
  return TreeBuilder(mechanism, choices).run();
}

}  // namespace sinew
