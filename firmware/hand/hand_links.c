/* SPDX-License-Identifier: BSD-2-Clause */
#include <string.h>

#include "hand.h"
#include "hand_parts.h"
#include "thumb.h"

/* The base by one step of its search from the last tick's angles, the hinges directly (5.22, 5.24).
 */
static uint32_t find_thumb(hand_state *s, const hand_parameters *p, const double *h, double *q) {
  static const double middle[2] = {0.0, 0.0};
  double correction;
  int status;
  const int anew = s->astray_ticks >= p->restart_ticks;
  thumb_link_position_warm(h, anew ? middle : s->q, q, &correction, &status);
  thumb_hinge_position(&h[4], &q[2]);
  const int converged = status == THUMB_LINK_POSITION_WARM_CONVERGED;
  s->astray_ticks = converged || anew ? 0U : s->astray_ticks + 1U;
  return converged ? SINEW_FINE : HAND_NOT_CONVERGED;
}

/* The crank's angle by least squares from its two tendons. */
static void find_crank(const hand_state *s, const hand_parameters *p, const double *h, double *q) {
  const double a = s->crank_coupling[0], b = s->crank_coupling[1];
  q[0] = p->crank_reference + (a * h[0] + b * h[1]) / (a * a + b * b);
}

static uint32_t find_group(hand_state *s, const hand_parameters *p, uint32_t group, const double *h,
                           double *q) {
  const uint32_t first = p->first_coordinate[group];
  uint32_t status = SINEW_FINE;
  if (group == HAND_FINGERS)
    find_crank(s, p, h, q);
  else if (hand_fingers[group].position != 0)
    hand_fingers[group].position(h, q);
  else
    status = find_thumb(s, p, h, q);
  const uint32_t count = hand_coordinates_of(p, group);
  for (uint32_t j = 0; j < count; ++j) {
    const double low = p->joint_low[first + j], high = p->joint_high[first + j];
    if (!sinew_is_within(q[j], low, high)) status |= HAND_JOINT_RANGE;
    q[j] = sinew_limited(q[j], low, high, s->q[first + j]);
    s->q[first + j] = q[j];
  }
  return status;
}

static void add_wrist_torque(const hand_output *out, const hand_tick *t, double *tau) {
  double first = 0.0, second = 0.0;
  for (uint32_t i = 0; i < HAND_TENDONS; ++i) {
    first -= t->wrist_coupling[2U * i] * out->force[i];
    second -= t->wrist_coupling[2U * i + 1U] * out->force[i];
  }
  tau[0] = first;
  tau[1] = second;
}

/* A group that is unsafe keeps its last angles. */
void hand_find_links(hand_state *s, const hand_parameters *p, hand_output *out, hand_tick *t) {
  for (uint32_t group = 0; group < HAND_GROUPS; ++group) {
    const uint32_t first = p->first_coordinate[group], tendon = p->first_tendon[group];
    double *q = &out->q[first], *tau = &out->joint_torque[first];
    if ((out->group_status[group] & HAND_UNSAFE) == 0U)
      out->group_status[group] |= find_group(s, p, group, &t->displacement[tendon], q);
    else
      memcpy(q, &s->q[first], hand_coordinates_of(p, group) * sizeof *q);
    if (group < HAND_FINGERS)
      hand_fingers[group].torque(q, &t->force[tendon], tau);
    else
      tau[0] =
          -(s->crank_coupling[0] * t->force[tendon] + s->crank_coupling[1] * t->force[tendon + 1U]);
  }
  add_wrist_torque(out, t, &out->joint_torque[HAND_COORDINATES]);
}

void hand_take_stiffness(hand_state *s, const hand_parameters *p, hand_output *out) {
  ++s->stiffness_age;
  if (hand_is_turn(s, p, 0U)) {
    hand_joint_stiffness(out->q, out->q_wrist, out->force, out->stiffness, out->joint_stiffness);
    s->stiffness_age = 0U;
  }
  out->stiffness_age = s->stiffness_age;
}
