/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Every function of the model lever behind one calling convention.
 *
 * Made by: sinew generate models/lever
 * Model:   sha256 15dde9f611cf6f60b088af06e8cd7bbe07ac2edbefd53940e6f2012efb5af55c
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_lever_CATALOGUE_H
#define SINEW_lever_CATALOGUE_H

#include "sinew_catalogue.h"

#ifdef __cplusplus
extern "C" {
#endif

extern const sinew_catalogue lever_catalogue;

#ifdef __cplusplus
}
#endif
#endif
