/* SPDX-License-Identifier: BSD-2-Clause
 *
 * The parts of a tick, in the order in which hand_step calls them. Not for users of hand_step.
 */
#ifndef SINEW_HAND_PARTS_H
#define SINEW_HAND_PARTS_H

#include "hand_step.h"

/* What is not done in every tick is done by turns. Two things take two turns each: the first one
 * keeps all that the second one needs, so that what comes out is of one tick. Beside them as many
 * motors' friction and ripple as have room (hand_motors.c). One turn: all. */
enum {
  HAND_WRIST_STIFFNESS_TURN = 0,
  HAND_WHOLE_STIFFNESS_TURN = 1,
  HAND_DYNAMICS_TURN = 2,
  HAND_FORCES_TURN = 3
};

#define HAND_LEAST_PIVOT 1e-12 /* m^2, of P^T P */

static inline int hand_is_turn(const hand_state *s, const hand_parameters *p, uint32_t turn) {
  return p->turns == 1U || s->turn == turn;
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

/* The rate of a checked channel: a first-order low-pass of its differences. It stands while samples
 * are missing, and is 0 while the channel is lost. */
static inline double hand_rate(double rate, double share, double difference, uint32_t before,
                               uint32_t now) {
  if ((before | now) == SINEW_FINE) return rate + share * (difference - rate);
  return (now & SINEW_SAFE) != 0U ? 0.0 : rate;
}

/* hand_wrist.c: potentiometers; lengths through the wrist and their derivatives. */
void hand_read_wrist(hand_state *s, const hand_parameters *p, const hand_input *in,
                     hand_output *out);
/* hand_tendons.c: channels of motors and levers checked; forces and stiffnesses, rates and torques
 * at the wrist, what the fingers are moved by, the wrist's feedforward. */
void hand_read_tendons(hand_state *s, const hand_parameters *p, const hand_input *in,
                       hand_output *out);
/* hand_links.c: link positions and torques; in its turns the stiffness matrix. */
void hand_find_links(hand_state *s, const hand_parameters *p, hand_output *out);
void hand_take_stiffness(hand_state *s, const hand_parameters *p, hand_output *out);
/* hand_reference.c: the wanted motion; in its turns the joints' feedforward and forces for it. */
void hand_follow(hand_state *s, const hand_parameters *p, const hand_input *in, hand_output *out);
/* hand_motors.c: where the motors have to be for it; friction and ripple in their turn, the servo,
 * the limits. */
void hand_command(hand_state *s, const hand_parameters *p, hand_output *out);

#endif
