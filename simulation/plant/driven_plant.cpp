// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/plant/driven_plant.h"

namespace sinew {
namespace {

/// Their bodies are part of the drives' effort.
class BareJoints : public Joints {
 public:
  explicit BareJoints(const std::vector<std::string>& joint_names) {
    names = joint_names;
    slides.assign(names.size(), false);
    damping = rest = Eigen::VectorXd::Zero(size());
  }

  void lengths(const double*, const WristMotion&, double*) const override {}
  void torque(const double*, const WristMotion&, const double*, double*) const override {}
  void coupling(const double*, const WristMotion&, double*, double*) const override {}
  void stiffness(const double*, const WristMotion&, const double*, const double*,
                 double*) const override {}
  void acceleration(const double*, const double*, const WristMotion&, const double*,
                    double*) const override {}
  void inertial_forces(const double*, const double*, const double*, const WristMotion&,
                       double* tau) const override {
    std::fill(tau, tau + size(), 0.0);
  }
  void mass_matrix(const double*, const WristMotion&, double* M) const override {
    std::fill(M, M + size() * size(), 0.0);
  }
  void bending(const double*, const WristMotion&, double*) const override {}
  void tip_torque(const double*, const double*, double*) const override {}
  double energy(const double*, const double*, const WristMotion&) const override { return 0.0; }
  double base_power(const double*, const double*, const double*,
                    const WristMotion&) const override {
    return 0.0;
  }
};

}  // namespace

Plant driven_plant(const Drives& drives, const std::vector<std::string>& names,
                   const Scenario& scenario) {
  Scenario stepped = scenario;
  stepped.drive = DriveMode::joint_torques;
  stepped.integrator = Integrator::fixed_step;
  PlantParts parts;
  parts.joints = std::make_shared<BareJoints>(names);
  parts.drives = drives;
  return Plant(stepped, std::move(parts));
}

}  // namespace sinew
