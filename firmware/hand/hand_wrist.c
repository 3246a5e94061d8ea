/* SPDX-License-Identifier: BSD-2-Clause */
#include "hand.h"
#include "hand_parts.h"

/* What a group's sensors and the wrist's say of it. */
static uint32_t sensors_of(const hand_parameters *p, const hand_output *out, uint32_t group) {
  const uint32_t first = p->first_tendon[group], end = first + hand_tendons_of(p, group);
  uint32_t status = out->wrist_status[0] | out->wrist_status[1];
  int slack = 0;
  for (uint32_t k = first; k < end; ++k) {
    const uint32_t channel = p->channel[k];
    status |= out->motor_status[channel] | out->lever_status[channel];
    slack |= !(out->force[channel] > 0.0);
  }
  if (slack) status |= HAND_SLACK;
  if ((status & SINEW_SAFE) != 0U) status |= HAND_UNSAFE;
  return status;
}

/* (5.1): R theta + h_wrist + h_finger - elongation = const. */
void hand_read_wrist(hand_state *s, const hand_parameters *p, const hand_input *in,
                     hand_output *out, hand_tick *t) {
  const double radius = p->motor_radius, per_radius = 1.0 / radius;
  const double rate71 = out->qd_wrist[0], rate73 = out->qd_wrist[1];
  (void)in;
  hand_wrist_passage(out->q_wrist, out->wrist_length, t->wrist_coupling);
  for (uint32_t i = 0; i < HAND_TENDONS; ++i) {
    const double length = out->wrist_length[i];
    const double rate =
        t->wrist_coupling[2U * i] * rate71 + t->wrist_coupling[2U * i + 1U] * rate73;
    out->wrist_rate[i] = rate;
    out->displacement[i] += p->closure[i] - radius * t->motor[i] - length;
    out->wrist_feedforward[i] = (s->wrist_at_reference[i] - length) * per_radius;
    out->wrist_feedforward_rate[i] = -rate * per_radius;
  }
  for (uint32_t k = 0; k < HAND_TENDONS; ++k) {
    t->displacement[k] = out->displacement[p->channel[k]];
    t->force[k] = out->force[p->channel[k]];
  }
  for (uint32_t group = 0; group < HAND_GROUPS; ++group)
    out->group_status[group] = sensors_of(p, out, group);
}
