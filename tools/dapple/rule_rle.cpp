// Patterns as run-length text.
// SPDX-License-Identifier: MIT
#include "rule_rle.hpp"

#include <algorithm>

namespace cli {

namespace {

constexpr uint32_t kMost = UINT16_MAX;  // cells of a pattern's side

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

class Reader {
 public:
  Reader(const std::string& text, Pattern& pattern, RleTrouble& trouble)
      : text_(text), pattern_(pattern), trouble_(trouble) {}

  bool read() { return header() && cells(); }

 private:
  char here() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool at_end() const { return at_ == text_.size(); }
  bool fail(size_t at, const std::string& reason) {
    trouble_ = {line_, static_cast<uint32_t>(at - line_begin_ + 1), reason};
    return false;
  }
  void skip_blanks() {
    while (is_blank(here())) ++at_;
  }
  void next_line() {
    at_ = std::min(text_.find('\n', at_), text_.size() - 1) + 1;
    line_begin_ = at_;
    ++line_;
  }

  // At the start of a line: the remarks, and the lines that hold nothing.
  void skip_remarks() {
    for (;;) {
      const size_t begin = at_;
      if (here() != '#') skip_blanks();
      if (at_end() || (here() != '#' && here() != '\n')) {
        at_ = begin;
        return;
      }
      next_line();
    }
  }

  bool number(uint32_t& value) {
    const size_t begin = at_;
    value = 0;
    for (; is_digit(here()); ++at_) {
      value = value * 10 + static_cast<uint32_t>(here() - '0');
      if (value > kMost) return fail(begin, "the number is above " + std::to_string(kMost));
    }
    return true;
  }

  // "x = 12"
  bool side(char name, uint32_t& value) {
    skip_blanks();
    if (here() != name) return fail(at_, "the header, x = WIDTH, y = HEIGHT, rule = RULE, is expected");
    ++at_;
    skip_blanks();
    if (here() != '=') return fail(at_, "= is expected");
    ++at_;
    skip_blanks();
    if (!is_digit(here())) return fail(at_, "a number is expected");
    return number(value);
  }

  bool header() {
    skip_remarks();
    if (at_end()) return fail(at_, "the header, x = WIDTH, y = HEIGHT, rule = RULE, is missing");
    if (!side('x', pattern_.width)) return false;
    skip_blanks();
    if (here() != ',') return fail(at_, ", is expected");
    ++at_;
    if (!side('y', pattern_.height)) return false;
    skip_blanks();
    if (here() == ',') {
      ++at_;
      skip_blanks();
      if (text_.compare(at_, 4, "rule") != 0) return fail(at_, "rule = RULE is expected");
      at_ += 4;
      skip_blanks();
      if (here() != '=') return fail(at_, "= is expected");
      ++at_;
      skip_blanks();
      const size_t begin = at_;
      while (!at_end() && here() != '\n' && !is_blank(here())) ++at_;
      pattern_.rule = text_.substr(begin, at_ - begin);
      skip_blanks();
    }
    if (!at_end() && here() != '\n') return fail(at_, "the end of the header is expected");
    if (!at_end()) next_line();
    return true;
  }

  bool item(char c, size_t begin, uint32_t count) {
    const bool on = c == 'o' || c == 'A', off = c == 'b' || c == '.';
    uint32_t& coordinate = c == '$' ? y_ : x_;
    if (!on && !off && c != '$')
      return fail(at_, (c >= 'A' && c <= 'X') || (c >= 'p' && c <= 'y') ? "there are more than two states"
                                                                        : "b, o, $, ! or a number is expected");
    if (count > kMost - coordinate) return fail(begin, "the pattern has a side above " + std::to_string(kMost));
    if (on && count > 0) {
      pattern_.runs.push_back({x_, y_, count});
      pattern_.width = std::max(pattern_.width, x_ + count);
      pattern_.height = std::max(pattern_.height, y_ + 1);
    }
    coordinate += count;
    if (c == '$') x_ = 0;
    return true;
  }

  bool cells() {
    skip_remarks();
    while (here() != '!' || at_end()) {
      if (at_end()) return fail(at_, "the pattern ends without !");
      if (here() == '\n') {
        next_line();
        skip_remarks();
        continue;
      }
      if (is_blank(here())) {
        ++at_;
        continue;
      }
      const size_t begin = at_;
      uint32_t count = 1;
      if (is_digit(here()) && !number(count)) return false;
      if (begin != at_ && (at_end() || here() == '!')) return fail(begin, "a number stands before nothing");
      if (!item(here(), begin, count)) return false;
      ++at_;
    }
    if (pattern_.width == 0 || pattern_.height == 0) pattern_.width = pattern_.height = 0;
    return true;
  }

  const std::string& text_;
  Pattern& pattern_;
  RleTrouble& trouble_;
  size_t at_ = 0, line_begin_ = 0;
  uint32_t line_ = 1, x_ = 0, y_ = 0;
};

// Items of a pattern, in lines.
class Writer {
 public:
  void put(uint32_t count, char c) {
    const std::string item = (count > 1 ? std::to_string(count) : "") + c;
    if (line_.size() + item.size() > 70) {
      text_ += line_ + "\n";
      line_.clear();
    }
    line_ += item;
  }
  std::string finish() {
    put(1, '!');
    return text_ + line_ + "\n";
  }

 private:
  std::string text_, line_;
};

}  // namespace

bool read_rle(const std::string& text, Pattern& pattern, RleTrouble& trouble) {
  pattern = {};
  return Reader(text, pattern, trouble).read();
}

void place(const Pattern& pattern, Torus& torus) {
  const uint32_t left = (torus.width() - pattern.width) / 2, top = (torus.height() - pattern.height) / 2;
  for (const Run& run : pattern.runs)
    for (uint32_t i = 0; i < run.count; ++i)
      torus.set(static_cast<uint16_t>(left + run.x + i), static_cast<uint16_t>(top + run.y), true);
}

std::string write_rle(const Torus& torus, const std::string& rule, const std::string& remark) {
  Writer writer;
  uint32_t ended = 0;  // rows that wait for their $
  for (uint16_t y = 0; y < torus.height(); ++y, ++ended) {
    uint32_t count = 0;
    bool on = false;
    const auto put_run = [&](char c) {
      if (count == 0) return;
      if (ended > 0) writer.put(ended, '$');
      ended = 0;
      writer.put(count, c);
    };
    for (uint16_t x = 0; x < torus.width(); ++x, ++count) {
      if (torus.get(x, y) == on) continue;
      put_run(on ? 'o' : 'b');
      on = !on;
      count = 0;
    }
    if (on) put_run('o');
  }
  return "#C " + remark + "\nx = " + std::to_string(torus.width()) + ", y = " + std::to_string(torus.height()) +
         ", rule = " + rule + "\n" + writer.finish();
}

}  // namespace cli
