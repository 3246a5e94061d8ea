// SPDX-License-Identifier: GPL-3.0-or-later
// Mistakes found in a description: collected, each with its place, and reported together.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "symbolic/files/source_location.h"

namespace sinew {

/// A description that cannot be used. Every message reads
/// `file:line:column: what is wrong; what was expected`.
class DescriptionError : public std::runtime_error {
 public:
  explicit DescriptionError(std::vector<std::string> messages);
  const std::vector<std::string>& messages() const { return messages_; }

 private:
  std::vector<std::string> messages_;
};

/// `file:line:column`, escaped, or the file alone where the line is unknown (0).
std::string to_text(const SourceLocation& where);

/// Collects mistakes while a description is read, so that one run shows them all.
class Findings {
 public:
  /// One mistake; the same mistake at the same place is kept once. What text from outside brings
  /// with it is escaped and shortened (message_part), and of very many mistakes the first are kept
  /// (limits::shown_mistakes) and the others counted.
  void add(const SourceLocation& where, std::string_view wrong, std::string_view expected);
  bool any() const { return !entries_.empty(); }
  std::size_t count() const { return count_; }
  /// Throws DescriptionError with all messages, in the order of the files' lines, if there are any.
  void raise_if_any() const;

 private:
  struct Entry {
    SourceLocation where;
    std::string text;
  };
  std::vector<Entry> entries_;
  std::unordered_set<std::size_t> known_;  ///< hashes of the texts, those not kept as well
  std::size_t count_ = 0;
};

}  // namespace sinew
