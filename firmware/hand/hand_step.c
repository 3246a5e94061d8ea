/* SPDX-License-Identifier: BSD-2-Clause */
#include "hand_step.h"

#include "hand_parts.h"

void hand_step(hand_state *state, const hand_parameters *parameters, const hand_input *input,
               hand_output *output) {
  output->status = SINEW_FINE;
  hand_read_wrist(state, parameters, input, output);
  hand_read_tendons(state, parameters, input, output);
  hand_find_links(state, parameters, output);
  hand_take_stiffness(state, parameters, output);
  hand_follow(state, parameters, input, output);
  hand_command(state, parameters, output);
  output->ticks = ++state->ticks;
  state->turn = state->turn + 1U < parameters->turns ? state->turn + 1U : 0U;
}
