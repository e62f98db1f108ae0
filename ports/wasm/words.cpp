// Why a recipe or a size is refused, in words. See words.hpp.
// SPDX-License-Identifier: MIT
#include "words.hpp"

namespace wasm {

using dapple::Need;
using dapple::Trouble;
using dapple::recipe::Family;
using dapple::recipe::Word;
using dapple::recipe::word_of;

Text& Text::operator<<(char c) {
  if (length_ + 1 >= size_) return *this;
  text_[length_++] = c;
  text_[length_] = 0;
  return *this;
}

Text& Text::operator<<(const char* text) {
  while (*text != 0) *this << *text++;
  return *this;
}

Text& Text::operator<<(Word word) {
  for (uint16_t i = 0; i < word.length; ++i) *this << word.text[i];
  return *this;
}

Text& Text::operator<<(int32_t number) {
  char digits[10];
  uint8_t n = 0;
  uint32_t value = number < 0 ? 0u - static_cast<uint32_t>(number) : static_cast<uint32_t>(number);
  if (number < 0) *this << '-';
  do {
    digits[n++] = static_cast<char>('0' + value % 10);
    value /= 10;
  } while (value != 0);
  while (n > 0) *this << digits[--n];
  return *this;
}

Text& Text::decimal(int32_t micro) {
  const uint32_t one = static_cast<uint32_t>(dapple::base::kMicro);
  const uint32_t value = micro < 0 ? 0u - static_cast<uint32_t>(micro) : static_cast<uint32_t>(micro);
  if (micro < 0) *this << '-';
  *this << static_cast<int32_t>(value / one);
  uint32_t rest = value % one;
  if (rest != 0) *this << '.';
  for (uint32_t place = one / 10; rest != 0; place /= 10) {
    *this << static_cast<char>('0' + rest / place);
    rest %= place;
  }
  return *this;
}

Text& Text::shown(Word word) {
  constexpr uint16_t kLongest = 60;
  *this << "'";
  for (uint16_t i = 0; i < word.length && i < kLongest; ++i) {
    const char c = word.text[i];
    *this << (static_cast<unsigned char>(c) < 32 || c == 127 ? '?' : c);
  }
  return *this << (word.length > kLongest ? "...'" : "'");
}

static void tell_families(Text& out) {
  const char* comma = "";
  for (const Family& family : dapple::recipe::families) {
    out << comma << family.name;
    comma = ", ";
  }
}

static void tell_keys(Text& out, const Family& family) {
  for (uint8_t i = 0; i < family.number_count; ++i) {
    out << family.numbers[i].name << ", ";
    if (family.numbers[i].kind == dapple::Number::angles) out << "angles, ";
  }
  out << "wavelength, steps, level, levels, fine, solver, start, pitch, aspect, jitter, radius, amplitude, ramp, range, "
         "light, gloss, grain";
}

static void tell_broken(Text& out, const char* whole, const Trouble& trouble) {
  const Word word = trouble.word;
  const bool at_start = trouble.column == 1 || whole[trouble.column - 2] == ' ';
  if (at_start) out.shown(word) << " is not key=value";
  else if (word.length == 0) out << "a value is missing";
  else if (dapple::recipe::find(word, ',') < word.length) out.shown(word) << " has too many numbers";
  else out.shown(word) << " is not a number; numbers are decimal, with at most six digits after the point";
}

static void tell_unknown(Text& out, const Trouble& trouble) {
  if (trouble.column == 1 && trouble.allowed == nullptr) {
    if (trouble.word.length == 0) out << "the recipe is empty";
    else out << "no family is called ", out.shown(trouble.word);
    out << "; a recipe begins with ";
    return tell_families(out);
  }
  const char* allowed = trouble.allowed != nullptr ? trouble.allowed : "carry|refine";
  for (const Family& family : dapple::recipe::families)
    if (dapple::recipe::equal(word_of(allowed), family.name)) {
      out.shown(trouble.word) << " is not a key of " << family.name << "; there is ";
      return tell_keys(out, family);
    }
  out.shown(trouble.word) << " is not one of ";
  for (; *allowed != 0; ++allowed) {
    if (*allowed == '|') out << ", ";
    else out << *allowed;
  }
}

static void tell_outside(Text& out, const char* whole, const Trouble& trouble) {
  const auto number = [&](int32_t value) -> Text& { return trouble.whole ? out << value : out.decimal(value); };
  if (trouble.word.length == dapple::recipe::length_of(whole)) out << "the wavelength";
  else out.shown(trouble.word);
  out << " is out of range, ";
  number(trouble.low) << " to ";
  number(trouble.high);
}

// Which words exclude each other follows from the word that was met.
static void tell_impossible(Text& out, const Trouble& trouble) {
  if (dapple::recipe::equal(trouble.word, "carry")) out << "a recipe has at most " << dapple::kMaxStages << " stages";
  else if (dapple::recipe::equal(trouble.word, "refine"))
    out << "'then refine' needs a stage of level 1 to 3 before it, and there are at most " << dapple::kMaxStages << " stages";
  else out << "fine=F needs levels=L, and the steps must be more than F (L - 1)";
}

void tell_trouble(Text& out, const char* whole, const Trouble& trouble) {
  switch (trouble.status) {
    case dapple::broken_text: return tell_broken(out, whole, trouble);
    case dapple::unknown_word: return tell_unknown(out, trouble);
    case dapple::out_of_range: return tell_outside(out, whole, trouble);
    default: return tell_impossible(out, trouble);
  }
}

static int32_t rounded_up(const Need& need, uint16_t side) {
  return (side + need.multiple - 1) / need.multiple * need.multiple;
}

void tell_need(Text& out, const Need& need, const dapple::Domain& domain) {
  switch (need.status) {
    case dapple::bad_side:
      out << "a side has at least " << dapple::kSmallestSide << " cells";
      return;
    case dapple::not_a_multiple:
      out << "the sides must be multiples of " << need.multiple;
      return;
    case dapple::tile_too_small:
      out << domain.width << " x " << domain.height << " is too small: this recipe needs at least "
          << rounded_up(need, need.width) << " x " << rounded_up(need, need.height);
      return;
    case dapple::too_large: out << "more memory than there are addresses"; return;
    case dapple::too_little_memory: out << "not enough memory"; return;
    case dapple::too_far: out << "the plane ends here"; return;
    case dapple::halo_too_wide:
      out << "not for the endless plane: it would have to grow " << static_cast<int32_t>(need.halo)
          << " cells more on every side, and " << dapple::kWidestHalo << " are the most; a repeated tile needs none";
      return;
    case dapple::bad_map: out << "map=image and solver=styled need images, which cannot be given here"; return;
    default: out << "the stages of the recipe do not fit each other; the last one must have level=0, after 'then refine'";
  }
}

}  // namespace wasm
