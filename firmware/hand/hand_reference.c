/* SPDX-License-Identifier: BSD-2-Clause */
#include <string.h>

#include "hand.h"
#include "hand_parts.h"
#include "thumb.h"

#define LARGEST_RATE 100.0         /* rad/s */
#define LARGEST_ACCELERATION 1.0e4 /* rad/s^2 */
#define LARGEST_GRAVITY 100.0      /* m/s^2 */
#define SHARE_KEPT 0.05            /* of the pretension, in every tendon */

/* A group that does not follow: its reference is where the joints are. */
static void leave_reference(hand_state *s, const hand_output *out, uint32_t first, uint32_t end) {
  for (uint32_t j = first; j < end; ++j) {
    s->tick.qd[j] = s->tick.qdd[j] = 0.0;
    s->reference[j] = s->tick.later[j] = out->q[j];
  }
}

/* The reference goes from where it was towards the wanted position at a bounded rate. */
static uint32_t approach(hand_state *s, const hand_parameters *p, const hand_input *in,
                         const double *from, uint32_t first, uint32_t end) {
  const double step = p->reference_rate * p->period;
  uint32_t status = SINEW_FINE;
  for (uint32_t j = first; j < end; ++j) {
    double position = in->q[j], qd = in->qd[j], qdd = in->qdd[j];
    if (!(sinew_magnitude(qd) <= LARGEST_RATE && sinew_magnitude(qdd) <= LARGEST_ACCELERATION &&
          sinew_is_within(position, p->joint_low[j], p->joint_high[j]))) {
      status = HAND_SETPOINT;
      qd = sinew_limited(qd, -LARGEST_RATE, LARGEST_RATE, 0.0);
      qdd = sinew_limited(qdd, -LARGEST_ACCELERATION, LARGEST_ACCELERATION, 0.0);
      position = sinew_limited(position, p->joint_low[j], p->joint_high[j], from[j]);
    }
    s->tick.qd[j] = qd;
    s->tick.qdd[j] = qdd;
    const double way = position - from[j];
    if (way > step) position = from[j] + step;
    if (way < -step) position = from[j] - step;
    s->reference[j] = position;
    s->tick.later[j] = position + qd * p->period;
  }
  return status;
}

/* A group that begins to follow goes on from where its joints are. */
static void move_reference(hand_state *s, const hand_parameters *p, const hand_input *in,
                           hand_output *out, uint32_t group) {
  const uint32_t bit = 1U << group, first = p->first_coordinate[group];
  const uint32_t end = first + hand_coordinates_of(p, group);
  if (in->drive != 1U || (out->group_status[group] & HAND_UNSAFE) != 0U) {
    s->driven &= ~bit;
    leave_reference(s, out, first, end);
    return;
  }
  const double *from = (s->driven & bit) != 0U ? s->reference : out->q;
  s->driven |= bit;
  out->group_status[group] |= approach(s, p, in, from, first, end);
}

static double more_force(const hand_parameters *p, double force) {
  const double least = (SHARE_KEPT - 1.0) * p->pretension, most = p->torque_limit / p->motor_radius;
  return sinew_limited(force, least, most, 0.0);
}

/* The smallest forces that give a finger's joints their feedforward, above the pretension. */
static void distribute(hand_state *s, const hand_parameters *p, uint32_t finger) {
  const uint32_t first = p->first_tendon[finger], end = first + hand_tendons_of(p, finger);
  /* A finger of three joints has 0 for the fourth, which is the next one's first. */
  const double *tau = &s->joint_feedforward[p->first_coordinate[finger]];
  const double tau0 = tau[0], tau1 = tau[1], tau2 = tau[2], tau3 = tau[3];
  for (uint32_t k = first; k < end; ++k) {
    const double *by = s->tendon[k].by_torque;
    const double force = by[0] * tau0 + by[1] * tau1 + by[2] * tau2 + by[3] * tau3;
    s->tendon[k].more = more_force(p, force);
  }
}

/* What its base's forces are by torque depends on the thumb's posture. */
static void turn_thumb(hand_state *s, const double *q) {
  double P[HAND_FINGER_TENDONS * HAND_FINGER_JOINTS], A[3] = {0.0};
  thumb_coupling_matrix(q, P);
  for (uint32_t k = 0; k < HAND_BASE_TENDONS; ++k) {
    const double *row = &P[HAND_FINGER_JOINTS * k];
    A[0] += row[0] * row[0];
    A[1] += row[0] * row[1];
    A[2] += row[1] * row[1];
  }
  const double determinant = A[0] * A[2] - A[1] * A[1];
  const double per = 1.0 / (determinant > HAND_LEAST_PIVOT * A[0] ? determinant : 1.0);
  for (uint32_t k = 0; k < HAND_BASE_TENDONS; ++k) {
    const double *row = &P[HAND_FINGER_JOINTS * k];
    s->tendon[k].by_torque[0] = (A[1] * row[1] - A[2] * row[0]) * per;
    s->tendon[k].by_torque[1] = (A[1] * row[0] - A[0] * row[1]) * per;
  }
}

/* Gravity and inverse dynamics of the wanted motion. */
static void find_dynamics(hand_state *s, const hand_input *in, hand_output *out) {
  double gravity[3], of_finger[HAND_FINGERS * 3];
  for (uint32_t i = 0; i < 3U; ++i) {
    gravity[i] = sinew_limited(in->gravity[i], -LARGEST_GRAVITY, LARGEST_GRAVITY, 0.0);
    if (!sinew_is_within(in->gravity[i], -LARGEST_GRAVITY, LARGEST_GRAVITY))
      out->status |= HAND_SETPOINT;
  }
  hand_finger_gravity(s->reference, out->q_wrist, gravity, of_finger);
  hand_inverse_dynamics(s->reference, s->tick.qd, s->tick.qdd, of_finger, s->next_feedforward);
  s->next_feedforward[HAND_JOINTS] = 0.0; /* the crank's load is not modelled */
  memcpy(s->next_thumb, s->reference, sizeof s->next_thumb);
  s->next_feedforward_age = 0U;
}

/* Torques and the forces for them change in the same tick. */
static void find_forces(hand_state *s, const hand_parameters *p) {
  memcpy(s->joint_feedforward, s->next_feedforward, sizeof s->joint_feedforward);
  s->feedforward_age = s->next_feedforward_age;
  turn_thumb(s, s->next_thumb);
  for (uint32_t finger = 0; finger < HAND_FINGERS; ++finger) distribute(s, p, finger);
}

void hand_follow(hand_state *s, const hand_parameters *p, const hand_input *in, hand_output *out) {
  for (uint32_t group = 0; group < HAND_GROUPS; ++group) move_reference(s, p, in, out, group);
  ++s->feedforward_age;
  ++s->next_feedforward_age;
  if (hand_is_turn(s, p, HAND_DYNAMICS_TURN)) find_dynamics(s, in, out);
  if (hand_is_turn(s, p, HAND_FORCES_TURN)) find_forces(s, p);
  memcpy(out->joint_feedforward, s->joint_feedforward, sizeof s->joint_feedforward);
  out->feedforward_age = s->feedforward_age;
}
