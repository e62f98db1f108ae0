// Seamless tiles scroll past in the terminal, two pixels a character. While one preset is shown, the next grows a few rows
// of work a frame, as it would in a game; then it moves in from the right. Piped, the same frames come out one below
// the other, always the same bytes.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "dapple.hpp"
#include "recipe/list.hpp"
#include "terminal.hpp"

namespace {

constexpr uint16_t kTile = 96;   // cells; more where a preset needs it
constexpr int kSoftEdge = 12;    // columns over which two presets blend
constexpr int kFrameTime = 33;   // ms

struct Options {
  terminal::Size size{80, 24};
  int frames = 60;
  int shown = 20;                // frames a preset is shown, crossing over included
  uint32_t seed = 1337;
  bool hash = false, live = false, help = false, sized = false;
};

// A tile on its way: grown in slices, painted as it stands.
class Tile {
 public:
  Tile(uint16_t index, uint32_t seed) {
    char text[dapple::kMaxName];
    const dapple::PresetEntry entry = dapple::preset_at(index, text);
    name = text;
    sentence = entry.sentence;
    const dapple::Need least = dapple::need_for(*entry.preset, dapple::torus(kTile, kTile));
    const dapple::Domain domain = dapple::torus(side(least.width, least.multiple), side(least.height, least.multiple));
    memory_.resize(dapple::bytes_for(*entry.preset, domain));
    good = texture_.begin(*entry.preset, domain, seed, memory_.data(), memory_.size()) == dapple::ok;
    if (good) pixels_.resize(static_cast<size_t>(domain.width) * domain.height * 3);
  }
  Tile(const Tile&) = delete;
  Tile& operator=(const Tile&) = delete;

  // The part of the work that spreads all of it over `frames` frames.
  uint32_t slice(int frames) const { return static_cast<uint32_t>(texture_.rows_in_all() / static_cast<unsigned>(frames) + 1); }
  void grow(uint32_t rows) { complete_ = texture_.step(rows) == dapple::done; }
  int percent() const {
    return complete_ ? 100 : static_cast<int>(texture_.rows_done() * UINT64_C(100) / std::max<uint64_t>(texture_.rows_in_all(), 1));
  }

  // Brings the pixels up to where the texture stands.
  void paint() {
    if (painted_) return;
    const dapple::Domain& d = texture_.domain();
    for (uint16_t y = 0; y < d.height; ++y) texture_.paint(y, dapple::Pixels::rgb888, &pixels_[size_t{3} * y * d.width]);
    painted_ = complete_;
  }
  const uint8_t* at(int x, int y) const {
    const dapple::Domain& d = texture_.domain();
    return &pixels_[size_t{3} * (static_cast<size_t>(y % d.height) * d.width + static_cast<size_t>(x % d.width))];
  }

  std::string name, sentence;
  bool good = false;

 private:
  static uint16_t side(uint16_t least, uint16_t multiple) {
    const unsigned wanted = std::max<unsigned>(least, kTile);
    return static_cast<uint16_t>((wanted + multiple - 1) / multiple * multiple);
  }

  dapple::Texture texture_;
  std::vector<uint8_t> memory_, pixels_;
  bool complete_ = false, painted_ = false;
};

// Two tiles and where they are: frame by frame the picture moves one column left, and down a row every third frame.
class Strip {
 public:
  explicit Strip(const Options& options) : options_(options), crossing_(options.shown / 3) {
    now_ = std::make_unique<Tile>(0, options.seed);
    follow();
  }

  bool good() const { return now_->good && next_->good; }

  // Works for one frame: the first tile is seen growing, every later one is ready when its time comes.
  void advance() {
    ++frame_;
    if (++phase_ == options_.shown) {
      now_ = std::move(next_);
      follow();
      phase_ = 0;
    }
    const int frames = options_.shown - crossing_;
    now_->grow(now_->slice(std::max(frames / 2, 1)));
    next_->grow(next_->slice(std::max(frames - 1, 1)));
    now_->paint();
    if (phase_ >= frames) next_->paint();
  }

  // The picture as text of columns x rows characters; the last row tells what is seen.
  std::string text(terminal::Size size) const {
    std::string out;
    for (int row = 0; row + 1 < size.rows; ++row) {
      Pen pen;
      for (int x = 0; x < size.columns; ++x) {
        uint8_t upper[3], lower[3];
        pixel(x, 2 * row, size.columns, upper);
        pixel(x, 2 * row + 1, size.columns, lower);
        pen.half_block(upper, lower, out);
      }
      out += "\x1b[0m\n";
    }
    return out + caption(size.columns);
  }

 private:
  // Colours as the terminal has them, so that equal ones are not sent again.
  struct Pen {
    uint8_t fore[3], back[3];
    bool set = false;

    void half_block(const uint8_t* upper, const uint8_t* lower, std::string& out) {
      if (!set || std::memcmp(fore, upper, 3) != 0) colour(38, upper, out);
      if (!set || std::memcmp(back, lower, 3) != 0) colour(48, lower, out);
      std::memcpy(fore, upper, 3);
      std::memcpy(back, lower, 3);
      set = true;
      out += "\u2580";
    }
    static void colour(int what, const uint8_t* rgb, std::string& out) {
      char code[32];
      std::snprintf(code, sizeof code, "\x1b[%d;2;%d;%d;%dm", what, rgb[0], rgb[1], rgb[2]);
      out += code;
    }
  };

