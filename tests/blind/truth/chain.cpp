// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blind/truth/chain.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace sinew::trials {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;

Matrix3d turned(const Vector3d& rpy) {
  return (AngleAxisd(rpy.z(), Vector3d::UnitZ()) * AngleAxisd(rpy.y(), Vector3d::UnitY()) *
          AngleAxisd(rpy.x(), Vector3d::UnitX()))
      .toRotationMatrix();
}

/// A link in the base frame.
struct Placed {
  Matrix3d axes;
  Vector3d joint, axis, centre, spin, spin_rate, acceleration;  // of the joint's point
  Vector3d velocity;
};

std::string vector_text(const Vector3d& v) {
  return fmt::format("[{:.12g}, {:.12g}, {:.12g}]", v.x(), v.y(), v.z());
}

std::string value_text(double value, const char* unit) {
  return fmt::format("{{ value = {:.12g}, unit = \"{}\", from = \"assumed\" }}", value, unit);
}

}  // namespace

Index Chain::size() const {
  return std::count_if(links.begin(), links.end(), [](const Link& l) { return l.follows == 0.0; });
}

std::size_t Chain::link_of(Index axis) const {
  std::size_t link = 0;
  while (links.at(link).follows != 0.0 || axis_of(link) < axis) ++link;
  return link;
}

Index Chain::axis_of(std::size_t link) const {
  const auto end = links.begin() + static_cast<std::ptrdiff_t>(link) + 1;
  return std::count_if(links.begin(), end, [](const Link& l) { return l.follows == 0.0; }) - 1;
}

VectorXd Chain::torque(const VectorXd& q, const VectorXd& v, const VectorXd& a) const {
  if (size() == static_cast<Index>(links.size())) return torque_of_each(q, v, a);
  // By virtual work: what a joint that follows takes comes through the loop that turns it.
  const auto all = [&](const VectorXd& x) {
    VectorXd y(static_cast<Index>(links.size()));
    for (std::size_t i = 0; i < links.size(); ++i) {
      const auto k = static_cast<Index>(i);
      y(k) = links[i].follows != 0.0 ? links[i].follows * y(k - 1) : x(axis_of(i));
    }
    return y;
  };
  VectorXd each = torque_of_each(all(q), all(v), all(a));
  VectorXd result(size());
  for (std::size_t i = links.size(); i-- > 0;) {
    const auto k = static_cast<Index>(i);
    if (links[i].follows != 0.0)
      each(k - 1) += links[i].follows * each(k);
    else
      result(axis_of(i)) = each(k);
  }
  return result;
}

VectorXd Chain::torque_of_each(const VectorXd& q, const VectorXd& v, const VectorXd& a) const {
  const auto n = links.size();
  std::vector<Placed> at(n);
  std::vector<Vector3d> force(n), moment(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Link& link = links[i];
    Placed base;
    base.axes = Matrix3d::Identity();
    for (Vector3d* x : {&base.joint, &base.spin, &base.spin_rate, &base.velocity}) x->setZero();
    base.acceleration = -gravity;
    const Placed& from = link.parent < 0 ? base : at[static_cast<std::size_t>(link.parent)];
    const auto k = static_cast<Index>(i);
    Placed& p = at[i];
    const Matrix3d frame = from.axes * turned(link.rpy);
    p.axis = frame * link.axis.normalized();
    Vector3d arm = from.axes * link.xyz;
    p.spin = from.spin;
    p.spin_rate = from.spin_rate;
    p.axes = frame;
    if (link.slides) {
      arm += q(k) * p.axis;
    } else {
      p.axes = AngleAxisd(q(k), p.axis).toRotationMatrix() * frame;
      p.spin += v(k) * p.axis;
      p.spin_rate += a(k) * p.axis + from.spin.cross(v(k) * p.axis);
    }
    p.joint = from.joint + arm;
    p.acceleration =
        from.acceleration + from.spin_rate.cross(arm) + from.spin.cross(from.spin.cross(arm));
    if (link.slides) p.acceleration += a(k) * p.axis + 2.0 * from.spin.cross(v(k) * p.axis);
    const Vector3d reach = p.axes * link.com;
    p.centre = p.joint + reach;
    const auto moved = [&](const Vector3d& r) -> Vector3d {
      return p.acceleration + p.spin_rate.cross(r) + p.spin.cross(p.spin.cross(r));
    };
    force[i] = link.mass * moved(reach);
    const Matrix3d tensor = p.axes * link.inertia * p.axes.transpose();
    moment[i] = tensor * p.spin_rate + p.spin.cross(tensor * p.spin) + p.centre.cross(force[i]);
    if (i + 1 == n && payload > 0.0) {
      const Vector3d r = p.axes * tip, extra = payload * moved(r);
      force[i] += extra;
      moment[i] += (p.joint + r).cross(extra);
    }
  }
  // Moments about the base's origin: they add up along the chain as they are.
  VectorXd result(static_cast<Index>(n));
  for (std::size_t i = n; i-- > 0;) {
    const Placed& p = at[i];
    result(static_cast<Index>(i)) =
        links[i].slides ? p.axis.dot(force[i]) : p.axis.dot(moment[i] - p.joint.cross(force[i]));
    if (links[i].parent < 0) continue;
    const auto parent = static_cast<std::size_t>(links[i].parent);
    force[parent] += force[i];
    moment[parent] += moment[i];
  }
  return result;
}

