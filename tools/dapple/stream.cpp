// dapple stream: a camera flies over the endless plane, in the terminal, two pixels a character; chunks grow as they
// come into sight. Piped, every frame waits for its chunks, and frames come out one below the other, always the same.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <cstring>

#include "base/math.hpp"
#include "chunks.hpp"
#include "commands.hpp"
#include "errors.hpp"
#include "recipes.hpp"
#include "terminal.hpp"

namespace cli {

namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr uint16_t kLargestView = 2048;        // pixels a side
constexpr uint8_t kMissing[3] = {52, 54, 58};  // colour of what is not there yet
constexpr uint32_t kSlice = 32;                // rows of work between two looks at the clock
constexpr uint32_t kPipedFrames = 60;
constexpr milliseconds kFrameTime(33), kGrowTime(22);

struct View {
  uint16_t width, height;  // pixels; the height is even

  bool operator!=(const View& other) const { return width != other.width || height != other.height; }
};

uint16_t even(int height) { return static_cast<uint16_t>((height + 1) / 2 * 2); }

// Flies at one speed, turning gently by itself or to where it is steered. The place is the view's left upper pixel.
class Camera {
 public:
  explicit Camera(Place start) : x_(int64_t{start.x} * kPart), y_(int64_t{start.y} * kPart) {}

  void steer(Key key) {
    steered_ = key != Key::space;
    wanted_ = key == Key::right ? 0 : key == Key::down ? 0x4000 : key == Key::left ? 0x8000 : 0xc000;
  }

  // One frame. At the edge of the plane it goes along it and turns away.
  void fly(View view) {
    ++frame_;
    const auto wave = [&](uint32_t pace) { return dapple::base::sine(static_cast<uint16_t>(pace * frame_)); };
    const int32_t turn = steered_ ? static_cast<int16_t>(static_cast<uint16_t>(wanted_ - heading_)) / 12
                                  : (wave(97) >> 8) + (wave(31) >> 10);
    heading_ = static_cast<uint16_t>(heading_ + turn);
    const bool across = move(x_, dapple::base::cosine(heading_), view.width);
    const bool down = move(y_, dapple::base::sine(heading_), view.height);
    if (!across || !down) heading_ = static_cast<uint16_t>(heading_ + 0x400);
  }

  Place place() const { return {static_cast<int32_t>(x_ >> 8), static_cast<int32_t>(y_ >> 8)}; }

 private:
  static constexpr int32_t kPart = 256, kSpeed = 400;  // of a pixel; parts a frame
  static constexpr int64_t kEdge = dapple::kFarthest - 2 * dapple::kWidestHalo;

  // direction: Q15. False at the edge.
  static bool move(int64_t& at, int32_t direction, uint16_t size) {
    const int64_t wanted = at + ((direction * kSpeed) >> 15);
    at = std::clamp(wanted, -kEdge * kPart, (kEdge - size) * kPart);
    return at == wanted;
  }

  int64_t x_, y_;  // 1/kPart pixel
  uint32_t frame_ = 0;
  uint16_t heading_ = 0, wanted_ = 0;  // 1/65536 turn, from x towards y (down)
  bool steered_ = false;
};

// The plane through a cache large enough for the view and as much again.
class World {
 public:
  World(const Subject& subject, uint32_t seed, uint8_t threads)
      : ready_(ready_of(subject.recipe)), recipe_(*ready_), seed_(seed), threads_(threads) {
    const uint32_t halo = dapple::need_for(recipe_, dapple::window(0, 0, kSides[0], kSides[0])).halo;
    for (const uint16_t side : kSides)
      if (side_ < halo) side_ = side;
    in_blocks_ = dapple::need_for(recipe_, dapple::window(0, 0, side_, side_)).block != 0;
  }

