/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Every function of the model ring behind one calling convention.
 *
 * Made by: sinew generate models/ring
 * Model:   sha256 1f4b3990ffc6980ffccbfc6418e580555e7561f229241dc052214b4c0e8cbe05
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_ring_CATALOGUE_H
#define SINEW_ring_CATALOGUE_H

#include "sinew_catalogue.h"

#ifdef __cplusplus
extern "C" {
#endif

extern const sinew_catalogue ring_catalogue;

#ifdef __cplusplus
}
#endif
#endif
