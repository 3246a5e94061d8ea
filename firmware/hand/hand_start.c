/* SPDX-License-Identifier: BSD-2-Clause */
#include <string.h>

#include "hand.h"
#include "hand_parts.h"
#include "hmc.h"
#include "sinew_checksum.h"
#include "sinew_solve.h"

#define MOST_JOINTS 4U
#define MOST_TENDONS 8U
#define LEAST_PIVOT 1e-12 /* m^2, of P^T P */

static void start_channels(hand_state *s, const hand_parameters *p) {
  for (uint32_t i = 0; i < HAND_TENDONS; ++i) {
    sinew_channel_start(&s->motor[i], &p->motor_limits);
    sinew_channel_start(&s->lever[i], &p->lever_limits);
  }
  for (uint32_t i = 0; i < 2U; ++i) {
    sinew_channel_start(&s->wrist[i], &p->wrist_limits);
    s->last_wrist[i] = p->wrist_reference[i];
  }
}

/* -P (P^T P)^-1: the smallest forces for torques on a finger's joints. 1 where P has no full rank.
 */
int hand_invert_coupling(const hand_finger *finger, const double *q, double *force_by_torque) {
  double P[MOST_TENDONS * MOST_JOINTS], A[MOST_JOINTS * MOST_JOINTS];
  const int n = (int)finger->joints, m = (int)finger->tendons;
  finger->coupling(q, P);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j) {
      double sum = 0.0;
      for (int k = 0; k < m; ++k) sum += P[k * n + i] * P[k * n + j];
      A[i * n + j] = sum;
    }
  const int singular = sinew_factorise(A, n, LEAST_PIVOT);
  for (int j = 0; j < n; ++j) {
    double y[MOST_JOINTS] = {0.0};
    y[j] = 1.0;
    sinew_substitute(A, n, y, y);
    for (int k = 0; k < m; ++k) {
      double sum = 0.0;
      for (int i = 0; i < n; ++i) sum -= P[k * n + i] * y[i];
      force_by_torque[(int)MOST_TENDONS * j + k] = sum;
    }
  }
  return singular > 0;
}

/* Lengths and couplings at q = 0. */
static int start_fingers(hand_state *s, const hand_parameters *p) {
  int singular = 0;
  for (uint32_t f = 0; f < HAND_FINGERS; ++f) {
    const double *zero = &s->q[p->first_coordinate[f]];
    hand_fingers[f].lengths(zero, &s->finger_at_zero[p->first_tendon[f]]);
    singular |= hand_invert_coupling(&hand_fingers[f], zero,
                                     &s->force_by_torque[MOST_TENDONS * p->first_coordinate[f]]);
  }
  return singular;
}

static void start_crank(hand_state *s, const hand_parameters *p) {
  double *at_reference = &s->finger_at_zero[p->first_tendon[HAND_FINGERS]], h[2];
  hmc_tendon_lengths(p->crank_reference, at_reference);
  hmc_tendon_lengths(p->crank_reference + 1.0, h);
  for (uint32_t i = 0; i < 2U; ++i) s->crank_coupling[i] = h[i] - at_reference[i];
  s->q[HAND_JOINTS] = p->crank_reference;
}

int hand_start(hand_state *state, const hand_parameters *parameters) {
  double coupling[HAND_TENDONS * 2];
  memset(state, 0, sizeof *state);
  if (parameters->version != HAND_TABLE_VERSION || parameters->turns == 0U)
    return HAND_START_VERSION;
  if (parameters->checksum != sinew_checksum(0U, parameters, offsetof(hand_parameters, checksum)))
    return HAND_START_CHECKSUM;
  start_channels(state, parameters);
  hand_wrist_passage(parameters->wrist_reference, state->wrist_at_reference, coupling);
  start_crank(state, parameters);
  memcpy(state->reference, state->q, sizeof state->q);
  return start_fingers(state, parameters) ? HAND_START_SINGULAR : HAND_START_FINE;
}