  // Before the first look, and when the view has another size. What there is goes when it is too little.
  void resize(View view) {
    pixels_.resize(size_t{3} * view.width * view.height);
    view_ = view;
    const uint32_t slots = 2 * dapple::chunks_in_view(side_, view.width, view.height) + 8;
    if (slots <= chunks_.slots()) return;
    brush_.format = dapple::Pixels::rgb888;
    const size_t bytes = dapple::chunk_bytes(recipe_, side_, static_cast<uint16_t>(slots), brush_.format);
    memory_.assign(bytes, 0);
    dapple::Options options;
    options.kernels = best_kernels();
    if (chunks_.begin(recipe_, seed_, side_, static_cast<uint16_t>(slots), brush_, memory_.data(), bytes, options) != dapple::ok)
      fail("the chunks of this recipe cannot be grown");
    grow_ = growers_of(chunks_, threads_);
  }

  // A slice of what is missing in sight: a chunk a thread, but on one thread, where windows are in blocks and take long,
  // rows of one. False: nothing is missing.
  bool grow_some() {
    return threads_ == 1 && in_blocks_ ? chunks_.step(kSlice) == dapple::more : grow_(threads_) > 0;
  }
  // All of it.
  void grow_all() {
    while (grow_(UINT32_MAX) > 0) {
    }
  }

  void look_at(Place place) {
    place_ = place;
    chunks_.look_at(place.x, place.y, view_.width, view_.height);
  }

  dapple::Chunks& chunks() { return chunks_; }

  // Lines of half blocks, `newline` behind each.
  std::string text(const std::string& newline) {
    for (size_t i = 0; i < pixels_.size(); ++i) pixels_[i] = kMissing[i % 3];
    const dapple::Sight& sight = chunks_.sight();
    for (int32_t cy = sight.top; cy <= sight.bottom; ++cy)
      for (int32_t cx = sight.left; cx <= sight.right; ++cx) copy_chunk(cx, cy);
    std::string out;
    const size_t row = size_t{3} * view_.width;
    for (size_t y = 0; y < view_.height; y += 2)
      out += half_blocks(&pixels_[y * row], &pixels_[(y + 1) * row], view_.width) + newline;
    return out;
  }

 private:
  static constexpr uint16_t kSides[] = {128, 256, 512};  // of chunks: the first that is as wide as the halo

  // The part of a chunk that is in the view.
  void copy_chunk(int32_t cx, int32_t cy) {
    const uint8_t* const chunk = chunks_.pixels(cx, cy);
    if (chunk == nullptr) return;
    const int32_t left = cx * side_ - place_.x, top = cy * side_ - place_.y;  // in the view
    const int32_t first = std::max(left, 0), end = std::min<int32_t>(left + side_, view_.width);
    if (end <= first) return;
    for (int32_t y = std::max(top, 0); y < std::min<int32_t>(top + side_, view_.height); ++y)
      std::memcpy(
          &pixels_[size_t{3} * (static_cast<size_t>(y) * view_.width + static_cast<size_t>(first))],
          chunk + static_cast<size_t>(y - top) * chunks_.line_bytes() + size_t{3} * static_cast<size_t>(first - left),
          size_t{3} * static_cast<size_t>(end - first));
  }

  std::shared_ptr<const dapple::Recipe> ready_;
  const dapple::Recipe& recipe_;
  uint32_t seed_;
  uint8_t threads_;
  uint16_t side_ = kSides[0];
  bool in_blocks_ = false;
  View view_{};
  Place place_{};
  dapple::Brush brush_;
  dapple::Chunks chunks_;
  std::function<uint32_t(uint32_t)> grow_;
  std::vector<uint8_t> memory_, pixels_;
};

// Chunks a second, over the last second.
class Rate {
 public:
  std::string text(uint32_t grown) {
    const auto now = steady_clock::now();
    const auto passed = std::chrono::duration_cast<milliseconds>(now - since_);
    if (passed >= milliseconds(1000)) {
      rate_ = std::to_string(uint64_t{1000} * (grown - before_) / static_cast<uint64_t>(passed.count()));
      before_ = grown;
      since_ = now;
    }
    return " (" + rate_ + "/s)";
  }

