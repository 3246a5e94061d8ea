/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Every function of the model guiding behind one calling convention.
 *
 * Made by: sinew generate models/guiding
 * Model:   sha256 46008d1ec7c51e1a1f40582caaef4c99f74a4a0435168858e8014640103ff18b
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_guiding_CATALOGUE_H
#define SINEW_guiding_CATALOGUE_H

#include "sinew_catalogue.h"

#ifdef __cplusplus
extern "C" {
#endif

extern const sinew_catalogue guiding_catalogue;

#ifdef __cplusplus
}
#endif
#endif
