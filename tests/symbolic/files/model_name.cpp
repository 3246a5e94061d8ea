// SPDX-License-Identifier: GPL-3.0-or-later
// Names of models whose emitted files would hide a header, or break the emitted C.
#include "symbolic/files/model_name.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <sstream>

#include "symbolic/files/identifier.h"

using namespace sinew;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> words(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> all;
  for (std::string word; in >> word;) all.push_back(word);
  return all;
}

/// Headers of a folder of the project, without their ending.
std::vector<std::string> headers_of(const char* folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(fs::path(SINEW_SOURCE_DIR) / folder))
    if (entry.path().extension() == ".h") names.push_back(entry.path().stem().string());
  return names;
}

void check_refused(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    INFO(name);
    CHECK(why_not_model_name(name));
    // What is suggested instead, and what an import takes, is fine.
    CHECK(!why_not_model_name(make_model_name(name)));
    CHECK(model_name_rule(name).starts_with("expected "));
  }
}

}  // namespace

TEST_CASE("no model is called like a standard header", "[model name]") {
  const std::string c11 =
      "assert complex ctype errno fenv float inttypes iso646 limits locale math setjmp signal "
      "stdalign stdarg stdatomic stdbool stddef stdint stdio stdlib stdnoreturn string tgmath "
      "threads time uchar wchar wctype";
  const std::string cpp20 =
      "algorithm any array atomic barrier bit bitset charconv chrono codecvt compare complex "
      "concepts condition_variable coroutine deque exception execution filesystem format "
      "forward_list fstream functional future initializer_list iomanip ios iosfwd iostream istream "
      "iterator latch limits list locale map memory memory_resource mutex new numbers numeric "
      "optional ostream queue random ranges ratio regex scoped_allocator semaphore set "
      "shared_mutex "
      "source_location span sstream stack stdexcept stop_token streambuf string string_view "
      "strstream syncstream system_error thread tuple type_traits typeindex typeinfo unordered_map "
      "unordered_set utility valarray variant vector version cassert cctype cerrno cfenv cfloat "
      "cinttypes climits clocale cmath csetjmp csignal cstdarg cstddef cstdint cstdio cstdlib "
      "cstring ctime cuchar cwchar cwctype";
  check_refused(words(c11));
  check_refused(words(cpp20));
  check_refused({"Math", "STDINT"});  // a file system may know no capitals
}

// Planted: a header added to firmware/ that model_name.cpp does not name turned this red.
TEST_CASE("no model is called like a header of the runtime or of the boards", "[model name]") {
  check_refused(headers_of("runtime"));
  check_refused(headers_of("firmware"));
  check_refused({"sinew", "sinew_anything", "Sinew_x", "index_batch", "index_catalogue"});
}

TEST_CASE("words of C and C++ and reserved names are no names", "[model name]") {
  check_refused(
      words("int double restrict class operator typename co_await and xor_eq NULL main "
            "_X _x __x a__b 9a"));
  for (const char* name : {"_X", "__x", "a__b", "class", "restrict", ""})
    CHECK(why_not_identifier(name));
  for (const char* name :
       {"index", "wrist", "hand_2", "my_string", "mathematics", "thumb_table_5_2"})
    CHECK(!why_not_model_name(name));
  CHECK(make_model_name("my-robot 2") == "my_robot_2");
  CHECK(make_model_name("string") == "string_model");
  // A joint or a tendon is no file.
  for (const char* name : {"string", "limits", "port"}) CHECK(!why_not_identifier(name));
}
