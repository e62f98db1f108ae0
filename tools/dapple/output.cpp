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

Output* Output::unfinished_ = nullptr;

// The folder to remove when a signal ends the program; null for none.
static const char* unfinished_folder = nullptr;

void Output::remove_and_end(int signal) {
  for (const Output* one = unfinished_; one != nullptr; one = one->next_) unlink(one->temporary_.c_str());
  if (unfinished_folder != nullptr) rmdir(unfinished_folder);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

[[noreturn]] static void cannot_write(const std::string& path, const std::string& why) {
  fail("cannot write " + shown(path) + ": " + why);
}

Folder::Folder(const std::string& path) : path_(path) {
  std::error_code error;
  if (files::is_directory(path, error)) return;
  if (files::exists(path, error)) fail("cannot make the folder " + shown(path) + ": a file has that name");
  if (!files::create_directory(path, error)) fail("cannot make the folder " + shown(path) + ": " + error.message());
  made_ = true;
  unfinished_folder = path_.c_str();
}

Folder::~Folder() {
  std::error_code error;
  if (made_) files::remove(path_, error);
  unfinished_folder = nullptr;
}

void Folder::keep() {
  made_ = false;
  unfinished_folder = nullptr;
}

std::string Folder::file(const std::string& name) const { return (files::path(path_) / name).string(); }

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

// Signals wait while there is one.
class SignalsWait {
 public:
  SignalsWait() {
    sigset_t ours;
    sigemptyset(&ours);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&ours, signal);
    sigprocmask(SIG_BLOCK, &ours, &before_);
  }
  ~SignalsWait() { sigprocmask(SIG_SETMASK, &before_, nullptr); }
  SignalsWait(const SignalsWait&) = delete;
  SignalsWait& operator=(const SignalsWait&) = delete;

 private:
  sigset_t before_;
};

// Opens a new file in the same folder, so that renaming it is one step. A signal finds no file that is not on the list.
void Output::open_beside(const std::string& path) {
  const std::string begin = (files::path(path_).parent_path() / ".dapple-").string() + std::to_string(getpid()) + "-";
  const SignalsWait until_listed;
  for (int attempt = 0; file_ == nullptr; ++attempt) {
    temporary_ = begin + std::to_string(attempt) + ".part";
    file_ = std::fopen(temporary_.c_str(), "wbx");
    if (file_ != nullptr || (errno == EEXIST && attempt < 100)) continue;
    temporary_.clear();
    cannot_write(path, std::strerror(errno));
  }
  next_ = unfinished_;
  unfinished_ = this;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    if (std::signal(signal, remove_and_end) == SIG_IGN) std::signal(signal, SIG_IGN);
}

Output::~Output() {
  if (file_ != nullptr && file_ != stdout) std::fclose(file_);
  if (temporary_.empty()) return;
  std::remove(temporary_.c_str());
  forget();
}

// A signal does not look for the temporary file any more.
void Output::forget() {
  Output** link = &unfinished_;
  while (*link != this) link = &(*link)->next_;
  *link = next_;
  temporary_.clear();
}

void Output::write(const void* bytes, size_t count) {
  if (error_ == 0 && std::fwrite(bytes, 1, count, file_) != count) error_ = errno;
}

// All is written, or the reason is told.
void Output::close() {
  if (std::fflush(file_) != 0 && error_ == 0) error_ = errno;
  if (file_ != stdout && std::fclose(file_) != 0 && error_ == 0) error_ = errno;
  file_ = nullptr;
  if (error_ != 0) cannot_write(path_ == "-" ? "standard output" : path_, std::strerror(error_));
}

// 0, or errno.
int Output::name() {
  if (temporary_.empty()) return 0;
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) return errno;
  forget();
  return 0;
}

void Output::finish() {
  close();
  if (const int error = name()) cannot_write(path_, std::strerror(error));
}

void Output::finish_all(const std::vector<std::unique_ptr<Output>>& all) {
  for (const std::unique_ptr<Output>& one : all) one->close();
  size_t named = 0;
  int error = 0;
  {
    const SignalsWait until_all_are_named;
    while (named < all.size() && (error = all[named]->name()) == 0) ++named;
    for (size_t i = 0; error != 0 && i < named; ++i) std::remove(all[i]->path_.c_str());
  }
  if (error != 0) cannot_write(all[named]->path_, std::strerror(error));
}

void finish_standard_output() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout)) fail("cannot write standard output");
}

}  // namespace cli
