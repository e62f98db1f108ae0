// A crew of threads that do one piece of work together: the caller is one of them.
// SPDX-License-Identifier: MIT
#pragma once
#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace dapple::desktop {

class Crew {
 public:
  explicit Crew(unsigned size);
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  unsigned size() const { return static_cast<unsigned>(threads_.size()) + 1; }
  // Calls work(0) .. work(size - 1), each on a thread of its own; returns when all have come back.
  void all(const std::function<void(unsigned)>& work);

 private:
  void serve(unsigned index);

  const int looks_;
  std::vector<std::thread> threads_;
  const std::function<void(unsigned)>* work_ = nullptr;
  std::atomic<uint32_t> round_{0}, left_{0};
  std::atomic<bool> over_{false};
  std::mutex mutex_;
  std::condition_variable begun_, ended_;
};

}  // namespace dapple::desktop
