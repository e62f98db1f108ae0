// The panel of the board lm3s6965evb: an SSD0323 of 128 x 64 pixels and 16 greys on SSI0; PC7 tells data from commands.
// SPDX-License-Identifier: MIT
#pragma once
#include <stdint.h>

namespace panel {

void begin();

// A frame: begin_frame, then its rows from the top down, in pieces of any length: two pixels a byte, the left one in
// the high nibble.
void begin_frame();
void send(const uint8_t* bytes, uint16_t count);

}  // namespace panel
