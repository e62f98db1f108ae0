// The presets as text, packed by the compiler: a byte from 128 on stands for a phrase that comes again and again. 3.9 KB in
// place of 8.8. Any preset can be written so; one in words of its own only takes more bytes.
// SPDX-License-Identifier: MIT
#pragma once
#include "recipe/word.hpp"

namespace texts {

constexpr char kPhrases[] =
    " angle| around a centre| aspect| at one bit a cell| diffusion=isotropic| fi|"
    " field=scalar nodes=64 bend=1.3| gloss=0.| jitter| kill| levels=2 fine=8| light=| of | radius=|"
    " ramp=| range| range=-0.| ratio=1.5 scale=| react=da| react=md| rho=-0.0| rho=0| start=seeds pitch=|"
    " steps=| stretch=| that | the | threads| ways| window=6 scale=|, coarse to fine|,0.|.025|1.5|"
    "17.188734|=0.|=9.167325|@0..0.|_fast|a basket |bits|branch|coral|crossing|e directions|eave|flow|"
    "giraffe|gray-scott feed=0.0|haunch|labyrinth|mapped pairs=|"
    "mapped pairs=2 react=md map=radial detail=0.|nobody has named|rain|reptile|ripples|sand|spots|"
    "straw plaited |stripes|threshold pairs=|zebra";

// Of every preset name, sentence and recipe, each ended by a zero.
constexpr char kPlain[] =
#define DAPPLE_PRESET(name, sentence, text) #name "\0" sentence "\0" text "\0"
#include "recipe/presets.def"
#undef DAPPLE_PRESET
    ;
constexpr uint16_t kPlainBytes = sizeof kPlain - 1;

struct Packed {
  uint16_t bytes;
  uint8_t byte[kPlainBytes];
};

// The longest phrase at every place, or the character that is there.
constexpr Packed pack() {
  dapple::recipe::Word phrase[128] = {}, rest = dapple::recipe::word_of(kPhrases);
  uint8_t phrases = 0;
  for (; rest.length > 0; ++phrases) phrase[phrases] = take(rest, '|');
  Packed packed{};
  for (uint16_t place = 0; place < kPlainBytes;) {
    uint16_t longest = 1;
    uint8_t code = static_cast<uint8_t>(kPlain[place]);
    for (uint8_t i = 0; i < phrases; ++i) {
      const dapple::recipe::Word& p = phrase[i];
      if (p.length <= longest || kPlainBytes - place < p.length || p.text[0] != kPlain[place]) continue;
      if (!equal(p, {kPlain + place, p.length})) continue;
      longest = p.length;
      code = static_cast<uint8_t>(128 + i);
    }
    packed.byte[packed.bytes++] = code;
    place = static_cast<uint16_t>(place + longest);
  }
  return packed;
}

template <uint16_t n> struct Bytes {
  uint8_t byte[n];
};
template <uint16_t n> constexpr Bytes<n> first(const Packed& packed) {
  Bytes<n> bytes{};
  for (uint16_t i = 0; i < n; ++i) bytes.byte[i] = packed.byte[i];
  return bytes;
}
constexpr Packed kPacked = pack();
constexpr auto kBytes = first<kPacked.bytes>(kPacked);

// Writes text `index` with its zero to `out`; false: there are not as many.
inline bool unpack(int32_t index, char* out) {
  const uint8_t* from = kBytes.byte;
  const uint8_t* const end = from + sizeof kBytes;
  for (; index > 0 && from < end; ++from)
    if (*from == 0) --index;
  if (from == end) return false;
  for (; *from != 0; ++from) {
    const char* phrase = kPhrases;
    for (uint8_t skip = static_cast<uint8_t>(*from & 127); *from >= 128 && skip > 0; ++phrase)
      if (*phrase == '|') --skip;
    if (*from < 128) *out++ = static_cast<char>(*from);
    else
      for (; *phrase != 0 && *phrase != '|'; ++phrase) *out++ = *phrase;
  }
  *out = 0;
  return true;
}

}  // namespace texts
