// Where a picture goes: standard output, or a file that appears under its name only when it is complete. Several files in a
// folder: close all of them, and finish them when all are closed.
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

  // Everything is written; fails when something was not.
  void close();
  // The file is complete: closes it, if that is not done, and gives it its name.
  void finish();

 private:
  void open_beside(const std::string& path);

  std::string path_, temporary_;  // temporary_ is empty where nothing has to be renamed
  std::FILE* file_ = nullptr;
  int error_ = 0;  // errno of the first failed write
};

// A folder for files, made if it is not there; one that was made goes again unless it is kept.
class Folder {
 public:
  explicit Folder(const std::string& path);
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string file(const std::string& name) const;
  void keep();

 private:
  std::string path_;
  bool made_ = false;
};

// Ends a command that printed to standard output; fails when the text did not get out.
void finish_standard_output();

}  // namespace cli
