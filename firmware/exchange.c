/* SPDX-License-Identifier: BSD-2-Clause */
#include "exchange.h"

#define RADIANS_A_COUNT (6.283185307179586 / (double)MAILBOX_COUNTS_A_TURN)
#define LARGEST_TORQUE 2000.0 /* N m: what an int32_t of uN m holds */

static double missing(void) {
  const double zero = 0.0;
  return zero / zero;
}

static double counts_of(uint32_t word, uint32_t mask) {
  return (word & MAILBOX_VALID) != 0U ? (double)(word & mask) : missing();
}

void exchange_measured(const mailbox_measured *from, hand_input *to) {
  for (uint32_t i = 0; i < HAND_TENDONS; ++i) {
    to->motor_angle[i] = (double)from->motor[i] * RADIANS_A_COUNT;
    to->lever_count[i] = counts_of(from->sensor[i], MAILBOX_LEVER_MASK);
  }
  for (uint32_t i = 0; i < 2U; ++i)
    to->wrist_count[i] = counts_of(from->wrist[i], MAILBOX_COUNT_MASK);
}

void exchange_nothing(hand_input *to) {
  for (uint32_t i = 0; i < HAND_TENDONS; ++i) {
    to->motor_angle[i] = missing();
    to->lever_count[i] = missing();
  }
  for (uint32_t i = 0; i < 2U; ++i) to->wrist_count[i] = missing();
}

void exchange_setpoint(const mailbox_setpoint *from, uint32_t command, hand_input *to) {
  for (uint32_t i = 0; i < 3U; ++i) to->gravity[i] = (double)from->gravity[i];
  for (uint32_t j = 0; j < HAND_COORDINATES; ++j) {
    to->q[j] = (double)from->q[j];
    to->qd[j] = (double)from->qd[j];
    to->qdd[j] = (double)from->qdd[j];
  }
  to->drive = (command & MAILBOX_DRIVE) != 0U ? 1U : 0U;
}

static int32_t micro(double torque) {
  return (int32_t)(1.0e6 * sinew_limited(torque, -LARGEST_TORQUE, LARGEST_TORQUE, 0.0));
}

void exchange_answer(const hand_output *from, mailbox_answer *to) {
  for (uint32_t i = 0; i < HAND_TENDONS; ++i) {
    to->torque[i] = micro(from->motor_torque[i]);
    to->feedforward[i] = micro(from->motor_feedforward[i]);
    to->channel_status[i] = from->motor_status[i] | from->lever_status[i] << 16;
  }
  for (uint32_t i = 0; i < 2U; ++i) to->wrist_status[i] = from->wrist_status[i];
  to->status = from->status;
}

void exchange_record(const mailbox_measured *measured, const hand_output *from,
                     const mailbox_answer *answer, mailbox_record *to) {
  to->frame = answer->frame;
  to->status = answer->status;
  for (uint32_t i = 0; i < HAND_TENDONS; ++i) {
    to->motor[i] = measured->motor[i];
    to->torque[i] = answer->torque[i];
    to->force[i] = (float)from->force[i];
  }
  for (uint32_t j = 0; j < HAND_COORDINATES; ++j) to->q[j] = (float)from->q[j];
  for (uint32_t i = 0; i < 2U; ++i) to->q_wrist[i] = (float)from->q_wrist[i];
  to->reserved = 0U;
}
