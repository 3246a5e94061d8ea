// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/known_payload.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <stdexcept>

#include "identification/subjects/driven_subject.h"
#include "identification/subjects/slow_recording.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr Index kDriveColumns = 4;   // of each joint: inertia, viscous, Coulomb, offset
constexpr Index kLinkColumns = 10;   // of each link
constexpr Index kCentreColumns = 3;  // of each load's centre
constexpr int kRounds = 3;           // the place's square is small beside the place
constexpr double kTurnShare = 0.01;  // of the top speed, over which friction turns
constexpr double kRidge = 1e-8;      // of a column's square: what logs cannot tell stays small

bool carries(const KnownPayload& payload, const Recording& log) {
  return std::find(payload.recordings.begin(), payload.recordings.end(), log.name) !=
         payload.recordings.end();
}

/// Links whose own parameters the logs tell beside the loads. Of a load that is always there they
/// tell none: along a joint's axis its first moment is its neighbour's, too.
std::vector<std::string> open_links(const std::vector<Recording>& training,
                                    const RigidColumns& rigid,
                                    const std::vector<KnownPayload>& loads) {
  const auto is_always_there = [&](const KnownPayload& load) {
    return std::all_of(training.begin(), training.end(), [&](const Recording& log) {
      return carries(load, log) && log.payload.minCoeff() > 0.5 * load.mass;
    });
  };
  if (std::any_of(loads.begin(), loads.end(), is_always_there)) return {};
  return rigid.moving_links();
}

/// Columns of all that is fitted, for one joint of one log.
class Columns {
 public:
  /// `links`: those whose own parameters are fitted.
  Columns(const Recording& log, const RigidColumns& rigid, const std::vector<std::string>& links,
          const std::vector<KnownPayload>& loads)
      : log_(log), loads_(loads) {
    for (const std::string& link : links) links_.push_back(rigid.mass_columns(link, log));
    for (const KnownPayload& load : loads) {
      if (!carries(load, log)) continue;
      own_.push_back(log.payload.asDiagonal() * rigid.mass_columns(load.link, log));
      asked_.push_back(log.payload.asDiagonal() *
                       rigid.point_mass(load.link, load.centre.value_or(Vector3d::Zero()), log));
    }
  }

  Index count() const {
    return kLinkColumns * static_cast<Index>(links_.size()) + kDriveColumns * log_.q.cols() +
           kCentreColumns * static_cast<Index>(loads_.size());
  }

  /// What the loads ask where they are thought to be, without what is linear in the place: their
  /// weight at the links' frames, and the square of the distance in their moments of inertia.
  VectorXd bent(Index joint) const {
    VectorXd sum = VectorXd::Zero(log_.q.rows());
    std::size_t k = 0;
    for (const KnownPayload& load : loads_) {
      if (!carries(load, log_)) continue;
      const auto first = own_[k].middleCols(joint * kLinkColumns + 1, kCentreColumns);
      sum += asked_[k++].col(joint) - first * load.centre.value_or(Vector3d::Zero());
    }
    return sum;
  }

  MatrixXd of(Index joint) const {
    MatrixXd x = MatrixXd::Zero(log_.q.rows(), count());
    Index at = 0;
    for (const MatrixXd& link : links_) {
      x.middleCols(at, kLinkColumns) = link.middleCols(joint * kLinkColumns, kLinkColumns);
      at += kLinkColumns;
    }
    const VectorXd speed = log_.qd.col(joint);
    const double turn = kTurnShare * std::max(speed.cwiseAbs().maxCoeff(), 1e-12);
    const VectorXd direction = (speed / turn).array().tanh();
    x.middleCols(at + kDriveColumns * joint, kDriveColumns) << log_.qdd.col(joint), speed,
        direction, VectorXd::Ones(speed.size());
    at += kDriveColumns * log_.q.cols();
    std::size_t k = 0;
    for (const KnownPayload& load : loads_) {
      if (carries(load, log_))
        x.middleCols(at, kCentreColumns) =
            own_[k++].middleCols(joint * kLinkColumns + 1, kCentreColumns);
      at += kCentreColumns;
    }
    return x;
  }

