// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/observed_subject.h"

#include <algorithm>
#include <stdexcept>

#include "generator/assemble.h"
#include "generator/cost.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct InputSlot {
  const MatrixXd* signal = nullptr;
  Index at = 0, count = 0;
};

Index size_of(const sinew_argument& argument) {
  return static_cast<Index>(argument.rows) * argument.cols;
}

/// Values learnt before, in the order of the deviations or shapes.
VectorXd values_of(const Observation& observation, const Identified& identified, bool shapes) {
  std::vector<double> values;
  for (const ObservationEffect& effect : observation.effects)
    for (const ObservationParameter& p : shapes ? effect.shapes : effect.deviations) {
      values.push_back(shapes ? p.high : 0.0);
      for (const IdentifiedEffect& entry : identified.effects)
        if (entry.effect == effect.id && entry.place == effect.place)
          for (const IdentifiedValue& v : shapes ? entry.shape : entry.coefficients)
            if (v.name == p.name) values.back() = v.value;
    }
  return VectorXd::Map(values.data(), static_cast<Index>(values.size()));
}

LinearParameter linear_of(const ObservationParameter& p, double learnt) {
  return {p.name, p.unit, p.low - learnt, p.high - learnt, false, {}};
}

std::string key_of(const ObservationEffect& effect) {
  return "change by " + effect.id + " at " + effect.place;
}

}  // namespace

ObservedModel::ObservedModel(const std::string& model, const Function& function,
                             const std::filesystem::path& runtime) {
  const EmittedModel emitted = assemble({model, "What its sensors read", "", {}}, {function}, {});
  operations_ = count_operations(emitted.functions.front()).operations();
  compiled_ = std::make_shared<CompiledModel>(emitted, runtime);
}

MatrixXd ObservedModel::operator()(const Recording& log, const VectorXd& deviation,
                                   const VectorXd& shape,
                                   const std::map<std::string, MatrixXd>* instead) const {
  const sinew_function& function = compiled_->find("observation");
  VectorXd in = VectorXd::Zero(function.input_size), out(function.output_size);
  std::vector<InputSlot> slots;
  Index at = 0, state = -1, states = 0;
  for (int i = 0; i < function.input_count; ++i) {
    const sinew_argument& argument = function.inputs[i];
    const std::string name = argument.name;
    const Index count = size_of(argument);
    const MatrixXd* given = log.signals.find(name);
    if (instead && instead->contains(name))
      slots.push_back({&instead->at(name), at, count});
    else if (name == "step")
      in(at) = log.step;
    else if (name == "memory")
      state = at, states = count;
    else if (name == "deviation")
      in.segment(at, count) = deviation;
    else if (name == "shape")
      in.segment(at, count) = shape;
    else if (given)
      slots.push_back({given, at, count});
    else
      throw std::logic_error("the recording has no signal '" + name + "'");
    at += count;
  }
  const Index channels = size_of(function.outputs[0]);
  MatrixXd measured(log.time.size(), channels);
  for (Index k = 0; k < measured.rows(); ++k) {
    for (const InputSlot& slot : slots)
      in.segment(slot.at, slot.count) = slot.signal->row(k).transpose();
    function.call(in.data(), out.data());
    measured.row(k) = out.head(channels).transpose();
    measured.row(k).head(units_.size()).array() /= units_.transpose().array();
    if (state >= 0) in.segment(state, states) = out.segment(channels, states);
  }
  return measured;
}

ObservedSubject::ObservedSubject(Observation observation, std::vector<ObservedChannel> channels,
                                 Identified identified, std::filesystem::path runtime)
    : observation_(std::move(observation)),
      channels_(std::move(channels)),
      identified_(std::move(identified)),
      runtime_(std::move(runtime)),
      open_(observation_.model, open_observation(observation_), runtime_),
      learnt_(values_of(observation_, identified_, false)),
      shapes_(values_of(observation_, identified_, true)) {
  problem_.channels = static_cast<int>(channels_.size());
  problem_.unlike_channels = true;
  Index deviations = 0, shapes = 0;
  for (const ObservationEffect& effect : observation_.effects) {
    first_deviation_.push_back(deviations);
    first_shape_.push_back(shapes);
    deviations += static_cast<Index>(effect.deviations.size());
    shapes += static_cast<Index>(effect.shapes.size());
  }
}

void ObservedSubject::add(Recording recording, bool held_out) {
  (held_out ? problem_.holdout : problem_.training).push_back(std::move(recording));
}

