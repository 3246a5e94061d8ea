/* SPDX-License-Identifier: BSD-2-Clause
 *
 * States at which emitted functions are compared between host and board. The same source is compiled
 * for both; only integer arithmetic and correctly rounded operations are used, so both draw the
 * same bits.
 */
#ifndef SINEW_STATES_H
#define SINEW_STATES_H

#include <stdint.h>

#include "sinew_catalogue.h"

/* Fills `in`, function->input_size elements of scalar_bytes each, with state number `state`:
 * 0 all low ends of the ranges, 1 all high ends, 2 all zero (or the end nearest to zero); from 3 on
 * three of four states are uniform in the ranges, and in every fourth each element is an end, zero,
 * a multiple of pi/2, or uniform. A missing range counts as -1..1.
 * A state depends on the function's name and the number only, never on what was drawn before. */
void state_draw(const sinew_function *function, int scalar_bytes, uint32_t state, void *in);

#endif