 private:
  const Recording& log_;
  const std::vector<KnownPayload>& loads_;
  std::vector<MatrixXd> links_, own_, asked_;
};

/// Every joint in units of its own effort.
struct NormalEquations {
  MatrixXd gram;
  VectorXd right;

  void add(const Columns& columns, const Recording& slow, const MatrixXd& said) {
    if (gram.size() == 0) {
      gram = MatrixXd::Zero(columns.count(), columns.count());
      right = VectorXd::Zero(columns.count());
    }
    for (Index j = 0; j < slow.q.cols(); ++j) {
      const VectorXd& measured = slow.target[static_cast<std::size_t>(j)];
      const double scale = std::max(measured.norm() / std::sqrt(double(measured.size())), 1e-12);
      const MatrixXd x = columns.of(j) / scale;
      const VectorXd left = (measured - said.col(j) - columns.bent(j)) / scale;
      gram.noalias() += x.transpose() * x;
      right.noalias() += x.transpose() * left;
    }
  }

  VectorXd solved() const {
    const VectorXd size = gram.diagonal().cwiseMax(1e-30).cwiseSqrt();
    MatrixXd scaled = size.cwiseInverse().asDiagonal() * gram * size.cwiseInverse().asDiagonal();
    scaled.diagonal().array() += kRidge;
    return size.cwiseInverse().asDiagonal() *
           scaled.ldlt().solve(VectorXd(size.cwiseInverse().asDiagonal() * right));
  }
};

/// Columns of the load's first moments, three a joint; zero where the log does not carry it.
MatrixXd moments_of(const KnownPayload& payload, const RigidColumns& rigid, const Recording& log) {
  MatrixXd moments = MatrixXd::Zero(log.q.rows(), kCentreColumns * log.q.cols());
  if (!carries(payload, log)) return moments;
  const MatrixXd own = log.payload.asDiagonal() * rigid.mass_columns(payload.link, log);
  for (Index j = 0; j < log.q.cols(); ++j)
    moments.middleCols(j * kCentreColumns, kCentreColumns) =
        own.middleCols(j * kLinkColumns + 1, kCentreColumns) / payload.mass;
  return moments;
}

}  // namespace

KnownPayload known_payload(const CarriedPayload* told, const RigidColumns& rigid) {
  KnownPayload payload;
  const std::vector<std::string> last = rigid.last_links();
  if (told) payload = {told->link, told->mass, told->centre, {}, {}};
  if (payload.link.empty() && last.size() != 1)
    throw std::invalid_argument(
        "a payload's link has to be said where several links may carry it: payload@LINK");
  if (payload.link.empty()) payload.link = last.front();
  return payload;
}

void fit_centres(const std::vector<Recording>& training, const EffortModel& model,
                 const RigidColumns& rigid, std::vector<KnownPayload>& payloads) {
  std::vector<KnownPayload> open;
  for (const KnownPayload& payload : payloads)
    if (!payload.centre) open.push_back(payload);
  if (open.empty()) return;
  for (const KnownPayload& payload : open)
    if (std::none_of(training.begin(), training.end(),
                     [&](const Recording& log) { return carries(payload, log); }))
      throw std::invalid_argument(fmt::format(
          "no log to learn from carries the {:.4g} kg at {}, so that their centre stays unknown; "
          "say it (payload={:.4g}kg at X, Y, Z m), or give such a log to --log",
          payload.mass, payload.link, payload.mass));
  const std::vector<std::string> links = open_links(training, rigid, open);
  for (int round = 0; round < kRounds; ++round) {
    NormalEquations equations;
    for (const Recording& log : training) {
      const Recording slow = slow_recording(log);
      if (slow.q.size() > 0) equations.add(Columns(slow, rigid, links, open), slow, model(slow));
    }
    const VectorXd fitted = equations.solved();  // the centres come last
    Index at = fitted.size() - kCentreColumns * static_cast<Index>(open.size());
    for (KnownPayload& payload : open) {
      payload.centre = fitted.segment<3>(at);
      at += kCentreColumns;
    }
  }
  std::size_t next = 0;
  for (KnownPayload& payload : payloads)
    if (!payload.centre) {
      payload.centre = open[next++].centre;
      payload.is_free = links.empty();
    }
}

