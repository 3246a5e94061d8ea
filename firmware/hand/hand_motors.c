/* SPDX-License-Identifier: BSD-2-Clause */
#include "hand_parts.h"
#include "hmc.h"
#include "motor.h"

/* Of all tendons in the reference posture and a tick later. */
static void find_lengths(hand_state *s, const hand_parameters *p) {
  const double *later = s->tick.later;
  for (uint32_t finger = 0; finger < HAND_FINGERS; ++finger) {
    const uint32_t first = p->first_coordinate[finger], tendon = p->first_tendon[finger];
    hand_fingers[finger].lengths(&s->reference[first], &s->tick.length[tendon]);
    hand_fingers[finger].lengths(&later[first], &s->tick.length_later[tendon]);
  }
  const uint32_t first = p->first_coordinate[HAND_FINGERS], tendon = p->first_tendon[HAND_FINGERS];
  hmc_tendon_lengths(s->reference[first], &s->tick.length[tendon]);
  hmc_tendon_lengths(later[first], &s->tick.length_later[tendon]);
}

/* Friction and ripple of the motors whose turn it is, at the angle in the middle of the ticks they
 * will stand for. In turn t they are those up to before[t + 1] in the order of the groups: turns
 * with stiffness or feedforward leave less room. */
static void take_frictions(hand_state *s, const hand_parameters *p, const hand_output *out) {
  static const uint32_t before[HAND_TURNS + 1] = {0U, 2U, 8U, 9U, 16U, 27U, HAND_TENDONS};
  const uint32_t from = p->turns == 1U ? 0U : before[s->turn];
  const uint32_t until = p->turns == 1U ? (uint32_t)HAND_TENDONS : before[s->turn + 1U];
  const double per_step = 1.0 / (p->motor_radius * p->period);
  const double ahead = 0.5 * (double)(p->turns - 1U) * p->period;
  for (uint32_t k = from; k < until; ++k) {
    hand_tendon *tendon = &s->tendon[k];
    const double moves = s->tick.length_later[k] - s->tick.length[k];
    const double rate = out->wrist_feedforward_rate[tendon->channel] - moves * per_step;
    const double angle = sinew_channel_value(&tendon->motor, &p->motor_limits);
    double margin;
    motor_compensation_torque(angle + ahead * rate, rate, &tendon->friction, &margin);
  }
}

/* Motor angles and rates at which the tendons hold the reference posture, by (5.1); servo and
 * feedforward, limited; statuses of those that had to be. */
static inline uint32_t command_motors(const hand_state *s, const hand_parameters *p,
                                      hand_output *out, uint32_t first, uint32_t end) {
  const double radius = p->motor_radius, pretension = p->pretension;
  const double least = p->least_stiffness, limit = p->torque_limit;
  const double gain = p->servo_gain / radius, rate_gain = p->servo_rate_gain / (radius * p->period);
  uint32_t status = SINEW_FINE;
  for (uint32_t k = first; k < end; ++k) {
    const hand_tendon *tendon = &s->tendon[k];
    const uint32_t i = tendon->channel;
    const double more = tendon->more, length = s->tick.length[k];
    const double stiffness = out->stiffness[i] > least ? out->stiffness[i] : least;
    const double takes_up = more / stiffness - (length - tendon->at_zero);
    const double runs_out = s->tick.length_later[k] - length;
    const double feedforward = radius * (pretension + more) + tendon->friction;
    double torque = tendon->servo + gain * takes_up - rate_gain * runs_out + feedforward;
    if (!(sinew_magnitude(torque) <= limit)) {
      torque = sinew_limited(torque, -limit, limit, 0.0);
      status = HAND_TORQUE_LIMITED;
    }
    out->friction_feedforward[i] = tendon->friction;
    out->motor_feedforward[i] = feedforward;
    out->motor_torque[i] = torque;
  }
  return status;
}

static void release_motors(const hand_state *s, const hand_parameters *p, hand_output *out,
                           uint32_t first, uint32_t end) {
  for (uint32_t k = first; k < end; ++k) {
    const uint32_t i = p->channel[k];
    out->friction_feedforward[i] = s->tendon[k].friction;
    out->motor_feedforward[i] = p->motor_radius * (p->pretension + s->tendon[k].more);
    out->motor_torque[i] = 0.0;
  }
}

void hand_command(hand_state *s, const hand_parameters *p, hand_output *out) {
  find_lengths(s, p);
  take_frictions(s, p, out);
  for (uint32_t group = 0; group < HAND_GROUPS; ++group) {
    const uint32_t first = p->first_tendon[group], end = first + hand_tendons_of(p, group);
    if ((s->driven >> group & 1U) != 0U)
      out->group_status[group] |= command_motors(s, p, out, first, end);
    else
      release_motors(s, p, out, first, end);
    out->status |= out->group_status[group];
  }
}