 private:
  steady_clock::time_point since_ = steady_clock::now();
  uint32_t before_ = 0;
  std::string rate_ = "-";
};

std::string caption(const Subject& subject, const dapple::Chunks& chunks, Place place, uint32_t frame, size_t columns,
                    const std::string& rate) {
  const dapple::ChunkCounters& c = chunks.counters();
  const std::string line = " " + subject.name + "  at " + place_text(place) + "  frame " + std::to_string(frame) +
                           "  grown " + std::to_string(c.grown) + rate + "  hits " + std::to_string(c.hits) + "/" +
                           std::to_string(c.hits + c.misses) + "  " + std::to_string(c.held) + " chunks " +
                           std::to_string(c.bytes / 1024) + " KB";
  return line.substr(0, columns);
}

View view_of(const Options& options, TerminalSize size) {
  const int width = options.width == 0 ? size.columns : std::min<int>(options.width, size.columns);
  const int height =
      options.height == 0 ? 2 * (size.rows - 1) : std::min<int>(even(options.height), 2 * (size.rows - 1));
  return {static_cast<uint16_t>(std::min<int>(width, kLargestView)),
          static_cast<uint16_t>(std::min<int>(height, kLargestView))};
}

// In the terminal: frames in place, in time, until q, a signal or the last frame.
void play(const Options& options, const Subject& subject, World& world, Camera& camera) {
  Screen screen;
  Rate rate;
  TerminalSize before{0, 0};
  View view{};
  for (uint32_t frame = 1; options.frames == 0 || frame <= options.frames; ++frame) {
    const auto start = steady_clock::now();
    const TerminalSize size = terminal_size();
    std::string out = "\x1b[H";
    if (screen.came_back() || size.columns != before.columns || size.rows != before.rows) out = "\x1b[2J\x1b[H";
    before = size;
    const View wanted = view_of(options, size);
    if (wanted != view) world.resize(view = wanted);
    camera.fly(view);
    world.look_at(camera.place());
    while (world.grow_some() && steady_clock::now() < start + kGrowTime) {
    }
    const size_t columns = static_cast<size_t>(size.columns);
    std::string line =
        caption(subject, world.chunks(), camera.place(), frame, columns, rate.text(world.chunks().counters().grown));
    line.resize(columns, ' ');
    if (!screen.write(out + world.text("\r\n") + line)) return;
    for (Key key; (key = screen.key(start + kFrameTime)) != Key::none; camera.steer(key))
      if (key == Key::quit) return;
  }
}

// Piped: one below the other, each complete.
void print(const Options& options, const Subject& subject, World& world, Camera& camera, View view) {
  world.resize(view);
  const uint32_t frames = options.frames == 0 ? kPipedFrames : options.frames;
  for (uint32_t frame = 1; frame <= frames; ++frame) {
    camera.fly(view);
    world.look_at(camera.place());
    world.grow_all();
    const std::string line = caption(subject, world.chunks(), camera.place(), frame, view.width, "");
    std::fputs((world.text("\n") + line + "\n").c_str(), stdout);
    finish_standard_output();
  }
}

}  // namespace

void stream(const Options& options) {
  const Subject subject = subject_of(options);
  if (options.width > kLargestView || options.height > kLargestView)
    refuse("--size " + size_text(options.width, options.height) + ": the view has at most " +
           size_text(kLargestView, kLargestView) + " pixels");
  View view = {80, 46};
  if (options.width != 0) view = {options.width, even(options.height)};
  const Place start = options.at.value_or(Place{0, 0});
  need_of(subject, dapple::window(start.x, start.y, view.width, view.height), 1);  // refuses what the plane is not for
  World world(subject, options.seed, options.bands);
  Camera camera(start);
  if (on_terminal()) play(options, subject, world, camera);
  else print(options, subject, world, camera, view);
}

}  // namespace cli
