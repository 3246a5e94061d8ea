/* SPDX-License-Identifier: BSD-2-Clause */
#include <string.h>

#include "hand.h"
#include "hand_parts.h"
#include "hmc.h"
#include "sinew_checksum.h"
#include "sinew_solve.h"

static void start_channels(hand_state *s, const hand_parameters *p) {
  for (uint32_t i = 0; i < HAND_TENDONS; ++i) {
    sinew_channel_start(&s->tendon[i].motor, &p->motor_limits);
    sinew_channel_start(&s->tendon[i].lever, &p->lever_limits);
  }
  for (uint32_t i = 0; i < 2U; ++i) {
    sinew_channel_start(&s->wrist[i], &p->wrist_limits);
    s->last_wrist[i] = p->wrist_reference[i];
  }
}

/* -P (P^T P)^-1 of a finger: the smallest forces for torques on its joints. 1 where P has no full
 * rank. */
static int invert_coupling(const hand_finger *finger, const double *q, hand_tendon *tendon) {
  double P[HAND_FINGER_TENDONS * HAND_FINGER_JOINTS], A[HAND_FINGER_JOINTS * HAND_FINGER_JOINTS];
  const int n = (int)finger->joints, m = (int)finger->tendons;
  finger->coupling(q, P);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j) {
      double sum = 0.0;
      for (int k = 0; k < m; ++k) sum += P[k * n + i] * P[k * n + j];
      A[i * n + j] = sum;
    }
  const int singular = sinew_factorise(A, n, HAND_LEAST_PIVOT);
  for (int j = 0; j < n; ++j) {
    double y[HAND_FINGER_JOINTS] = {0.0};
    y[j] = 1.0;
    sinew_substitute(A, n, y, y);
    for (int k = 0; k < m; ++k) {
      double sum = 0.0;
      for (int i = 0; i < n; ++i) sum -= P[k * n + i] * y[i];
      tendon[k].by_torque[j] = sum;
    }
  }
  return singular > 0;
}

/* Lengths and couplings at q = 0. */
static int start_fingers(hand_state *s, const hand_parameters *p) {
  int singular = 0;
  for (uint32_t f = 0; f < HAND_FINGERS; ++f) {
    const double *zero = &s->q[p->first_coordinate[f]];
    hand_tendon *tendon = &s->tendon[p->first_tendon[f]];
    double h[HAND_FINGER_TENDONS];
    hand_fingers[f].lengths(zero, h);
    for (uint32_t k = 0; k < hand_tendons_of(p, f); ++k) tendon[k].at_zero = h[k];
    singular |= invert_coupling(&hand_fingers[f], zero, tendon);
  }
  return singular;
}

static void start_crank(hand_state *s, const hand_parameters *p) {
  double at_reference[2], h[2];
  hmc_tendon_lengths(p->crank_reference, at_reference);
  hmc_tendon_lengths(p->crank_reference + 1.0, h);
  for (uint32_t i = 0; i < 2U; ++i) {
    s->tendon[p->first_tendon[HAND_FINGERS] + i].at_zero = at_reference[i];
    s->crank_coupling[i] = h[i] - at_reference[i];
  }
  s->q[HAND_JOINTS] = p->crank_reference;
}

static void start_wrist(hand_state *s, const hand_parameters *p) {
  double length[HAND_TENDONS];
  hand_wrist_passage(p->wrist_reference, length, s->tick.wrist_coupling);
  for (uint32_t k = 0; k < HAND_TENDONS; ++k) {
    s->tendon[k].channel = p->channel[k];
    s->tendon[k].wrist_at_reference = length[p->channel[k]];
  }
}

int hand_start(hand_state *state, const hand_parameters *parameters) {
  memset(state, 0, sizeof *state);
  if (parameters->version != HAND_TABLE_VERSION ||
      (parameters->turns != 1U && parameters->turns != HAND_TURNS))
    return HAND_START_VERSION;
  if (parameters->checksum != sinew_checksum(0U, parameters, offsetof(hand_parameters, checksum)))
    return HAND_START_CHECKSUM;
  start_channels(state, parameters);
  start_wrist(state, parameters);
  state->stiffness_age = state->feedforward_age = HAND_NONE_YET;
  start_crank(state, parameters);
  memcpy(state->reference, state->q, sizeof state->q);
  return start_fingers(state, parameters) ? HAND_START_SINGULAR : HAND_START_FINE;
}
