/* SPDX-License-Identifier: BSD-2-Clause
 *
 * All of a tendon that does not depend on the others, in one loop: what one part finds the next one
 * has in a register.
 */
#include "hand_parts.h"
#include "sinew_polynomial.h"

/* Written out: a loop would take half as many instructions again, 114 times a tick. */
#define POLYNOMIAL(c, u) \
  ((c)[0] +              \
   (u) *                 \
       ((c)[1] +         \
        (u) * ((c)[2] +  \
               (u) * ((c)[3] + (u) * ((c)[4] + (u) * ((c)[5] + (u) * ((c)[6] + (u) * (c)[7])))))))
_Static_assert(HAND_LEVER_TERMS == 8, "POLYNOMIAL has 8 terms");

/* What is the same for all tendons of a tick, and the wrist's torques so far. */
typedef struct {
  double radius, per_radius, per_period, gain, rate_gain, rate71, rate73;
  double torque71, torque73;
} passage;

/* Of one tendon: N, m, N/m. */
typedef struct {
  double force, elongation, stiffness;
} pull;

static inline double read_motor(hand_tendon *tendon, const hand_parameters *p,
                                double per_period, double sample) {
  sinew_channel *channel = &tendon->motor;
  const uint32_t before = channel->status;
  const double last = channel->good; /* of a fine channel: the last angle */
  const double angle = sinew_channel_tick(channel, &p->motor_limits, sample);
  const double rate = (angle - last) * per_period;
  tendon->rate = hand_rate(tendon->rate, p->rate_share, rate, before, channel->status);
  return angle;
}

/* Returns HAND_SLACK where there is no force. */
static inline uint32_t read_lever(hand_tendon *tendon, const hand_parameters *p,
                                  const hand_lever *lever, double sample, pull *of) {
  const double count = sinew_channel_tick(&tendon->lever, &p->lever_limits, sample);
  const double u = sinew_normalised(count, lever->centre, lever->inverse);
  of->force = POLYNOMIAL(lever->force, u);
  if (!(of->force > 0.0)) {
    of->force = of->elongation = of->stiffness = 0.0;
    return HAND_SLACK;
  }
  of->elongation = POLYNOMIAL(lever->elongation, u);
  of->stiffness = POLYNOMIAL(lever->stiffness, u);
  return SINEW_FINE;
}

/* Through the wrist, by (5.1): R theta + h_wrist + h_finger - elongation = const. Returns what the
 * finger's end has moved. */
static inline double pass_wrist(const hand_tick *tick, const hand_parameters *p, hand_output *out,
                                passage *w, hand_tendon *tendon, double angle, const pull *of) {
  const uint32_t i = tendon->channel;
  const double by_q71 = tick->wrist_coupling[2U * i], by_q73 = tick->wrist_coupling[2U * i + 1U];
  const double length = out->wrist_length[i], rate = by_q71 * w->rate71 + by_q73 * w->rate73;
  const double feedforward = (tendon->wrist_at_reference - length) * w->per_radius;
  const double feedforward_rate = -rate * w->per_radius;
  w->torque71 -= by_q71 * of->force;
  w->torque73 -= by_q73 * of->force;
  out->wrist_rate[i] = rate;
  out->wrist_feedforward[i] = feedforward;
  out->wrist_feedforward_rate[i] = feedforward_rate;
  tendon->servo =
      w->gain * (feedforward - angle) + w->rate_gain * (feedforward_rate - tendon->rate);
  return of->elongation + (p->closure[i] - w->radius * angle - length);
}

/* Returns what the sensors of a group say. */
static uint32_t read_group(hand_state *s, const hand_parameters *p, const hand_input *in,
                           hand_output *out, passage *sums, uint32_t group) {
  const uint32_t first = p->first_tendon[group];
  const hand_tendon *end = &s->tendon[first + hand_tendons_of(p, group)];
  double *place = &s->tick.moved_and_force[first];
  passage w = *sums;
  uint32_t status = SINEW_FINE;
  for (hand_tendon *tendon = &s->tendon[first]; tendon != end; ++tendon) {
    const uint32_t i = tendon->channel;
    pull of;
    const double angle = read_motor(tendon, p, w.per_period, in->motor_angle[i]);
    status |= read_lever(tendon, p, &p->lever[i], in->lever_count[i], &of);
    const double moved = pass_wrist(&s->tick, p, out, &w, tendon, angle, &of);
    out->force[i] = place[HAND_TENDONS] = of.force;
    out->stiffness[i] = of.stiffness;
    out->displacement[i] = *place++ = moved;
    out->motor_status[i] = tendon->motor.status;
    out->lever_status[i] = tendon->lever.status;
    status |= tendon->motor.status | tendon->lever.status;
  }
  *sums = w;
  return status;
}

void hand_read_tendons(hand_state *s, const hand_parameters *p, const hand_input *in,
                       hand_output *out) {
  const uint32_t of_wrist = out->wrist_status[0] | out->wrist_status[1];
  passage w = {p->motor_radius, 1.0 / p->motor_radius, 1.0 / p->period,
               p->servo_gain,   p->servo_rate_gain,    out->qd_wrist[0],
               out->qd_wrist[1], 0.0,                  0.0};
  for (uint32_t group = 0; group < HAND_GROUPS; ++group) {
    const uint32_t status = of_wrist | read_group(s, p, in, out, &w, group);
    out->group_status[group] = (status & SINEW_SAFE) != 0U ? status | HAND_UNSAFE : status;
  }
  out->joint_torque[HAND_COORDINATES] = w.torque71;
  out->joint_torque[HAND_COORDINATES + 1] = w.torque73;
}