  void follow() {
    index_ = static_cast<uint16_t>((index_ + 1) % dapple::preset_count());
    next_ = std::make_unique<Tile>(index_, options_.seed);
  }

  // Share of the next tile in column x, 0..256: its edge moves in from the right.
  int share(int x, int columns) const {
    const int since = phase_ - (options_.shown - crossing_);
    if (since < 0) return 0;
    const int edge = columns - (columns + kSoftEdge) * (since + 1) / (crossing_ + 1);
    return std::clamp((x - edge) * 256 / kSoftEdge, 0, 256);
  }

  void pixel(int x, int y, int columns, uint8_t* rgb) const {
    const int weight = share(x, columns), across = x + frame_, down = y + frame_ / 3;
    const uint8_t* const a = now_->at(across, down);
    const uint8_t* const b = weight > 0 ? next_->at(across, down) : a;
    for (int i = 0; i < 3; ++i) rgb[i] = static_cast<uint8_t>((a[i] * (256 - weight) + b[i] * weight + 128) >> 8);
  }

  std::string caption(int columns) const {
    char progress[64];
    std::snprintf(progress, sizeof progress, "   next: %s %d %%", next_->name.c_str(), next_->percent());
    std::string line = " " + now_->name + ": " + now_->sentence;
    const size_t width = static_cast<size_t>(columns), room = width - std::min(width, std::strlen(progress) + 1);
    line.resize(room, ' ');
    return (line + progress + " ").substr(0, width);
  }

  Options options_;
  int crossing_, frame_ = 0, phase_ = -1;
  uint16_t index_ = 0;
  std::unique_ptr<Tile> now_, next_;
};

// In the terminal: frames in place, in time, until a key or the last one.
void play(const Options& options, Strip& strip) {
  const terminal::Screen screen;
  terminal::Size before{0, 0};
  auto time = std::chrono::steady_clock::now();
  for (int frame = 0; frame < options.frames && !terminal::asked_to_stop(); ++frame) {
    strip.advance();
    const terminal::Size size = options.sized ? options.size : terminal::size();
    const bool resized = size.columns != before.columns || size.rows != before.rows;
    before = size;
    if (!terminal::write_all((resized ? "\x1b[2J\x1b[H" : "\x1b[H") + strip.text(size))) return;
    time = std::max(time + std::chrono::milliseconds(kFrameTime), std::chrono::steady_clock::now());
    std::this_thread::sleep_until(time);
  }
}

// Piped: one below the other.
int print(const Options& options, Strip& strip) {
  uint64_t hash = UINT64_C(0xcbf29ce484222325);
  for (int frame = 0; frame < options.frames; ++frame) {
    strip.advance();
    const std::string text = strip.text(options.size) + "\n";
    for (const char c : text) hash = (hash ^ static_cast<uint8_t>(c)) * UINT64_C(0x100000001b3);
    if (!options.hash && !terminal::write_all(text)) return 1;
  }
  if (options.hash) std::printf("%016" PRIx64 "\n", hash);
  return 0;
}

constexpr char kUsage[] =
    "usage: dapple_stream [--frames N] [--size COLUMNSxROWS] [--seed N] [--hash]\n"
    "Seamless tiles scroll by in the terminal; any key ends it. Piped, 60 frames of 80x24 come out.\n"
    "  --hash   print the FNV-1a hash of the piped frames instead of them\n";

bool number(const char* text, const char* until, long low, long high, long& value) {
  char* end = nullptr;
  value = std::strtol(text, &end, 10);
  return end == until && end != text && value >= low && value <= high;
}

bool size_of(const char* text, terminal::Size& size) {
  const char* const x = std::strchr(text, 'x');
  long columns = 0, rows = 0;
  if (x == nullptr || !number(text, x, 8, 1000, columns) || !number(x + 1, text + std::strlen(text), 2, 1000, rows)) return false;
  size = {static_cast<int>(columns), static_cast<int>(rows)};
  return true;
}

// Null, or the word that is wrong.
const char* read(int count, char** words, Options& options) {
  long frames = 0, seed = 0;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    const char* const value = i + 1 < count ? words[i + 1] : "";
    const char* const end = value + std::strlen(value);
    if (word == "--help") options.help = true;
    else if (word == "--hash") options.hash = true;
    else if (word == "--frames" && number(value, end, 1, 1000000, frames)) ++i;
    else if (word == "--seed" && number(value, end, 0, INT32_MAX, seed)) options.seed = static_cast<uint32_t>(seed), ++i;
    else if (word == "--size" && size_of(value, options.size)) options.sized = true, ++i;
    else return words[i];
  }
  options.live = terminal::there() && !options.hash;
  if (options.live) options.shown = 120;
  if (frames > 0) options.frames = static_cast<int>(frames);
  else if (options.live) options.frames = options.shown * dapple::preset_count();
  return nullptr;
}

}  // namespace

int main(int count, char** words) {
  Options options;
  if (const char* const wrong = read(count, words, options)) {
    std::fprintf(stderr, "dapple_stream: cannot use '%s'\n%s", wrong, kUsage);
    return 2;
  }
  if (options.help) return std::fputs(kUsage, stdout) < 0;
  Strip strip(options);
  if (!strip.good()) {
    std::fprintf(stderr, "dapple_stream: a preset cannot be grown\n");
    return 1;
  }
  if (!options.live) return print(options, strip);
  play(options, strip);
}
