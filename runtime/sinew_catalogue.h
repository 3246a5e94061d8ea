/* SPDX-License-Identifier: BSD-2-Clause
 *
 * What <model>_catalogue.c offers: every emitted function behind one calling convention, so that
 * tests, the firmware's equality check and simulation can run any model without knowing it.
 */
#ifndef SINEW_CATALOGUE_H
#define SINEW_CATALOGUE_H

#ifdef __cplusplus
extern "C" {
#endif

/* One array argument or result, row-major. low and high have rows*cols entries: the range in which
 * the model is meant to be used (null for results). */
typedef struct {
    const char *name;
    const char *unit;
    int rows;
    int cols;
    const double *low;
    const double *high;
} sinew_argument;

/* in: all inputs one after the other; out: all results one after the other. Elements are double
 * where scalar_bytes is 8 and float where it is 4. */
typedef struct {
    const char *name;
    int input_count;
    int output_count;
    int input_size;  /* elements in all inputs together */
    int output_size; /* elements in all results together */
    const sinew_argument *inputs;
    const sinew_argument *outputs;
    void (*call)(const void *in, void *out);
} sinew_function;

typedef struct {
    const char *model;
    const char *hash; /* of the model description, as in manifest.json */
    int scalar_bytes;
    int function_count;
    const sinew_function *functions;
} sinew_catalogue;

/* Each model defines: extern const sinew_catalogue <model>_catalogue; */

#ifdef __cplusplus
}
#endif
#endif
