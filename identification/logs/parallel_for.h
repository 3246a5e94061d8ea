// SPDX-License-Identifier: GPL-3.0-or-later
// body(i) for i = 0..count-1 on some threads; the first exception is passed on.
#pragma once

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace sinew::diagnosis {

/// As many threads as the machine has.
inline constexpr int kAllThreads = 0;

/// Whether this thread runs a body.
inline thread_local bool within_parallel_for = false;

/// Within a body of another one it stays on its thread: the machine is busy as it is.
template <typename Body>
void parallel_for(int count, int threads, const Body& body) {
  if (threads == kAllThreads) threads = static_cast<int>(std::thread::hardware_concurrency());
  if (within_parallel_for) threads = 1;
  std::atomic<int> next{0};
  std::exception_ptr failure;
  std::mutex guard;
  const auto work = [&] {
    const bool was_within = std::exchange(within_parallel_for, true);
    for (int i = next++; i < count; i = next++) {
      try {
        body(i);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(guard);
        if (!failure) failure = std::current_exception();
        next = count;
      }
    }
    within_parallel_for = was_within;
  };
  std::vector<std::thread> others;
  for (int t = 1; t < threads && t < count; ++t) others.emplace_back(work);
  work();
  for (std::thread& other : others) other.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace sinew::diagnosis
