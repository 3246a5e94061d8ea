/* SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Status 0 where the hash of trigonometry_hash.h is the expected one.
 */
#include "trigonometry_hash.h"

int main(void) {
    const uint64_t hash = sinew_trigonometry_hash(SINEW_TRIGONOMETRY_HASH_COUNT, 1);
    return hash == SINEW_TRIGONOMETRY_HASH_EXPECTED ? 0 : 1;
}
