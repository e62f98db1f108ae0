// One texture of the family bits on one torus, with every number known to the compiler: for the smallest machines. A 64 x 64
// tile on a microcontroller with 2 KB of RAM, in a few KB of flash. The same bytes as a frugal Texture of the same preset.
//
//   static dapple::Tile<dapple::presets::zebra_bits, 64, 64> tile;   // all of its memory
//   tile.begin(7);
//   while (tile.step(8) == dapple::more) watchdog();
//   for (uint16_t y = 0; y < 64; ++y) { uint8_t line[128]; tile.paint<dapple::Pixels::rgb565_swapped>(y, line); panel(line); }
//
// Serves presets of one stage, at full or half resolution, of up to five masks by M-D or two by D-A. Colours have no light.
// SPDX-License-Identifier: MIT
#pragma once
#include "dapple.hpp"
#include "evolve/enlarge.hpp"
#include "stencil/straight.hpp"

namespace dapple::tile {

constexpr stencil::KnownMasks masks_of(const int32_t* number, uint16_t rows) {
  stencil::MaskShape shapes[stencil::kMaxMasks] = {};
  stencil::Mask masks[stencil::kMaxMasks] = {};
  const uint8_t count = evolve::shapes_of(number, shapes);
  const bool summed = evolve::summed(number);
  for (uint8_t j = 0; j < (summed ? 1 : count); ++j)
    if (!stencil::make_mask(shapes + j, summed ? count : 1, masks[j])) return {};
  return stencil::known_masks(masks, summed ? static_cast<uint8_t>(1) : count, rows);
}

constexpr bool serves(const Recipe& recipe, const Domain& domain) {
  const Stage& stage = recipe.stage[0];
  return need_for(recipe, domain).status == ok && recipe.stages == 1 && stage.model == &bits_model && stage.level <= 1 &&
         (stage.number[bits::react] == stencil::max_difference || evolve::summed(stage.number) || stage.number[bits::masks] == 1);
}

// round(rho P) of every step.
constexpr uint8_t kMostSteps = 64;
struct Thresholds {
  int8_t step[kMostSteps];
};
constexpr Thresholds thresholds_of(const Stage& stage, int16_t sum) {
  Thresholds result{};
  for (uint32_t i = 0; i < stage.steps && i < kMostSteps; ++i)
    result.step[i] = static_cast<int8_t>(stencil::threshold_of(scheduled(stage.number + bits::rho, {i, stage.steps}), sum));
  return result;
}

// The largest word of at most the machine's 32 bits that `cells` are a whole number of.
template <uint8_t bytes> struct WordOf { using Word = uint8_t; };
template <> struct WordOf<2> { using Word = uint16_t; };
template <> struct WordOf<4> { using Word = uint32_t; };
constexpr uint8_t word_bytes(uint16_t cells) {
  const uint8_t most = sizeof(base::Word) > 4 ? 4 : sizeof(base::Word);
  uint8_t bytes = most;
  while (cells % (8u * bytes) != 0) bytes = static_cast<uint8_t>(bytes / 2);
  return bytes;
}

// The place of a field's value in the range of a ramp, 0..4080: floor(over * 4080 / span) without a division, 1 <= span < 2^15.
// 2^shift >= 8 span, so the first guess is too small by one at most.
constexpr uint8_t place_shift(uint16_t span) {
  uint8_t shift = 0;
  while ((UINT64_C(4080) << (shift + 1)) / span < 65536) ++shift;
  return shift;
}
template <int16_t low, uint16_t span> inline int16_t place(int16_t value) {
  constexpr uint8_t shift = place_shift(span);
  constexpr uint16_t factor = static_cast<uint16_t>((UINT64_C(4080) << shift) / span);
  static_assert(span < 32768 && (UINT32_C(1) << shift) >= UINT32_C(8) * span, "the guess is too small by more than one");
  const int32_t wide = static_cast<int32_t>(value) - low;
  const uint16_t over = static_cast<uint16_t>(wide < 0 ? 0 : wide > span ? span : wide);
  const uint16_t at = static_cast<uint16_t>((static_cast<uint32_t>(over) * factor) >> shift);
  const uint16_t rest = static_cast<uint16_t>(4080u * over - static_cast<uint32_t>(at) * span);  // < 2 span
  return static_cast<int16_t>(rest >= span ? at + 1 : at);
}

struct Ramps {
  paint::Stretch stretch[kMaxStops];
};
constexpr Ramps ramps_of(const paint::Shader& shader) {
  Ramps result{};
  for (uint8_t i = 0; i < shader.stops; ++i) result.stretch[i] = shader.stretch[i];
  return result;
}

template <const Preset& preset> constexpr paint::Shader shader = paint::shader_of(preset.recipe.paint, Brush{}, bits::kUnit, 0, 0);
template <const Preset& preset, uint16_t rows>
constexpr stencil::KnownMasks masks = masks_of(preset.recipe.stage[0].number, rows);
template <const Preset& preset, int16_t sum> constexpr Thresholds thresholds DAPPLE_ROM = thresholds_of(preset.recipe.stage[0], sum);
template <const Preset& preset> constexpr Ramps ramps DAPPLE_ROM = ramps_of(shader<preset>);

// The stretch of the ramp that pixels are in: read from read-only memory when it changes.
template <const Preset& preset> struct OnRamp {
  paint::Stretch now;
  uint8_t index;
  int16_t end;  // where the next one begins

  static constexpr int16_t kNone = INT16_MAX;
  void look(uint8_t i) {
    index = i;
    now = base::rom_load(ramps<preset>.stretch + i);
    end = i + 1 < shader<preset>.stops ? base::rom_load(&ramps<preset>.stretch[i + 1].at) : kNone;
  }
  void colour(int16_t at_q4, uint8_t* rgb) {
    const int16_t at = at_q4 >> 4;
    while (index > 0 && at < now.at) look(static_cast<uint8_t>(index - 1));
    while (at >= end) look(static_cast<uint8_t>(index + 1));
    paint::stretch_colour(now, at_q4, rgb);
  }
};

}  // namespace dapple::tile

