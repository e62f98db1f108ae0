// Files that appear under their names only when they are complete.
// SPDX-License-Identifier: MIT
#include "output.hpp"

#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>

#include "errors.hpp"

namespace cli {

namespace files = std::filesystem;

// What to remove when a signal ends the program, files and the folder they are in; the folder has the first place.
constexpr size_t kMostUnfinished = 32;
static char unfinished[kMostUnfinished][4096];

static void remove_and_end(int signal) {
  for (size_t i = kMostUnfinished; i-- > 0;)
    if (unfinished[i][0] != 0 && unlink(unfinished[i]) != 0) rmdir(unfinished[i]);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

static void watch(const std::string& path) {
  size_t place = 0;
  while (place < kMostUnfinished && unfinished[place][0] != 0) ++place;
  if (place == kMostUnfinished || path.size() >= sizeof unfinished[0]) return;
  std::memcpy(unfinished[place], path.c_str(), path.size() + 1);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    if (std::signal(signal, remove_and_end) == SIG_IGN) std::signal(signal, SIG_IGN);
}

static void forget(const std::string& path) {
  for (char* const place : unfinished)
    if (path == place) place[0] = 0;
}

[[noreturn]] static void cannot_write(const std::string& path, const std::string& why) {
  fail("cannot write " + shown(path) + ": " + why);
}

Output::Output(const std::string& path) : path_(path) {
  if (path == "-") {
    file_ = stdout;
    return;
  }
  std::error_code error;
  const files::file_status status = files::status(path, error);
  if (!files::status_known(status)) cannot_write(path, error.message());
  if (files::is_directory(status)) cannot_write(path, "it is a directory");
  if (files::exists(status) && access(path.c_str(), W_OK) != 0) cannot_write(path, std::strerror(errno));
  if (files::exists(status) && !files::is_regular_file(status)) {  // a device or a pipe: nothing to rename
    file_ = std::fopen(path.c_str(), "wb");
    if (file_ == nullptr) cannot_write(path, std::strerror(errno));
    return;
  }
  if (files::exists(status)) path_ = files::canonical(path, error).string();  // write through a link, do not replace it
  open_beside(path);
}

// Opens a new file in the same folder, so that renaming it is one step.
void Output::open_beside(const std::string& path) {
  const std::string begin = (files::path(path_).parent_path() / ".dapple-").string() + std::to_string(getpid()) + "-";
  for (int attempt = 0; file_ == nullptr; ++attempt) {
    temporary_ = begin + std::to_string(attempt) + ".part";
    file_ = std::fopen(temporary_.c_str(), "wbx");
    if (file_ != nullptr || (errno == EEXIST && attempt < 100)) continue;
    temporary_.clear();
    cannot_write(path, std::strerror(errno));
  }
  watch(temporary_);
}

Output::~Output() {
  if (file_ != nullptr && file_ != stdout) std::fclose(file_);
  if (temporary_.empty()) return;
  std::remove(temporary_.c_str());
  forget(temporary_);
}

void Output::write(const void* bytes, size_t count) {
  if (error_ == 0 && std::fwrite(bytes, 1, count, file_) != count) error_ = errno;
}

void Output::close() {
  if (file_ == nullptr) return;
  if (std::fflush(file_) != 0 && error_ == 0) error_ = errno;
  if (file_ != stdout && std::fclose(file_) != 0 && error_ == 0) error_ = errno;
  file_ = nullptr;
  if (error_ != 0) cannot_write(path_ == "-" ? "standard output" : path_, std::strerror(error_));
}

void Output::finish() {
  close();
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) cannot_write(path_, std::strerror(errno));
  forget(temporary_);
  temporary_.clear();
}

Folder::Folder(const std::string& path) : path_(path) {
  std::error_code error;
  if (files::is_directory(path, error)) return;
  if (files::exists(path, error)) fail("cannot make the folder " + shown(path) + ": a file has that name");
  if (!files::create_directory(path, error)) fail("cannot make the folder " + shown(path) + ": " + error.message());
  made_ = true;
  watch(path_);
}

Folder::~Folder() {
  if (!made_) return;
  rmdir(path_.c_str());
  forget(path_);
}

std::string Folder::file(const std::string& name) const { return (files::path(path_) / name).string(); }

void Folder::keep() {
  if (made_) forget(path_);
  made_ = false;
}

void finish_standard_output() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout)) fail("cannot write standard output");
}

}  // namespace cli
