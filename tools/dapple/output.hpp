// Where a picture goes: standard output, or a file that appears under its name only when it is complete, alone or as one
// of several that appear together.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace cli {

// A folder, made if it is not there, and gone again unless it is kept.
class Folder {
 public:
  explicit Folder(const std::string& path);
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  void keep();
  std::string file(const std::string& name) const;

 private:
  std::string path_;
  bool made_ = false;
};

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

  // Gives several complete files their names, all of them or none.
  static void finish_all(const std::vector<std::unique_ptr<Output>>& all);

 private:
  void open_beside(const std::string& path);
  void close();
  int name();
  void forget();

  static void remove_and_end(int signal);
  static Output* unfinished_;  // the files to remove when a signal ends the program

  std::string path_, temporary_;  // temporary_ is empty where nothing has to be renamed
  std::FILE* file_ = nullptr;
  int error_ = 0;  // errno of the first failed write
  Output* next_ = nullptr;  // of the unfinished ones
};

// Ends a command that printed to standard output; fails when the text did not get out.
void finish_standard_output();

}  // namespace cli