namespace dapple {

// Chosen: the unsigned type of up to 32 bits that cells are packed in, of which a row of the grid is a whole number.
template <const Preset& preset, uint16_t width, uint16_t height,
          class Chosen = typename tile::WordOf<tile::word_bytes(width >> preset.recipe.stage[0].level)>::Word>
class Tile {
  static constexpr Stage kStage = preset.recipe.stage[0];
  static constexpr uint8_t kLevel = kStage.level;
  static constexpr uint16_t kWide = width >> kLevel, kHigh = height >> kLevel;  // of the grid
  static_assert(tile::serves(preset.recipe, torus(width, height)), "Tile does not serve this preset, or not at this size");
  static_assert(kWide % 8 == 0 && kHigh < 16384 && kWide <= 255 * 8, "the grid's rows are whole bytes, at most 255 of them");
  static_assert(kStage.steps <= tile::kMostSteps, "too many steps");

  using Word = Chosen;
  static constexpr const stencil::KnownMasks& kMasks = tile::masks<preset, kHigh>;
  static constexpr uint8_t kBits = 8 * sizeof(Word), kWords = kWide / kBits, kRadius = kMasks.radius;
  static constexpr uint8_t kWindow = stencil::window_rows_of(kMasks), kBefore = kMasks.running ? kRadius + 1 : kRadius;
  static constexpr uint8_t kRing = kBefore + 1;
  static constexpr int16_t kWarm = kMasks.running ? 2 * kRadius + 1 : 0;  // rows before D is that of whole windows
  static_assert(kWide % kBits == 0, "the grid's rows are not whole words");
  static_assert(kHigh > 2 * kRadius + 2, "the grid has fewer rows than a window");

 public:
  // Readies the texture; grows nothing yet.
  void begin(uint32_t seed) {
    seed_ = seed;
    step_ = kStart;
    y_ = 0;
    for (Word& bits : blank_) bits = 0;
  }

  // Up to `rows` rows of work: more, or done. Whatever the slicing, the same bytes.
  Status step(uint16_t rows) {
    for (; rows > 0 && step_ != kDone; --rows) one_row();
    return step_ == kDone ? done : more;
  }
  void finish() { while (step(UINT16_MAX) == more) {} }

  // Row y of the field of a finished texture: `width` values within +-unit().
  void row(uint16_t y, int16_t* out) {
    each_value(y, [](void* to, uint16_t x, int16_t value) { static_cast<int16_t*>(to)[x] = value; }, out);
  }
  static constexpr int16_t unit() { return bits::kUnit; }

  // Row y of a finished texture as pixels: pixel_bytes(format, width) bytes.
  template <Pixels format> void paint(uint16_t y, void* out) {
    Painter painter;
    painter.out = static_cast<uint8_t*>(out);
    painter.y = y;
    painter.key = base::row_key(seed_, paint::kGrainStream, y);
    painter.ramp.look(0);
    each_value(y, [](void* to, uint16_t x, int16_t value) {
      Painter& p = *static_cast<Painter*>(to);
      uint8_t rgb[3];
      colour(p, x, value, rgb);
      paint::put_pixel(format, x, p.y, rgb, false, 0, p.out);
    }, &painter);
  }

