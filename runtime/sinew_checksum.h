/* SPDX-License-Identifier: BSD-2-Clause
 *
 * CRC-32 (polynomial 0x04c11db7 reflected, as in Ethernet, zip and POSIX's gzip), with a table of
 * 16 words: 2 look-ups a byte. For tables that are tested at start and blocks that are handed over.
 */
#ifndef SINEW_CHECKSUM_H
#define SINEW_CHECKSUM_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Of `size` bytes, going on from the checksum of what came before (0 at the beginning):
 * sinew_checksum(sinew_checksum(0, a, n), b, m) is that of a and b in a row. Of "123456789":
 * 0xcbf43926. */
static inline uint32_t sinew_checksum(uint32_t before, const void *data, size_t size) {
    static const uint32_t of_nibble[16] = {0x00000000U, 0x1db71064U, 0x3b6e20c8U, 0x26d930acU,
                                           0x76dc4190U, 0x6b6b51f4U, 0x4db26158U, 0x5005713cU,
                                           0xedb88320U, 0xf00f9344U, 0xd6d6a3e8U, 0xcb61b38cU,
                                           0x9b64c2b0U, 0x86d3d2d4U, 0xa00ae278U, 0xbdbdf21cU};
    const unsigned char *byte = (const unsigned char *)data;
    uint32_t sum = ~before;
    for (size_t i = 0; i < size; ++i) {
        sum ^= byte[i];
        sum = (sum >> 4) ^ of_nibble[sum & 15U];
        sum = (sum >> 4) ^ of_nibble[sum & 15U];
    }
    return ~sum;
}

#ifdef __cplusplus
}
#endif
#endif
