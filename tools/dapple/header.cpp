// Pictures as C headers: a constant array that compiles as it is, as C99 and as C++.
// SPDX-License-Identifier: MIT
#include <cctype>

#include "image.hpp"

namespace cli {

// Letters, digits and underscores of the name.
static std::string identifier(const std::string& name, bool upper) {
  std::string result;
  for (const char c : name) {
    const unsigned char letter = static_cast<unsigned char>(c);
    result += !std::isalnum(letter) ? '_' : upper ? static_cast<char>(std::toupper(letter)) : c;
  }
  return result;
}

static void write_bytes(Lines& lines, Output& out) {
  const char* const hex = "0123456789abcdef";
  uint64_t written = 0;
  for (uint32_t i = lines.count(); i > 0; --i) {
    const uint8_t* line = lines.next();
    for (size_t k = 0; k < lines.bytes(); ++k, ++written) {
      const char text[5] = {'0', 'x', hex[line[k] >> 4], hex[line[k] & 15], ','};
      out.write(written == 0 ? "  " : written % 20 == 0 ? "\n  " : " ");
      out.write(text, sizeof text);
    }
  }
}

void write_c(Lines& lines, Output& out) {
  const std::string name = identifier(lines.picture().name, false), upper = identifier(lines.picture().name, true);
  const std::string width = std::to_string(lines.width()), height = std::to_string(lines.height());
  const std::string bytes = std::to_string(lines.count() * uint64_t{lines.bytes()});
  out.write("/* " + lines.picture().name + ": " + width + " x " + height + " pixels, " + name_of(lines.pixels()) +
            ", " + std::to_string(lines.bytes()) + " bytes a " +
            (lines.count() == lines.height() ? "row" : "page of eight rows") + ".\n   " + lines.picture().note +
            " */\n");
  out.write("#ifndef DAPPLE_" + upper + "_H\n#define DAPPLE_" + upper + "_H\n\n#include <stdint.h>\n\n");
  out.write("#define " + upper + "_WIDTH " + width + "\n#define " + upper + "_HEIGHT " + height + "\n#define " + upper +
            "_FORMAT \"" + name_of(lines.pixels()) + "\"\n\n");
  out.write("#ifdef __GNUC__\n__attribute__((unused))\n#endif\nstatic const uint8_t " + name + "_pixels[" + bytes +
            "] = {\n");
  write_bytes(lines, out);
  out.write("\n};\n\n#endif\n");
}

}  // namespace cli
