/* SPDX-License-Identifier: GPL-3.0-or-later
 *
 * One number that depends on every bit of what the runtime's functions return for many inputs. Equal
 * on every target, or the floating-point rules of the build are wrong. Plain C, for boards too.
 */
#ifndef SINEW_TRIGONOMETRY_HASH_H
#define SINEW_TRIGONOMETRY_HASH_H

#include "sinew_math.h"

#define SINEW_TRIGONOMETRY_HASH_COUNT 20000U
/* sinew_trigonometry_hash(SINEW_TRIGONOMETRY_HASH_COUNT, 1) */
#define SINEW_TRIGONOMETRY_HASH_EXPECTED UINT64_C(0x8937906721c0f136)

static inline uint64_t sinew_hash_next(uint64_t state) {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return state;
}

static inline uint64_t sinew_hash_word(uint64_t hash, uint64_t word) {
    return ((hash ^ word) * UINT64_C(0x9e3779b97f4a7c15)) ^ (hash >> 29);
}

static inline uint64_t sinew_hash_double(uint64_t hash, double x) {
    double s, c;
    sinew_sincos(x, &s, &c);
    hash = sinew_hash_word(sinew_hash_word(hash, sinew_bits(s)), sinew_bits(c));
    sinew_sincos_wide(x, &s, &c);
    hash = sinew_hash_word(sinew_hash_word(hash, sinew_bits(s)), sinew_bits(c));
    hash = sinew_hash_word(hash, sinew_bits(sinew_atan(x)));
    hash = sinew_hash_word(hash, sinew_bits(sinew_atan2(x, c)));
    hash = sinew_hash_word(hash, sinew_bits(sinew_atan2(s, x)));
    hash = sinew_hash_word(hash, sinew_bits(sinew_acos(x)));
    hash = sinew_hash_word(hash, sinew_bits(sinew_asin(x)));
    hash = sinew_hash_word(hash, sinew_bits(sinew_exp(x)));
    hash = sinew_hash_word(hash, sinew_bits(sinew_log(x)));
    hash = sinew_hash_word(hash, sinew_bits(sinew_tanh(x)));
    hash = sinew_hash_word(hash, sinew_bits(sinew_sqrt(x)));
    hash = sinew_hash_word(hash, sinew_bits(sinew_finite(x)));
    return sinew_hash_word(hash, sinew_bits(sinew_choose(x, sinew_min(s, c), sinew_max(s, c))));
}

static inline uint64_t sinew_hash_float(uint64_t hash, float x) {
    float s, c;
    sinew_sincosf(x, &s, &c);
    hash = sinew_hash_word(sinew_hash_word(hash, sinew_bitsf(s)), sinew_bitsf(c));
    sinew_sincos_widef(x, &s, &c);
    hash = sinew_hash_word(sinew_hash_word(hash, sinew_bitsf(s)), sinew_bitsf(c));
    hash = sinew_hash_word(hash, sinew_bitsf(sinew_atanf(x)));
    hash = sinew_hash_word(hash, sinew_bitsf(sinew_atan2f(x, c)));
    hash = sinew_hash_word(hash, sinew_bitsf(sinew_atan2f(s, x)));
    hash = sinew_hash_word(hash, sinew_bitsf(sinew_acosf(x)));
    hash = sinew_hash_word(hash, sinew_bitsf(sinew_asinf(x)));
    hash = sinew_hash_word(hash, sinew_bitsf(sinew_expf(x)));
    hash = sinew_hash_word(hash, sinew_bitsf(sinew_logf(x)));
    hash = sinew_hash_word(hash, sinew_bitsf(sinew_tanhf(x)));
    hash = sinew_hash_word(hash, sinew_bitsf(sinew_sqrtf(x)));
    hash = sinew_hash_word(hash, sinew_bitsf(sinew_finitef(x)));
    return sinew_hash_word(hash,
                           sinew_bitsf(sinew_choosef(x, sinew_minf(s, c), sinew_maxf(s, c))));
}

/* Numbers within +-1, within +-800, and bit patterns of every kind (NaN and infinity included), count
 * of each; the seed is any number but 0. */
static inline uint64_t sinew_trigonometry_hash(uint32_t count, uint64_t seed) {
    uint64_t state = seed * UINT64_C(0x2545f4914f6cdd1d);
    uint64_t hash = 0;
    for (uint32_t i = 0; i < count; ++i) {
        state = sinew_hash_next(state);
        /* 1 to 2 less 1.5: no conversion from integers, which some cores lack. */
        const double unit =
            sinew_from_bits((state >> 12) | UINT64_C(0x3ff0000000000000)) - 1.5;
        const float unit_float = sinew_from_bitsf((uint32_t)(state >> 41) | 0x3f800000U) - 1.5F;
        const double x[3] = {unit * 2.0, unit * 1600.0, sinew_from_bits(state)};
        const float x_float[3] = {unit_float * 2.0F, unit_float * 1600.0F,
                                  sinew_from_bitsf((uint32_t)(state >> 32))};
        for (int kind = 0; kind < 3; ++kind) {
            hash = sinew_hash_double(hash, x[kind]);
            hash = sinew_hash_float(hash, x_float[kind]);
        }
    }
    return hash;
}

#endif
