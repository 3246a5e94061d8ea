/* SPDX-License-Identifier: BSD-2-Clause */
#include "hand_parts.h"
#include "motor.h"

/* Friction and ripple of one motor, at the angle in the middle of the ticks they will stand for. */
static void take_friction(hand_state *s, const hand_parameters *p, const hand_tick *t, uint32_t i) {
  const double rate = t->motor_reference_rate[i];
  const double middle = t->motor[i] + 0.5 * (double)(p->turns - 1U) * p->period * rate;
  double margin;
  motor_compensation_torque(middle, rate, &s->friction[i], &margin);
}

/* The motors whose turn it is: all where there are fewer than three turns; else the turns between
 * the first and the last have an equal share each. */
static void take_frictions(hand_state *s, const hand_parameters *p, const hand_tick *t) {
  const uint32_t shares = p->turns < 3U ? 1U : p->turns - 2U;
  const uint32_t first = p->turns < 3U ? 0U : s->turn - 1U;
  if (p->turns >= 3U && (s->turn == 0U || s->turn == p->turns - 1U)) return;
  for (uint32_t i = first; i < HAND_TENDONS; i += shares) take_friction(s, p, t, i);
}

/* Servo and feedforward, limited; statuses of those that had to be. */
static uint32_t command_motors(const hand_state *s, const hand_parameters *p, hand_output *out,
                               const hand_tick *t, uint32_t first, uint32_t end) {
  const double gain = p->servo_gain, rate_gain = p->servo_rate_gain, limit = p->torque_limit;
  uint32_t status = SINEW_FINE;
  for (uint32_t k = first; k < end; ++k) {
    const uint32_t i = p->channel[k];
    const double feedforward = out->motor_feedforward[i] + s->friction[i];
    double torque = gain * (t->motor_reference[i] - t->motor[i]) +
                    rate_gain * (t->motor_reference_rate[i] - s->motor_rate[i]) + feedforward;
    if (!sinew_is_within(torque, -limit, limit)) {
      torque = sinew_limited(torque, -limit, limit, 0.0);
      status = HAND_TORQUE_LIMITED;
    }
    out->friction_feedforward[i] = s->friction[i];
    out->motor_feedforward[i] = feedforward;
    out->motor_torque[i] = torque;
  }
  return status;
}

static void release_motors(const hand_state *s, const hand_parameters *p, hand_output *out,
                           uint32_t first, uint32_t end) {
  for (uint32_t k = first; k < end; ++k) {
    const uint32_t i = p->channel[k];
    out->friction_feedforward[i] = s->friction[i];
    out->motor_torque[i] = 0.0;
  }
}

void hand_command(hand_state *s, const hand_parameters *p, const hand_input *in, hand_output *out,
                  const hand_tick *t) {
  (void)in;
  take_frictions(s, p, t);
  for (uint32_t group = 0; group < HAND_GROUPS; ++group) {
    const uint32_t first = p->first_tendon[group], end = first + hand_tendons_of(p, group);
    if ((s->driven >> group & 1U) != 0U)
      out->group_status[group] |= command_motors(s, p, out, t, first, end);
    else
      release_motors(s, p, out, first, end);
    out->status |= out->group_status[group];
  }
}
