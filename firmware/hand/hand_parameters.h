/* SPDX-License-Identifier: BSD-2-Clause
 *
 * What hand_step needs to know of one hand. hand_parameters.c holds the table, made from the model
 * by
 *
 *     sinew parameters models/hand --out generated/hand_step/hand_parameters.c
 *
 * SI units. The layout has no gaps and is the same on every target with 8-byte aligned doubles.
 */
#ifndef SINEW_HAND_PARAMETERS_H
#define SINEW_HAND_PARAMETERS_H

#include <stdint.h>

#include "sinew_channel.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
  HAND_TENDONS = 38,     /* motors, levers and wrist channels, numbered by wrist channel */
  HAND_FINGERS = 5,      /* thumb, index, middle, ring, fifth */
  HAND_GROUPS = 6,       /* the fingers and the four-bar's crank */
  HAND_JOINTS = 18,      /* of the fingers, without the crank */
  HAND_COORDINATES = 19, /* with the crank behind them */
  HAND_LEVER_TERMS = 8,  /* coefficients of a lever's polynomials */
  HAND_TURNS = 6,        /* ticks in which all that is done by turns has had its turn */
  HAND_TABLE_VERSION = 2
};

/* One lever's sensor, its tendon included: polynomials, from the constant upwards, in
 * (count - centre) * inverse, which is held at -1 and 1 outside the counts that were calibrated. */
typedef struct {
  double centre, inverse;              /* counts, 1/counts */
  double force[HAND_LEVER_TERMS];      /* N */
  double elongation[HAND_LEVER_TERMS]; /* m, of lever and tendon, 0 where both are free */
  double stiffness[HAND_LEVER_TERMS];  /* N/m, of lever and tendon in series */
} hand_lever;

/* What is used most stands first, where processors reach it with the shortest instructions. */
typedef struct {
  double period;                          /* s, of a tick */
  double motor_radius;                    /* m, of the motors' pulleys */
  double pretension;                      /* N, at which every tendon is held */
  double least_stiffness;                 /* N/m, of a tendon that is not slack */
  double rate_share;                      /* of a new difference in a filtered rate, 0..1 */
  double servo_gain, servo_rate_gain;     /* N m/rad, N m s/rad at the motor's output */
  double torque_limit;                    /* N m, at the motor's output */
  double reference_rate;                  /* rad/s, fastest change of the reference of a joint */
  double wrist_offset[2], wrist_scale[2]; /* bar angle = offset + scale * count [rad] */
  double wrist_reference[2];              /* rad, q71 and q73 of the reference pose */
  double wrist_low[2], wrist_high[2];     /* rad, the range in which the wrist is regular */
  double crank_reference;                 /* rad, where the crank's tendons have length 0 */
  sinew_channel_limits motor_limits; /* rad */
  sinew_channel_limits lever_limits; /* counts */
  sinew_channel_limits wrist_limits; /* counts */
  /* R theta + h_wrist + h_finger - elongation of each tendon (5.1) [m] */
  double closure[HAND_TENDONS];
  hand_lever lever[HAND_TENDONS];
  double joint_low[HAND_COORDINATES], joint_high[HAND_COORDINATES]; /* rad */
  /* Wrist channel of each tendon, from 0: those of the fingers in their order, then the crank's. */
  uint32_t channel[HAND_TENDONS];
  uint32_t first_tendon[HAND_GROUPS]; /* of a group, into `channel` */
  uint32_t first_coordinate[HAND_GROUPS];
  /* 1: everything in every tick. HAND_TURNS: stiffness, friction and feedforward by turns. */
  uint32_t turns;
  uint32_t restart_ticks; /* not converged for so long: the thumb's search begins anew */
  uint32_t version;       /* HAND_TABLE_VERSION */
  uint32_t checksum;      /* sinew_checksum of all bytes before */
} hand_parameters;

/* Made by `sinew parameters`. */
extern const hand_parameters hand_parameters_table;

#ifdef __cplusplus
}
#endif
#endif
