/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Every function of the model index behind one calling convention.
 *
 * Made by: sinew generate models/index
 * Model:   sha256 87dae3bf2513ab5836c918f869de07d956d21148227d4e316059a4cbc5f06f25
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_index_CATALOGUE_H
#define SINEW_index_CATALOGUE_H

#include "sinew_catalogue.h"

#ifdef __cplusplus
extern "C" {
#endif

extern const sinew_catalogue index_catalogue;

#ifdef __cplusplus
}
#endif
#endif
