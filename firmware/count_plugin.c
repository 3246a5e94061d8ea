/* SPDX-License-Identifier: BSD-2-Clause
 *
 * QEMU plugin: executed instructions between the marks of count.c, without those of functions named
 * call_... . For every group one line "count <windows> <fewest> <most>" goes to QEMU's plugin log.
 *
 * Debian's QEMU loads plugins but comes without qemu-plugin.h; the names used of version 1 of its
 * interface are declared here.
 */
#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

typedef uint64_t qemu_plugin_id_t;
typedef struct qemu_info_t qemu_info_t;
struct qemu_plugin_tb;
struct qemu_plugin_insn;
enum qemu_plugin_op { QEMU_PLUGIN_INLINE_ADD_U64 };
enum qemu_plugin_cb_flags { QEMU_PLUGIN_CB_NO_REGS };
typedef void (*translation_callback)(qemu_plugin_id_t, struct qemu_plugin_tb *);
typedef void (*execution_callback)(unsigned int, void *);
typedef void (*exit_callback)(qemu_plugin_id_t, void *);

void qemu_plugin_register_vcpu_tb_trans_cb(qemu_plugin_id_t, translation_callback);
void qemu_plugin_register_vcpu_insn_exec_cb(struct qemu_plugin_insn *, execution_callback,
                                            enum qemu_plugin_cb_flags, void *);
void qemu_plugin_register_vcpu_insn_exec_inline(struct qemu_plugin_insn *, enum qemu_plugin_op,
                                                void *, uint64_t);
void qemu_plugin_register_atexit_cb(qemu_plugin_id_t, exit_callback, void *);
size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *);
struct qemu_plugin_insn *qemu_plugin_tb_get_insn(const struct qemu_plugin_tb *, size_t);
const char *qemu_plugin_insn_symbol(const struct qemu_plugin_insn *);
void qemu_plugin_outs(const char *);

extern int qemu_plugin_version;
int qemu_plugin_version = 1;

#define GROUP_LIMIT 512

typedef struct {
  uint64_t windows;
  uint64_t fewest;
  uint64_t most;
} group;

static group groups[GROUP_LIMIT];
static int group_count = 0;
static uint64_t executed = 0;
static uint64_t window_start = 0;

static void begin_group(unsigned int cpu, void *nothing) {
  (void)cpu;
  (void)nothing;
  if (group_count < GROUP_LIMIT) groups[group_count].fewest = UINT64_MAX;
  ++group_count;
}

static void begin_window(unsigned int cpu, void *nothing) {
  (void)cpu;
  (void)nothing;
  window_start = executed;
}

static void end_window(unsigned int cpu, void *nothing) {
  (void)cpu;
  (void)nothing;
  if (group_count < 1 || group_count > GROUP_LIMIT) return;
  group *current = &groups[group_count - 1];
  const uint64_t count = executed - window_start;
  ++current->windows;
  if (count < current->fewest) current->fewest = count;
  if (count > current->most) current->most = count;
}

static execution_callback callback_of(const char *symbol) {
  if (symbol == NULL) return NULL;
  if (strcmp(symbol, "count_group") == 0) return begin_group;
  if (strcmp(symbol, "count_begin") == 0) return begin_window;
  if (strcmp(symbol, "count_end") == 0) return end_window;
  return NULL;
}

static void on_translation(qemu_plugin_id_t id, struct qemu_plugin_tb *block) {
  (void)id;
  for (size_t i = 0; i < qemu_plugin_tb_n_insns(block); ++i) {
    struct qemu_plugin_insn *instruction = qemu_plugin_tb_get_insn(block, i);
    const char *symbol = qemu_plugin_insn_symbol(instruction);
    if (symbol != NULL && strncmp(symbol, "call_", 5) == 0) continue;
    const execution_callback callback = callback_of(symbol);
    if (callback != NULL) {
      qemu_plugin_register_vcpu_insn_exec_cb(instruction, callback, QEMU_PLUGIN_CB_NO_REGS, NULL);
    }
    qemu_plugin_register_vcpu_insn_exec_inline(instruction, QEMU_PLUGIN_INLINE_ADD_U64, &executed,
                                               1);
  }
}

static void on_exit_of_emulator(qemu_plugin_id_t id, void *nothing) {
  (void)id;
  (void)nothing;
  char line[128];
  if (group_count > GROUP_LIMIT) {
    qemu_plugin_outs("error: more groups than GROUP_LIMIT\n");
    return;
  }
  for (int i = 0; i < group_count; ++i) {
    snprintf(line, sizeof line, "count %" PRIu64 " %" PRIu64 " %" PRIu64 "\n", groups[i].windows,
             groups[i].fewest, groups[i].most);
    qemu_plugin_outs(line);
  }
}

int qemu_plugin_install(qemu_plugin_id_t id, const qemu_info_t *info, int count, char **words);

int qemu_plugin_install(qemu_plugin_id_t id, const qemu_info_t *info, int count, char **words) {
  (void)info;
  (void)count;
  (void)words;
  qemu_plugin_register_vcpu_tb_trans_cb(id, on_translation);
  qemu_plugin_register_atexit_cb(id, on_exit_of_emulator, NULL);
  return 0;
}
