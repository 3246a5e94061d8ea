// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/files/description_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <tuple>

#include "symbolic/files/limits.h"
#include "symbolic/files/readable.h"

namespace sinew {
namespace {

std::string joined(const std::vector<std::string>& messages) {
  std::string text;
  for (const std::string& message : messages) text += (text.empty() ? "" : "\n") + message;
  return text;
}

}  // namespace

DescriptionError::DescriptionError(std::vector<std::string> messages)
    : std::runtime_error(joined(messages)), messages_(std::move(messages)) {}

std::string to_text(const SourceLocation& where) {
  const std::string file = readable_line(where.file);
  if (where.line == 0) return file;
  return fmt::format("{}:{}:{}", file, where.line, where.column);
}

void Findings::add(const SourceLocation& where, std::string_view wrong, std::string_view expected) {
  std::string text = fmt::format("{}: {}; {}", to_text(where), wrong, expected);
  if (!known_.insert(std::hash<std::string>{}(text)).second) return;
  ++count_;
  if (entries_.size() == limits::shown_mistakes) return;
  entries_.push_back({where, fmt::format("{}: {}; {}", to_text(where), message_part(wrong),
                                         message_part(expected))});
}

void Findings::raise_if_any() const {
  if (entries_.empty()) return;
  std::vector<Entry> sorted = entries_;
  std::vector<std::string> files;  // in the order in which they were first complained about
  for (const Entry& entry : sorted)
    if (std::find(files.begin(), files.end(), entry.where.file) == files.end())
      files.push_back(entry.where.file);
  const auto place = [&](const Entry& entry) {
    const auto file = std::find(files.begin(), files.end(), entry.where.file);
    return std::make_tuple(file - files.begin(), entry.where.line, entry.where.column);
  };
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const Entry& a, const Entry& b) { return place(a) < place(b); });
  std::vector<std::string> messages;
  for (Entry& entry : sorted) messages.push_back(std::move(entry.text));
  if (count_ > messages.size())
    messages.push_back(fmt::format("{}: and {} more mistakes; mend these first",
                                   to_text({files.back(), 0, 0}), count_ - messages.size()));
  throw DescriptionError(std::move(messages));
}

}  // namespace sinew
