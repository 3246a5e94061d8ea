// SPDX-License-Identifier: GPL-3.0-or-later
#include <cvodes/cvodes.h>
#include <fmt/format.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <memory>
#include <stdexcept>

#include "simulation/plant/integrate.h"
#include "simulation/plant/motion_solver.h"

namespace sinew {
namespace {

/// What the C callbacks reach; an exception is kept until CVODE has returned.
struct Callbacks {
  Plant& plant;
  MotionSolver solver;
  std::exception_ptr failure;

  template <typename Body>
  int guarded(Body body) {
    try {
      body();
      return 0;
    } catch (...) {
      failure = std::current_exception();
      return -1;
    }
  }
};

Callbacks& callbacks(void* user) {
  return *static_cast<Callbacks*>(user);
}

int right_hand_side(double time, N_Vector y, N_Vector dy, void* user) {
  Callbacks& c = callbacks(user);
  return c.guarded(
      [&] { c.plant.derivative(time, N_VGetArrayPointer(y), N_VGetArrayPointer(dy)); });
}

/// CVODE's I - gamma J: the Jacobian where the old one is no longer good, and its factors.
int linear_system(double time, N_Vector y, N_Vector, SUNMatrix, booleantype jacobian_is_good,
                  booleantype* renewed, double gamma, void* user, N_Vector, N_Vector, N_Vector) {
  Callbacks& c = callbacks(user);
  return c.guarded([&] {
    *renewed = jacobian_is_good ? SUNFALSE : SUNTRUE;
    if (!jacobian_is_good) c.plant.jacobian(time, N_VGetArrayPointer(y), c.solver.jacobian);
    c.solver.prepare(gamma);
  });
}

int solve(SUNLinearSolver linear, SUNMatrix, N_Vector x, N_Vector b, double) {
  static_cast<MotionSolver*>(linear->content)->solve(N_VGetArrayPointer(b), N_VGetArrayPointer(x));
  return 0;
}

int nothing_to_set_up(SUNLinearSolver, SUNMatrix) {
  return 0;
}

SUNLinearSolver_Type direct(SUNLinearSolver) {
  return SUNLINEARSOLVER_DIRECT;
}

SUNMatrix_ID own_kind(SUNMatrix) {
  return SUNMATRIX_CUSTOM;
}

/// The matrix lives in the MotionSolver; CVODE only wants to hold one.
SUNMatrix placeholder(SUNContext context) {
  SUNMatrix matrix = SUNMatNewEmpty(context);
  matrix->ops->getid = own_kind;
  return matrix;
}

SUNLinearSolver structured_solver(MotionSolver& solver, SUNContext context) {
  SUNLinearSolver linear = SUNLinSolNewEmpty(context);
  linear->ops->gettype = direct;
  linear->ops->setup = nothing_to_set_up;
  linear->ops->solve = solve;
  linear->content = &solver;
  return linear;
}

int quadrature(double time, N_Vector y, N_Vector power, void* user) {
  Callbacks& c = callbacks(user);
  return c.guarded([&] {
    const Powers powers = c.plant.powers(c.plant.evaluated(time, N_VGetArrayPointer(y), true));
    std::copy(powers.begin(), powers.end(), N_VGetArrayPointer(power));
  });
}

int roots(double time, N_Vector y, double* values, void* user) {
  Callbacks& c = callbacks(user);
  return c.guarded([&] { c.plant.events(time, N_VGetArrayPointer(y), values); });
}

// CVODE spends most of its own time in these two, and the library's are not compiled for vectors.

/// z = a x + b y.
void linear_sum(double a, N_Vector x, double b, N_Vector y, N_Vector z) {
  const auto size = NV_LENGTH_S(x);
  const Eigen::Map<const Eigen::ArrayXd> from_x(NV_DATA_S(x), size), from_y(NV_DATA_S(y), size);
  Eigen::Map<Eigen::ArrayXd>(NV_DATA_S(z), size) = a * from_x + b * from_y;
}

/// Root of the mean of (w x)².
double weighted_norm(N_Vector x, N_Vector w) {
  const auto size = NV_LENGTH_S(x);
  const Eigen::Map<const Eigen::ArrayXd> values(NV_DATA_S(x), size), weights(NV_DATA_S(w), size);
  return std::sqrt((values * weights).square().sum() / static_cast<double>(size));
}

/// Powers of friction jump where it turns round: with the motion's own tolerances, as numbers,
/// CVODE may find no step that is short enough there.
constexpr double power_slack = 100.0;

void quiet(int, const char*, const char*, char*, void*) {}

/// CVODES with its vectors, matrix and solver.
class Solver {
 public:
  explicit Solver(Plant& plant) : callbacks_{plant, {}, nullptr}, scenario_(plant.scenario()) {
    SUNContext_Create(nullptr, &context_);
    const auto size = plant.size();
    y_ = N_VNew_Serial(size, context_);
    work_ = N_VNew_Serial(power_count, context_);
    shown_ = N_VNew_Serial(size, context_);
    for (N_Vector each : {y_, work_}) {
      N_VEnableFusedOps_Serial(each, SUNTRUE);
      each->ops->nvlinearsum = linear_sum;
      each->ops->nvwrmsnorm = weighted_norm;
    }
    const Eigen::VectorXd start = plant.initial_state();
    std::copy(start.data(), start.data() + size, N_VGetArrayPointer(y_));
    N_VConst(0.0, work_);
    memory_ =
        CVodeCreate(scenario_.integrator == Integrator::cvode_bdf ? CV_BDF : CV_ADAMS, context_);
    check(CVodeInit(memory_, right_hand_side, 0.0, y_));
    check(CVodeSetErrHandlerFn(memory_, quiet, nullptr));
    check(CVodeSetUserData(memory_, &callbacks_));
    check(CVodeSStolerances(memory_, scenario_.relative_tolerance, scenario_.absolute_tolerance));
    check(CVodeSetMaxNumSteps(memory_, 1000000));
    if (scenario_.longest_step > 0.0) check(CVodeSetMaxStep(memory_, scenario_.longest_step));
    matrix_ = placeholder(context_);
    linear_ = structured_solver(callbacks_.solver, context_);
    check(CVodeSetLinearSolver(memory_, linear_, matrix_));
    check(CVodeSetLinSysFn(memory_, linear_system));
    check(CVodeQuadInit(memory_, quadrature, work_));
    check(CVodeSetQuadErrCon(memory_, SUNTRUE));
    check(CVodeQuadSStolerances(memory_, power_slack * scenario_.relative_tolerance,
                                power_slack * scenario_.absolute_tolerance));
    events_ = static_cast<int>(plant.event_names().size());
    if (events_ > 0) {
      check(CVodeRootInit(memory_, events_, roots));
      check(CVodeSetNoInactiveRootWarn(memory_));
    }
  }
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;
  ~Solver() {
    CVodeFree(&memory_);
    linear_->content = nullptr;
    SUNLinSolFreeEmpty(linear_);
    SUNMatFreeEmpty(matrix_);
    for (N_Vector each : {y_, work_, shown_}) N_VDestroy(each);
    SUNContext_Free(&context_);
  }

