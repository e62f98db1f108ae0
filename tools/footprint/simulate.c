/* Runs a program on a simulated AVR and counts what it takes, by cycles and by the stack pointer after every instruction.
     simulate MCU PROGRAM SAID COUNTED [MARK]
   SAID gets what the program sends through USART0. COUNTED gets, in the order of events, as tools/footprint/count.c does:
     span N       cycles from one arrival at the address MARK (in bytes of flash) to the next
     stack N      the deepest stack in bytes, from the end of RAM
   The status is 0 when the program went to sleep without interrupts, 1 when it crashed or ran for too long, 2 for usage.
   SPDX-License-Identifier: MIT */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <simavr/avr_uart.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>

static const avr_cycle_count_t most_cycles = 4000000000u;

static void on_text(struct avr_irq_t *irq, uint32_t value, void *said) {
  (void)irq;
  fputc((int)value, said);
}

static avr_t *load(const char *mcu, const char *path) {
  elf_firmware_t firmware;
  memset(&firmware, 0, sizeof firmware);
  if (elf_read_firmware(path, &firmware) != 0) {
    fprintf(stderr, "simulate: not a program: %s\n", path);
    return NULL;
  }
  avr_t *avr = avr_make_mcu_by_name(mcu);
  if (avr == NULL) {
    fprintf(stderr, "simulate: no such microcontroller: %s\n", mcu);
    return NULL;
  }
  avr_init(avr);
  if (firmware.flashsize > avr->flashend + 1) {
    fprintf(stderr, "simulate: %u bytes do not fit the %u bytes of flash\n", (unsigned)firmware.flashsize,
            (unsigned)avr->flashend + 1);
    return NULL;
  }
  avr->frequency = 16000000;
  avr_load_firmware(avr, &firmware);
  avr->log = LOG_ERROR;
  return avr;
}

/* Text arrives byte by byte, and waiting for it costs no real time. */
static void listen(avr_t *avr, FILE *said) {
  uint32_t flags = 0;
  avr_ioctl(avr, AVR_IOCTL_UART_GET_FLAGS('0'), &flags);
  flags &= ~(uint32_t)(AVR_UART_FLAG_STDIO | AVR_UART_FLAG_POLL_SLEEP);
  avr_ioctl(avr, AVR_IOCTL_UART_SET_FLAGS('0'), &flags);
  avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUTPUT), on_text, said);
}

/* The deepest stack so far. Frames are made by writing the pointer's two bytes one after the other, and between the two
   it points anywhere: calls and pushes, of one to three bytes, count at once, other values when they have stood for
   four instructions. */
typedef struct {
  unsigned deepest, last, stood;
} Stack;

static void look_at_stack(Stack *stack, const avr_t *avr) {
  const unsigned low = 0x5d, high = 0x5e; /* its place among the data */
  const unsigned now = avr->data[low] | (unsigned)avr->data[high] << 8;
  const bool pushed = now < stack->last && stack->last - now <= 3;
  stack->stood = now == stack->last ? stack->stood + 1 : 0;
  stack->last = now;
  if ((pushed || stack->stood >= 4) && now > 0 && now < stack->deepest) stack->deepest = now;
}

static int run(avr_t *avr, FILE *counted, bool marks, avr_flashaddr_t mark) {
  Stack stack = {avr->ramend, 0, 0};
  avr_cycle_count_t since = 0;
  bool marked = false;
  int state = cpu_Running;
  while (state != cpu_Done && state != cpu_Crashed && avr->cycle < most_cycles) {
    if (marks && avr->pc == mark) {
      if (marked) fprintf(counted, "span %llu\n", (unsigned long long)(avr->cycle - since));
      marked = true;
      since = avr->cycle;
    }
    state = avr_run(avr);
    look_at_stack(&stack, avr);
  }
  fprintf(counted, "stack %u\n", avr->ramend - stack.deepest);
  if (state == cpu_Done) return 0;
  fprintf(stderr, "simulate: the program %s\n", state == cpu_Crashed ? "crashed" : "ran for too long");
  return 1;
}

static FILE *open_file(const char *path) {
  FILE *file = fopen(path, "wb");
  if (file == NULL) perror(path);
  return file;
}

int main(int words, char **word) {
  if (words != 5 && words != 6) {
    fprintf(stderr, "usage: simulate MCU PROGRAM SAID COUNTED [MARK]\n");
    return 2;
  }
  avr_t *avr = load(word[1], word[2]);
  if (avr == NULL) return 2;
  FILE *said = open_file(word[3]), *counted = open_file(word[4]);
  if (said == NULL || counted == NULL) return 2;
  listen(avr, said);
  const bool marks = words == 6;
  const int status = run(avr, counted, marks, marks ? (avr_flashaddr_t)strtoul(word[5], NULL, 0) : 0);
  return (fclose(said) | fclose(counted)) == 0 ? status : 1;
}
