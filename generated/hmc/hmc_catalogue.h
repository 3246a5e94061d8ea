/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Every function of the model hmc behind one calling convention.
 *
 * Made by: sinew generate models/hmc
 * Model:   sha256 c6b6b6fab0f68b853c57719fa8fd34070a670d46c78afafe5dbd5dc96995e9e7
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_hmc_CATALOGUE_H
#define SINEW_hmc_CATALOGUE_H

#include "sinew_catalogue.h"

#ifdef __cplusplus
extern "C" {
#endif

extern const sinew_catalogue hmc_catalogue;

#ifdef __cplusplus
}
#endif
#endif
