// A crew of threads. See crew.hpp.
// SPDX-License-Identifier: MIT
#include "crew.hpp"

namespace dapple::desktop {

// Sweeps follow each other within microseconds: a thread looks so often before it goes to sleep, unless others wait for
// its processor.
constexpr int kLooks = 1000;

static void breathe() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

Crew::Crew(unsigned size) : looks_(size > std::thread::hardware_concurrency() ? 0 : kLooks) {
  for (unsigned i = 1; i < size; ++i) threads_.emplace_back([this, i] { serve(i); });
}

Crew::~Crew() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    over_ = true;
    ++round_;
  }
  begun_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Crew::serve(unsigned index) {
  for (uint32_t seen = 0;;) {
    for (int i = 0; i < looks_ && round_ == seen; ++i) breathe();
    if (round_ == seen) {
      std::unique_lock<std::mutex> lock(mutex_);
      begun_.wait(lock, [&] { return round_ != seen; });
    }
    ++seen;
    if (over_) return;
    (*work_)(index);
    if (--left_ > 0) continue;
    const std::lock_guard<std::mutex> lock(mutex_);
    ended_.notify_one();
  }
}

void Crew::all(const std::function<void(unsigned)>& work) {
  if (threads_.empty()) return work(0);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    work_ = &work;
    left_ = static_cast<uint32_t>(threads_.size());
    ++round_;
  }
  begun_.notify_all();
  work(0);
  for (int i = 0; i < looks_ && left_ > 0; ++i) breathe();
  if (left_ == 0) return;
  std::unique_lock<std::mutex> lock(mutex_);
  ended_.wait(lock, [&] { return left_ == 0; });
}

}  // namespace dapple::desktop
