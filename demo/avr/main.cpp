// On an ATmega328P (Arduino Uno, Nano) at 16 MHz: tiles through USART0 at 115200 baud, for ever, seed by seed. STOP: once,
// and then sleeps without interrupts, which ends a simulation.
// SPDX-License-Identifier: MIT
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>
#include "show.hpp"

static show::Memory memory;

static void put(char c) {
  while ((UCSR0A & (1 << UDRE0)) == 0) {
  }
  UDR0 = static_cast<uint8_t>(c);
}

extern "C" int main() {
  UCSR0A = 1 << U2X0;
  UBRR0 = 16;  // 16 MHz / 8 / 17 = 117647 baud
  UCSR0B = 1 << TXEN0;
#ifdef STOP
  show::all(memory, 1, put);
  while ((UCSR0A & (1 << UDRE0)) == 0) {
  }
  cli();
  sleep_enable();
  sleep_cpu();
#endif
  for (uint32_t seed = 1;; ++seed) show::all(memory, seed, put);
}
