/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Every function of the model effects behind one calling convention.
 *
 * Made by: sinew generate models/effects
 * Model:   sha256 69c538edcbf3bf2f45779b1c8a2551790ff791915ec1f60e5b93999b2315532f
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_effects_CATALOGUE_H
#define SINEW_effects_CATALOGUE_H

#include "sinew_catalogue.h"

#ifdef __cplusplus
extern "C" {
#endif

extern const sinew_catalogue effects_catalogue;

#ifdef __cplusplus
}
#endif
#endif
