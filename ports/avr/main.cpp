// The self-test on an ATmega1284P at 16 MHz, text through USART0; sleeping without interrupts ends the simulation.
// POOL: bytes of RAM for textures; the rest of the 16 KB is stack and what C++ keeps in RAM.
// SPDX-License-Identifier: MIT
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>
#include "selftest.hpp"

static uint8_t memory[POOL];
extern uint8_t __heap_start[];  // the first byte behind .bss: as far down as the stack may come
static constexpr uint8_t kGuard = 16;

// Sets the bytes there, or says whether they are as they were.
static bool guard(bool set) {
  bool whole = true;
  for (uint8_t i = 0; i < kGuard; ++i) {
    volatile uint8_t& byte = __heap_start[i];
    if (set) byte = 0xa5;
    whole = whole && byte == 0xa5;
  }
  return whole;
}

static void put(char c) {
  while ((UCSR0A & (1 << UDRE0)) == 0) {
  }
  UDR0 = static_cast<uint8_t>(c);
}

extern "C" int main() {
  UBRR0 = 0;  // a simulated line takes any rate
  UCSR0B = 1 << TXEN0;
  guard(true);
  selftest(put, sizeof memory, memory);
  if (!guard(false))
    for (const char* text = "the stack ran into the textures\n"; *text != 0;) put(*text++);
  put('\n');
  while ((UCSR0A & (1 << UDRE0)) == 0) {
  }
  cli();
  sleep_enable();
  sleep_cpu();
  for (;;) {
  }
}
