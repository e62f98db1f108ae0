// A POSIX terminal as a canvas: its size, its keys, what stops it, and everything put back at the end.
// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <cstdint>
#include <string>

namespace cli {

struct TerminalSize {
  int columns, rows;
};

// Standard output is a terminal.
bool on_terminal();
TerminalSize terminal_size();

enum class Key { none, quit, left, down, up, right, space };

// While it lives: the alternate screen without cursor, keys without echo. Only one at a time.
class Screen {
 public:
  Screen();
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  // The next key there is, waiting for one until `until`; quit too when a signal asks to end. Others are passed over.
  Key key(std::chrono::steady_clock::time_point until);

  // All of the bytes; false when the terminal is gone or a signal asks to end.
  bool write(const std::string& bytes);

  // Once after the program was suspended and went on: the screen is empty.
  bool came_back();

 private:
  void enter();
  void leave();
  void suspend();
  void read_keys();
  Key take_key();

  std::string unread_;
  bool has_keys_ = false, came_back_ = false;
};

// A line of characters, two pixels each: rows of `count` rgb pixels as upper and lower half blocks, colours reset
// behind.
std::string half_blocks(const uint8_t* upper, const uint8_t* lower, int count);

}  // namespace cli
