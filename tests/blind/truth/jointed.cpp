// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blind/truth/jointed.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "tests/blind/truth/compared.h"
#include "tests/blind/truth/in_motion.h"
#include "tests/blind/truth/signal_path.h"

namespace sinew::trials {
namespace {

const Hidden* find(const std::vector<Hidden>& hidden, const std::string& cause, int at) {
  for (const Hidden& h : hidden)
    if (h.cause == cause && h.at == at && h.dose != 0.0) return &h;
  return nullptr;
}

/// Any direction, the same whenever it is asked.
Vector3d direction_of(const Hidden& h) {
  truth::Draw draw(h.seed);
  const double up = draw.uniform(-1.0, 1.0), around = draw.uniform(0.0, 2.0 * pi);
  const double flat = std::sqrt(1.0 - up * up);
  return {flat * std::cos(around), flat * std::sin(around), up};
}

constexpr double softest = 2.0 * pi * 4.0;  // rad/s: dose 1 of gear_elasticity

/// What hangs behind a soft gear, or beyond a gap: follows the motor by itself.
class Behind {
 public:
  Behind(const std::vector<Hidden>& hidden, int axis)
      : soft_(find(hidden, "gear_elasticity", axis)), gap_(find(hidden, "backlash", axis)) {}
  bool there() const { return soft_ || gap_; }

  void start(double q, double v) {
    q_ = q;
    v_ = v;
  }
  /// Pull of the load on the motor; `asked`: what the load asks for beside its inertia.
  double pull(double q, double v, double inertia, double asked, double step) {
    const double w = soft_ ? softest / std::sqrt(std::max(soft_->dose, 1e-9)) : 2.0 * pi * 90.0;
    const double k = inertia * std::min(w * w, 0.2 / (step * step));
    const double d = (soft_ ? 0.06 : 0.5) * std::sqrt(k * inertia);
    const double gap = gap_ ? 0.5 * gap_->dose : 0.0;
    if (!settled_) {
      // The log begins with the load carried.
      q_ = q - asked / k - (gap_ ? std::copysign(gap, asked) : 0.0);
      settled_ = true;
    }
    const double stretch = q - q_;
    double pull = 0.0;
    if (std::abs(stretch) > gap) {
      pull = k * (stretch - std::copysign(gap, stretch)) + d * (v - v_);
      // A contact does not hold back.
      if (gap_ && pull * stretch < 0.0) pull = 0.0;
    }
    a_ = (pull - asked) / inertia;
    v_ += step * a_;
    q_ += step * v_;
    return pull;
  }
  double acceleration() const { return a_; }

