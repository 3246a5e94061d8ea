/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Every function of the model wrist behind one calling convention.
 *
 * Made by: sinew generate models/wrist
 * Model:   sha256 5646b07e7724f9dffd716a90d2124284950ee812515cbecbb3d964272a0f8011
 * Do not edit: change the model and generate again.
 */
#ifndef SINEW_wrist_CATALOGUE_H
#define SINEW_wrist_CATALOGUE_H

#include "sinew_catalogue.h"

#ifdef __cplusplus
extern "C" {
#endif

extern const sinew_catalogue wrist_catalogue;

#ifdef __cplusplus
}
#endif
#endif
