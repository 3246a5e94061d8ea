/* SPDX-License-Identifier: BSD-2-Clause */
#include <string.h>

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

static double wanted_value(double value, double size, uint32_t *status) {
  if (sinew_is_within(value, -size, size)) return value;
  *status |= HAND_SETPOINT;
  return sinew_limited(value, -size, size, 0.0);
}

/* A group that does not follow: its reference is where the joints are. */
static void leave_reference(hand_state *s, const hand_output *out, uint32_t first, uint32_t end,
                            wanted *motion) {
  for (uint32_t j = first; j < end; ++j) {
    motion->qd[j] = motion->qdd[j] = 0.0;
    s->reference[j] = out->q[j];
  }
}

/* The reference goes towards the wanted position at a bounded rate; a group that begins to follow
 * goes on from where its joints are. */
static void move_reference(hand_state *s, const hand_parameters *p, const hand_input *in,
                           hand_output *out, uint32_t group, wanted *motion) {
  const uint32_t bit = 1U << group, first = p->first_coordinate[group];
  const uint32_t end = first + hand_coordinates_of(p, group);
  const double step = p->reference_rate * p->period;
  const double *from = (s->driven & bit) != 0U ? s->reference : out->q;
  uint32_t status = SINEW_FINE;
  s->driven &= ~bit;
  if (in->drive != 1U || (out->group_status[group] & HAND_UNSAFE) != 0U) {
    leave_reference(s, out, first, end, motion);
    return;
  }
  for (uint32_t j = first; j < end; ++j) {
    const double low = p->joint_low[j], high = p->joint_high[j];
    double position = in->q[j];
    motion->qd[j] = wanted_value(in->qd[j], LARGEST_RATE, &status);
    motion->qdd[j] = wanted_value(in->qdd[j], LARGEST_ACCELERATION, &status);
    if (!sinew_is_within(position, low, high)) {
      status |= HAND_SETPOINT;
      position = sinew_limited(position, low, high, from[j]);
    }
    s->reference[j] = sinew_approached(from[j], position, step);
  }
  s->driven |= bit;
  out->group_status[group] |= status;
}

static void find_feedforward(hand_state *s, const hand_input *in, hand_output *out,
                             const wanted *motion) {
  double gravity[3], of_finger[HAND_FINGERS * 3];
  for (uint32_t i = 0; i < 3U; ++i)
    gravity[i] = wanted_value(in->gravity[i], LARGEST_GRAVITY, &out->status);
  hand_finger_gravity(s->reference, out->q_wrist, gravity, of_finger);
  hand_inverse_dynamics(s->reference, motion->qd, motion->qdd, of_finger, s->joint_feedforward);
  s->joint_feedforward[HAND_JOINTS] = 0.0; /* the crank's load is not modelled */
}

/* The smallest forces that give the joints of a finger their feedforward, above the pretension. */
static void distribute(hand_state *s, const hand_parameters *p, uint32_t finger) {
  const uint32_t first = p->first_coordinate[finger], joints = hand_coordinates_of(p, finger);
  const uint32_t tendons = hand_tendons_of(p, finger);
  const double *per_torque = &s->force_by_torque[MOST_TENDONS * first];
  const double least = (SHARE_KEPT - 1.0) * p->pretension, most = p->torque_limit / p->motor_radius;
  for (uint32_t k = 0; k < tendons; ++k) {
    double force = 0.0;
    for (uint32_t j = 0; j < joints; ++j)
      force += per_torque[MOST_TENDONS * j + k] * s->joint_feedforward[first + j];
    s->more[p->first_tendon[finger] + k] = sinew_limited(force, least, most, 0.0);
  }
}

static void lengths_of(uint32_t group, const double *q, double *h) {
  if (group < HAND_FINGERS)
    hand_fingers[group].lengths(q, h);
  else
    hmc_tendon_lengths(q[0], h);
}

/* Motor angles at which the tendons hold the reference posture with those forces, by (5.1). */
static void find_motors(const hand_state *s, const hand_parameters *p, hand_output *out,
                        hand_tick *t, uint32_t group, const wanted *motion) {
  const uint32_t first = p->first_coordinate[group], tendon = p->first_tendon[group];
  const uint32_t joints = hand_coordinates_of(p, group), tendons = hand_tendons_of(p, group);
  const double radius = p->motor_radius, per_radius = 1.0 / radius;
  const double per_step = per_radius / p->period, least = p->least_stiffness;
  const double pretension = p->pretension;
  double ahead[4], h[MOST_TENDONS], h_ahead[MOST_TENDONS];
  for (uint32_t j = 0; j < joints; ++j)
    ahead[j] = s->reference[first + j] + motion->qd[first + j] * p->period;
  lengths_of(group, &s->reference[first], h);
  lengths_of(group, ahead, h_ahead);
  for (uint32_t k = 0; k < tendons; ++k) {
    const uint32_t i = p->channel[tendon + k];
    const double more = s->more[tendon + k];
    const double stiffness = out->stiffness[i] > least ? out->stiffness[i] : least;
    const double moved = h[k] - s->finger_at_zero[tendon + k];
    t->motor_reference[i] = out->wrist_feedforward[i] + (more / stiffness - moved) * per_radius;
    t->motor_reference_rate[i] = out->wrist_feedforward_rate[i] - (h_ahead[k] - h[k]) * per_step;
    out->motor_feedforward[i] = radius * (pretension + more);
  }
}

void hand_follow(hand_state *s, const hand_parameters *p, const hand_input *in, hand_output *out,
                 hand_tick *t) {
  wanted motion;
  for (uint32_t group = 0; group < HAND_GROUPS; ++group)
    move_reference(s, p, in, out, group, &motion);
  if (hand_is_turn(s, p, p->turns - 1U)) {
    /* The thumb's coupling depends on its posture. */
    (void)hand_invert_coupling(&hand_fingers[0], s->reference, s->force_by_torque);
    find_feedforward(s, in, out, &motion);
    for (uint32_t finger = 0; finger < HAND_FINGERS; ++finger) distribute(s, p, finger);
  }
  memcpy(out->joint_feedforward, s->joint_feedforward, sizeof s->joint_feedforward);
  for (uint32_t group = 0; group < HAND_GROUPS; ++group) find_motors(s, p, out, t, group, &motion);
}
