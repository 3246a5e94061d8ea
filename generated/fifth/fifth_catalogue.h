/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Every function of the model fifth behind one calling convention.
 *
 * Made by: sinew generate models/fifth
 * Model:   sha256 ae27d826145740fcb6e3f8c3b6f00dad5a582dbf0da2c06f617ce673f467b351
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
