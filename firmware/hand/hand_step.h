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
 * Every output is of the tick's own sensors and wanted values but for three, which come by turns of
 * HAND_TURNS ticks (2 ms at 3 kHz, 500 Hz) unless the table says that all is done in every tick:
 *
 *     joint_stiffness      a whole matrix of one tick's state, from 1 to 6 ticks old: stiffness_age
 *     joint_feedforward    and the forces for it, likewise: feedforward_age
 *     friction_feedforward of a motor, from 0 to 5 ticks old, of the angle in their middle
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
  double
      joint_feedforward[HAND_COORDINATES]; /* gravity and inverse dynamics of the wanted motion */
  /* Commands, per motor. */
  double wrist_feedforward[HAND_TENDONS]; /* rad, holds the fingers still; 0 in the reference */
  double wrist_feedforward_rate[HAND_TENDONS]; /* rad/s */
  double friction_feedforward[HAND_TENDONS];   /* N m, against friction and ripple */
  double motor_feedforward[HAND_TENDONS];      /* N m, all that does not come from the servo */
  double motor_torque[HAND_TENDONS];           /* N m, to the motor, limited; 0 where unsafe */
  /* N m/rad; written in its turn, left as it is in the other ticks: pass the same output again. */
  double joint_stiffness[(HAND_COORDINATES + 2) * (HAND_COORDINATES + 2)];
  /* Statuses: bits of sinew_channel.h and of the enum above. */
  uint32_t motor_status[HAND_TENDONS], lever_status[HAND_TENDONS], wrist_status[2];
  uint32_t group_status[HAND_GROUPS]; /* of its sensors and of what follows from them */
  uint32_t status;                    /* of all together */
  /* Ticks since the state that joint_stiffness is of, and the motion that joint_feedforward is of;
   * HAND_NONE_YET and more before the first ones. */
  uint32_t stiffness_age, feedforward_age;
  uint32_t ticks;                     /* since the start, this one included */
} hand_output;

#define HAND_NONE_YET 0x80000000U /* ticks: 8 days at 3 kHz */

/* Most of one finger; of the thumb's base, whose coupling depends on its posture. */
enum { HAND_FINGER_JOINTS = 4, HAND_FINGER_TENDONS = 8, HAND_BASE_TENDONS = 4 };

/* What the parts of one tick hand on; means nothing between ticks. */
typedef struct {
  double wrist_coupling[HAND_TENDONS * 2]; /* m/rad */
  /* The groups' tendons in a row: what their ends have moved [m], then their forces [N]. */
  double moved_and_force[2 * HAND_TENDONS];
  double length[HAND_TENDONS];       /* m, in the reference posture */
  double length_later[HAND_TENDONS]; /* m, a tick later */
  double later[HAND_COORDINATES];    /* rad, where the reference will be then */
  double qd[HAND_COORDINATES], qdd[HAND_COORDINATES]; /* wanted, limited [rad/s, rad/s^2] */
} hand_tick;

/* One tendon. What a tick needs of it stands side by side: one address for all. */
typedef struct {
  sinew_channel motor, lever;
  uint32_t channel, reserved;           /* as in the table */
  double rate;                          /* of the motor, filtered [rad/s] */
  double servo;                         /* N m, of the servo for what the wrist asks */
  double at_zero;                       /* m, displacement at q = 0 and the crank's reference */
  double wrist_at_reference;            /* m */
  double by_torque[HAND_FINGER_JOINTS]; /* N a N m; of the thumb's base: of its last turn */
  double more;                          /* N above the pretension, until it is its turn again */
  double friction;                      /* N m, likewise */
} hand_tendon;

/* What the stiffness matrix is made of: all of one tick. */
typedef struct {
  double q[HAND_COORDINATES], wrist_coupling[HAND_TENDONS * 2];
  double force[HAND_TENDONS], stiffness[HAND_TENDONS], wrist_stiffness[4];
  uint32_t age, reserved; /* ticks */
} hand_snapshot;

/* The caller's; nothing in it is to be read or written by others. */
typedef struct {
  hand_tick tick; /* first, where it is reached with the shortest instructions */
  sinew_channel wrist[2];
  hand_tendon tendon[HAND_TENDONS]; /* the groups' tendons in a row */
  double last_wrist[2], wrist_rate[2];
  double q[HAND_COORDINATES]; /* last link positions: where searches start */
  double
      reference[HAND_COORDINATES]; /* what the motors follow: q of the input, at a bounded rate */
  double crank_coupling[2];                   /* m/rad */
  double joint_feedforward[HAND_COORDINATES]; /* N m, until it is its turn again */
  /* The next one and the thumb's reference of the same tick: forces for it come a turn later. */
  double next_feedforward[HAND_COORDINATES], next_thumb[HAND_FINGER_JOINTS];
  hand_snapshot snapshot;
  uint32_t ticks, turn, stiffness_age, feedforward_age, next_feedforward_age, astray_ticks;
  uint32_t driven; /* groups that followed, as bits */
  uint32_t reserved;
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
