// Named colour ramps: one line each. Stops are "rrggbb", evenly spread, or "at:rrggbb" with at = 0..255.
// SPDX-License-Identifier: MIT
#pragma once
#include "../paint/paint.hpp"
#include "word.hpp"

namespace dapple::recipe {

struct NamedRamp {
  const char *name, *stops;
};

inline constexpr NamedRamp ramps[] = {
    {"grey", "000000,ffffff"},
    {"reptile", "0:10180a,70:2f4416,150:6f8a34,215:b9c25c,255:e8e88c"},
    {"giraffe", "0:f3e2b4,96:efdcaa,124:c79a5a,150:8d5324,255:7a4117"},
    {"coral", "0:4a0a20,80:8c2440,150:d8606a,205:f2988c,255:ffdccb"},
    {"straw", "0:2e1c08,90:6b4616,170:b98a35,255:f4da92"},
    {"jade", "0:06201f,90:0d4a47,140:4fb59c,200:96dfc6,255:d8fff0"},
    {"denim", "0:0e1c3c,90:27437a,170:6f8db8,215:cfd3c4,255:f7edd4"},
    {"sand", "0:8a6232,110:c8985a,190:e4bd7e,255:f8e2b2"},
    {"hedge", "0:06240f,100:15552a,135:7fa982,165:e6e6d6,255:fbf8ee"},
    {"space", "0:05071e,100:0b1440,132:7fd0dc,165:4fbcd0,205:2fa5c0,228:b8ecf0,255:fdfbe8"},
    {"zebra", "0:0f0c0b,112:14110f,144:f4efe6,255:faf6ee"},
    {"plaster", "0:9c978a,128:d6d1c4,255:f2efe6"},
    {"wicker", "0:24130a,100:5d3a1e,170:b88650,255:f0d09c"},
    {"lichen", "0:1a2a1c,80:34563a,150:8fb06a,210:d8d68c,255:fff6cf"},
    {"ink", "0:f4efe4,90:e8e0d0,150:5b6a86,255:17213c"},
    {"ember", "0:120608,80:5a1210,150:c8441a,210:f6a338,255:fff2b8"},
    {"lagoon", "0:04263c,90:0c6a80,160:36b3a8,220:a9e6c6,255:f6fff0"},
    {"orchid", "0:1d0a2e,90:5a2378,160:b04fb0,220:eda0d0,255:fff0fa"},
    {"slate", "0:14202c,100:2c4254,150:7d96a6,200:b9c8cf,255:eef2ee"},
    {"leopard", "0:e8c98a,110:d9ab5f,150:6b3d1c,255:24130c"},
    {"finger", "0:f6f0e4,112:efe6d6,144:4a3a4c,255:2b2036"},
    {"plum", "0:140a2c,90:3a1f6e,170:8a63c4,255:e6d4ff"},
    {"tide", "0:06304a,112:0a4a68,144:f2e3c2,255:fbf3de"},
    {"sea", "0:041c24,90:0a4d56,170:37a39a,255:d6f7e6"},
    {"brain", "0:6e3238,90:a8585c,150:d88f8c,210:f0bdb4,255:ffe2d8"},
    {"ocean", "0:061c2e,90:0d4566,160:4d93b3,215:b5dae6,255:f4fcff"},
    {"violet", "0:1c1046,90:3d2785,170:8f74d6,255:eee2ff"},
    {"magenta", "0:22042c,90:5a1270,170:b448c4,255:ffd8fa"},
    {"rust", "0:340d06,90:6e2413,170:c07444,255:fbe6b4"},
    {"teal", "0:052a30,90:0a5a5c,170:45b8ac,255:e2fff2"},
    {"moss", "0:201a10,100:4a4a22,170:88963e,255:d9df94"},
};

constexpr bool read_stops(Word text, Ramp& ramp) {
  ramp = Ramp{};
  const bool placed = find(text, ':') < text.length;
  for (Word rest = text; rest.length > 0 || ramp.count == 0;) {
    if (ramp.count == kMaxStops) return false;
    Stop& stop = ramp.stop[ramp.count];
    Word item = take(rest, ',');
    uint32_t at = 0;
    if (placed && (!read_integer(take(item, ':'), at) || at > 255)) return false;
    if (placed && ramp.count > 0 && at <= ramp.stop[ramp.count - 1].at) return false;
    uint8_t rgb[3] = {};
    if (!read_colour(item, rgb)) return false;
    stop = {static_cast<uint8_t>(at), rgb[0], rgb[1], rgb[2]};
    ++ramp.count;
  }
  for (uint8_t i = 0; !placed && i < ramp.count && ramp.count > 1; ++i) ramp.stop[i].at = static_cast<uint8_t>(255 * i / (ramp.count - 1));
  return true;
}

// A name, or stops.
constexpr bool read_ramp(Word text, Ramp& ramp) {
  for (const NamedRamp& named : ramps)
    if (equal(text, named.name)) return read_stops(word_of(named.stops), ramp);
  return read_stops(text, ramp);
}

constexpr bool equal(const Ramp& a, const Ramp& b) {
  if (a.count != b.count) return false;
  for (uint8_t i = 0; i < a.count; ++i) {
    const Stop &s = a.stop[i], &t = b.stop[i];
    if (s.at != t.at || s.red != t.red || s.green != t.green || s.blue != t.blue) return false;
  }
  return true;
}

}  // namespace dapple::recipe
