// Where a picture goes: standard output, or a file that appears under its name only when it is complete.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>

namespace cli {

class Output {
 public:
  // "-" is standard output. Fails here, before any work, when the file cannot be written.
  explicit Output(const std::string& path);
  ~Output();  // removes what is not complete
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  // A failure is kept and reported by finish.
  void write(const void* bytes, size_t count);
  void write(const std::string& text) { write(text.data(), text.size()); }
  void put(uint8_t byte) { write(&byte, 1); }

  // The file is complete: gives it its name.
  void finish();

 private:
  void open_beside(const std::string& path);

  std::string path_, temporary_;  // temporary_ is empty where nothing has to be renamed
  std::FILE* file_ = nullptr;
  char* watched_ = nullptr;  // names the temporary file to whoever removes it at a signal
  int error_ = 0;  // errno of the first failed write
};

// Ends a command that printed to standard output; fails when the text did not get out.
void finish_standard_output();

}  // namespace cli
