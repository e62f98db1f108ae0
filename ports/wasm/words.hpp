// What the module says in words: why a recipe or a size is refused. No library of strings here, so text is put together
// in a buffer of fixed length.
// SPDX-License-Identifier: MIT
#pragma once
#include "dapple.hpp"
#include "recipe/list.hpp"

namespace wasm {

// Text being put together; what does not fit is left out.
class Text {
 public:
  Text(char* text, size_t size) : text_(text), size_(size) { text_[0] = 0; }

  Text& operator<<(char c);
  Text& operator<<(const char* text);
  Text& operator<<(dapple::recipe::Word word);
  Text& operator<<(int32_t number);

  // 1/kMicro as a decimal number.
  Text& decimal(int32_t micro);
  // As it was given, between quotation marks, shortened.
  Text& shown(dapple::recipe::Word word);
  uint32_t length() const { return static_cast<uint32_t>(length_); }

 private:
  char* text_;
  size_t size_, length_ = 0;
};

// Why parse refused `whole`.
void tell_trouble(Text& out, const char* whole, const dapple::Trouble& trouble);

// Why begin refuses what `need` is of.
void tell_need(Text& out, const dapple::Need& need, const dapple::Domain& domain);

}  // namespace wasm
