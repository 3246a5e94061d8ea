/* SPDX-License-Identifier: BSD-2-Clause
 *
 * The memory that the FPGA and the real-time computer share: registers of 32 bits, little-endian,
 * each written by one side only. The table with every offset is in docs/firmware.md.
 *
 * Each block is guarded by a sequence word of its writer: odd while it writes, even and two higher
 * when it has. A reader that finds it odd, or changed while it read, has torn values and reads
 * again.
 */
#ifndef SINEW_MAILBOX_H
#define SINEW_MAILBOX_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
  MAILBOX_TENDONS = 38,
  MAILBOX_COORDINATES = 19,
  MAILBOX_MAGIC = 0x57454e53, /* "SNEW" */
  MAILBOX_LAYOUT = 1,
  MAILBOX_COUNTS_A_TURN = 409600, /* of a motor's position word, at the output shaft */
  MAILBOX_RECORDS = 1024,         /* a power of two */
  MAILBOX_RECORD_CHANNELS = 38,

  /* mailbox_control.command, written by the side that commands */
  MAILBOX_DRIVE = 1,    /* the motors follow the setpoint */
  MAILBOX_LOCKSTEP = 2, /* the other side waits for every answer: frames are never late */
  MAILBOX_STOP = 4,     /* the real-time computer ends its program: for tests */

  /* Sensor and wrist words */
  MAILBOX_COUNT_MASK = 0xffff,
  MAILBOX_LEVER_MASK = 0xfff
};
#define MAILBOX_VALID 0x80000000U /* the word holds a fresh sample */

/* 0x0000 */
typedef struct {
  uint32_t magic, layout; /* the FPGA's, before anything else is read */
  uint32_t command;       /* MAILBOX_DRIVE, ... */
  uint32_t reserved[13];
} mailbox_control;

/* 0x0040: the FPGA's, once a period */
typedef struct {
  uint32_t sequence;
  uint32_t frame;                   /* one higher in every period */
  int32_t motor[MAILBOX_TENDONS];   /* position of the output shafts, counts */
  uint32_t sensor[MAILBOX_TENDONS]; /* lever counts in the lower 12 bits, MAILBOX_VALID */
  uint32_t wrist[2];                /* potentiometers in the lower 16 bits, MAILBOX_VALID */
  uint32_t frame_again;             /* the same as frame; written last */
  uint32_t reserved;
} mailbox_measured;

/* 0x0200: of the side that commands, whenever it wants; IEEE single precision */
typedef struct {
  uint32_t sequence;
  float gravity[3];               /* m/s^2, forearm frame */
  float q[MAILBOX_COORDINATES];   /* rad */
  float qd[MAILBOX_COORDINATES];  /* rad/s */
  float qdd[MAILBOX_COORDINATES]; /* rad/s^2 */
  uint32_t reserved[3];
} mailbox_setpoint;

/* 0x0400: the real-time computer's, once a period */
typedef struct {
  uint32_t sequence;
  uint32_t frame;                  /* of the measured block that this answers */
  uint32_t heartbeat;              /* one higher in every tick, answered or not */
  uint32_t status;                 /* of the whole hand, see hand_step.h, and MAILBOX_... below */
  int32_t torque[MAILBOX_TENDONS]; /* uN m at the output shafts */
  int32_t feedforward[MAILBOX_TENDONS];     /* of it, what does not come from the servo */
  uint32_t channel_status[MAILBOX_TENDONS]; /* motor in the lower, lever in the upper half */
  uint32_t wrist_status[2];
  uint32_t starts;   /* cold starts since power-on, as far as memory has kept them */
  uint32_t late;     /* ticks without a frame in time */
  uint32_t repeated; /* blocks written anew with an old frame */
  uint32_t skipped;  /* frames that were never seen */
  uint32_t torn;     /* readings that had to be given up */
  uint32_t overruns; /* ticks that took longer than a period */
  uint32_t longest;  /* ticks of the timer, of one step */
  uint32_t lost_records;
  uint32_t frame_again;
  uint32_t reserved;
} mailbox_answer;

/* One tick as the recorder keeps it. */
typedef struct {
  uint32_t frame, status;
  int32_t motor[MAILBOX_RECORD_CHANNELS];  /* counts */
  int32_t torque[MAILBOX_RECORD_CHANNELS]; /* uN m */
  float force[MAILBOX_RECORD_CHANNELS];    /* N */
  float q[MAILBOX_COORDINATES];            /* rad */
  float q_wrist[2];                        /* rad */
  uint32_t reserved;
} mailbox_record;

/* 0x0800: the real-time computer writes `written` and the records, the other side `read`. */
typedef struct {
  uint32_t written, read;
  uint32_t reserved[14];
  mailbox_record records[MAILBOX_RECORDS];
} mailbox_recorder;

typedef struct {
  mailbox_control control;
  mailbox_measured measured;
  unsigned char to_setpoint[0x200 - 0x40 - sizeof(mailbox_measured)];
  mailbox_setpoint setpoint;
  unsigned char to_answer[0x200 - sizeof(mailbox_setpoint)];
  mailbox_answer answer;
  unsigned char to_recorder[0x400 - sizeof(mailbox_answer)];
  mailbox_recorder recorder;
} mailbox;

/* What a reading found. */
typedef enum {
  MAILBOX_NEW,      /* a frame that was not seen before */
  MAILBOX_NOTHING,  /* nothing was written since the last reading */
  MAILBOX_REPEATED, /* written anew, with a frame that was seen */
  MAILBOX_TORN      /* written while it was read, every time it was tried */
} mailbox_reading;

/* The reader's memory. */
typedef struct {
  uint32_t sequence, frame; /* of the last whole block */
  uint32_t seen;            /* 1 once a frame was taken */
  uint32_t repeated, skipped, torn;
} mailbox_reader;

/* Reads the measured block, trying a bounded number of times. *block is changed where the result is
 * MAILBOX_NEW. */
mailbox_reading mailbox_read_measured(const volatile mailbox *box, mailbox_reader *reader,
                                      mailbox_measured *block);

/* 1 and the setpoint where it could be read whole; 0 leaves *block as it is. */
int mailbox_read_setpoint(const volatile mailbox *box, mailbox_setpoint *block);

/* Each writes a whole block under its sequence word; block->sequence does not matter. */
void mailbox_write_measured(volatile mailbox *box, const mailbox_measured *block);
void mailbox_write_setpoint(volatile mailbox *box, const mailbox_setpoint *block);
void mailbox_write_answer(volatile mailbox *box, const mailbox_answer *block);

/* For the FPGA's side: 1 and the answer where it could be read whole. */
int mailbox_read_answer(const volatile mailbox *box, mailbox_answer *block);

/* 0 where the recorder is full: the tick is not kept. */
int mailbox_put_record(volatile mailbox *box, const mailbox_record *record);
/* The other side's: 0 where there is none. */
int mailbox_take_record(volatile mailbox *box, mailbox_record *record);

#ifdef __cplusplus
}
#endif
#endif
