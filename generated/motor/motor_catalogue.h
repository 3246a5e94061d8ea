/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Every function of the model motor behind one calling convention.
 *
 * Made by: sinew generate models/motor
 * Model:   sha256 2c199a43b98e0841badcd614a7ffc517e317754389edc12753b1bb278e566736
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_motor_CATALOGUE_H
#define SINEW_motor_CATALOGUE_H

#include "sinew_catalogue.h"

#ifdef __cplusplus
extern "C" {
#endif

extern const sinew_catalogue motor_catalogue;

#ifdef __cplusplus
}
#endif
#endif
