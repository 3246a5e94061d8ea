/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Every function of the model thumb behind one calling convention.
 *
 * Made by: sinew generate models/thumb
 * Model:   sha256 a1887dfbbeca57cfa47ae5f680c6749b28b13c33cd3d097b0d35ffdcc7f65850
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_thumb_CATALOGUE_H
#define SINEW_thumb_CATALOGUE_H

#include "sinew_catalogue.h"

#ifdef __cplusplus
extern "C" {
#endif

extern const sinew_catalogue thumb_catalogue;

#ifdef __cplusplus
}
#endif
#endif
