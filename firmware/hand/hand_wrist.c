/* SPDX-License-Identifier: BSD-2-Clause */
#include "hand.h"
#include "hand_parts.h"

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
  s->wrist_rate[i] = hand_rate(s->wrist_rate[i], p->rate_share,
                               (angle - s->last_wrist[i]) / p->period, before, now);
  s->last_wrist[i] = angle;
  out->q_wrist[i] = angle;
  out->qd_wrist[i] = s->wrist_rate[i];
  out->wrist_status[i] = now;
}

void hand_read_wrist(hand_state *s, const hand_parameters *p, const hand_input *in,
                     hand_output *out) {
  for (uint32_t i = 0; i < 2U; ++i) read_potentiometer(s, p, in, out, i);
  hand_wrist_passage(out->q_wrist, out->wrist_length, s->tick.wrist_coupling);
}
