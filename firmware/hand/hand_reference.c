/* SPDX-License-Identifier: BSD-2-Clause */
#include "hand.h"
#include "hand_parts.h"
#include "hmc.h"

#define MOST_TENDONS 8U
#define LARGEST_RATE 100.0         /* rad/s */
#define LARGEST_ACCELERATION 1.0e4 /* rad/s^2 */
#define LARGEST_GRAVITY 100.0      /* m/s^2 */
#define SHARE_KEPT 0.05            /* of the pretension, in every tendon */

typedef struct {
  double qd[HAND_COORDINATES], qdd[HAND_COORDINATES];
} wanted;

static double wanted_value(double value, double size, uint32_t* status) {
  if (!sinew_is_within(value, -size, size)) *status |= HAND_SETPOINT;
  return sinew_limited(value, -size, size, 0.0);
}

/* The reference goes towards the wanted position at a bounded rate; where a group does not follow
 * it is where the joints are, and goes on from there. */
static void move_reference(hand_state* s, const hand_parameters* p, const hand_input* in,
                           hand_output* out, uint32_t group, wanted* motion) {
  const uint32_t bit = 1U << group, first = p->first_coordinate[group];
  const int follows = in->drive == 1U && (out->group_status[group] & HAND_UNSAFE) == 0U;
  for (uint32_t j = first; j < first + hand_coordinates_of(p, group); ++j) {
    uint32_t* status = &out->group_status[group];
    const double now = (s->driven & bit) != 0U ? s->reference[j] : out->q[j];
    motion->qd[j] = follows ? wanted_value(in->qd[j], LARGEST_RATE, status) : 0.0;
    motion->qdd[j] = follows ? wanted_value(in->qdd[j], LARGEST_ACCELERATION, status) : 0.0;
    if (follows && !sinew_is_within(in->q[j], p->joint_low[j], p->joint_high[j]))
      *status |= HAND_SETPOINT;
    const double end = sinew_limited(in->q[j], p->joint_low[j], p->joint_high[j], now);
    s->reference[j] =
        follows ? sinew_approached(now, end, p->reference_rate * p->period) : out->q[j];
  }
  s->driven = follows ? s->driven | bit : s->driven & ~bit;
}

static void find_feedforward(hand_state* s, const hand_input* in, hand_output* out,
                             const wanted* motion) {
  double gravity[3], of_finger[HAND_FINGERS * 3];
  for (uint32_t i = 0; i < 3U; ++i)
    gravity[i] = wanted_value(in->gravity[i], LARGEST_GRAVITY, &out->status);
  hand_finger_gravity(s->reference, out->q_wrist, gravity, of_finger);
  hand_inverse_dynamics(s->reference, motion->qd, motion->qdd, of_finger, out->joint_feedforward);
  out->joint_feedforward[HAND_JOINTS] = 0.0; /* the crank's load is not modelled */
}

static void lengths_of(uint32_t group, const double* q, double* h) {
  if (group < HAND_FINGERS)
    hand_fingers[group].lengths(q, h);
  else
    hmc_tendon_lengths(q, h);
}

/* The smallest forces that give the joints their feedforward, on top of the pretension [N]. */
static void distribute(const hand_state* s, const hand_parameters* p, const double* tau,
                       uint32_t group, double* more) {
  const uint32_t joints = hand_coordinates_of(p, group), tendons = hand_tendons_of(p, group);
  const double* per_torque = &s->force_by_torque[MOST_TENDONS * p->first_coordinate[group]];
  const double least = (SHARE_KEPT - 1.0) * p->pretension;
  for (uint32_t k = 0; k < tendons; ++k) {
    double force = 0.0;
    if (group < HAND_FINGERS)
      for (uint32_t j = 0; j < joints; ++j) force += per_torque[MOST_TENDONS * j + k] * tau[j];
    more[k] = sinew_limited(force, least, p->torque_limit / p->motor_radius, 0.0);
  }
}

/* Motor angles at which the tendons hold the reference posture with those forces, by (5.1). */
static void find_motors(const hand_state* s, const hand_parameters* p, hand_output* out,
                        hand_tick* t, uint32_t group, const wanted* motion) {
  const uint32_t first = p->first_coordinate[group], tendon = p->first_tendon[group];
  const double per_radius = 1.0 / p->motor_radius;
  double ahead[4], h[MOST_TENDONS], h_ahead[MOST_TENDONS], more[MOST_TENDONS];
  for (uint32_t j = 0; j < hand_coordinates_of(p, group); ++j)
    ahead[j] = s->reference[first + j] + motion->qd[first + j] * p->period;
  lengths_of(group, &s->reference[first], h);
  lengths_of(group, ahead, h_ahead);
  distribute(s, p, &out->joint_feedforward[first], group, more);
  for (uint32_t k = 0; k < hand_tendons_of(p, group); ++k) {
    const uint32_t i = p->channel[tendon + k];
    const double stiffness =
        out->stiffness[i] > p->least_stiffness ? out->stiffness[i] : p->least_stiffness;
    const double moved = h[k] - s->finger_at_zero[tendon + k];
    t->motor_reference[i] = out->wrist_feedforward[i] + (more[k] / stiffness - moved) * per_radius;
    t->motor_reference_rate[i] =
        out->wrist_feedforward_rate[i] - (h_ahead[k] - h[k]) / p->period * per_radius;
    out->motor_feedforward[i] = p->motor_radius * (p->pretension + more[k]);
  }
}

void hand_follow(hand_state* s, const hand_parameters* p, const hand_input* in, hand_output* out,
                 hand_tick* t) {
  wanted motion;
  if (s->ticks % p->turns == p->turns - 1U) /* the thumb's coupling depends on its posture */
    (void)hand_invert_coupling(&hand_fingers[0], s->reference, s->force_by_torque);
  for (uint32_t group = 0; group < HAND_GROUPS; ++group)
    move_reference(s, p, in, out, group, &motion);
  find_feedforward(s, in, out, &motion);
  for (uint32_t group = 0; group < HAND_GROUPS; ++group) find_motors(s, p, out, t, group, &motion);
}
