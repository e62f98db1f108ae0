// Firmware for the board lm3s6965evb: the scenes of scenes.hpp on its panel, 25 frames a second, for ever. Started with
// the command line "stills" (QEMU: -semihosting-config arg=stills) it does not wait between frames, stops at one frame
// of every scene, says so, and goes on to the next when it is sent a character.
// SPDX-License-Identifier: MIT
#include "panel.hpp"
#include "scenes.hpp"

extern "C" {
void host_put(char c);
uint32_t host_call(uint32_t operation, uintptr_t argument);
uint32_t stack_used();
}

static uint8_t memory[oled::kBytes];
static oled::Show show;

// SysTick counts down at the clock of the core: 12.5 MHz in the emulated board after reset.
namespace systick {

struct Registers {
  volatile uint32_t control, reload, now;
};
static Registers& registers() { return *reinterpret_cast<Registers*>(0xe000e010u); }
static volatile uint32_t& pending() { return *reinterpret_cast<volatile uint32_t*>(0xe000ed04u); }
constexpr uint32_t kIsPending = UINT32_C(1) << 26, kClear = UINT32_C(1) << 25;

constexpr uint32_t kLongest = UINT32_C(1) << 24, kFrame = 12500000 / 25;

// The interrupt is masked: all it does is to end a wait.
static void begin(uint32_t period) {
  __asm volatile("cpsid i");
  registers().reload = period - 1;
  registers().now = 0;
  registers().control = 7;
}

static void wait() {
  while ((pending() & kIsPending) == 0) __asm volatile("wfi");
  pending() = kClear;
}

}  // namespace systick

static bool asked_for_stills() {
  char words[80];
  struct {
    char* text;
    uint32_t bytes;
  } room = {words, sizeof words};
  const uint32_t get_command_line = 0x15;
  if (host_call(get_command_line, reinterpret_cast<uintptr_t>(&room)) != 0) return false;
  const char wanted[] = "stills";
  uint8_t same = 0;
  while (same < sizeof wanted && words[same] == wanted[same]) ++same;
  return same == sizeof wanted;
}

static void put(const char* text) {
  while (*text != 0) host_put(*text++);
}

static void put(const char* text, uint32_t number) {
  char digit[11] = {};
  uint8_t at = 10;
  do digit[--at] = static_cast<char>('0' + number % 10);
  while ((number /= 10) > 0);
  put(text);
  put(digit + at);
}

// Ticks that a scene's frames took, for a period of kLongest.
struct Meter {
  uint32_t all = 0, most = 0, start = 0;

  void begin() { start = systick::registers().now; }
  void end() {
    const uint32_t ticks = (start - systick::registers().now) % systick::kLongest;
    all += ticks;
    most = ticks > most ? ticks : most;
  }
  void tell(const char* what, uint16_t frames) const {
    put(what, all / frames);
    put(" ticks a frame, at most ", most);
  }
};

static void draw() {
  panel::begin_frame();
  for (uint16_t y = 0; y < oled::kHeight; ++y) {
    uint8_t line[oled::kLineBytes];
    show.line(y, line);
    panel::send(line, sizeof line);
  }
}

static void wait_for_host(uint8_t scene, const Meter& growing, const Meter& drawing) {
  put("scene ", scene + 1u);
  growing.tell(" shown: growing ", show.still());
  drawing.tell("; drawing ", show.still());
  put("; stack ", stack_used());
  put("\n");
  const uint32_t read_character = 0x07;
  host_call(read_character, 0);
}

static void play(uint8_t scene, bool stills) {
  Meter growing, drawing;
  const uint16_t frames = stills ? show.still() : show.frames();
  for (uint16_t frame = 0; frame < frames; ++frame) {
    growing.begin();
    show.advance();
    growing.end();
    drawing.begin();
    draw();
    drawing.end();
    if (!stills) systick::wait();
  }
  if (stills) wait_for_host(scene, growing, drawing);
}

extern "C" int main() {
  const bool stills = asked_for_stills();
  panel::begin();
  systick::begin(stills ? systick::kLongest : systick::kFrame);
  for (uint8_t scene = 0; show.begin(scene, memory) == dapple::ok;) {
    play(scene, stills);
    scene = scene + 1 < oled::kScenes ? static_cast<uint8_t>(scene + 1) : 0;
  }
  put("scene refused\n");
  return 1;
}
