/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Between the mailbox's words and what hand_step takes and gives.
 */
#ifndef SINEW_EXCHANGE_H
#define SINEW_EXCHANGE_H

#include "hand_step.h"
#include "mailbox.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A word without MAILBOX_VALID becomes NaN: hand_step holds the last good value. */
void exchange_measured(const mailbox_measured *from, hand_input *to);
/* All sensors missing: of a tick without a frame. */
void exchange_nothing(hand_input *to);
void exchange_setpoint(const mailbox_setpoint *from, uint32_t command, hand_input *to);

/* Torques, feedforward and statuses; frames and counters stay. */
void exchange_answer(const hand_output *from, mailbox_answer *to);
void exchange_record(const mailbox_measured *measured, const hand_output *from,
                     const mailbox_answer *answer, mailbox_record *to);

#ifdef __cplusplus
}
#endif
#endif
