// SPDX-License-Identifier: MIT
#include "terminal.hpp"

#include <poll.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>

namespace terminal {

namespace {

volatile sig_atomic_t signalled = 0;
termios keys_before;
bool keys_changed = false;

void stop_soon(int) { signalled = 1; }

}  // namespace

bool there() { return isatty(STDOUT_FILENO) == 1; }

Size size() {
  winsize window{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) != 0 || window.ws_col == 0 || window.ws_row == 0) return {80, 24};
  return {window.ws_col, window.ws_row};
}

Screen::Screen() {
  struct sigaction action {};
  action.sa_handler = stop_soon;
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) sigaction(number, &action, nullptr);
  if (tcgetattr(STDIN_FILENO, &keys_before) == 0) {
    termios quiet = keys_before;
    quiet.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    keys_changed = tcsetattr(STDIN_FILENO, TCSANOW, &quiet) == 0;
  }
  write_all("\x1b[?1049h\x1b[?25l\x1b[2J");
}

Screen::~Screen() {
  write_all("\x1b[0m\x1b[?25h\x1b[?1049l");
  if (keys_changed) tcsetattr(STDIN_FILENO, TCSAFLUSH, &keys_before);
}

bool asked_to_stop() {
  pollfd keys{STDIN_FILENO, POLLIN, 0};
  return signalled != 0 || (keys_changed && poll(&keys, 1, 0) > 0);
}

bool write_all(const std::string& bytes) {
  for (size_t at = 0; at < bytes.size();) {
    const ssize_t written = write(STDOUT_FILENO, bytes.data() + at, bytes.size() - at);
    if (written > 0) at += static_cast<size_t>(written);
    else if (errno != EINTR) return false;
  }
  return true;
}

}  // namespace terminal
