/* SPDX-License-Identifier: BSD-2-Clause */
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

/* The rate of a checked channel: a first-order low-pass of its differences. It stands while samples
 * are missing, and is 0 while the channel is lost. */
static double rate_of(double rate, double share, double difference, uint32_t before, uint32_t now) {
  if ((before | now) == SINEW_FINE) return rate + share * (difference - rate);
  return (now & SINEW_SAFE) != 0U ? 0.0 : rate;
}

static void read_motors(hand_state *s, const hand_parameters *p, const hand_input *in,
                        hand_output *out, hand_tick *t) {
  const double share = p->rate_share, per_period = 1.0 / p->period;
  for (uint32_t i = 0; i < HAND_TENDONS; ++i) {
    const uint32_t before = s->motor[i].status;
    const double angle = sinew_channel_tick(&s->motor[i], &p->motor_limits, in->motor_angle[i]);
    const uint32_t now = s->motor[i].status;
    s->motor_rate[i] =
        rate_of(s->motor_rate[i], share, (angle - s->last_motor[i]) * per_period, before, now);
    s->last_motor[i] = angle;
    t->motor[i] = angle;
    out->motor_status[i] = now;
  }
}

/* Force and stiffness; the elongation goes to out->displacement, where hand_read_wrist finds it. */
static void read_levers(hand_state *s, const hand_parameters *p, const hand_input *in,
                        hand_output *out) {
  for (uint32_t i = 0; i < HAND_TENDONS; ++i) {
    const hand_lever *lever = &p->lever[i];
    const double count = sinew_channel_tick(&s->lever[i], &p->lever_limits, in->lever_count[i]);
    const double u = sinew_normalised(count, lever->centre, lever->inverse);
    const double force = POLYNOMIAL(lever->force, u);
    const double elongation = POLYNOMIAL(lever->elongation, u);
    const double stiffness = POLYNOMIAL(lever->stiffness, u);
    const int slack = !(force > 0.0);
    out->force[i] = slack ? 0.0 : force;
    out->stiffness[i] = slack ? 0.0 : stiffness;
    out->displacement[i] = slack ? 0.0 : elongation;
    out->lever_status[i] = s->lever[i].status;
  }
}

static void read_potentiometer(hand_state *s, const hand_parameters *p, const hand_input *in,
                               hand_output *out, uint32_t i) {
  const uint32_t before = s->wrist[i].status;
  const double count = sinew_channel_tick(&s->wrist[i], &p->wrist_limits, in->wrist_count[i]);
  const uint32_t now = s->wrist[i].status;
  /* Lost: the angle stays where it was last, which is nearer than any other. */
  const double angle = (now & SINEW_SAFE) != 0U
                           ? s->last_wrist[i]
                           : sinew_limited(p->wrist_offset[i] + p->wrist_scale[i] * count,
                                           p->wrist_low[i], p->wrist_high[i], s->last_wrist[i]);
  s->wrist_rate[i] =
      rate_of(s->wrist_rate[i], p->rate_share, (angle - s->last_wrist[i]) / p->period, before, now);
  s->last_wrist[i] = angle;
  out->q_wrist[i] = angle;
  out->qd_wrist[i] = s->wrist_rate[i];
  out->wrist_status[i] = now;
}

void hand_read_sensors(hand_state *s, const hand_parameters *p, const hand_input *in,
                       hand_output *out, hand_tick *t) {
  read_motors(s, p, in, out, t);
  read_levers(s, p, in, out);
  for (uint32_t i = 0; i < 2U; ++i) read_potentiometer(s, p, in, out, i);
}
