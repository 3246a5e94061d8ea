// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/effort_model.h"

#include <string>

#include "generator/assemble.h"
#include "generator/cost.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Where an argument's numbers start, and how many there are.
struct ArgumentSlot {
  std::string name;
  Index at = 0, count = 0;
};

std::vector<ArgumentSlot> slots_of(const sinew_argument* arguments, int count) {
  std::vector<ArgumentSlot> slots;
  Index at = 0;
  for (int i = 0; i < count; ++i) {
    const Index size = static_cast<Index>(arguments[i].rows) * arguments[i].cols;
    slots.push_back({arguments[i].name, at, size});
    at += size;
  }
  return slots;
}

}  // namespace

EffortModel::EffortModel(const DrivenModel& model, const Identified& identified,
                         const std::filesystem::path& runtime)
    : joints_(static_cast<int>(model.joints.size())) {
  const EmittedModel emitted = assemble({model.name, "Effort of the drives", "", {}},
                                        {effort_function(model, identified)}, {});
  operations_ = count_operations(emitted.functions.front()).operations();
  compiled_ = std::make_shared<CompiledModel>(emitted, runtime);
}

MatrixXd EffortModel::operator()(const Recording& log) const {
  return (*this)(log, log.q, log.qd, log.qdd);
}

MatrixXd EffortModel::operator()(const Recording& log, const MatrixXd& q, const MatrixXd& qd,
                                 const MatrixXd& qdd) const {
  const sinew_function& function = compiled_->find("effort");
  const auto inputs = slots_of(function.inputs, function.input_count);
  VectorXd in = VectorXd::Zero(function.input_size), out(function.output_size);
  const auto jerk = log.signals.find("jerk"), jounce = log.signals.find("jounce"),
             tension = log.signals.find("tension");
  MatrixXd efforts(q.rows(), joints_);
  Index state = -1;
  for (const ArgumentSlot& slot : inputs)
    if (slot.name == "memory") state = slot.at;
  for (Index k = 0; k < q.rows(); ++k) {
    for (const ArgumentSlot& slot : inputs) {
      auto part = in.segment(slot.at, slot.count);
      if (slot.name == "q")
        part = q.row(k).transpose();
      else if (slot.name == "qd")
        part = qd.row(k).transpose();
      else if (slot.name == "qdd")
        part = qdd.row(k).transpose();
      else if (slot.name == "load" && log.load.size() > 0)
        part = log.load.row(k).transpose();
      else if (slot.name == "tension")
        part = tension->second.row(k).transpose();
      else if (slot.name == "qddd" && jerk != log.signals.end())
        part = jerk->second.row(k).transpose();
      else if (slot.name == "qdddd" && jounce != log.signals.end())
        part = jounce->second.row(k).transpose();
      else if (slot.name == "time")
        part(0) = log.time(k) - log.time(0);
      else if (slot.name == "step")
        part(0) = log.step;
    }
    function.call(in.data(), out.data());
    efforts.row(k) = out.head(joints_).transpose();
    if (state >= 0) in.segment(state, out.size() - joints_) = out.tail(out.size() - joints_);
  }
  return efforts;
}

}  // namespace sinew::diagnosis
