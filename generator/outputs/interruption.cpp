// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/outputs/interruption.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <mutex>
#include <set>
#include <thread>

namespace sinew {
namespace {

namespace fs = std::filesystem;

struct Registry {
  std::mutex mutex;
  std::multiset<fs::path> paths;
};

/// Never destroyed: an interruption may come while the process ends.
Registry& registry() {
  static Registry* const only = new Registry;
  return *only;
}

volatile sig_atomic_t has_come = 0;

int pipe_ends[2] = {-1, -1};  // the handler writes, the thread reads

/// All that may be done in a handler: the rest is the thread's.
void hand_over(int signal) {
  const int error = errno;
  const auto number = static_cast<unsigned char>(signal);
  has_come = 1;
  (void)!::write(pipe_ends[1], &number, 1);
  errno = error;
}

/// Others may still be writing below the path, so that one passage need not do.
void remove_whole(const fs::path& path) {
  for (int attempt = 0; attempt < 20; ++attempt) {
    std::error_code error;
    fs::remove_all(path, error);
    if (!error && !fs::exists(fs::symlink_status(path, error))) return;
    ::usleep(10000);
  }
}

/// The lock is kept to the end: nothing new is made after what is there was removed.
[[noreturn]] void remove_and_end(int signal) {
  registry().mutex.lock();
  for (const fs::path& path : registry().paths) remove_whole(path);
  ::signal(signal, SIG_DFL);
  ::kill(::getpid(), signal);
  for (;;) ::pause();
}

void wait_for_signal() {
  unsigned char number = 0;
  for (;;) {
    const ssize_t got = ::read(pipe_ends[0], &number, 1);
    if (got == 1) remove_and_end(number);
    if (got == 0 || errno != EINTR) return;
  }
}

}  // namespace

RemovedIfInterrupted::RemovedIfInterrupted(const std::function<fs::path()>& make) {
  const std::lock_guard<std::mutex> lock(registry().mutex);
  path_ = fs::absolute(make());
  registry().paths.insert(path_);
}

RemovedIfInterrupted::~RemovedIfInterrupted() {
  const std::lock_guard<std::mutex> lock(registry().mutex);
  registry().paths.erase(registry().paths.find(path_));
}

NotInterrupted::NotInterrupted() {
  registry().mutex.lock();
}

NotInterrupted::~NotInterrupted() {
  registry().mutex.unlock();
}

void end_if_interrupted() {
  while (has_come != 0) ::pause();
}

void remove_when_interrupted() {
  if (::pipe2(pipe_ends, O_CLOEXEC) != 0) return;
  std::thread(wait_for_signal).detach();
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction now {};
    if (::sigaction(signal, nullptr, &now) != 0 || now.sa_handler == SIG_IGN) continue;
    struct sigaction ours {};
    ours.sa_handler = hand_over;
    ours.sa_flags = SA_RESTART;
    ::sigemptyset(&ours.sa_mask);
    ::sigaction(signal, &ours, nullptr);
  }
}

}  // namespace sinew
