/* SPDX-License-Identifier: BSD-2-Clause */
#include "mailbox.h"

#define TRIES 4

_Static_assert(offsetof(mailbox, measured) == 0x40, "register map");
_Static_assert(offsetof(mailbox, setpoint) == 0x200, "register map");
_Static_assert(offsetof(mailbox, answer) == 0x400, "register map");
_Static_assert(offsetof(mailbox, recorder) == 0x800, "register map");
_Static_assert(sizeof(mailbox_record) == 552, "no gaps");

/* Every access goes to memory, word by word, in order. */
static void copy_from(void *to, const volatile void *from, size_t bytes) {
  uint32_t *word = (uint32_t *)to;
  const volatile uint32_t *source = (const volatile uint32_t *)from;
  for (size_t i = 0; i < bytes / 4U; ++i) word[i] = source[i];
}

static void copy_to(volatile void *to, const void *from, size_t bytes) {
  volatile uint32_t *word = (volatile uint32_t *)to;
  const uint32_t *source = (const uint32_t *)from;
  for (size_t i = 0; i < bytes / 4U; ++i) word[i] = source[i];
}

static void fence(void) { __atomic_thread_fence(__ATOMIC_SEQ_CST); }

/* A block's first word is its sequence. 1 where all of it is of one writing. */
static int read_block(const volatile void *from, void *to, size_t bytes) {
  const volatile uint32_t *sequence = (const volatile uint32_t *)from;
  for (int i = 0; i < TRIES; ++i) {
    const uint32_t before = *sequence;
    fence();
    copy_from(to, from, bytes);
    fence();
    if ((before & 1U) == 0U && *sequence == before && *(uint32_t *)to == before) return 1;
  }
  return 0;
}

static void write_block(volatile void *to, const void *from, size_t bytes) {
  volatile uint32_t *sequence = (volatile uint32_t *)to;
  const uint32_t before = *sequence & ~1U;
  *sequence = before + 1U;
  fence();
  copy_to((volatile char *)to + 4, (const char *)from + 4, bytes - 4U);
  fence();
  *sequence = before + 2U;
  fence();
}

mailbox_reading mailbox_read_measured(const volatile mailbox *box, mailbox_reader *reader,
                                      mailbox_measured *block) {
  mailbox_measured now;
  const uint32_t sequence = box->measured.sequence;
  if (sequence == 0U || (sequence & 1U) != 0U)
    return MAILBOX_NOTHING; /* never, or not yet written */
  if (reader->seen != 0U && sequence == reader->sequence) return MAILBOX_NOTHING;
  if (!read_block(&box->measured, &now, sizeof now) || now.frame != now.frame_again) {
    ++reader->torn;
    return MAILBOX_TORN;
  }
  reader->sequence = now.sequence;
  const uint32_t ahead = now.frame - reader->frame;
  if (reader->seen != 0U && (ahead == 0U || ahead > 0x80000000U)) {
    ++reader->repeated;
    return MAILBOX_REPEATED;
  }
  if (reader->seen != 0U) reader->skipped += ahead - 1U;
  reader->frame = now.frame;
  reader->seen = 1U;
  *block = now;
  return MAILBOX_NEW;
}

int mailbox_read_setpoint(const volatile mailbox *box, mailbox_setpoint *block) {
  mailbox_setpoint now;
  if (!read_block(&box->setpoint, &now, sizeof now)) return 0;
  *block = now;
  return 1;
}

int mailbox_read_answer(const volatile mailbox *box, mailbox_answer *block) {
  mailbox_answer now;
  if (!read_block(&box->answer, &now, sizeof now) || now.frame != now.frame_again) return 0;
  *block = now;
  return 1;
}

void mailbox_write_measured(volatile mailbox *box, const mailbox_measured *block) {
  write_block(&box->measured, block, sizeof *block);
}

void mailbox_write_setpoint(volatile mailbox *box, const mailbox_setpoint *block) {
  write_block(&box->setpoint, block, sizeof *block);
}

void mailbox_write_answer(volatile mailbox *box, const mailbox_answer *block) {
  write_block(&box->answer, block, sizeof *block);
}

int mailbox_put_record(volatile mailbox *box, const mailbox_record *record) {
  volatile mailbox_recorder *ring = &box->recorder;
  const uint32_t written = ring->written;
  if (written - ring->read >= MAILBOX_RECORDS) return 0;
  copy_to(&ring->records[written & (MAILBOX_RECORDS - 1U)], record, sizeof *record);
  fence();
  ring->written = written + 1U;
  return 1;
}

int mailbox_take_record(volatile mailbox *box, mailbox_record *record) {
  volatile mailbox_recorder *ring = &box->recorder;
  const uint32_t read = ring->read;
  if (ring->written == read) return 0;
  fence();
  copy_from(record, &ring->records[read & (MAILBOX_RECORDS - 1U)], sizeof *record);
  fence();
  ring->read = read + 1U;
  return 1;
}
