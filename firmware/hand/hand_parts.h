/* SPDX-License-Identifier: BSD-2-Clause
 *
 * The parts of a tick, in the order in which hand_step calls them. Not for users of hand_step.
 */
#ifndef SINEW_HAND_PARTS_H
#define SINEW_HAND_PARTS_H

#include "hand_step.h"

/* What is not done in every tick is done in turns: the stiffness matrix in turn 0, friction and
 * ripple of the motors in those between, the joints' feedforward in the last. One turn: all. */
static inline int hand_is_turn(const hand_state *s, const hand_parameters *p, uint32_t turn) {
  return p->turns < 2U || s->turn == turn;
}

/* A finger's emitted functions. */
typedef struct {
  uint32_t joints, tendons;
  void (*lengths)(const double *q, double *h);
  void (*coupling)(const double *q, double *P);
  void (*torque)(const double *q, const double *f, double *tau);
  void (*position)(const double *h, double *q); /* null for the thumb, whose P depends on q */
} hand_finger;

extern const hand_finger hand_fingers[HAND_FINGERS];

/* Tendons and coordinates of a group. */
static inline uint32_t hand_tendons_of(const hand_parameters *p, uint32_t group) {
  const uint32_t end =
      group + 1U < HAND_GROUPS ? p->first_tendon[group + 1U] : (uint32_t)HAND_TENDONS;
  return end - p->first_tendon[group];
}

static inline uint32_t hand_coordinates_of(const hand_parameters *p, uint32_t group) {
  const uint32_t end =
      group + 1U < HAND_GROUPS ? p->first_coordinate[group + 1U] : (uint32_t)HAND_COORDINATES;
  return end - p->first_coordinate[group];
}

/* hand_start.c: -P (P^T P)^-1 of a finger at q, 8 numbers a joint; 1 where P has no full rank. */
int hand_invert_coupling(const hand_finger *finger, const double *q, double *force_by_torque);

/* hand_sensors.c: all channels checked; forces and stiffnesses. */
void hand_read_sensors(hand_state *s, const hand_parameters *p, const hand_input *in,
                       hand_output *out, hand_tick *t);
/* hand_wrist.c: lengths and rates through the wrist, what the fingers are moved by, its
 * feedforward. */
void hand_read_wrist(hand_state *s, const hand_parameters *p, const hand_input *in,
                     hand_output *out, hand_tick *t);
/* hand_links.c: link positions and torques; in its turn the stiffness matrix. */
void hand_find_links(hand_state *s, const hand_parameters *p, hand_output *out, hand_tick *t);
void hand_take_stiffness(hand_state *s, const hand_parameters *p, hand_output *out);
/* hand_reference.c: where the motors have to be for the wanted motion, and the joints' feedforward.
 */
void hand_follow(hand_state *s, const hand_parameters *p, const hand_input *in, hand_output *out,
                 hand_tick *t);
/* hand_motors.c: friction and ripple in their turn, the servo, the limits. */
void hand_command(hand_state *s, const hand_parameters *p, const hand_input *in, hand_output *out,
                  const hand_tick *t);

#endif
