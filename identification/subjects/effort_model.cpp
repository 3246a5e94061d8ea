// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/effort_model.h"

#include <tbb/parallel_for.h>
#include <algorithm>

#include "generator/assemble.h"
#include "generator/cost.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kBlock = 2048;  // samples whose inputs stay in the cache

/// All inputs but the motion and the memory, a column each sample; what is not logged stays.
void take_logged(const Recording& log, const std::vector<EffortSlot>& slots, Index first,
                 Eigen::Ref<MatrixXd> in) {
  const auto signal = [&](const char* name, const EffortSlot& slot) {
    if (const MatrixXd* found = log.signals.find(name))
      in.middleRows(slot.at, slot.count) = found->middleRows(first, in.cols()).transpose();
  };
  for (const EffortSlot& slot : slots) {
    switch (slot.input) {
      case EffortInput::load:
        if (log.load.size() > 0)
          in.middleRows(slot.at, slot.count) = log.load.middleRows(first, in.cols()).transpose();
        break;
      case EffortInput::tension:
        signal("tension", slot);
        break;
      case EffortInput::jerk:
        signal("jerk", slot);
        break;
      case EffortInput::jounce:
        signal("jounce", slot);
        break;
      case EffortInput::time:
        in.row(slot.at) = (log.time.segment(first, in.cols()).array() - log.started()).transpose();
        break;
      case EffortInput::step:
        in.row(slot.at).setConstant(log.step);
        break;
      default:
        break;
    }
  }
}

/// q, qd, qdd: a column each sample.
template <typename Q, typename Qd, typename Qdd>
void take_motion(const Q& q, const Qd& qd, const Qdd& qdd, const std::vector<EffortSlot>& slots,
                 Eigen::Ref<MatrixXd> in) {
  for (const EffortSlot& slot : slots) {
    auto part = in.middleRows(slot.at, slot.count);
    if (slot.input == EffortInput::q) part = q;
    if (slot.input == EffortInput::qd) part = qd;
    if (slot.input == EffortInput::qdd) part = qdd;
  }
}

const EffortSlot* memory_of(const std::vector<EffortSlot>& slots) {
  for (const EffortSlot& slot : slots)
    if (slot.input == EffortInput::memory) return &slot;
  return nullptr;
}

}  // namespace

EffortModel::EffortModel(const DrivenModel& model, const Identified& identified,
                         const std::filesystem::path& runtime)
    : model_(model),
      identified_(identified),
      runtime_(runtime),
      joints_(static_cast<int>(model.joints.size())) {
  for (const DrivenJoint& joint : model.joints) motor_.push_back(joint.motor);
  std::vector<Function> functions{effort_function(model, identified)};
  if (std::adjacent_find(motor_.begin(), motor_.end(), std::not_equal_to<>()) != motor_.end())
    functions.push_back(motor_effort_function(model, identified));
  const EmittedModel emitted =
      assemble({model.name, "Effort of the drives", "", {}}, functions, {});
  operations_ = count_operations(emitted.functions.front()).operations();
  compiled_ = std::make_shared<CompiledModel>(emitted, runtime);
}

MatrixXd EffortModel::operator()(const Recording& log) const {
  return (*this)(log, log.q, log.qd, log.qdd);
}

MatrixXd EffortModel::operator()(const Recording& log, const MatrixXd& q, const MatrixXd& qd,
                                 const MatrixXd& qdd) const {
  return run("effort", log, q, qd, qdd);
}

VectorXd EffortModel::of_joint(int joint, const Recording& log, const MatrixXd& q,
                               const MatrixXd& qd, const MatrixXd& qdd) const {
  const bool alone = motor_[static_cast<std::size_t>(joint)] && compiled_->has("motor_effort");
  return run(alone ? "motor_effort" : "effort", log, q, qd, qdd).col(joint);
}

MatrixXd EffortModel::run(const std::string& name, const Recording& log, const MatrixXd& q,
                          const MatrixXd& qd, const MatrixXd& qdd) const {
  const sinew_function& function = compiled_->find(name);
  const std::vector<EffortSlot> slots = effort_slots(function);
  const EffortSlot* memory = memory_of(slots);
  MatrixXd efforts(q.rows(), joints_);
  const auto block = [&](Index first, VectorXd& state) {
    const Index n = std::min(kBlock, q.rows() - first);
    MatrixXd in = MatrixXd::Zero(function.input_size, n), out(function.output_size, n);
    take_logged(log, slots, first, in);
    take_motion(q.middleRows(first, n).transpose(), qd.middleRows(first, n).transpose(),
                qdd.middleRows(first, n).transpose(), slots, in);
    for (Index k = 0; k < n; ++k) {
      if (memory) in.col(k).segment(memory->at, memory->count) = state;
      function.call(in.col(k).data(), out.col(k).data());
      if (memory) state = out.col(k).tail(memory->count);
    }
    efforts.middleRows(first, n) = out.topRows(joints_).transpose();
  };
  const Index blocks = (q.rows() + kBlock - 1) / kBlock;
  // What an effect remembers goes on from one sample to the next.
  VectorXd state = VectorXd::Zero(memory ? memory->count : 0);
  if (memory)
    for (Index b = 0; b < blocks; ++b) block(b * kBlock, state);
  else
    tbb::parallel_for(0, static_cast<int>(blocks), [&](int b) {
      VectorXd none;
      block(b * kBlock, none);
    });
  if (log.payload_effort.size() > 0)
    efforts.leftCols(log.payload_effort.cols()) += log.payload_effort;
  return efforts;
}

Drives EffortModel::drives() const {
  return {model_, identified_, {.bodies = true, .as_read = true}, runtime_, compiled_};
}

}  // namespace sinew::diagnosis
