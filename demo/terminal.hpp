// A POSIX terminal as a canvas: size, keys, interruption, and everything put back at the end.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace terminal {

struct Size {
  int columns, rows;
};

// Standard output is a terminal.
bool there();
Size size();

// While it lives: the alternate screen without cursor, keys without echo, signals that ask to stop.
class Screen {
 public:
  Screen();
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;
};

// A key was pressed, or a signal asks to stop.
bool asked_to_stop();

// All of it, to standard output; false when nobody reads any more.
bool write_all(const std::string& bytes);

}  // namespace terminal
