/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Every function of the model fifth behind one calling convention.
 *
 * Made by: sinew generate models/fifth
 * Model:   sha256 8d87ca7346489bc145a70a75b068dfc4258cb551e478c1ab0974147f92cfefd5
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_fifth_CATALOGUE_H
#define SINEW_fifth_CATALOGUE_H

#include "sinew_catalogue.h"

#ifdef __cplusplus
extern "C" {
#endif

extern const sinew_catalogue fifth_catalogue;

#ifdef __cplusplus
}
#endif
#endif