void ObservedSubject::set_units() {
  VectorXd energy = VectorXd::Zero(static_cast<Index>(channels_.size()));
  double count = 1e-300;
  for (const Recording& log : problem_.training) {
    const MatrixXd said = open_(log, learnt_, shapes_);
    for (Index c = 0; c < energy.size(); ++c) {
      const VectorXd left = log.target[static_cast<std::size_t>(c)] - said.col(c);
      energy(c) += (left.array() - left.mean()).square().sum();
    }
    count += static_cast<double>(said.rows());
  }
  units_ = (energy / count).cwiseSqrt().cwiseMax(1e-12);
  open_.set_units(units_);
  for (auto* logs : {&problem_.training, &problem_.holdout})
    for (Recording& log : *logs)
      for (std::size_t c = 0; c < log.target.size(); ++c)
        log.target[c] /= units_(static_cast<Index>(c));
}

void ObservedSubject::set_known() {
  for (auto* logs : {&problem_.training, &problem_.holdout})
    for (Recording& log : *logs) {
      const MatrixXd said = open_(log, learnt_, shapes_);
      log.known.clear();
      for (Index c = 0; c < units_.size(); ++c) log.known.push_back(said.col(c));
      log.signals["said"] = said;
    }
}

void ObservedSubject::prepare() {
  set_units();
  set_known();
  problem_.library.clear();
  origins_.clear();
  for (std::size_t i = 0; i < observation_.effects.size(); ++i) add_effect(i);
}

std::function<MatrixXd(const Recording&, const VectorXd&)> ObservedSubject::derivative_columns(
    Index at, Index shape_at, const std::vector<double>& steps) const {
  const Index channels = static_cast<Index>(channels_.size());
  return [open = open_, learnt = learnt_, shapes = shapes_, at, shape_at, steps, channels](
             const Recording& log, const VectorXd& nonlinear) {
    VectorXd shape = shapes;
    shape.segment(shape_at, nonlinear.size()) = nonlinear;
    MatrixXd all(log.time.size(), channels * static_cast<Index>(steps.size()));
    for (std::size_t p = 0; p < steps.size(); ++p) {
      VectorXd up = learnt, down = learnt;
      up(at + static_cast<Index>(p)) += steps[p];
      down(at + static_cast<Index>(p)) -= steps[p];
      all.middleCols(channels * static_cast<Index>(p), channels) =
          (open(log, up, shape) - open(log, down, shape)).leftCols(channels) / (2.0 * steps[p]);
    }
    return all;
  };
}

void ObservedSubject::add_effect(std::size_t index) {
  const ObservationEffect& effect = observation_.effects[index];
  const Index at = first_deviation_[index], shape_at = first_shape_[index];
  Candidate c;
  c.name = effect.name;
  c.place = effect.place;
  c.channels = effect.outputs;
  c.limit_meaning = effect.limit;
  c.isolating_experiment = effect.experiment;
  std::vector<double> steps;
  for (std::size_t p = 0; p < effect.deviations.size(); ++p) {
    c.linear.push_back(linear_of(effect.deviations[p], learnt_(at + static_cast<Index>(p))));
    steps.push_back(effect.deviations[p].step);
  }
  for (const ObservationParameter& p : effect.shapes)
    c.nonlinear.push_back({p.name, p.unit, p.low, p.high, static_cast<int>(p.step), p.low > 0.0});
  const Index channels = static_cast<Index>(channels_.size());
  const auto derivative = derivative_columns(at, shape_at, steps);
  const std::string key = key_of(effect);
  if (effect.shapes.empty())
    for (auto* logs : {&problem_.training, &problem_.holdout})
      for (Recording& log : *logs) log.signals[key] = derivative(log, VectorXd());
  c.columns = [derivative, key, channels, acts = effect.outputs](
                  const Recording& log, int channel, const VectorXd& nonlinear) -> MatrixXd {
    if (!acts.empty() && std::find(acts.begin(), acts.end(), channel) == acts.end()) return {};
    const MatrixXd* cached = log.signals.find(key);
    const MatrixXd all = cached ? *cached : derivative(log, nonlinear);
    MatrixXd columns(all.rows(), all.cols() / channels);
    for (Index p = 0; p < columns.cols(); ++p) columns.col(p) = all.col(p * channels + channel);
    return columns;
  };
  problem_.library.push_back(std::move(c));
  origins_.push_back({static_cast<int>(index), effect.id});
}

void ObservedSubject::add_offset(int channel) {
  Candidate c;
  c.name = "zero of " + channels_[static_cast<std::size_t>(channel)].name;
  c.place = channels_[static_cast<std::size_t>(channel)].name;
  c.channels = {channel};
  c.linear = {{"zero", channels_[static_cast<std::size_t>(channel)].unit, -1e300, 1e300, true, {}}};
  c.columns = [channel, one = 1.0 / units_(channel)](const Recording& log, int at,
                                                     const VectorXd&) -> MatrixXd {
    if (at != channel) return {};
    return MatrixXd::Constant(log.time.size(), 1, one);
  };
  problem_.baseline.push_back(std::move(c));
}

void ObservedSubject::add_candidate(Candidate candidate, const std::string& id) {
  problem_.library.push_back(std::move(candidate));
  origins_.push_back({-1, id});
}

}  // namespace sinew::diagnosis
