/* What a program takes, counted while an emulator runs it: a plugin for QEMU 7.2 (TCG plugins, version 1 of their
   interface). Exact and repeatable; no change to the program.
     -plugin file=count.so,out=FILE,main=ADDRESS,mark=ADDRESS,floor=ADDRESS,top=ADDRESS
   Writes FILE, in the order of events, as tools/footprint/simulate.c does:
     span N       instructions executed from one call of the function at `mark` to the next
     stack N      bytes between `top` and the lowest address above `floor` that was stored to since `main` began
   Debian has no package of qemu-plugin.h; what is needed of it stands below.
   SPDX-License-Identifier: MIT */
#include <inttypes.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PUBLIC __attribute__((visibility("default")))

typedef uint64_t qemu_plugin_id_t;
typedef uint32_t qemu_plugin_meminfo_t;
typedef struct qemu_info_t qemu_info_t;
struct qemu_plugin_tb;
struct qemu_plugin_insn;
enum { NO_REGISTERS = 0, ADD_TO_COUNTER = 0, STORES = 2 };
typedef void (*OnBlock)(qemu_plugin_id_t, struct qemu_plugin_tb *);
typedef void (*OnInstruction)(unsigned, void *);
typedef void (*OnMemory)(unsigned, qemu_plugin_meminfo_t, uint64_t, void *);
typedef void (*OnEnd)(qemu_plugin_id_t, void *);
void qemu_plugin_register_vcpu_tb_trans_cb(qemu_plugin_id_t, OnBlock);
void qemu_plugin_register_vcpu_insn_exec_cb(struct qemu_plugin_insn *, OnInstruction, int, void *);
void qemu_plugin_register_vcpu_insn_exec_inline(struct qemu_plugin_insn *, int, void *, uint64_t);
void qemu_plugin_register_vcpu_mem_cb(struct qemu_plugin_insn *, OnMemory, int, int, void *);
void qemu_plugin_register_atexit_cb(qemu_plugin_id_t, OnEnd, void *);
size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *);
struct qemu_plugin_insn *qemu_plugin_tb_get_insn(const struct qemu_plugin_tb *, size_t);
uint64_t qemu_plugin_insn_vaddr(const struct qemu_plugin_insn *);

PUBLIC int qemu_plugin_version = 1;

static FILE *out;
static uint64_t count, since, main_at, mark_at, floor_at, top_at, lowest;
static bool started, marked;

static void on_main(unsigned cpu, void *data) {
  (void)cpu, (void)data;
  started = true;
}

static void on_mark(unsigned cpu, void *data) {
  (void)cpu, (void)data;
  if (marked) fprintf(out, "span %" PRIu64 "\n", count - since);
  marked = true;
  since = count;
}

static void on_store(unsigned cpu, qemu_plugin_meminfo_t info, uint64_t address, void *data) {
  (void)cpu, (void)info, (void)data;
  if (started && address >= floor_at && address < lowest) lowest = address;
}

static void on_block(qemu_plugin_id_t id, struct qemu_plugin_tb *block) {
  (void)id;
  const size_t instructions = qemu_plugin_tb_n_insns(block);
  for (size_t i = 0; i < instructions; ++i) {
    struct qemu_plugin_insn *one = qemu_plugin_tb_get_insn(block, i);
    const uint64_t address = qemu_plugin_insn_vaddr(one);
    if (address == main_at) qemu_plugin_register_vcpu_insn_exec_cb(one, on_main, NO_REGISTERS, NULL);
    if (address == mark_at) qemu_plugin_register_vcpu_insn_exec_cb(one, on_mark, NO_REGISTERS, NULL);
    if (top_at > floor_at) qemu_plugin_register_vcpu_mem_cb(one, on_store, NO_REGISTERS, STORES, NULL);
    qemu_plugin_register_vcpu_insn_exec_inline(one, ADD_TO_COUNTER, &count, 1);
  }
}

static void on_end(qemu_plugin_id_t id, void *data) {
  (void)id, (void)data;
  if (top_at > floor_at) fprintf(out, "stack %" PRIu64 "\n", top_at - lowest);
  if (fclose(out) != 0) perror("count.so");
}

static bool take(const char *word, const char *name, uint64_t *value) {
  const size_t length = strlen(name);
  if (strncmp(word, name, length) != 0 || word[length] != '=') return false;
  *value = strtoull(word + length + 1, NULL, 0);
  return true;
}

PUBLIC int qemu_plugin_install(qemu_plugin_id_t id, const qemu_info_t *info, int words, char **word) {
  (void)info;
  for (int i = 0; i < words; ++i) {
    if (strncmp(word[i], "out=", 4) == 0) {
      out = fopen(word[i] + 4, "w");
    } else if (!take(word[i], "main", &main_at) && !take(word[i], "mark", &mark_at) &&
               !take(word[i], "floor", &floor_at) && !take(word[i], "top", &top_at)) {
      fprintf(stderr, "count.so: no such argument: %s; there are out, main, mark, floor and top\n", word[i]);
      return 2;
    }
  }
  if (out == NULL) {
    fprintf(stderr, "count.so: out=FILE has to be a file that can be written\n");
    return 2;
  }
  lowest = top_at;
  qemu_plugin_register_vcpu_tb_trans_cb(id, on_block);
  qemu_plugin_register_atexit_cb(id, on_end, NULL);
  return 0;
}
