// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/files/model_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "symbolic/files/identifier.h"

namespace sinew {
namespace {

// Headers without their ending, lower-case: C11 (7.1.2), C++20 (16.4.2.3) and POSIX.
constexpr std::string_view standard_headers =
    " assert complex ctype errno fenv float inttypes iso646 limits locale math setjmp signal "
    "stdalign stdarg stdatomic stdbool stddef stdint stdio stdlib stdnoreturn string tgmath "
    "threads time uchar wchar wctype "
    " algorithm any array atomic barrier bit bitset cassert ccomplex cctype cerrno cfenv cfloat "
    "charconv chrono cinttypes ciso646 climits clocale cmath codecvt compare concepts "
    "condition_variable coroutine csetjmp csignal cstdalign cstdarg cstdbool cstddef cstdint "
    "cstdio cstdlib cstring ctgmath ctime cuchar cwchar cwctype deque exception execution expected "
    "filesystem flat_map flat_set format forward_list fstream functional future generator "
    "initializer_list iomanip ios iosfwd iostream istream iterator latch list map mdspan memory "
    "memory_resource mutex new numbers numeric optional ostream print queue random ranges ratio "
    "regex scoped_allocator semaphore set shared_mutex source_location span spanstream sstream "
    "stack stacktrace stdexcept stdfloat stop_token streambuf string_view strstream syncstream "
    "system_error thread tuple type_traits typeindex typeinfo unordered_map unordered_set utility "
    "valarray variant vector version "
    " aio cpio dirent dlfcn endian fcntl features fmtmsg fnmatch ftw getopt glob grp iconv "
    "langinfo "
    "libgen libintl malloc monetary mqueue ndbm netdb nl_types poll pthread pwd regexp sched "
    "search "
    "spawn strings stropts syslog tar termios trace ulimit unistd utime utmpx values varargs "
    "wordexp ";

// The runtime's headers all begin with sinew_; these are of the boards' programs (firmware/).
constexpr std::string_view board_headers =
    " console equality evaluation exchange hand_loop mailbox port semihosting states ";

constexpr std::array<std::string_view, 2> emitted_endings{"_batch", "_catalogue"};

std::string in_lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

bool is_word_of(std::string_view words, std::string_view word) {
  return words.find(fmt::format(" {} ", word)) != std::string_view::npos;
}

/// What would be hidden, or nothing.
std::optional<std::string> hidden_by(std::string_view name) {
  const std::string lower = in_lower_case(name);  // some file systems know no other
  if (is_word_of(standard_headers, lower))
    return "is the name of a standard header, which the emitted files would hide";
  if (is_word_of(board_headers, lower)) return "is the name of a header of the boards' programs";
  if (lower == "sinew" || lower.starts_with("sinew_")) return "begins as the runtime's headers do";
  for (const std::string_view ending : emitted_endings)
    if (lower.ends_with(ending))
      return fmt::format("ends with {}, as an emitted file of another model does", ending);
  return std::nullopt;
}

}  // namespace

std::optional<std::string> why_not_model_name(std::string_view name) {
  if (auto why = why_not_identifier(name)) return why;
  return hidden_by(name);
}

std::string model_name_rule(std::string_view name) {
  if (!why_not_identifier(name))
    return fmt::format("expected another name, for instance '{}'", make_model_name(name));
  return std::string(identifier_rule());
}

std::string make_model_name(std::string_view text) {
  std::string name = make_identifier(text);
  if (!hidden_by(name)) return name;
  constexpr std::size_t room_for_ending = 57;
  name = (in_lower_case(name).starts_with("sinew") ? "model_of_" : "") + name;
  name = name.substr(0, room_for_ending);
  while (name.back() == '_') name.pop_back();
  return name + "_model";
}

}  // namespace sinew
