/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Every function of the model thumb_table_5_2 behind one calling convention.
 *
 * Made by: sinew generate models/thumb_table_5_2
 * Model:   sha256 bbe6ad946c25f79dfb874427de1b09ec5897fef90ad1f6d32550868697528da8
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_thumb_table_5_2_CATALOGUE_H
#define SINEW_thumb_table_5_2_CATALOGUE_H

#include "sinew_catalogue.h"

#ifdef __cplusplus
extern "C" {
#endif

extern const sinew_catalogue thumb_table_5_2_catalogue;

#ifdef __cplusplus
}
#endif
#endif
