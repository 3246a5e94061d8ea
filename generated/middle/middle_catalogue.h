/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Every function of the model middle behind one calling convention.
 *
 * Made by: sinew generate models/middle
 * Model:   sha256 5178dcc126793c8544b85aef441fae055a412f16d86c338979b82e8fddc6e30d
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_middle_CATALOGUE_H
#define SINEW_middle_CATALOGUE_H

#include "sinew_catalogue.h"

#ifdef __cplusplus
extern "C" {
#endif

extern const sinew_catalogue middle_catalogue;

#ifdef __cplusplus
}
#endif
#endif
