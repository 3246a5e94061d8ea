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

/* Angles by the tendons; a group that is unsafe keeps its last ones. */
static void find_group(hand_state *s, const hand_parameters *p, hand_output *out, uint32_t group) {
  const double *h = &s->tick.moved_and_force[p->first_tendon[group]];
  double *q = &out->q[p->first_coordinate[group]];
  if ((out->group_status[group] & HAND_UNSAFE) != 0U)
    memcpy(q, &s->q[p->first_coordinate[group]], hand_coordinates_of(p, group) * sizeof *q);
  else if (group == HAND_FINGERS)
    find_crank(s, p, h, q);
  else if (hand_fingers[group].position != 0)
    hand_fingers[group].position(h, q);
  else
    out->group_status[group] |= find_thumb(s, p, h, q);
}

static SINEW_RARE double limit_joint(const hand_state *s, const hand_parameters *p,
                                     hand_output *out, uint32_t j) {
  uint32_t group = HAND_GROUPS - 1U;
  while (p->first_coordinate[group] > j) --group;
  out->group_status[group] |= HAND_JOINT_RANGE;
  return sinew_limited(out->q[j], p->joint_low[j], p->joint_high[j], s->q[j]);
}

void hand_find_links(hand_state *s, const hand_parameters *p, hand_output *out) {
  const double *force = &s->tick.moved_and_force[HAND_TENDONS];
  for (uint32_t group = 0; group < HAND_GROUPS; ++group) find_group(s, p, out, group);
  for (uint32_t j = 0; j < HAND_COORDINATES; ++j) {
    double q = out->q[j];
    if (!sinew_is_within(q, p->joint_low[j], p->joint_high[j])) q = limit_joint(s, p, out, j);
    out->q[j] = s->q[j] = q;
  }
  for (uint32_t finger = 0; finger < HAND_FINGERS; ++finger) {
    const uint32_t first = p->first_coordinate[finger];
    hand_fingers[finger].torque(&out->q[first], &force[p->first_tendon[finger]],
                                &out->joint_torque[first]);
  }
  force += p->first_tendon[HAND_FINGERS];
  out->joint_torque[p->first_coordinate[HAND_FINGERS]] =
      -(s->crank_coupling[0] * force[0] + s->crank_coupling[1] * force[1]);
}

/* What whole_stiffness needs, in the tick whose state the matrix will be of. */
static void keep_snapshot(hand_state *s, const hand_output *out) {
  hand_snapshot *of = &s->snapshot;
  memcpy(of->q, out->q, sizeof of->q);
  memcpy(of->wrist_coupling, s->tick.wrist_coupling, sizeof of->wrist_coupling);
  memcpy(of->force, out->force, sizeof of->force);
  memcpy(of->stiffness, out->stiffness, sizeof of->stiffness);
  of->age = 0U;
}

/* hand_joint_stiffness in two turns; the output is written as a whole in the second one. */
void hand_take_stiffness(hand_state *s, const hand_parameters *p, hand_output *out) {
  hand_snapshot *of = &s->snapshot;
  ++s->stiffness_age;
  ++of->age;
  if (hand_is_turn(s, p, HAND_WRIST_STIFFNESS_TURN)) {
    keep_snapshot(s, out);
    hand_wrist_stiffness(out->q_wrist, out->wrist_length, s->tick.wrist_coupling, out->force,
                         out->stiffness, of->wrist_stiffness);
  }
  if (hand_is_turn(s, p, HAND_WHOLE_STIFFNESS_TURN)) {
    hand_whole_stiffness(of->q, of->wrist_coupling, of->force, of->stiffness, of->wrist_stiffness,
                         out->joint_stiffness);
    s->stiffness_age = of->age;
  }
  out->stiffness_age = s->stiffness_age;
}
