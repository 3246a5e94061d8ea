/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Every function of the model ring behind one calling convention.
 *
 * Made by: sinew generate models/ring
 * Model:   sha256 a8bc321adefac22c0d65aa59ce2185ee47e4dfbbfa393b8abd0790fd9d4a1b7f
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