std::string centre_signal(const KnownPayload& payload) {
  return fmt::format("centre of {} kg at {}", payload.mass, payload.link);
}

Candidate free_centre(const KnownPayload& payload) {
  Candidate c;
  c.name = "centre of the payload";
  c.place = "link " + payload.link;
  for (const char* axis : {"x", "y", "z"}) {
    LinearParameter moment;
    moment.name = fmt::format("first_moment_{}", axis);
    moment.unit = "kg*m";
    c.linear.push_back(moment);
  }
  c.columns = [signal = centre_signal(payload)](const Recording& log, int channel,
                                                const VectorXd&) -> MatrixXd {
    const MatrixXd* moments = log.signals.find(signal);
    // A motion that is proposed carries no load.
    if (!moments) return MatrixXd::Zero(log.q.rows(), kCentreColumns);
    return moments->middleCols(channel * kCentreColumns, kCentreColumns);
  };
  return c;
}

/// The mass over time: a column's, or what was told of the whole log.
void DrivenSubject::add_payload(const Log& log, const sinew::Segment& segment,
                                const DrivenColumns& columns, const CarriedPayload* carried,
                                Recording& r) {
  if (columns.payload < 0 && !carried) return;
  if (columns.payload >= 0 && carried && carried->mass > 0.0)
    throw std::invalid_argument(log.file +
                                ": its payload is told twice, by --condition and by its column "
                                "'payload'; leave one out");
  if (!rigid_ || tendons_)
    throw std::invalid_argument(
        "--condition payload: is for robots whose joints' efforts are "
        "logged; this model has no link that carries one");
  r.payload = columns.payload >= 0 ? VectorXd(segment.samples.col(columns.payload).matrix())
                                   : VectorXd::Constant(r.q.rows(), carried->mass);
  if (r.payload.isZero(0.0)) {
    r.payload.resize(0);
    return;
  }
  KnownPayload payload = known_payload(carried, *rigid_);
  if (columns.payload >= 0) payload.mass = r.payload.maxCoeff();
  const auto same = std::find_if(payloads_.begin(), payloads_.end(), [&](const KnownPayload& p) {
    return p.link == payload.link && p.mass == payload.mass && p.centre == payload.centre;
  });
  KnownPayload& owner =
      same != payloads_.end() ? *same : payloads_.emplace_back(std::move(payload));
  owner.recordings.push_back(r.name);
  if (owner.logs.empty() || owner.logs.back() != log.file) owner.logs.push_back(log.file);
}

/// What it asks of the joints, in all logs that carry it.
void DrivenSubject::take(const KnownPayload& payload) {
  for (auto* logs : {&problem_.training, &problem_.holdout})
    for (Recording& log : *logs) {
      if (carries(payload, log))
        log.payload_effort =
            log.payload.asDiagonal() * rigid_->point_mass(payload.link, *payload.centre, log);
      if (payload.is_free) log.signals[centre_signal(payload)] = moments_of(payload, *rigid_, log);
    }
}

std::vector<PayloadNote> DrivenSubject::take_payloads() {
  std::vector<PayloadNote> notes;
  if (payloads_.empty()) return notes;
  std::vector<bool> told;
  for (const KnownPayload& payload : payloads_) told.push_back(payload.centre.has_value());
  for (const KnownPayload& payload : payloads_)
    if (payload.centre) take(payload);
  fit_centres(problem_.training, effort_, *rigid_, payloads_);
  for (std::size_t i = 0; i < payloads_.size(); ++i) {
    const KnownPayload& payload = payloads_[i];
    if (!told[i]) take(payload);
    const Vector3d& c = *payload.centre;
    const std::string text = fmt::format(
        "a payload of {:.4g} kg at {} is no deviation, as told; its centre is at {:.3g}, {:.3g}, "
        "{:.3g} m in the link's frame, {}",
        payload.mass, payload.link, c.x(), c.y(), c.z(),
        told[i] ? "as told" : "which was fitted to the logs");
    for (const std::string& log : payload.logs) notes.push_back({log, text});
  }
  return notes;
}

}  // namespace sinew::diagnosis
