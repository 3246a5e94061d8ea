/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Ring of records of one size between one writer and one reader, in the caller's memory: from a
 * loop that must not wait to one that may. Full: the record is not written, and counted.
 */
#ifndef SINEW_RING_H
#define SINEW_RING_H

#include <stdint.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    unsigned char *records; /* capacity times record_bytes, the caller's */
    uint32_t record_bytes;
    uint32_t capacity; /* a power of two, at most 2^31 */
    uint32_t written;  /* records ever; the writer's */
    uint32_t read;     /* records ever; the reader's */
    uint32_t lost;     /* records that found no place; the writer's */
} sinew_ring;

/* 0; 1 where the capacity is not a power of two or a size is 0, and nothing is changed. */
static inline int sinew_ring_start(sinew_ring *ring, void *memory, uint32_t record_bytes,
                                   uint32_t capacity) {
    if (capacity == 0U || (capacity & (capacity - 1U)) != 0U || record_bytes == 0U) return 1;
    ring->records = (unsigned char *)memory;
    ring->record_bytes = record_bytes;
    ring->capacity = capacity;
    ring->written = 0U;
    ring->read = 0U;
    ring->lost = 0U;
    return 0;
}

/* Records that wait to be read. */
static inline uint32_t sinew_ring_waiting(const sinew_ring *ring) {
    return __atomic_load_n(&ring->written, __ATOMIC_ACQUIRE) -
           __atomic_load_n(&ring->read, __ATOMIC_ACQUIRE);
}

static inline unsigned char *sinew_ring_place(const sinew_ring *ring, uint32_t number) {
    return ring->records + (size_t)(number & (ring->capacity - 1U)) * ring->record_bytes;
}

/* The writer's: 1 where the record was taken, 0 where the ring is full. */
static inline int sinew_ring_put(sinew_ring *ring, const void *record) {
    if (sinew_ring_waiting(ring) >= ring->capacity) {
        ring->lost += ring->lost < 0xffffffffU;
        return 0;
    }
    memcpy(sinew_ring_place(ring, ring->written), record, ring->record_bytes);
    __atomic_store_n(&ring->written, ring->written + 1U, __ATOMIC_RELEASE);
    return 1;
}

/* The reader's: 1 and the oldest record, 0 where there is none. */
static inline int sinew_ring_take(sinew_ring *ring, void *record) {
    if (sinew_ring_waiting(ring) == 0U) return 0;
    memcpy(record, sinew_ring_place(ring, ring->read), ring->record_bytes);
    __atomic_store_n(&ring->read, ring->read + 1U, __ATOMIC_RELEASE);
    return 1;
}

#ifdef __cplusplus
}
#endif
#endif
