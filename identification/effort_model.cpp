// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/effort_model.h"

#include "generator/assemble.h"
#include "generator/cost.h"

namespace sinew::diagnosis {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

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
  EffortAtInstant effort(*this);
  MatrixXd efforts(q.rows(), joints_);
  for (Index k = 0; k < q.rows(); ++k) {
    effort.take(log, k);
    efforts.row(k) =
        effort(q.row(k).transpose(), qd.row(k).transpose(), qdd.row(k).transpose()).transpose();
    effort.remember();
  }
  return efforts;
}

EffortAtInstant::EffortAtInstant(const EffortModel& model)
    : compiled_(model.compiled_), function_(&compiled_->find("effort")), joints_(model.joints_) {
  Index at = 0;
  for (int i = 0; i < function_->input_count; ++i) {
    const Index size = static_cast<Index>(function_->inputs[i].rows) * function_->inputs[i].cols;
    slots_.push_back({function_->inputs[i].name, at, size});
    at += size;
  }
  in_ = VectorXd::Zero(function_->input_size);
  out_ = VectorXd::Zero(function_->output_size);
}

void EffortAtInstant::take(const Recording& log, Index sample) {
  const auto signal = [&](const char* name, Eigen::Ref<VectorXd> part) {
    const auto found = log.signals.find(name);
    if (found != log.signals.end()) part = found->second.row(sample).transpose();
  };
  for (const Slot& slot : slots_) {
    auto part = in_.segment(slot.at, slot.count);
    if (slot.name == "load" && log.load.size() > 0)
      part = log.load.row(sample).transpose();
    else if (slot.name == "tension")
      signal("tension", part);
    else if (slot.name == "qddd")
      signal("jerk", part);
    else if (slot.name == "qdddd")
      signal("jounce", part);
    else if (slot.name == "time")
      part(0) = log.time(sample) - log.time(0);
    else if (slot.name == "step")
      part(0) = log.step;
  }
}

VectorXd EffortAtInstant::operator()(const VectorXd& q, const VectorXd& qd, const VectorXd& qdd) {
  for (const Slot& slot : slots_) {
    auto part = in_.segment(slot.at, slot.count);
    if (slot.name == "q")
      part = q;
    else if (slot.name == "qd")
      part = qd;
    else if (slot.name == "qdd")
      part = qdd;
  }
  function_->call(in_.data(), out_.data());
  return out_.head(joints_);
}

void EffortAtInstant::remember() {
  for (const Slot& slot : slots_)
    if (slot.name == "memory") in_.segment(slot.at, slot.count) = out_.tail(slot.count);
}

}  // namespace sinew::diagnosis
