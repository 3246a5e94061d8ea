// SPDX-License-Identifier: GPL-3.0-or-later
// What must not be left behind by a run that is interrupted (Ctrl-C, kill, a closed terminal).
#pragma once

#include <filesystem>
#include <functional>

namespace sinew {

/// A file or folder that goes away with an interrupted run, for as long as this object lives. The
/// object itself removes nothing.
class RemovedIfInterrupted {
 public:
  /// `make` makes the file or folder and returns its path; no interruption comes in between. What
  /// it throws is passed on. It may not make another object of this class.
  explicit RemovedIfInterrupted(const std::function<std::filesystem::path()>& make);
  ~RemovedIfInterrupted();
  RemovedIfInterrupted(const RemovedIfInterrupted&) = delete;
  RemovedIfInterrupted& operator=(const RemovedIfInterrupted&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// While it lives an interruption waits: for steps that are short and leave things whole only
/// together. No RemovedIfInterrupted may begin or end meanwhile in the same thread.
class NotInterrupted {
 public:
  NotInterrupted();
  ~NotInterrupted();
  NotInterrupted(const NotInterrupted&) = delete;
  NotInterrupted& operator=(const NotInterrupted&) = delete;
};

/// From here on SIGINT, SIGTERM and SIGHUP remove what is registered, with all below it, before
/// they end the process as they always do. A signal that the process was started to ignore stays
/// so. For a program's main(), once; a library leaves signals alone.
void remove_when_interrupted();

/// Does not return where such a signal has come: the process ends by it. To be called before a
/// program complains of what the signal broke off, and before it ends by itself.
void end_if_interrupted();

}  // namespace sinew
