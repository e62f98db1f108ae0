// A POSIX terminal as a canvas. See terminal.hpp.
// SPDX-License-Identifier: MIT
#include "terminal.hpp"

#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

namespace cli {

using std::chrono::steady_clock;

namespace {

constexpr int kEndings[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};

volatile std::sig_atomic_t asked_to_end = 0, asked_to_pause = 0;
termios line_before;  // how the terminal takes lines, to be put back

void end_soon(int) { asked_to_end = 1; }
void pause_soon(int) { asked_to_pause = 1; }

// Without SA_RESTART, so that waiting and writing stop.
void handle(int number, void (*handler)(int), int flags = 0) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigemptyset(&action.sa_mask);
  sigaction(number, &action, nullptr);
}

void append_colour(std::string& out, const char* what, const uint8_t* rgb) {
  out += what;
  for (int i = 0; i < 3; ++i) out += std::to_string(rgb[i]) + (i < 2 ? ";" : "m");
}

}  // namespace

bool on_terminal() { return isatty(STDOUT_FILENO) == 1; }

TerminalSize terminal_size() {
  winsize window{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) != 0 || window.ws_col == 0 || window.ws_row == 0) return {80, 24};
  return {window.ws_col, window.ws_row};
}

// A second signal ends the program at once, should a stopped terminal take no bytes.
Screen::Screen() {
  asked_to_end = asked_to_pause = 0;
  for (const int number : kEndings) handle(number, end_soon, static_cast<int>(SA_RESETHAND));
  handle(SIGTSTP, pause_soon);
  enter();
}

Screen::~Screen() {
  leave();
  for (const int number : kEndings) handle(number, SIG_DFL);
  handle(SIGTSTP, SIG_DFL);
}

void Screen::enter() {
  has_keys_ = tcgetattr(STDIN_FILENO, &line_before) == 0;
  if (has_keys_) {
    termios quiet = line_before;
    quiet.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    quiet.c_cc[VMIN] = 1;
    quiet.c_cc[VTIME] = 0;
    has_keys_ = tcsetattr(STDIN_FILENO, TCSANOW, &quiet) == 0;
  }
  write("\x1b[?1049h\x1b[?25l\x1b[2J");
}

void Screen::leave() {
  const std::string restore = "\x1b[0m\x1b[?25h\x1b[?1049l";
  for (size_t at = 0; at < restore.size();) {
    const ssize_t written = ::write(STDOUT_FILENO, restore.data() + at, restore.size() - at);
    if (written > 0) at += static_cast<size_t>(written);
    else if (errno != EINTR) break;
  }
  if (!has_keys_) return;
  tcflush(STDIN_FILENO, TCIFLUSH);
  tcsetattr(STDIN_FILENO, TCSANOW, &line_before);
}

// Stops here until somebody sends SIGCONT.
void Screen::suspend() {
  asked_to_pause = 0;
  leave();
  handle(SIGTSTP, SIG_DFL);
  std::raise(SIGTSTP);
  handle(SIGTSTP, pause_soon);
  enter();
  came_back_ = true;
}

bool Screen::came_back() {
  const bool back = came_back_;
  came_back_ = false;
  return back;
}

bool Screen::write(const std::string& bytes) {
  for (size_t at = 0; at < bytes.size();) {
    const ssize_t written = ::write(STDOUT_FILENO, bytes.data() + at, bytes.size() - at);
    if (written > 0) at += static_cast<size_t>(written);
    else if (errno != EINTR || asked_to_end) return false;
  }
  return true;
}

// What the keyboard holds; at its end there is nobody left to press a key.
void Screen::read_keys() {
  char bytes[64];
  const ssize_t count = read(STDIN_FILENO, bytes, sizeof bytes);
  if (count > 0) unread_.append(bytes, static_cast<size_t>(count));
  else if (count == 0 || errno != EINTR) asked_to_end = 1;
}

// Arrows come as ESC [ A or ESC O A, up, down, right, left; they are read whole.
Key Screen::take_key() {
  constexpr Key kArrows[] = {Key::up, Key::down, Key::right, Key::left};
  while (!unread_.empty()) {
    const bool sequence = unread_.size() >= 3 && unread_[0] == '\x1b' && (unread_[1] == '[' || unread_[1] == 'O');
    const char c = unread_[sequence ? 2 : 0];
    unread_.erase(0, sequence ? 3 : 1);
    if (sequence && c >= 'A' && c <= 'D') return kArrows[c - 'A'];
    if (sequence) continue;
    if (c == 'q' || c == 'Q') return Key::quit;
    if (c == ' ') return Key::space;
    constexpr char kLetters[] = "hjkl";
    if (const char* const letter = std::strchr(kLetters, c); letter != nullptr && c != 0)
      return static_cast<Key>(static_cast<int>(Key::left) + static_cast<int>(letter - kLetters));
  }
  return Key::none;
}

Key Screen::key(steady_clock::time_point until) {
  while (true) {
    if (asked_to_pause) suspend();
    if (asked_to_end) return Key::quit;
    const Key found = take_key();
    if (found != Key::none) return found;
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - steady_clock::now());
    pollfd keys{has_keys_ ? STDIN_FILENO : -1, POLLIN, 0};
    const int ready = poll(&keys, 1, left.count() > 0 ? static_cast<int>(left.count()) : 0);
    if (ready > 0) read_keys();
    else if (ready == 0) return Key::none;
  }
}

std::string half_blocks(const uint8_t* upper, const uint8_t* lower, int count) {
  std::string out;
  for (int i = 0; i < count; ++i, upper += 3, lower += 3) {
    if (i == 0 || std::memcmp(upper, upper - 3, 3) != 0) append_colour(out, "\x1b[38;2;", upper);
    if (i == 0 || std::memcmp(lower, lower - 3, 3) != 0) append_colour(out, "\x1b[48;2;", lower);
    out += "\u2580";
  }
  return out + "\x1b[0m";
}

}  // namespace cli
