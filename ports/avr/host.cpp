// What a program says, through USART0 of an ATmega, and its end: sleep without interrupts, which ends a simulation.
// SPDX-License-Identifier: MIT
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>

extern "C" {
void host_put(char c);
[[noreturn]] void exit(int);
}

static void wait_for_room() {
  while ((UCSR0A & (1 << UDRE0)) == 0) {
  }
}

// At the rate of a reset; a simulated line takes any.
void host_put(char c) {
  UCSR0B = 1 << TXEN0;
  wait_for_room();
  UDR0 = static_cast<uint8_t>(c);
}

// What the start-up code calls after main.
void exit(int) {
  wait_for_room();
  cli();
  sleep_enable();
  sleep_cpu();
  for (;;) {
  }
}
