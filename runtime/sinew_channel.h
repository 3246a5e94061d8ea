/* SPDX-License-Identifier: BSD-2-Clause
 *
 * One measured channel through faults: what is wrong with it, the value to go on with, and since
 * when. A bad sample gives the last good value; after a stated number of ticks a safe one. The
 * state holds only values that were good, so a bad sample never reaches the next tick.
 */
#ifndef SINEW_CHANNEL_H
#define SINEW_CHANNEL_H

#include <stdint.h>

#include "sinew_limits.h"

/* Kept out of the way of what happens in every tick. */
#ifdef __GNUC__
#define SINEW_RARE __attribute__((noinline, cold, unused))
#define SINEW_LIKELY(condition) __builtin_expect((condition), 1)
#else
#define SINEW_RARE inline
#define SINEW_LIKELY(condition) (condition)
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* Bits of a status; 0 is fine. The first four say what is wrong with the sample, the last two what
 * is done. */
enum {
    SINEW_FINE = 0,
    SINEW_NOT_FINITE = 1, /* NaN or infinity: also what stands for "no sample" */
    SINEW_OUT_OF_RANGE = 2,
    SINEW_JUMPED = 4, /* further from the last good value than a tick allows */
    SINEW_FROZEN = 8, /* the same value for too long */
    SINEW_HELD = 32,  /* the value is the last good one */
    SINEW_SAFE = 64   /* the value is the safe one */
};

/* What a channel may do; caller's constants. */
typedef struct {
    double low, high;      /* range of a good sample, both included */
    double largest_step;   /* between two good samples a tick apart; times the ticks missed */
    double safe;           /* value after `hold_ticks` */
    uint32_t hold_ticks;   /* bad ticks for which the last good value stands */
    uint32_t frozen_ticks; /* equal samples that are too many; 0: may rest for ever */
    uint32_t settle_ticks; /* good ticks in a row after which a safe channel is used again; >= 1 */
    uint32_t reserved;     /* 0; keeps the layout without gaps */
} sinew_channel_limits;

typedef struct {
    double good;        /* last good sample */
    double last;        /* last finite sample within the range, good or not */
    uint32_t bad_ticks; /* since the last good one */
    uint32_t same_ticks;
    uint32_t good_ticks; /* in a row while the channel is safe */
    uint32_t status;     /* as returned last */
} sinew_channel;

/* Before the first tick: the channel is safe, and comes up once its samples follow each other. */
static inline void sinew_channel_start(sinew_channel *channel, const sinew_channel_limits *limits) {
    channel->good = limits->safe;
    channel->last = limits->safe;
    channel->bad_ticks = limits->hold_ticks;
    channel->same_ticks = 0U;
    channel->good_ticks = 0U;
    channel->status = SINEW_SAFE;
}

/* What is wrong with a sample; 0 if nothing. */
static inline uint32_t sinew_channel_fault(sinew_channel *channel,
                                           const sinew_channel_limits *limits, double sample) {
    if (!sinew_is_finite(sample)) return SINEW_NOT_FINITE;
    if (!sinew_is_within(sample, limits->low, limits->high)) return SINEW_OUT_OF_RANGE;
    const int same = sample == channel->last;
    const double from = (channel->status & SINEW_SAFE) != 0U ? channel->last : channel->good;
    const uint32_t missed = (channel->status & SINEW_SAFE) != 0U ? 0U : channel->bad_ticks;
    channel->last = sample;
    channel->same_ticks = same ? channel->same_ticks + (channel->same_ticks < 0xffffffffU) : 0U;
    if (limits->frozen_ticks > 0U && channel->same_ticks >= limits->frozen_ticks)
        return SINEW_FROZEN;
    const double step = limits->largest_step * (double)(missed + 1U);
    return sinew_is_within(sample - from, -step, step) ? SINEW_FINE : SINEW_JUMPED;
}

/* A tick of a channel that is not fine, or whose sample moved in no ordinary way. */
SINEW_RARE static double sinew_channel_judge(sinew_channel *channel,
                                                    const sinew_channel_limits *limits,
                                                    double sample) {
    uint32_t status = sinew_channel_fault(channel, limits, sample);
    const int was_safe = (channel->status & SINEW_SAFE) != 0U;
    if (status == SINEW_FINE && was_safe) {
        ++channel->good_ticks;
        if (channel->good_ticks < limits->settle_ticks) status = SINEW_SAFE;
    }
    double value = sample;
    if (status == SINEW_FINE) {
        channel->good = sample;
        channel->bad_ticks = 0U;
        channel->good_ticks = 0U;
    } else {
        if ((status & SINEW_SAFE) == 0U) channel->good_ticks = 0U;
        if (channel->bad_ticks < limits->hold_ticks) ++channel->bad_ticks;
        const int held = !was_safe && channel->bad_ticks < limits->hold_ticks;
        status |= held ? (uint32_t)SINEW_HELD : (uint32_t)SINEW_SAFE;
        value = held ? channel->good : limits->safe;
    }
    channel->status = status;
    return value;
}

/* One tick: returns the value to use, always finite; channel->status says what it is worth. A
 * channel that is safe comes back after `settle_ticks` good ticks in a row. */
static inline double sinew_channel_tick(sinew_channel *channel, const sinew_channel_limits *limits,
                                        double sample) {
    const double move = sample - channel->good;
    if (channel->status != SINEW_FINE ||
        !(sinew_magnitude(move) <= limits->largest_step) ||
        !sinew_is_within(sample, limits->low, limits->high))
        return sinew_channel_judge(channel, limits, sample);
    if (SINEW_LIKELY(move != 0.0)) {
        channel->good = sample;
        channel->last = sample;
        channel->same_ticks = 0U;
        return sample;
    }
    if (limits->frozen_ticks == 0U) return sample; /* it may rest */
    if (channel->same_ticks + 1U >= limits->frozen_ticks)
        return sinew_channel_judge(channel, limits, sample);
    ++channel->same_ticks;
    return sample;
}

/* The value that the last tick returned. */
static inline double sinew_channel_value(const sinew_channel *channel,
                                         const sinew_channel_limits *limits) {
    return (channel->status & SINEW_SAFE) != 0U ? limits->safe : channel->good;
}

#ifdef __cplusplus
}
#endif
#endif
