/* SPDX-License-Identifier: BSD-2-Clause */
#include "hand_parts.h"
#include "sinew_polynomial.h"
#include "tendon.h"

/* The rate of a checked channel: a first-order low-pass of its differences. It stands while samples
 * are missing, and is 0 while the channel is lost. */
static void take_rate(const hand_parameters* p, uint32_t before, uint32_t now, double value,
                      double* last, double* rate) {
  if ((now & SINEW_SAFE) != 0U)
    *rate = 0.0;
  else if (before == SINEW_FINE && now == SINEW_FINE)
    *rate += p->rate_share * ((value - *last) / p->period - *rate);
  *last = value;
}

static void read_motor(hand_state* s, const hand_parameters* p, const hand_input* in,
                       hand_output* out, hand_tick* t, uint32_t i) {
  const uint32_t before = s->motor[i].status;
  const uint32_t now =
      sinew_channel_tick(&s->motor[i], &p->motor_limits, in->motor_angle[i], &t->motor[i]);
  take_rate(p, before, now, t->motor[i], &s->last_motor[i], &s->motor_rate[i]);
  out->motor_status[i] = now;
}

/* Force and stiffness; the elongation goes to out->displacement, where hand_read_wrist finds it. */
static void read_lever(hand_state* s, const hand_parameters* p, const hand_input* in,
                       hand_output* out, uint32_t i) {
  const hand_lever* lever = &p->lever[i];
  double count, of_lever, force, stiffness, elongation;
  out->lever_status[i] =
      sinew_channel_tick(&s->lever[i], &p->lever_limits, in->lever_count[i], &count);
  const double u = sinew_normalised(count, lever->centre, lever->inverse);
  force = sinew_polynomial(lever->force, HAND_LEVER_TERMS - 1, u);
  elongation = sinew_polynomial(lever->elongation, HAND_LEVER_TERMS - 1, u);
  of_lever = sinew_polynomial(lever->stiffness, HAND_LEVER_TERMS - 1, u);
  tendon_series_stiffness(&of_lever, &stiffness);
  const int slack = !(force > 0.0) || !(elongation > 0.0);
  out->force[i] = slack ? 0.0 : force;
  out->stiffness[i] = slack ? 0.0 : stiffness;
  out->displacement[i] = slack ? 0.0 : elongation + p->tendon_softness * force;
}

static void read_potentiometer(hand_state* s, const hand_parameters* p, const hand_input* in,
                               hand_output* out, uint32_t i) {
  const uint32_t before = s->wrist[i].status;
  double count;
  const uint32_t now =
      sinew_channel_tick(&s->wrist[i], &p->wrist_limits, in->wrist_count[i], &count);
  /* Lost: the angle stays where it was last, which is nearer than any other. */
  const double angle = (now & SINEW_SAFE) != 0U
                           ? s->last_wrist[i]
                           : sinew_limited(p->wrist_offset[i] + p->wrist_scale[i] * count,
                                           p->wrist_low[i], p->wrist_high[i], s->last_wrist[i]);
  take_rate(p, before, now, angle, &s->last_wrist[i], &s->wrist_rate[i]);
  out->q_wrist[i] = angle;
  out->qd_wrist[i] = s->wrist_rate[i];
  out->wrist_status[i] = now;
}

void hand_read_sensors(hand_state* s, const hand_parameters* p, const hand_input* in,
                       hand_output* out, hand_tick* t) {
  for (uint32_t i = 0; i < HAND_TENDONS; ++i) {
    read_motor(s, p, in, out, t, i);
    read_lever(s, p, in, out, i);
  }
  for (uint32_t i = 0; i < 2U; ++i) read_potentiometer(s, p, in, out, i);
}