  double time() const { return time_; }
  const double* state() const { return N_VGetArrayPointer(y_); }

  /// One internal step, not beyond `stop`. True where it ended at an event.
  bool step(double stop) {
    check(CVodeSetStopTime(memory_, stop));
    const int flag = CVode(memory_, stop, y_, &time_, CV_ONE_STEP);
    if (flag < 0) check(flag);
    callbacks_.plant.accept(time_, state());
    return flag == CV_ROOT_RETURN;
  }

  /// -1, 0 or 1 an event function: none, or the direction of its change.
  std::vector<int> directions() {
    std::vector<int> found(static_cast<std::size_t>(events_));
    check(CVodeGetRootInfo(memory_, found.data()));
    return found;
  }

  /// The commands jump here: what the solver knows of the past is void.
  void restart() {
    check(CVodeGetQuadDky(memory_, time_, 0, work_));
    check(CVodeReInit(memory_, time_, y_));
    check(CVodeQuadReInit(memory_, work_));
  }

  void show(double time, const OnOutput& output) {
    check(CVodeGetDky(memory_, time, 0, shown_));
    output(time, N_VGetArrayPointer(shown_));
  }

  void report(const OnStep& step) {
    Powers work{};
    if (time_ > 0.0) {
      check(CVodeGetQuadDky(memory_, time_, 0, work_));
      std::copy(N_VGetArrayPointer(work_), N_VGetArrayPointer(work_) + power_count, work.begin());
    }
    step(time_, state(), work);
  }

  IntegrationCount count() {
    IntegrationCount c;
    check(CVodeGetNumSteps(memory_, &c.steps));
    check(CVodeGetNumRhsEvals(memory_, &c.evaluations));
    check(CVodeGetNumJacEvals(memory_, &c.jacobians));
    return c;
  }

 private:
  void check(int flag) {
    if (callbacks_.failure) std::rethrow_exception(callbacks_.failure);
    if (flag >= 0) return;
    char* name = CVodeGetReturnFlagName(flag);
    const std::string text = name;
    std::free(name);
    throw std::runtime_error(
        fmt::format("{}: CVODE stopped at {:.6g} s: {}; expected another tolerance or state",
                    scenario_.file, time_, text));
  }

  Callbacks callbacks_;
  const Scenario& scenario_;
  SUNContext context_ = nullptr;
  void* memory_ = nullptr;
  N_Vector y_ = nullptr, work_ = nullptr, shown_ = nullptr;
  SUNMatrix matrix_ = nullptr;
  SUNLinearSolver linear_ = nullptr;
  int events_ = 0;
  double time_ = 0.0;
};

}  // namespace

IntegrationCount integrate_by_cvode(Plant& plant, const IntegrationCalls& calls) {
  const Scenario& scenario = plant.scenario();
  const std::vector<std::string> names = plant.event_names();
  std::vector<double> stops = plant.jumps();
  stops.push_back(scenario.duration);
  Solver solver(plant);
  solver.report(calls.step);
  calls.output(0.0, solver.state());
  IntegrationCount total;
  const auto add = [&] {
    const IntegrationCount now = solver.count();
    total.steps += now.steps;
    total.evaluations += now.evaluations;
    total.jacobians += now.jacobians;
  };
  long next = 1;
  const long last = output_count(scenario);
  for (const double stop : stops) {
    while (solver.time() < stop) {
      const bool at_event = solver.step(stop);
      if (!at_event) solver.report(calls.step);
      for (; next < last && output_time(scenario, next) <= solver.time(); ++next)
        solver.show(output_time(scenario, next), calls.output);
      if (!at_event) continue;
      const std::vector<int> found = solver.directions();
      for (std::size_t i = 0; i < found.size(); ++i)
        if (found[i] != 0) calls.event({solver.time(), names[i], found[i] < 0});
    }
    add();
    if (stop < scenario.duration) solver.restart();
  }
  return total;
}

}  // namespace sinew
