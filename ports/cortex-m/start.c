/* Start-up of a Cortex-M without a C library: vectors, .data, .bss, a painted stack, and text through semihosting.
   SPDX-License-Identifier: MIT */
#include <stdint.h>

extern uint32_t stack_top, stack_floor, data_image, data_begin, data_end, bss_begin, bss_end;
int main(void);

enum { SYS_WRITEC = 0x03, SYS_EXIT = 0x18, STOPPED_WELL = 0x20026, STOPPED_BADLY = 0x20023 };

uint32_t host_call(uint32_t operation, uintptr_t argument) {
  register uint32_t r0 __asm("r0") = operation;
  register uintptr_t r1 __asm("r1") = argument;
  __asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}

void host_put(char c) { host_call(SYS_WRITEC, (uintptr_t)&c); }

static void host_exit(int code) {
  host_call(SYS_EXIT, code == 0 ? STOPPED_WELL : STOPPED_BADLY);
  for (;;) {
  }
}

static const uint32_t unused = 0x5ca1ab1e;

/* Bytes of stack that were ever written to. */
uint32_t stack_used(void) {
  const uint32_t *word = &stack_floor;
  while (word < &stack_top && *word == unused) ++word;
  return (uint32_t)((uintptr_t)&stack_top - (uintptr_t)word);
}

static __attribute__((noinline, noreturn)) void begin(void) {
  const uint32_t *from = &data_image;
  uint32_t *word;
  const uint32_t *here = (uint32_t *)__builtin_frame_address(0) - 16;
  for (word = &data_begin; word < &data_end;) *word++ = *from++;
  for (word = &bss_begin; word < &bss_end;) *word++ = 0;
  for (word = &stack_floor; word < here;) *word++ = unused;
  host_exit(main());
  for (;;) {
  }
}

/* Vector instructions fault until coprocessors 10 and 11 are open, and `begin` may hold some. */
__attribute__((noreturn)) void reset(void) {
#if defined(__ARM_FP) || defined(__ARM_FEATURE_MVE)
  *(volatile uint32_t *)0xe000ed88u |= UINT32_C(15) << 20;
  __asm volatile("dsb\n isb" ::: "memory");
#endif
  begin();
}

static void fault(void) {
  for (const char *text = "fault\n"; *text != 0;) host_put(*text++);
  host_exit(1);
}

typedef void (*Vector)(void);
__attribute__((section(".vectors"), used)) static const Vector vectors[16] = {
    (Vector)&stack_top, (Vector)reset, fault, fault, fault, fault, fault, fault};