 private:
  const Hidden *soft_, *gap_;
  double q_ = 0.0, v_ = 0.0, a_ = 0.0;
  bool settled_ = false;
};

// Of the range: docs/diagnosis_rules.md names them.
constexpr double bristle_lengths[] = {1e-5, 1e-4, 1e-3, 1e-2};

/// What bristles of one length hold back, less what friction does that turns at once.
VectorXd late_turning(const AxisModel& model, const VectorXd& v, double step, double length) {
  VectorXd late(v.size());
  double bent = v.size() > 0 && v(0) < 0.0 ? -1.0 : 1.0;
  for (Index k = 0; k < v.size(); ++k) {
    const double side = v(k) < 0.0 ? -1.0 : 1.0;
    bent = side + (bent - side) * std::exp(-std::abs(v(k)) * step / length);
    const double full =
        model.turning > 0.0 ? 2.0 / pi * std::atan(std::abs(v(k)) / model.turning) : 1.0;
    late(k) = full * (bent - side);
  }
  return late;
}

}  // namespace

Chain true_chain(const Chain& chain, const std::vector<Hidden>& hidden) {
  Chain real = chain;
  for (const Hidden& h : hidden) {
    if (h.cause == "payload") real.payload += h.dose;
    if (h.cause == "link_mass") {
      Link& link = real.links[static_cast<std::size_t>(h.at)];
      link.inertia *= (link.mass + h.dose) / link.mass;
      link.mass += h.dose;
    }
    if (h.cause == "link_centre")
      real.links[static_cast<std::size_t>(h.at)].com += h.dose * direction_of(h);
    if (h.cause == "link_products") {
      Eigen::Matrix3d& inertia = real.links[static_cast<std::size_t>(h.at)].inertia;
      const Eigen::Matrix3d turn = Eigen::AngleAxisd(h.dose, direction_of(h)).toRotationMatrix();
      inertia = (turn * inertia * turn.transpose()).eval();
    }
    if (h.cause == "coupling_ratio")
      real.links[static_cast<std::size_t>(h.at)].follows *= 1.0 + h.dose;
    if (h.cause == "gravity_left_out") real.gravity += h.dose * direction_of(h);
    if (h.cause == "gravity") {
      const Vector3d about(std::cos(h.phase), std::sin(h.phase), 0.3 * std::sin(3.0 * h.phase));
      real.gravity =
          Eigen::AngleAxisd(h.dose, about.normalized()).toRotationMatrix() * real.gravity;
    }
  }
  return real;
}

MatrixXd needed_efforts(const Jointed& jointed, const Course& course,
                        const std::vector<Hidden>& hidden) {
  const Chain chain = true_chain(jointed.chain, hidden);
  const Index n = chain.size(), rows = course.rows();
  MatrixXd efforts(rows, n);
  std::vector<Axis> axes;
  std::optional<Behind> behind;
  int soft = -1;
  for (Index j = 0; j < n; ++j) {
    const auto i = static_cast<std::size_t>(j);
    const int at = static_cast<int>(j);
    axes.emplace_back(jointed.axes[i], jointed.bristles[i], only_at(hidden, at));
    if (Behind b(hidden, at); b.there()) behind = b, soft = at;
  }
  const double step = course.step;
  for (Index k = 0; k < rows; ++k) {
    const Index first = k * course.inner;
    const Index before = std::max<Index>(first - 1, 0);
    const VectorXd q = course.q.row(first), v = course.v.row(first);
    const VectorXd motor = 0.5 * (course.a.row(first) + course.a.row(before));
    VectorXd a = motor;
    const double known = course.load.size() > 0 ? course.load(first) : 0.0;
    double pull = 0.0, carried = 0.0;
    if (behind) {
      carried = chain.carried(q, soft);
      const double behind_gear = (1.0 - jointed.motor_share) * carried;
      VectorXd held = a;
      held(soft) = 0.0;
      const double asked = chain.torque(q, v, held)(soft) + known;
      if (k == 0) behind->start(q(soft), v(soft));
      // As much before the instant as behind it: half a row's lead would be an effect of its own.
      const Index begin = std::max<Index>(first - course.inner / 2, 0),
                  end = first + course.inner - course.inner / 2;
      for (Index i = begin; i < end; ++i)
        pull += behind->pull(course.q(i, soft), course.v(i, soft), behind_gear, asked, step) /
                static_cast<double>(end - begin);
      a(soft) = (pull - asked) / behind_gear;
    }
    VectorXd rigid = chain.torque(q, v, a);
    // What turns with the motor does not lag behind.
    if (behind) rigid(soft) += jointed.motor_share * carried * (motor(soft) - a(soft));
    for (Index j = 0; j < n; ++j) {
      const Link& link = chain.links[chain.link_of(j)];
      Axis& axis = axes[static_cast<std::size_t>(j)];
      const double load = (jointed.carries ? rigid(j) : 0.0) + known;
      for (int s = 0; s < course.inner; ++s) {
        const Index i = first + s;
        const double r =
            axis.resist({step * static_cast<double>(i), course.q(i, j), course.v(i, j),
                         0.5 * (course.a(i, j) + course.a(std::max<Index>(i - 1, 0), j)), load},
                        step);
        if (s == 0) efforts(k, j) = rigid(j) + known + link.armature * motor(j) + r;
      }
    }
  }
  return efforts;
}

Course commanded(const Jointed& jointed, const Rhythm& rhythm, truth::Draw draw) {
  const auto n = static_cast<Index>(jointed.axes.size());
  const auto rows = static_cast<Index>(std::lround(rhythm.seconds / rhythm.period));
  Course course;
  course.inner = rhythm.inner;
  course.step = rhythm.period / rhythm.inner;
  const Index steps = rows * rhythm.inner;
  course.q = course.v = course.a = MatrixXd::Zero(steps, n);
  for (Index j = 0; j < n; ++j) {
    const AxisModel& axis = jointed.axes[static_cast<std::size_t>(j)];
    const auto table =
        truth::Motion(rhythm.kind, axis.range, axis.top_speed, rhythm.seconds, draw.fork())
            .table(course.step, static_cast<std::size_t>(steps));
    for (Index k = 0; k < steps; ++k) {
      const truth::Reference& r = table[static_cast<std::size_t>(k)];
      course.q(k, j) = jointed.middle[static_cast<std::size_t>(j)] + r.position;
      course.v(k, j) = r.velocity;
    }
    // As an integrator leaves it: between one step and the next. Rows take the mean of both sides.
    for (Index k = 0; k < steps; ++k)
      course.a(k, j) = k + 1 < steps ? (course.v(k + 1, j) - course.v(k, j)) / course.step
                                     : table.back().acceleration;
  }
  return course;
}

Course given(const MatrixXd& reference, const Rhythm& rhythm) {
  Course course;
  course.inner = rhythm.inner;
  course.step = rhythm.period / rhythm.inner;
  const Index rows = reference.rows(), steps = rows * rhythm.inner;
  MatrixXd speed = MatrixXd::Zero(rows, reference.cols());
  for (Index k = 1; k + 1 < rows; ++k)
    speed.row(k) = (reference.row(k + 1) - reference.row(k - 1)) / (2.0 * rhythm.period);
  course.q = course.v = course.a = MatrixXd::Zero(steps, reference.cols());
  course.q.row(0) = reference.row(0);
  for (Index i = 0; i < steps; ++i) {
    const Index k = i / rhythm.inner, next = std::min(k + 1, rows - 1);
    const double share = static_cast<double>(i % rhythm.inner) / rhythm.inner;
    course.v.row(i) = (1.0 - share) * speed.row(k) + share * speed.row(next);
    course.q.row(i) = (1.0 - share) * reference.row(k) + share * reference.row(next);
    course.a.row(i) = (speed.row(next) - speed.row(k)) / rhythm.period;
  }
  return course;
}

VectorXd at_its_speed(const VectorXd& q, const VectorXd& v, double step) {
  return q - 0.5 * step * v;
}

Course in_closed_loop(const Jointed& jointed, const std::vector<Hidden>& hidden,
                      const Course& wanted, const VectorXd& load, truth::Draw draw) {
  Course course = wanted;
  course.load = load;
  const AxisModel& model = jointed.axes.front();
  const Chain chain = true_chain(jointed.chain, hidden);
  Axis axis(model, jointed.bristles.front(), only_at(hidden, 0));
  Behind behind(hidden, 0);
  truth::Draw tuned = draw.fork();
  const double bandwidth = 2.0 * pi * tuned.uniform(6.0, 11.0), damping = tuned.uniform(0.7, 1.0);
  const double help = tuned.uniform(0.5, 0.9), step = course.step;
  const VectorXd zero = VectorXd::Zero(1);
  VectorXd q = wanted.q.row(0), v = wanted.v.row(0);
  behind.start(q(0), v(0));
  double resisting = 0.0, extra = 0.0;
  for (const Hidden& h : hidden)
    if (h.cause == "inertia") extra = h.dose;
  // One link: what it carries is the same everywhere, and its weight is all that its place changes.
  const double carried = chain.carried(q, 0), rotor = chain.links.front().armature;
  const double nominal = jointed.chain.carried(q, 0) + rotor;
  const auto weight_of = [&zero](const Chain& c, const VectorXd& at) {
    return c.gravity.isZero() ? 0.0 : c.torque(at, zero, zero)(0);
  };
  for (Index k = 0; k < course.q.rows(); ++k) {
    const double known = load.size() > 0 ? load(k) : 0.0;
    const double asked = weight_of(chain, q) + known;
    const double turning = model.turning > 0.0 ? model.turning : 0.02 * model.top_speed;
    const double command =
        nominal * (bandwidth * bandwidth * (wanted.q(k, 0) - q(0)) +
                   2.0 * damping * bandwidth * (wanted.v(k, 0) - v(0)) + wanted.a(k, 0)) +
        weight_of(jointed.chain, q) + known +
        help * (model.level * std::tanh(wanted.v(k, 0) / turning) + model.viscous * wanted.v(k, 0));
    double inertia = carried + rotor, against = asked;
    if (behind.there()) {
      against = behind.pull(q(0), v(0), (1.0 - jointed.motor_share) * carried, asked, step);
      inertia = rotor + jointed.motor_share * carried;
    }
    const double a = (command - resisting - against) /
                     (inertia + std::max(extra, -0.8 * inertia) + step * axis.slope(v(0), step));
    course.q.row(k) = at_its_speed(q, v, step).transpose();
    course.v(k, 0) = v(0);
    course.a(k, 0) = a;
    v(0) += step * a;
    q(0) += step * v(0);
    resisting = axis.resist({step * static_cast<double>(k + 1), q(0), v(0), 0.0, known}, step);
  }
  return course;
}

MatrixXd fitted_at(const AxisModel& model, const VectorXd& v, const VectorXd& a, double step,
                   unsigned which) {
  std::vector<VectorXd> columns;
  const auto side = [](double x) { return x < 0.0 ? -1.0 : 1.0; };
  if (which & fits_inertia) columns.push_back(a);
  if (which & fits_viscous) columns.push_back(v);
  if (which & fits_coulomb)
    columns.push_back(v.unaryExpr(
        [&](double x) { return model.turning > 0.0 ? std::atan(x / model.turning) : side(x); }));
  if (which & fits_offset) columns.push_back(VectorXd::Ones(v.size()));
  if (which & fits_turning)
    for (const double share : bristle_lengths)
      columns.push_back(late_turning(model, v, step, 2.0 * model.range * share));
  MatrixXd all(v.size(), static_cast<Index>(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i) all.col(static_cast<Index>(i)) = columns[i];
  return all;
}

VectorXd in_motion(const VectorXd& q, double step) {
  const double fast = documented_band(step), slow = std::min(18.0, fast);
  return weight_of(rests_of(smoothed(q, step, fast).v, smoothed(q, step, slow).v, step, fast),
                   q.size(), step);
}

double band_of(const VectorXd& perfect, const VectorXd& measured, double step, double band) {
  constexpr double low = 18.0;
  if (band <= low) return band;
  const auto above = [&](const VectorXd& x) {
    return rms(smoothed(x, step, band).a - smoothed(x, step, low).a);
  };
  return above(measured) < 2.0 * above(measured - perfect) ? low : band;
}

void learn_scales(Jointed& jointed, const Course& course) {
  const MatrixXd efforts = needed_efforts(jointed, course, {});
  for (std::size_t i = 0; i < jointed.axes.size(); ++i) {
    const auto j = static_cast<Index>(i);
    jointed.axes[i].effort = rms(efforts.col(j));
    jointed.axes[i].inertia = jointed.chain.carried(course.q.row(0), j) +
                              jointed.chain.links[jointed.chain.link_of(j)].armature;
  }
}

}  // namespace sinew::trials
