// SPDX-License-Identifier: GPL-3.0-or-later
// An output folder is the old one or the new one, whatever happens while it is written.
#include <catch2/catch.hpp>

#include <signal.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <functional>
#include <thread>

#include "tests/generator/lettered_files.h"
#include "tests/generator/traced_writing.h"
#include "tests/reference/random_numbers.h"
#include "tests/reference/temporary_folder.h"
#include "tests/skip.h"

using namespace sinew;
using reference::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

using Writer = std::function<void(const fs::path&, const FileSet&)>;
constexpr std::size_t big = 1000000;

/// What a careless program does.
void write_in_place(const fs::path& folder, const FileSet& files) {
  for (const auto& [name, content] : files) {
    std::ofstream(folder / name, std::ios::binary) << content;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

/// How trials with a process killed while it writes ended.
struct Outcomes {
  int old = 0, replaced = 0, mixed = 0, killed = 0;
};

/// Runs `write` in a child that is killed after `delay`; true where the kill came before its end.
bool killed_after(const std::function<void()>& write, std::chrono::microseconds delay) {
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    write();
    ::_exit(0);
  }
  std::this_thread::sleep_for(delay);
  ::kill(child, SIGKILL);
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  return WIFSIGNALED(status);
}

Outcomes kill_writers(const Writer& write, int trials) {
  const TemporaryFolder place;
  const fs::path folder = place.path() / "output";
  const FileSet before = lettered_files('o', big), after = lettered_files('n', big);
  replace_folder(folder, before);
  const auto start = std::chrono::steady_clock::now();
  write(folder, before);
  const std::chrono::duration<double, std::micro> whole = std::chrono::steady_clock::now() - start;
  reference::RandomNumbers random(7);
  Outcomes outcomes;
  for (int i = 0; i < trials; ++i) {
    const auto delay = static_cast<long>(random.uniform(0.0, 1.3 * whole.count()));
    outcomes.killed +=
        killed_after([&] { write(folder, after); }, std::chrono::microseconds(delay));
    const FileSet now = files_in(folder);
    ++(now == before ? outcomes.old : now == after ? outcomes.replaced : outcomes.mixed);
    if (now != before && now != after) fs::remove_all(folder);  // its manifest may be cut short
    replace_folder(folder, before);
    CHECK(files_in(folder) == before);
    CHECK(entries_in(place.path()) == 1);  // what the killed process left is gone
  }
  return outcomes;
}

std::vector<std::string> writing(const fs::path& folder, const std::string& limit = "") {
  std::vector<std::string> command{SINEW_WRITE_FOLDER, folder.string(), "n"};
  if (!limit.empty()) command.push_back(limit);
  return command;
}

std::string error_of(const fs::path& folder, const FileSet& files) {
  try {
    replace_folder(folder, files);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

/// Checks that a failed write of 'n' over a folder of 'o' left nothing but the old folder.
void check_untouched(const fs::path& parent) {
  CHECK(files_in(parent / "output") == lettered_files('o'));
  CHECK(entries_in(parent) == 1);
}

}  // namespace

TEST_CASE("killed at a random moment, the old or the new output stands whole") {
  const Outcomes outcomes = kill_writers(replace_folder, 60);
  CHECK(outcomes.mixed == 0);
  CHECK(outcomes.old > 0);
  CHECK(outcomes.killed > 10);
}

TEST_CASE("planted: writing in place is seen to leave a mixture") {
  CHECK(kill_writers(write_in_place, 40).mixed > 0);
}

TEST_CASE("killed at every system call of the writing, the old or the new output stands whole") {
  if (!strace_works())
    return sinew::test::skip("strace cannot trace here: only random moments are tested");
  const TemporaryFolder place;
  const fs::path folder = place.path() / "output";
  int killed = 0, old = 0, replaced = 0;
  for (const char* call : {"openat", "write", "fsync", "close", "mkdir", "renameat2", "unlinkat"})
    for (int count = 1; count <= 60; ++count) {
      replace_folder(folder, lettered_files('o'));
      if (!inject(call, "signal=SIGKILL", count, folder).happened) break;
      INFO(call << " " << count);
      const FileSet now = files_in(folder);
      CHECK((now == lettered_files('o') || now == lettered_files('n')));
      ++killed;
      ++(now == lettered_files('o') ? old : replaced);
    }
  CHECK(killed >= 20);
  CHECK(old > 0);
  CHECK(replaced > 0);
  replace_folder(folder, lettered_files('o'));
  check_untouched(place.path());
}

TEST_CASE("every system call that fails leaves the old output and says so") {
  if (!strace_works() || !writes_may_fail()) return sinew::test::skip("strace cannot trace here");
  const TemporaryFolder place;
  const fs::path folder = place.path() / "output";
  for (const auto& [call, error] : std::vector<std::pair<std::string, std::string>>{
           {"write", "ENOSPC"}, {"fsync", "EIO"}, {"mkdir", "EACCES"}, {"renameat2", "EIO"}})
    for (int count = 1; count <= 5; ++count) {
      replace_folder(folder, lettered_files('o'));
      const Injected injected = inject(call, "error=" + error, count, folder);
      INFO(call << " " << count);
      if (!injected.happened) {
        CHECK(count > 1);
        break;
      }
      CHECK(injected.status == 1);
      check_untouched(place.path());
    }
}

TEST_CASE(
    "without an exchange of folders two renames do it, and the old output survives an end "
    "between") {
  if (!strace_works()) return sinew::test::skip("strace cannot trace here");
  const TemporaryFolder place;
  const fs::path folder = place.path() / "output";
  const std::string no_exchange = "inject=renameat2:error=EINVAL";
  replace_folder(folder, lettered_files('o'));
  CHECK(inject("renameat2", "error=EINVAL", 1, folder).status == 0);
  CHECK(files_in(folder) == lettered_files('n'));
  CHECK(entries_in(place.path()) == 1);
  const std::vector<std::string> more{"-e", "trace=rename,renameat2", "-e", no_exchange};
  replace_folder(folder, lettered_files('o'));
  CHECK(inject("rename", "error=EACCES", 1, folder, more).status == 1);
  check_untouched(place.path());
  CHECK(inject("rename", "error=EACCES", 2, folder, more).status == 1);
  check_untouched(place.path());
  CHECK(inject("rename", "signal=SIGKILL", 2, folder, more).happened);
  CHECK(!fs::exists(folder));  // the end came between the two
  CHECK(error_of(folder, {{"a", "b"}}).empty());
  CHECK(entries_in(place.path()) == 1);
}

TEST_CASE("an old output that was set aside is put back before anything is judged") {
  const TemporaryFolder place;
  const fs::path folder = place.path() / "output";
  const fs::path aside = place.path() / ".output.0badcafe.gone";
  replace_folder(folder, lettered_files('o'));
  reference::write_text(folder / "thesis.txt", "years");
  fs::rename(folder, aside);
  reference::write_text(place.path() / ".sinew-0badcafe", "");
  fs::permissions(place.path() / ".sinew-0badcafe", fs::perms::owner_read | fs::perms::owner_write);
  CHECK_FALSE(
      error_of(folder, lettered_files('n')).empty());  // a foreign file is in the old output
  CHECK(fs::exists(folder / "thesis.txt"));
  CHECK_FALSE(fs::exists(aside));
}

TEST_CASE("a file that may not grow leaves the old output") {
  const TemporaryFolder place;
  const fs::path folder = place.path() / "output";
  replace_folder(folder, lettered_files('o'));
  for (const char* limit : {"0", "5", "1000", "199999"}) {
    std::string output;
    CHECK(reference::run_program(writing(folder, limit), output) == 1);
    // The output is a file too: it holds the message where the limit leaves room for it.
    if (std::string(limit).size() > 3) CHECK(output.find("cannot be written") != std::string::npos);
    check_untouched(place.path());
  }
  std::string output;
  CHECK(reference::run_program(writing(folder, "200000"), output) == 0);
  CHECK(files_in(folder) == lettered_files('n'));
}

TEST_CASE("a full file system leaves the old output") {
  const TemporaryFolder place;
  if (::mount("tmpfs", place.path().c_str(), "tmpfs", 0, "size=450k") != 0)
    return sinew::test::skip("a small file system cannot be mounted here");
  const fs::path folder = place.path() / "output";
  replace_folder(folder, lettered_files('o'));  // fits once, not twice
  const std::string error = error_of(folder, lettered_files('n'));
  CHECK(error.find("No space left") != std::string::npos);
  check_untouched(place.path());
  CHECK(::umount(place.path().c_str()) == 0);
}

TEST_CASE("a parent that may not be written leaves the old output") {
  const TemporaryFolder place;
  replace_folder(place.path() / "output", lettered_files('o'));
  const auto readable = fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read |
                        fs::perms::others_exec;
  fs::permissions(place.path(), readable);
  const pid_t child = ::fork();
  if (child == 0) {  // root may write everywhere, nobody may not
    if (::geteuid() == 0 && ::setuid(65534) != 0) ::_exit(2);
    const std::string error = error_of(place.path() / "output", lettered_files('n'));
    ::_exit(error.find("ermission denied") != std::string::npos ? 0 : 1);
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  CHECK((WIFEXITED(status) && WEXITSTATUS(status) == 0));
  fs::permissions(place.path(), fs::perms::owner_all);
  check_untouched(place.path());
}

TEST_CASE("a folder with a file that is not ours is refused and untouched") {
  const TemporaryFolder place;
  const fs::path folder = place.path() / "output";
  replace_folder(folder, lettered_files('o'));
  reference::write_text(folder / "notes.txt", "mine");
  const std::string error = error_of(folder, lettered_files('n'));
  CHECK(error.find("notes.txt") != std::string::npos);
  fs::remove(folder / "notes.txt");
  check_untouched(place.path());
  // Planted defect: folders in it not looked into: "years" were gone.
  for (const char* foreign : {"host/notes.txt", "thesis/chapter.c", "host/host/e.c"}) {
    fs::create_directories((folder / foreign).parent_path());
    reference::write_text(folder / foreign, "years");
    CHECK(error_of(folder, lettered_files('n')).find(fs::path(foreign).parent_path().string()) !=
          std::string::npos);
    CHECK(reference::read_text(folder / foreign) == "years");
    fs::remove_all(folder / (foreign[0] == 't' ? "thesis" : foreign));
    fs::remove(folder / "host" / "host");
  }
  check_untouched(place.path());

  fs::create_directory(place.path() / "foreign");
  reference::write_text(place.path() / "foreign" / "a.c", "mine");
  CHECK(error_of(place.path() / "foreign", lettered_files('n')).find("a.c") != std::string::npos);
  reference::write_text(place.path() / "plain", "mine");
  CHECK(error_of(place.path() / "plain", lettered_files('n')).find("not a folder") !=
        std::string::npos);
  CHECK(entries_in(place.path()) == 3);
}

TEST_CASE("files that are no longer emitted go") {
  const TemporaryFolder place;
  const fs::path folder = place.path() / "output";
  replace_folder(folder, lettered_files('o'));
  FileSet fewer = lettered_files('n');
  fewer.erase("c.c");
  replace_folder(folder, fewer);
  CHECK(files_in(folder) == fewer);
}

TEST_CASE("what an older version wrote beside the other files goes from there") {
  const TemporaryFolder place;
  const fs::path folder = place.path() / "output";
  FileSet before = lettered_files('o');
  before["e.c"] = before.extract("host/e.c").mapped();
  std::string& manifest = before["manifest.json"];
  manifest.replace(manifest.find("host/e.c"), 8, "e.c");
  replace_folder(folder, before);
  REQUIRE(files_in(folder) == before);
  CHECK(error_of(folder, lettered_files('n')) == "");
  CHECK(files_in(folder) == lettered_files('n'));
}

TEST_CASE("a folder differs where one in it does") {
  // Planted defect: folders in it not looked into: what is there without being asked for is none.
  const TemporaryFolder place;
  const fs::path folder = place.path() / "output";
  const FileSet files = lettered_files('o');
  replace_folder(folder, files);
  CHECK(difference(folder, files).empty());
  reference::write_text(folder / "host" / "more.c", "int more;\n");
  CHECK(difference(folder, files).find("a/output/host/more.c") != std::string::npos);
  fs::remove_all(folder / "host");
  CHECK(difference(folder, files).find("b/output/host/e.c") != std::string::npos);
}

TEST_CASE("relative, nested and unusual paths name the folder they name everywhere else") {
  const TemporaryFolder place;
  const fs::path before = fs::current_path();
  fs::current_path(place.path());
  const FileSet o = lettered_files('o'), n = lettered_files('n');
  for (const char* path : {"plain", "./dotted", "a/b/c", "trailing/", "twice//", "up/../beside",
                           "inner/.", "x/y/..", "with space"}) {
    INFO(path);
    REQUIRE(error_of(path, o) == "");
    REQUIRE(error_of(path, n) == "");
    const fs::path meant = (place.path() / path).lexically_normal();
    CHECK(files_in(meant) == n);
    for (const auto& entry : fs::recursive_directory_iterator(place.path()))
      CHECK(entry.path().filename().string().find(".sinew-") == std::string::npos);
  }
  fs::create_directory_symlink("plain", "link");
  replace_folder("link", o);
  CHECK(fs::is_symlink("link"));
  CHECK(files_in("plain") == o);
  fs::create_directory("here");
  fs::current_path("here");
  CHECK(error_of(".", o) == "");
  CHECK(files_in(place.path() / "here") == o);
  fs::current_path(before);
}
