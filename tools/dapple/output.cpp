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

// The files to remove when a signal ends the program; empty for none.
static char unfinished[2][4096];

static void remove_and_end(int signal) {
  for (const char* path : unfinished)
    if (path[0] != 0) unlink(path);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

// The slot that watches it; null for a name too long.
static char* watch(const std::string& path) {
  char* const free = unfinished[unfinished[0][0] != 0 ? 1 : 0];
  if (path.size() >= sizeof unfinished[0]) return nullptr;
  std::memcpy(free, path.c_str(), path.size() + 1);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    if (std::signal(signal, remove_and_end) == SIG_IGN) std::signal(signal, SIG_IGN);
  return free;
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
  watched_ = watch(temporary_);
}

Output::~Output() {
  if (file_ != nullptr && file_ != stdout) std::fclose(file_);
  if (!temporary_.empty()) std::remove(temporary_.c_str());
  if (watched_ != nullptr) watched_[0] = 0;
}

void Output::write(const void* bytes, size_t count) {
  if (error_ == 0 && std::fwrite(bytes, 1, count, file_) != count) error_ = errno;
}

void Output::finish() {
  if (std::fflush(file_) != 0 && error_ == 0) error_ = errno;
  if (file_ != stdout && std::fclose(file_) != 0 && error_ == 0) error_ = errno;
  file_ = nullptr;
  if (error_ != 0) cannot_write(path_ == "-" ? "standard output" : path_, std::strerror(error_));
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) cannot_write(path_, std::strerror(errno));
  temporary_.clear();
}

void finish_standard_output() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout)) fail("cannot write standard output");
}

}  // namespace cli
