/* SPDX-License-Identifier: BSD-2-Clause
 *
 * One tick of the hand: from 38 motor angles, 38 lever-sensor counts and two wrist potentiometers
 * to everything a controller asks of the model, and to the motors' torques (equations of section
 * 8).
 *
 *     hand_state state;
 *     if (hand_start(&state, &hand_parameters_table) != HAND_START_FINE) ...the table is damaged...
 *     for every tick: hand_step(&state, &hand_parameters_table, &input, &output);
 *
 * No heap, no global that is written, no loop without a bound, no library call but memcpy and
 * memset. All memory is the caller's: HAND_STATE_BYTES for the state.
 *
 * Units: rad, m, N, N m, s. Tendons, motors and levers are numbered by wrist channel; coordinates
 * are q[0..17] of the fingers (thumb 4, index 4, middle 4, ring 3, fifth 3) and q[18], the crank of
 * the four-bar; matrices of the whole hand have q71 and q73 behind them. Row-major.
 */
#ifndef SINEW_HAND_STEP_H
#define SINEW_HAND_STEP_H

#include <stdint.h>

#include "hand_parameters.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What is measured and what is wanted. Any bit pattern is allowed: NaN stands for "no sample". */
typedef struct {
  double motor_angle[HAND_TENDONS]; /* rad, at the output shaft; 0 where the table was made */
  double lever_count[HAND_TENDONS]; /* counts of the 12-bit sensors */
  double wrist_count[2];            /* counts of the potentiometers of q71, q73 */
  double gravity[3];                /* m/s^2, in the forearm frame {0} */
  double q[HAND_COORDINATES];       /* wanted motion of fingers and crank [rad] */
  double qd[HAND_COORDINATES];      /* rad/s */
  double qdd[HAND_COORDINATES];     /* rad/s^2; the crank's is not used */
  uint32_t drive; /* 1: the motors follow q; 0: their torques are 0 and all else is computed */
  uint32_t reserved;
} hand_input;

/* Beside the bits of sinew_channel.h, in the statuses of groups and of the hand. */
enum {
  HAND_SLACK = 256,           /* a tendon of the group has no force */
  HAND_NOT_CONVERGED = 512,   /* the thumb's search has not arrived; its angles are on their way */
  HAND_JOINT_RANGE = 1024,    /* a joint is beyond its range; matrices are those at the limit */
  HAND_SETPOINT = 2048,       /* a wanted value is no number or out of range, and was limited */
  HAND_TORQUE_LIMITED = 4096, /* a motor's torque was limited */
  HAND_UNSAFE = 8192 /* a sensor of the group or of the wrist is lost: its motors have torque 0 */
};

typedef struct {
  /* Per tendon. */
  double force[HAND_TENDONS];        /* N, at the motor's side */
  double stiffness[HAND_TENDONS];    /* N/m, of lever and tendon in series */
  double wrist_length[HAND_TENDONS]; /* m, path through the wrist */
  double wrist_rate[HAND_TENDONS];   /* m/s */
  double
      displacement[HAND_TENDONS]; /* m, h_finger: absolute for the thumb's base, else from q = 0 */
  /* Per coordinate. */
  double q_wrist[2], qd_wrist[2];            /* rad, rad/s */
  double q[HAND_COORDINATES];                /* link positions [rad] */
  double joint_torque[HAND_COORDINATES + 2]; /* of the tendon forces, -P^T f [N m] */
  /* N m/rad; written in its turn, left as it is in the other ticks: pass the same output again. */
  double joint_stiffness[(HAND_COORDINATES + 2) * (HAND_COORDINATES + 2)];
  double
      joint_feedforward[HAND_COORDINATES]; /* gravity and inverse dynamics of the wanted motion */
  /* Commands, per motor. */
  double wrist_feedforward[HAND_TENDONS]; /* rad, holds the fingers still; 0 in the reference */
  double wrist_feedforward_rate[HAND_TENDONS]; /* rad/s */
  double friction_feedforward[HAND_TENDONS];   /* N m, against friction and ripple */
  double motor_feedforward[HAND_TENDONS];      /* N m, all that does not come from the servo */
  double motor_torque[HAND_TENDONS];           /* N m, to the motor, limited; 0 where unsafe */
  /* Statuses: bits of sinew_channel.h and of the enum above. */
  uint32_t motor_status[HAND_TENDONS], lever_status[HAND_TENDONS], wrist_status[2];
  uint32_t group_status[HAND_GROUPS]; /* of its sensors and of what follows from them */
  uint32_t status;                    /* of all together */
  uint32_t stiffness_age;             /* ticks since joint_stiffness was computed */
  uint32_t ticks;                     /* since the start, this one included */
} hand_output;

/* What the parts of one tick hand on; means nothing between ticks. */
typedef struct {
  double motor[HAND_TENDONS];              /* rad, checked */
  double wrist_coupling[HAND_TENDONS * 2]; /* m/rad */
  double displacement[HAND_TENDONS];       /* m, the groups' tendons in a row */
  double force[HAND_TENDONS];              /* N, likewise */
  double motor_reference[HAND_TENDONS];    /* rad, by channel */
  double motor_reference_rate[HAND_TENDONS];
} hand_tick;

/* The caller's; nothing in it is to be read or written by others. */
typedef struct {
  sinew_channel motor[HAND_TENDONS], lever[HAND_TENDONS], wrist[2];
  double last_motor[HAND_TENDONS], motor_rate[HAND_TENDONS];
  double last_wrist[2], wrist_rate[2];
  double q[HAND_COORDINATES]; /* last link positions: where searches start */
  double
      reference[HAND_COORDINATES]; /* what the motors follow: q of the input, at a bounded rate */
  double wrist_at_reference[HAND_TENDONS]; /* m */
  double finger_at_zero[HAND_TENDONS];     /* m, displacement at q = 0 and the crank's reference */
  double crank_coupling[2];                /* m/rad */
  double force_by_torque[HAND_JOINTS * 8]; /* N a N m: 8 a joint, of the fingers with constant P */
  double friction[HAND_TENDONS];           /* N m, until it is its turn again */
  double joint_feedforward[HAND_COORDINATES], more[HAND_TENDONS]; /* until it is their turn again */
  uint32_t ticks, turn, stiffness_age, astray_ticks;
  uint32_t driven; /* groups that followed, as bits */
  uint32_t reserved;
  hand_tick tick; /* here, so that it is not on the stack */
} hand_state;

enum { HAND_STATE_BYTES = sizeof(hand_state) };

enum {
  HAND_START_FINE = 0,
  HAND_START_CHECKSUM = 1, /* the table's bytes are not those that were made */
  HAND_START_VERSION = 2,  /* the table is of another layout */
  HAND_START_SINGULAR = 3  /* a finger's tendons do not determine its joints */
};

/* Tests the table and makes the state of the first tick. Takes as long as some ticks do. */
int hand_start(hand_state *state, const hand_parameters *parameters);

/* One tick. Every output is finite for every input; the statuses say what it is worth. A faulty
 * channel keeps its last good value for hold_ticks of its limits and has the safe one from then on;
 * it comes back by itself. */
void hand_step(hand_state *state, const hand_parameters *parameters, const hand_input *input,
               hand_output *output);

#ifdef __cplusplus
}
#endif
#endif
