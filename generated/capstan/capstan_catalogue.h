/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Every function of the model capstan behind one calling convention.
 *
 * Made by: sinew generate models/capstan
 * Model:   sha256 9937a616cfcfa046d6bebb92e5b90c960f3b39b95c0b66932a954a91e45aa2ea
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_capstan_CATALOGUE_H
#define SINEW_capstan_CATALOGUE_H

#include "sinew_catalogue.h"

#ifdef __cplusplus
extern "C" {
#endif

extern const sinew_catalogue capstan_catalogue;

#ifdef __cplusplus
}
#endif
#endif
