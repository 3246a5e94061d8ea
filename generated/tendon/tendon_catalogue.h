/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Every function of the model tendon behind one calling convention.
 *
 * Made by: sinew generate models/tendon
 * Model:   sha256 9fa49807a7e8a052fcdd9aca09d5e31e41ada5f891672ef877029e3417b31747
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_tendon_CATALOGUE_H
#define SINEW_tendon_CATALOGUE_H

#include "sinew_catalogue.h"

#ifdef __cplusplus
extern "C" {
#endif

extern const sinew_catalogue tendon_catalogue;

#ifdef __cplusplus
}
#endif
#endif
