// See panel.hpp. Registers: the LM3S6965's data sheet (system control, GPIO, SSI); commands: the SSD0323's.
// SPDX-License-Identifier: MIT
#include "panel.hpp"

namespace panel {

static uint32_t read(uint32_t address) { return *reinterpret_cast<volatile uint32_t*>(address); }
static void write(uint32_t address, uint32_t word) { *reinterpret_cast<volatile uint32_t*>(address) = word; }
static void set(uint32_t address, uint32_t bits) { write(address, read(address) | bits); }

constexpr uint32_t kSystem = 0x400fe000, kSsi = 0x40008000, kPortA = 0x40004000, kPortC = 0x40006000;
constexpr uint32_t kPeripherals = 0x104, kPorts = 0x108;                      // clocks of system control
constexpr uint32_t kDirection = 0x400, kAlternate = 0x420, kDigital = 0x51c;  // of a GPIO port
constexpr uint32_t kControl0 = 0x00, kControl1 = 0x04, kData = 0x08, kStatus = 0x0c, kPrescale = 0x10;  // of SSI
constexpr uint32_t kBusy = 1u << 4, kReceived = 1u << 2;
constexpr uint32_t kSsiPins = 1u << 2 | 1u << 3 | 1u << 5;  // of port A: clock, frame, out
constexpr uint32_t kDataPin = 1u << 7;                      // of port C: high for data, low for commands

enum Command : uint8_t { columns = 0x15, rows = 0x75, normal_display = 0xa4, display_on = 0xaf };

// What comes back is thrown away: a full receive queue would stop the transfer.
static void send_byte(uint8_t byte) {
  write(kSsi + kData, byte);
  while ((read(kSsi + kStatus) & kBusy) != 0) {
  }
  while ((read(kSsi + kStatus) & kReceived) != 0) read(kSsi + kData);
}

// The address of a port's data is a mask too: only the pins of bits 2..9 are written.
static void choose(uint32_t level) { write(kPortC + (kDataPin << 2), level); }

void send(const uint8_t* bytes, uint16_t count) {
  for (uint16_t i = 0; i < count; ++i) send_byte(bytes[i]);
}

static void command(const uint8_t* bytes, uint16_t count) {
  choose(0);
  send(bytes, count);
  choose(kDataPin);
}

void begin() {
  set(kSystem + kPeripherals, 1u << 4);      // SSI0
  set(kSystem + kPorts, 1u << 0 | 1u << 2);  // ports A and C
  read(kSystem + kPorts);                    // a port takes three cycles to wake
  set(kPortA + kAlternate, kSsiPins);
  set(kPortA + kDigital, kSsiPins);
  set(kPortC + kDirection, kDataPin);
  set(kPortC + kDigital, kDataPin);
  write(kSsi + kControl1, 0);  // off while it is set up
  write(kSsi + kPrescale, 2);
  write(kSsi + kControl0, 7);  // eight bits
  write(kSsi + kControl1, 2);  // on, as the master
  const uint8_t awake[] = {normal_display, display_on};
  command(awake, sizeof awake);
}

void begin_frame() {
  const uint8_t whole[] = {columns, 0, 63, rows, 0, 63};
  command(whole, sizeof whole);
}

}  // namespace panel
