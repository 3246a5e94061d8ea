// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/equations/named_values.h"

#include <Eigen/Geometry>
#include <cmath>

#include "symbolic/expressions/exact_number.h"

namespace sinew {
namespace {

using GiNaC::ex;

constexpr const char* axis_names[] = {"x", "y", "z"};

bool says_direction(double value) {
  return value == 0.0 || std::abs(value) == 1.0;
}

/// A rotation about one of the axes by an angle, or nothing to be done for 0.
Matrix3ex about(std::size_t axis, const ex& c, const ex& s) {
  Matrix3ex R;
  const std::size_t j = (axis + 1) % 3, k = (axis + 2) % 3;
  R[axis][axis] = 1;
  R[j][j] = R[k][k] = c;
  R[k][j] = s;
  R[j][k] = -s;
  return R;
}

Matrix3ex times_matrix(const Matrix3ex& A, const Matrix3ex& B) {
  Matrix3ex result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) result[i][j] += A[i][k] * B[k][j];
  return result;
}

class ValueNames {
 public:
  ValueNames(const Mechanism& mechanism, SymbolTable& table)
      : mechanism_(mechanism), table_(table) {}

  MechanismValues all() {
    MechanismValues values;
    for (const Joint& joint : mechanism_.joints) values.joints.push_back(of_joint(joint));
    for (const Body& body : mechanism_.bodies) values.bodies.push_back(of_body(body));
    values.gravity = vector("g", "gravity", mechanism_.gravity, "m/s^2", "mechanism.gravity");
    return values;
  }

 private:
  Vector3 vector(const std::string& name, const std::string& meaning, const Eigen::Vector3d& value,
                 const std::string& unit, const std::string& path) {
    Vector3 result;
    for (std::size_t k = 0; k < 3; ++k)
      result[k] = table_.symbol(name + "_" + axis_names[k], meaning + ", along " + axis_names[k],
                                value[static_cast<Eigen::Index>(k)], unit, path);
    return result;
  }

  MechanismValues::OfJoint of_joint(const Joint& joint) {
    const std::string below = subscript_of(joint.name), path = "joint." + joint.name;
    MechanismValues::OfJoint values;
    values.translation = vector("l_" + below, "origin of joint " + joint.name + " on its parent",
                                joint.origin.translation, "m", path + ".origin.xyz");
    values.rotation = rotation(joint, below, path + ".origin.rpy");
    for (std::size_t k = 0; k < 3; ++k) {
      const double entry = joint.axis[static_cast<Eigen::Index>(k)];
      values.axis[k] =
          says_direction(entry)
              ? exact_number(entry)
              : table_.symbol("a_" + below + "_" + axis_names[k],
                              "axis of joint " + joint.name + ", along " + axis_names[k], entry,
                              "1", path + ".axis");
    }
    return values;
  }

  /// Rz(yaw) Ry(pitch) Rx(roll); quarter turns stay what they are.
  Matrix3ex rotation(const Joint& joint, const std::string& below, const std::string& path) {
    const Eigen::Matrix3d& R = joint.origin.rotation;
    bool exact = true;
    for (const double entry : R.reshaped()) exact = exact && says_direction(entry);
    Matrix3ex result;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        result[i][j] = exact_number(R(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
    if (exact) return result;
    const double pitch = std::atan2(-R(2, 0), std::hypot(R(0, 0), R(1, 0)));
    const double roll = std::atan2(R(2, 1), R(2, 2)), yaw = std::atan2(R(1, 0), R(0, 0));
    const auto turned = [&](std::size_t axis, const char* letter, const char* word, double angle) {
      if (std::abs(angle) < 1e-12) return about(axis, 1, 0);
      const ex symbol = table_.symbol(std::string(letter) + "_" + below,
                                      std::string(word) + " of joint " + joint.name + "'s origin",
                                      angle, "rad", path);
      return about(axis, GiNaC::cos(symbol), GiNaC::sin(symbol));
    };
    const Matrix3ex x = turned(0, "alpha", "roll", roll), y = turned(1, "beta", "pitch", pitch),
                    z = turned(2, "gamma", "yaw", yaw);
    return times_matrix(z, times_matrix(y, x));
  }

  MechanismValues::OfBody of_body(const Body& body) {
    const std::string below = subscript_of(body.name), of = " of " + body.name;
    const std::string path = "body." + body.name + ".mass_properties";
    MechanismValues::OfBody values;
    values.mass = table_.symbol("m_" + below, "mass" + of, body.mass, "kg", path);
    values.centre = vector("r_" + below, "centre of mass" + of, body.centre_of_mass, "m", path);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = i; j < 3; ++j)
        values.inertia[i][j] = values.inertia[j][i] =
            table_.symbol("I_" + below + "_" + axis_names[i] + axis_names[j], "inertia" + of,
                          body.inertia(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)),
                          "kg m^2", path);
    return values;
  }

  const Mechanism& mechanism_;
  SymbolTable& table_;
};

}  // namespace

std::string subscript_of(const std::string& name) {
  const bool numbered = name.size() > 1 && name.front() == 'q' &&
                        name.find_first_not_of("0123456789", 1) == std::string::npos;
  return numbered ? name.substr(1) : name;
}

ex SymbolTable::symbol(const std::string& name, const std::string& meaning, double value,
                       const std::string& unit, const std::string& path) {
  if (value == 0.0) return 0;
  const auto found = mechanism_.provenance.find(path);
  entries_.push_back({name, meaning, value, unit,
                      found == mechanism_.provenance.end() ? "assumed" : found->second});
  return GiNaC::symbol(name);
}

GiNaC::symbol SymbolTable::variable(const std::string& name, const std::string& meaning,
                                    const std::string& unit) {
  entries_.push_back({name, meaning, std::nullopt, unit, ""});
  return GiNaC::symbol(name);
}

MechanismValues named_values(const Mechanism& mechanism, SymbolTable& table) {
  return ValueNames(mechanism, table).all();
}

}  // namespace sinew
