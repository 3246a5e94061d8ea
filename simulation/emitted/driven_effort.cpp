// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/emitted/driven_effort.h"

#include <map>

#include "generator/assemble.h"

namespace sinew {

using Eigen::Index;
using Eigen::VectorXd;

std::vector<EffortSlot> effort_slots(const sinew_function& function) {
  static const std::map<std::string, EffortInput> inputs{{"q", EffortInput::q},
                                                         {"qd", EffortInput::qd},
                                                         {"qdd", EffortInput::qdd},
                                                         {"load", EffortInput::load},
                                                         {"tension", EffortInput::tension},
                                                         {"qddd", EffortInput::jerk},
                                                         {"qdddd", EffortInput::jounce},
                                                         {"time", EffortInput::time},
                                                         {"step", EffortInput::step},
                                                         {"memory", EffortInput::memory}};
  std::vector<EffortSlot> slots;
  Index at = 0;
  for (int i = 0; i < function.input_count; ++i) {
    const auto& input = function.inputs[i];
    const Index count = static_cast<Index>(input.rows) * input.cols;
    slots.push_back({inputs.at(input.name), at, count});
    at += count;
  }
  return slots;
}

DrivenEffort::DrivenEffort(const DrivenModel& model, const Identified& identified,
                           const std::filesystem::path& runtime)
    : DrivenEffort(std::make_shared<const CompiledModel>(
          assemble({model.name, "Effort of the drives", "", {}},
                   {effort_function(model, identified)}, {}),
          runtime)) {}

DrivenEffort::DrivenEffort(std::shared_ptr<const CompiledModel> compiled)
    : compiled_(std::move(compiled)),
      function_(&compiled_->find("effort")),
      joints_(function_->outputs[0].rows),
      slots_(effort_slots(*function_)) {
  in_ = VectorXd::Zero(function_->input_size);
  out_ = VectorXd::Zero(function_->output_size);
  if (const EffortSlot* memory = slot(EffortInput::memory))
    past_.memory = VectorXd::Zero(memory->count);
  set_step(step_);
}

const EffortSlot* DrivenEffort::slot(EffortInput input) const {
  for (const EffortSlot& each : slots_)
    if (each.input == input) return &each;
  return nullptr;
}

bool DrivenEffort::has_past() const {
  return slot(EffortInput::memory) || slot(EffortInput::jerk) || slot(EffortInput::jounce);
}

void DrivenEffort::set(EffortInput input, double value) {
  if (const EffortSlot* found = slot(input)) in_(found->at) = value;
}

void DrivenEffort::set(EffortInput input, const VectorXd& values) {
  const EffortSlot* found = slot(input);
  if (!found) return;
  auto part = in_.segment(found->at, found->count);
  if (values.size() == 0)
    part.setZero();
  else
    part = values;
}

void DrivenEffort::set_step(double seconds) {
  step_ = seconds;
  set(EffortInput::step, seconds);
}

/// At the first instant the motion has no derivatives beyond its acceleration.
void DrivenEffort::take_derivatives(const VectorXd& qdd) {
  qdd_ = qdd;
  if (past_.acceleration.size() == 0) {
    jerk_ = VectorXd::Zero(joints_);
    set(EffortInput::jerk, jerk_);
    set(EffortInput::jounce, jerk_);
    return;
  }
  jerk_ = (qdd - past_.acceleration) / step_;
  set(EffortInput::jerk, jerk_);
  if (slot(EffortInput::jounce)) set(EffortInput::jounce, (jerk_ - past_.jerk) / step_);
}

VectorXd DrivenEffort::operator()(const VectorXd& q, const VectorXd& qd, const VectorXd& qdd) {
  set(EffortInput::q, q);
  set(EffortInput::qd, qd);
  set(EffortInput::qdd, qdd);
  set(EffortInput::memory, past_.memory);
  take_derivatives(qdd);
  function_->call(in_.data(), out_.data());
  return out_.head(joints_);
}

void DrivenEffort::remember() {
  past_.memory = out_.tail(past_.memory.size());
  past_.acceleration = qdd_;
  past_.jerk = jerk_;
}

void DrivenEffort::forget() {
  past_.memory.setZero();
  past_.acceleration.resize(0);
  past_.jerk.resize(0);
}

}  // namespace sinew
