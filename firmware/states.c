/* SPDX-License-Identifier: BSD-2-Clause */
#include "states.h"

#include <string.h>

#define HALF_PI 1.57079632679489661923

/* splitmix64: every seed gives a different, well mixed sequence. */
static uint64_t draw_bits(uint64_t *generator) {
  *generator += UINT64_C(0x9e3779b97f4a7c15);
  uint64_t bits = *generator;
  bits = (bits ^ (bits >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
  bits = (bits ^ (bits >> 27)) * UINT64_C(0x94d049bb133111eb);
  return bits ^ (bits >> 31);
}

static uint64_t seed_of(const char *name, uint32_t state) {
  uint64_t seed = UINT64_C(0xcbf29ce484222325);
  for (; *name != '\0'; ++name) {
    seed = (seed ^ (uint64_t)(unsigned char)*name) * UINT64_C(0x100000001b3);
  }
  return (seed ^ state) * UINT64_C(0x100000001b3);
}

static double clipped(double value, double low, double high) {
  if (value < low) return low;
  return value > high ? high : value;
}

/* Both halves are below 2^32, so their conversions and the sum of 53 bits are exact. */
static double draw_uniform(uint64_t *generator, double low, double high) {
  const uint64_t bits = draw_bits(generator);
  const double upper = (double)(uint32_t)(bits >> 32);
  const double lower = (double)(uint32_t)((uint32_t)bits >> 11);
  const double unit = (upper * 2097152.0 + lower) * 0x1p-53;
  return clipped(low * (1.0 - unit) + high * unit, low, high);
}

static double draw_special(uint64_t *generator, double low, double high) {
  const uint32_t choice = (uint32_t)(draw_bits(generator) >> 32);
  const double turns = (double)((int32_t)((choice >> 3) % 9U) - 4);
  switch (choice & 7U) {
    case 0U:
      return low;
    case 1U:
      return high;
    case 2U:
      return clipped(0.0, low, high);
    case 3U:
    case 4U:
      return clipped(turns * HALF_PI, low, high);
    default:
      return draw_uniform(generator, low, high);
  }
}

static double draw_element(uint64_t *generator, uint32_t state, double low, double high) {
  if (state == 0U) return low;
  if (state == 1U) return high;
  if (state == 2U) return clipped(0.0, low, high);
  if ((state & 3U) == 3U) return draw_special(generator, low, high);
  return draw_uniform(generator, low, high);
}

static void store_element(void *in, int position, int scalar_bytes, double value) {
  char *place = (char *)in + (position * scalar_bytes);
  if (scalar_bytes == 4) {
    const float rounded = (float)value;
    memcpy(place, &rounded, sizeof rounded);
  } else {
    memcpy(place, &value, sizeof value);
  }
}

void state_draw(const sinew_function *function, int scalar_bytes, uint32_t state, void *in) {
  uint64_t generator = seed_of(function->name, state);
  int position = 0;
  for (int argument = 0; argument < function->input_count; ++argument) {
    const sinew_argument *input = &function->inputs[argument];
    for (int element = 0; element < input->rows * input->cols; ++element) {
      const double low = input->low != 0 ? input->low[element] : -1.0;
      const double high = input->high != 0 ? input->high[element] : 1.0;
      store_element(in, position++, scalar_bytes, draw_element(&generator, state, low, high));
    }
  }
}
