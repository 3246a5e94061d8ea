/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Every function of the model hand behind one calling convention.
 *
 * Made by: sinew generate models/hand
 * Model:   sha256 ea7c5987c1e241459bbd7e76931da3d2400f3ffea93eb620e4d52a2c4f3ed50b
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_hand_CATALOGUE_H
#define SINEW_hand_CATALOGUE_H

#include "sinew_catalogue.h"

#ifdef __cplusplus
extern "C" {
#endif

extern const sinew_catalogue hand_catalogue;

#ifdef __cplusplus
}
#endif
#endif