 private:
  // A row being painted.
  struct Painter {
    uint8_t* out;
    uint16_t y;
    base::RowKey key;
    tile::OnRamp<preset> ramp;
  };
  DAPPLE_APART static void colour(Painter& p, uint16_t x, int16_t value, uint8_t* rgb) {
    constexpr const paint::Shader& shader = tile::shader<preset>;
    p.ramp.colour(tile::place<shader.low, shader.span>(value), rgb);
    if constexpr (shader.grain != 0) paint::grain(shader.grain, p.key, x, rgb);
  }

  static constexpr uint8_t kStart = 254, kDone = 255;
  static constexpr int16_t kNone = INT16_MAX;

  // y of the next row: of the start, or of a sweep, where rows before 0 warm up.
  void one_row() {
    if (step_ == kStart) {
      start_row();
      if (++y_ == static_cast<int16_t>(kHigh)) next_sweep(0);
      return;
    }
    if (y_ >= 0) keep(y_);
    differences(y_, nullptr);
    if (++y_ == static_cast<int16_t>(kHigh)) next_sweep(static_cast<uint8_t>(step_ + 1));
  }

  void next_sweep(uint8_t step) {
    step_ = step == kStage.steps ? static_cast<uint8_t>(kDone) : step;
    for (int16_t& held : held_) held = kNone;
    warm_up(0);
  }

  // Forgets D; the row to begin with, so that D is whole from row y on.
  void warm_up(int16_t y) {
    y_ = static_cast<int16_t>(y - kWarm);
    lowest_ = static_cast<int16_t>(y - kBefore);
    if constexpr (kMasks.running)
      for (Word& bits : sums_) bits = 0;
  }

  void start_row() {
    Word* const row = cells_ + static_cast<size_t>(y_) * kWords;
    if constexpr (preset.recipe.start.kind == Start::noise) {
      const base::RowKey key = base::row_key(seed_, 0, y_);
      for (uint16_t x = 0; x < kWide; x = static_cast<uint16_t>(x + 32)) {
        uint32_t bits = base::hash(key, x >> 5);
        for (uint16_t i = x / kBits; i < kWords && i < (x + 32) / kBits; ++i) {
          row[i] = static_cast<Word>(bits);
          if constexpr (kBits < 32) bits >>= kBits;
        }
      }
    } else {
      uint8_t bytes[(kWide + 31) / 32 * 4];
      constexpr Start start = preset.recipe.start;
      start::seeds_row({grid::Cell::bit, kWide, kHigh, kLevel, 0, 0, false, seed_}, start, {0, 1, 0, 1}, 0, static_cast<uint16_t>(y_), bytes);
      for (uint8_t i = 0; i < kWords; ++i) row[i] = base::load_word<Word>(bytes + i * sizeof(Word));
    }
  }

  // Copies an old row before it is overwritten: the newest kRing rows, and the first kRadius for the end of the sweep.
  void keep(int16_t y) {
    const Word* const row = cells_ + static_cast<size_t>(y) * kWords;
    for (uint8_t i = 0; i < kWords; ++i) {
      swept_.ring[y % kRing * kWords + i] = row[i];
      if (y < kRadius) swept_.first[y * kWords + i] = row[i];
    }
  }

  // Old row i of the grid, or blank before the first that counts.
  const Word* old_row(int16_t i) const {
    if (i < lowest_) return blank_;
    if (step_ != kDone) {
      if (i >= static_cast<int16_t>(kHigh)) return swept_.first + (i - kHigh) * kWords;
      if (i >= 0 && i <= y_) return swept_.ring + i % kRing * kWords;
    }
    if (i < 0) i = static_cast<int16_t>(i + kHigh);
    if (i >= static_cast<int16_t>(kHigh)) i = static_cast<int16_t>(i - kHigh);
    return cells_ + static_cast<size_t>(i) * kWords;
  }

