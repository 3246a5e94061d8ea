/* SPDX-License-Identifier: BSD-2-Clause */
#include "hand_parts.h"
#include "motor.h"

/* Whether it is the turn of a motor's friction and ripple: in turns 1, 2, ... each of its share,
 * for the stiffness matrix has turn 0; in every tick where there is one turn only. */
static int is_turn_of(const hand_state* s, const hand_parameters* p, uint32_t motor) {
  if (p->turns < 2U) return 1;
  return s->ticks % p->turns == 1U + motor % (p->turns - 1U);
}

/* At the angle in the middle of the ticks that it will stand for. */
static void take_friction(hand_state* s, const hand_parameters* p, const hand_tick* t, uint32_t i) {
  const double rate = t->motor_reference_rate[i];
  const double middle = t->motor[i] + 0.5 * (double)(p->turns - 1U) * p->period * rate;
  double margin;
  motor_compensation_torque(&middle, &rate, &s->friction[i], &margin);
}

static uint32_t command_motor(hand_state* s, const hand_parameters* p, hand_output* out,
                              const hand_tick* t, uint32_t i) {
  const double servo = p->servo_gain * (t->motor_reference[i] - t->motor[i]) +
                       p->servo_rate_gain * (t->motor_reference_rate[i] - s->motor_rate[i]);
  out->motor_feedforward[i] += s->friction[i];
  const double torque = servo + out->motor_feedforward[i];
  out->motor_torque[i] = sinew_limited(torque, -p->torque_limit, p->torque_limit, 0.0);
  return torque == out->motor_torque[i] ? SINEW_FINE : HAND_TORQUE_LIMITED;
}

void hand_command(hand_state* s, const hand_parameters* p, const hand_input* in, hand_output* out,
                  const hand_tick* t) {
  (void)in;
  for (uint32_t i = 0; i < HAND_TENDONS; ++i) {
    if (is_turn_of(s, p, i)) take_friction(s, p, t, i);
    out->friction_feedforward[i] = s->friction[i];
  }
  for (uint32_t group = 0; group < HAND_GROUPS; ++group) {
    const uint32_t first = p->first_tendon[group];
    for (uint32_t k = first; k < first + hand_tendons_of(p, group); ++k) {
      const uint32_t i = p->channel[k];
      if ((s->driven >> group & 1U) != 0U)
        out->group_status[group] |= command_motor(s, p, out, t, i);
      else
        out->motor_torque[i] = 0.0;
    }
    out->status |= out->group_status[group];
  }
}
