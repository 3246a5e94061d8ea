/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Every function of the model hand behind one calling convention.
 *
 * Made by: sinew generate models/hand
 * Model:   sha256 149bfdb172c9db83c03fe3a5f8e740421544677e415df28801df6237951eb00f
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