  // D of one word: of the only mask, or in most[] the largest of them.
  template <uint8_t mask> const Word* difference(const stencil::WordPlace<Word>& place, Word* most) {
    Word own[stencil::kDifferenceBits];
    Word* d = mask == 0 ? most : own;
    if constexpr (kMasks.running) d = sums_ + (mask * kWords + place.at) * stencil::kDifferenceBits;
    stencil::known_difference<kMasks, mask>(place, d);
    if constexpr (kMasks.count == 1) return kMasks.running ? sums_ + place.at * stencil::kDifferenceBits : most;
    if constexpr (mask > 0) stencil::take_larger(d, most);
    else if constexpr (kMasks.running) for (uint8_t i = 0; i < stencil::kDifferenceBits; ++i) most[i] = d[i];
    if constexpr (mask + 1 < kMasks.count) difference<mask + 1>(place, most);
    return most;
  }

  // D of row y. In a sweep the new cells replace the old ones; of a finished texture `field`, if given, is what it shows.
  void differences(int16_t y, int16_t* field) {
    const Word* rows[kWindow];
    for (uint8_t k = 0; k < kWindow; ++k) rows[k] = old_row(static_cast<int16_t>(y - kBefore + k));
    for (uint8_t at = 0; at < kWords; ++at) {
      const uint8_t before = static_cast<uint8_t>(at == 0 ? kWords - 1 : at - 1), after = static_cast<uint8_t>(at + 1 == kWords ? 0 : at + 1);
      Word most[stencil::kDifferenceBits];
      const Word* const d = difference<0>({rows, at, before, after}, most);
      if (field != nullptr)
        field_word(d, field + at * kBits);
      else if (step_ != kDone && y >= 0)
        cells_[static_cast<size_t>(y) * kWords + at] =
            stencil::above(d, base::rom_load(&tile::thresholds<preset, kMasks.sum>.step[step_]));
    }
  }

  // --- the field of a finished texture ---------------------------------------------------------------------------------

  static void field_word(const Word* difference, int16_t* out) {
    Word d[stencil::kDifferenceBits];
    for (uint8_t b = 0; b < stencil::kDifferenceBits; ++b) d[b] = difference[b];
    constexpr stencil::FieldScale scale = stencil::field_scale(kMasks.sum);
    for (uint8_t i = 0; i < kBits; ++i) {
      uint8_t value = 0;
      for (uint8_t b = stencil::kDifferenceBits; b > 0; --b) {
        value = static_cast<uint8_t>((value << 1) | (d[b - 1] & 1));
        d[b - 1] = static_cast<Word>(d[b - 1] >> 1);
      }
      out[i] = stencil::field_value(scale, static_cast<int8_t>(value));
    }
  }

  // The field's row y of the grid, -1 to kHigh, with a halo of one. Those that follow each other downwards are the cheapest.
  const int16_t* field_row(int16_t y) {
    const uint8_t slot = y & (kHeld - 1);
    int16_t* const row = field_ + slot * (kWide + 2) + 1;
    if (held_[slot] == y) return row;
    if (!kMasks.running || y_ != y) warm_up(y);
    for (; y_ < y; ++y_) differences(y_, nullptr);
    differences(y_++, row);
    held_[slot] = y;
    row[-1] = row[kWide - 1];
    row[kWide] = row[0];
    return row;
  }

  // put(to, x, value) for the values of a row of the picture.
  DAPPLE_APART void each_value(uint16_t y, void (*put)(void* to, uint16_t x, int16_t value), void* to) {
    if (step_ != kDone) return;
    const int16_t at = static_cast<int16_t>(y >> kLevel);
    if constexpr (kLevel == 0) {
      const int16_t* const row = field_row(at);
      for (uint16_t x = 0; x < width; ++x) put(to, x, row[x]);
    } else {
      const int16_t upper = static_cast<int16_t>(at - (1 - (y & 1)));
      const int16_t *const above = field_row(upper), *const below = field_row(static_cast<int16_t>(upper + 1));
      const bool lower = (y & 1) == 0;
      evolve::enlarged(lower ? below : above, lower ? above : below, 0, width, [&](uint16_t x, int16_t value) { put(to, x, value); });
    }
  }

  static constexpr uint8_t kHeld = kLevel == 0 ? 1 : 2;  // rows of the field at hand
  struct Swept {
    Word ring[kRing * kWords], first[kRadius * kWords];
  };

  uint32_t seed_;
  int16_t y_;        // the row that comes next
  int16_t lowest_;   // rows before it count as blank
  int16_t held_[kHeld];
  uint8_t step_;
  Word blank_[kWords];
  Word sums_[kMasks.running ? kMasks.count * kWords * stencil::kDifferenceBits : 1];  // D of the row before
  Word cells_[static_cast<size_t>(kHigh) * kWords];
  union {
    Swept swept_;                        // while it grows
    int16_t field_[kHeld * (kWide + 2)]; // when it is done
  };
};

}  // namespace dapple
