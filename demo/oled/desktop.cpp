// The scenes of the OLED show on the desktop: the frame that stands for each as FOLDER/scene-N.ppm, as the emulator's
// window shows the panel: every pixel four times as wide and high, grey n as 17 n. Says how many greys each has.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <string>
#include <vector>

#include "scenes.hpp"

namespace {

constexpr int kLarger = 4;

// The greys of a frame, one a pixel.
std::vector<uint8_t> greys_of(const oled::Show& show) {
  std::vector<uint8_t> greys;
  for (uint16_t y = 0; y < oled::kHeight; ++y) {
    uint8_t line[oled::kLineBytes];
    show.line(y, line);
    for (const uint8_t two : line)
      greys.insert(greys.end(), {static_cast<uint8_t>(two >> 4), static_cast<uint8_t>(two & 15)});
  }
  return greys;
}

bool write_picture(const std::string& path, const std::vector<uint8_t>& greys) {
  std::string text =
      "P6\n" + std::to_string(kLarger * oled::kWidth) + " " + std::to_string(kLarger * oled::kHeight) + "\n255\n";
  for (int y = 0; y < kLarger * oled::kHeight; ++y)
    for (int x = 0; x < kLarger * oled::kWidth; ++x) {
      const size_t pixel = static_cast<size_t>(y / kLarger) * oled::kWidth + static_cast<size_t>(x / kLarger);
      text.append(3, static_cast<char>(17 * greys[pixel]));
    }
  std::FILE* const file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) return false;
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  const bool closed = std::fclose(file) == 0;
  if (!written || !closed) std::remove(path.c_str());
  return written && closed;
}

int count_of_kinds(const std::vector<uint8_t>& greys) {
  bool seen[16] = {};
  int kinds = 0;
  for (const uint8_t grey : greys) kinds += !seen[grey], seen[grey] = true;
  return kinds;
}

}  // namespace

int main(int count, char** words) {
  if (count != 2 || words[1][0] == '-') {
    std::fprintf(stderr,
                 "usage: dapple_oled FOLDER\n"
                 "Writes a frame of every scene of demo/oled as FOLDER/scene-N.ppm.\n");
    return count == 2 && std::string(words[1]) == "--help" ? 0 : 2;
  }
  std::vector<uint8_t> memory(oled::kBytes);
  oled::Show show;
  for (uint8_t scene = 0; scene < oled::kScenes; ++scene) {
    const std::string path = std::string(words[1]) + "/scene-" + std::to_string(scene + 1) + ".ppm";
    if (show.begin(scene, memory.data()) != dapple::ok) {
      std::fprintf(stderr, "dapple_oled: scene %d is refused\n", scene + 1);
      return 1;
    }
    for (uint16_t frame = 0; frame < show.still(); ++frame) show.advance();
    const std::vector<uint8_t> greys = greys_of(show);
    if (!write_picture(path, greys)) {
      std::fprintf(stderr, "dapple_oled: cannot write %s\n", path.c_str());
      return 1;
    }
    std::printf("scene %d: %d greys\n", scene + 1, count_of_kinds(greys));
  }
}