double Chain::carried(const VectorXd& q, Index j) const {
  const VectorXd none = VectorXd::Zero(size()), unit = VectorXd::Unit(size(), j);
  return torque(q, none, unit)(j) - torque(q, none, none)(j);
}

void write_file(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) throw std::runtime_error(file.string() + ":0:0: cannot be written");
}

void write_mechanism(const Chain& chain, const std::filesystem::path& folder) {
  std::string text = fmt::format(
      "[mechanism]\nname = \"{}\"\ngravity = {{ value = {}, unit = \"m/s^2\", "
      "from = \"assumed\" }}\n",
      chain.name, vector_text(chain.gravity));
  for (const Link& l : chain.links) text += fmt::format("\n[[body]]\nname = \"{}\"\n", l.name);
  for (const Link& l : chain.links) {
    const char* unit = l.slides ? "m" : "rad";
    const char* damping = l.slides ? "N*s/m" : "N*m*s/rad";
    text += fmt::format(
        "\n[[joint]]\nname = \"{}\"\ntype = \"{}\"\nparent = \"{}\"\nchild = \"{}\"\naxis = {}\n",
        l.joint, l.slides ? "prismatic" : "revolute",
        l.parent < 0 ? "base" : chain.links[static_cast<std::size_t>(l.parent)].name, l.name,
        vector_text(l.axis));
    text += fmt::format("origin.xyz = {{ value = {}, unit = \"m\", from = \"assumed\" }}\n",
                        vector_text(l.xyz));
    if (!l.rpy.isZero())
      text += fmt::format("origin.rpy = {{ value = {}, unit = \"rad\", from = \"assumed\" }}\n",
                          vector_text(l.rpy));
    text +=
        fmt::format("range = {{ value = [{:.12g}, {:.12g}], unit = \"{}\", from = \"assumed\" }}\n",
                    l.low, l.high, unit);
    text += "damping = " + value_text(l.damping, damping) + "\n";
    if (l.friction > 0.0)
      text += "friction = " + value_text(l.friction, l.slides ? "N" : "N*m") + "\n";
    if (l.friction_speed > 0.0)
      text += "friction_speed = " + value_text(l.friction_speed, l.slides ? "m/s" : "rad/s") + "\n";
    if (l.armature > 0.0)
      text += "armature = " + value_text(l.armature, l.slides ? "kg" : "kg*m^2") + "\n";
    if (l.motor_turn > 0.0) text += "motor_turn = " + value_text(l.motor_turn, unit) + "\n";
  }
  for (std::size_t i = 1; i < chain.links.size(); ++i)
    if (chain.links[i].follows != 0.0)
      text += fmt::format("\n[[coupling]]\ndependent = \"{}\"\nindependent = \"{}\"\nratio = {}\n",
                          chain.links[i].joint, chain.links[i - 1].joint,
                          value_text(chain.links[i].follows, "1"));
  for (const Tendon& t : chain.tendons) {
    std::string pulleys;
    for (std::size_t j = 0; j < static_cast<std::size_t>(t.radius.size()); ++j)
      if (t.radius(static_cast<Index>(j)) != 0.0)
        pulleys +=
            fmt::format("{}{{ joint = \"{}\", radius = {} }}", pulleys.empty() ? "" : ", ",
                        chain.links[j].joint, value_text(t.radius(static_cast<Index>(j)), "m"));
    text += fmt::format("\n[[tendon]]\nname = \"{}\"\npulleys = [{}]\n", t.name, pulleys);
  }
  text += fmt::format(
      "\n[[frame]]\nname = \"tip\"\nbody = \"{}\"\npose.xyz = {{ value = {}, unit = "
      "\"m\", from = \"assumed\" }}\n",
      chain.links.back().name, vector_text(chain.tip));
  write_file(folder / "mechanism.toml", text);
  std::string table =
      "link,mass [kg],com_x [m],com_y [m],com_z [m],ixx [kg*m^2],iyy [kg*m^2],izz [kg*m^2],"
      "ixy [kg*m^2],ixz [kg*m^2],iyz [kg*m^2]\n";
  for (const Link& l : chain.links) {
    const Matrix3d& I = l.inertia;
    table += fmt::format(
        "{},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g}\n",
        l.name, l.mass, l.com.x(), l.com.y(), l.com.z(), I(0, 0), I(1, 1), I(2, 2), I(0, 1),
        I(0, 2), I(1, 2));
  }
  write_file(folder / "mass_properties.csv", table);
}

}  // namespace sinew::trials
