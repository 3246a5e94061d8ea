// SPDX-License-Identifier: GPL-3.0-or-later
// Outputs in several folders are all old or all new, whatever happens while they are put in place.
#include "generator/outputs/outputs.h"

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "generator/outputs/unfinished_run.h"
#include "tests/generator/put_outputs.h"
#include "tests/generator/traced_writing.h"
#include "tests/reference/temporary_folder.h"
#include "tests/skip.h"

using namespace sinew;
using reference::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

bool is_hidden(const fs::path& relative) {
  for (const fs::path& part : relative)
    if (part.string().front() == '.') return true;
  return false;
}

/// All files below, by relative path; what a run keeps beside its targets only where asked.
FileSet tree(const fs::path& place, bool hidden) {
  FileSet files;
  for (const auto& entry : fs::recursive_directory_iterator(place)) {
    const fs::path relative = entry.path().lexically_relative(place);
    if (entry.is_regular_file() && is_hidden(relative) == hidden)
      files[relative.string()] = reference::read_text(entry.path());
  }
  return files;
}

/// A model, a report that somebody has put something beside, and C, all of one letter.
class Place {
 public:
  Place() {
    fs::create_directory(path() / "model");
    fs::create_directory(path() / "found");
    reference::write_text(path() / "found" / "thesis.txt", "years");
    put('n');
    after_ = tree(path(), false);
    put('o');
    before_ = tree(path(), false);
  }
  fs::path path() const { return place_.path(); }
  void put(char letter) const { put_outputs(path(), letter); }
  bool is_old() const { return tree(path(), false) == before_; }
  bool is_new() const { return tree(path(), false) == after_; }
  bool is_clean() const { return tree(path(), true).empty(); }
  void recover_all() const {
    for (const char* folder : {"model", "found", "found/generated"})
      recover_interrupted(path() / folder);
  }

 private:
  TemporaryFolder place_;
  FileSet before_, after_;
};

const std::vector<std::string> no_exchange{"-e", "trace=rename,renameat2", "-e",
                                           "inject=renameat2:error=EINVAL"};

/// How ends by force at each of a kind of system call left the outputs.
struct Ends {
  int old = 0, replaced = 0, mixed_before_recovery = 0;
};

/// Kills the writing at its first, second, ... call. The folder that is looked at next changes.
void kill_at_every(const std::string& call, const std::vector<std::string>& more, Ends& ends) {
  const Place place;
  const char* next[] = {"model", "found", "found/generated"};
  for (int count = 1; count <= 80; ++count) {
    place.put('o');
    const Injected injected =
        inject(call, "signal=SIGKILL", count, place.path(), more, SINEW_PUT_OUTPUTS);
    if (!injected.happened) return;
    INFO(call << " " << count);
    ends.mixed_before_recovery += !place.is_old() && !place.is_new();
    recover_interrupted(place.path() / next[count % 3]);
    CHECK((place.is_old() || place.is_new()));
    ++(place.is_old() ? ends.old : ends.replaced);
    place.recover_all();
    CHECK((place.is_old() || place.is_new()));
    CHECK(place.is_clean());
  }
}

}  // namespace

TEST_CASE("killed at any system call, all outputs are old or new when the next run has looked",
          "[slow]") {
  if (!strace_works()) {
    sinew::test::skip("strace cannot trace here");
    return;
  }
  // Planted defect: no journal in Outputs::commit(): neither after "rename 2" and "rename 3" (the
  // model, the model and the findings alone), nor after "renameat2 1".
  Ends ends;
  for (const char* call : {"openat", "write", "fsync", "mkdir", "link", "rename", "renameat2",
                           "ftruncate", "unlink", "unlinkat", "flock"})
    kill_at_every(call, {}, ends);
  kill_at_every("rename", no_exchange, ends);
  CHECK(ends.old > 20);
  CHECK(ends.replaced > 3);
  CHECK(ends.mixed_before_recovery > 2);  // there was something to put right
}

TEST_CASE("whatever call fails while outputs are put in place, all are old and it says so") {
  if (!strace_works() || !writes_may_fail()) {
    sinew::test::skip("strace cannot trace here");
    return;
  }
  // Planted defect: no undo() in Outputs::commit(): mixed after "rename 2", "rename 3", "renameat2
  // 1", and new with status 1 after "ftruncate 1".
  const Place place;
  int failed = 0;
  for (const auto& [call, error] :
       std::vector<std::pair<std::string, std::string>>{{"write", "ENOSPC"},
                                                        {"fsync", "EIO"},
                                                        {"mkdir", "EACCES"},
                                                        {"link", "EPERM"},
                                                        {"rename", "EBUSY"},
                                                        {"renameat2", "EIO"},
                                                        {"ftruncate", "EIO"}})
    for (int count = 1; count <= 60; ++count) {
      place.put('o');
      const Injected injected =
          inject(call, "error=" + error, count, place.path(), {}, SINEW_PUT_OUTPUTS);
      if (!injected.happened) break;
      INFO(call << " " << count);
      // Not every file system has second names or flushes folders: that alone is no failure.
      CHECK((injected.status == 1 ? place.is_old() : place.is_new()));
      CHECK((injected.status == 0 || injected.status == 1));
      CHECK(place.is_clean());
      failed += injected.status == 1;
    }
  CHECK(failed > 20);
  for (const int which : {3, 4, 5}) {  // the folder of C makes way and comes back
    place.put('o');
    CHECK(inject("rename", "error=EACCES", which, place.path(), no_exchange, SINEW_PUT_OUTPUTS)
              .status == 1);
    CHECK(place.is_old());
    CHECK(place.is_clean());
  }
}

TEST_CASE("a run that lives keeps its drafts, one that ended does not, and nobody else's go") {
  const TemporaryFolder place;
  UnfinishedRun alive;
  alive.enter(place.path() / "a.csv");
  const fs::path draft = beside(place.path() / "a.csv", alive.name(), Beside::draft);
  reference::write_text(draft, "half");
  const pid_t child = ::fork();
  if (child == 0) {
    UnfinishedRun dead;
    dead.enter(place.path() / "a.csv");
    reference::write_text(beside(place.path() / "a.csv", dead.name(), Beside::draft), "half");
    ::_exit(0);
  }
  REQUIRE(::waitpid(child, nullptr, 0) == child);
  // Somebody else may write this one, so that it is not believed.
  const fs::path planted = place.path() / ".sinew-00000000", victim = place.path() / "victim";
  reference::write_text(victim, "mine");
  reference::write_text(planted, std::string("new file victim\0all\0", 20));
  ::chmod(planted.c_str(), 0666);
  reference::write_text(place.path() / ".a.csv.swp", "an editor's");
  CHECK(entries_in(place.path()) == 7);
  recover_interrupted(place.path());
  CHECK(entries_in(place.path()) == 5);
  CHECK(fs::exists(draft));
  CHECK(fs::exists(victim));
}

TEST_CASE("a journal that came with a folder reaches no folder beside it") {
  // Planted defect: undo() without its look for the run's note: "precious" was gone.
  const TemporaryFolder place;
  fs::create_directory(place.path() / "model");
  reference::write_text(place.path() / "precious", "years");
  const fs::path note = place.path() / "model" / ".sinew-00000000";
  reference::write_text(note, std::string("new file ../precious\0all\0", 25));
  fs::permissions(note, fs::perms::owner_read | fs::perms::owner_write);
  recover_interrupted(place.path() / "model");
  CHECK(fs::exists(place.path() / "precious"));
  CHECK(!fs::exists(note));
}

TEST_CASE("a folder that moved with its neighbours after an end by force is put right there") {
  if (!strace_works()) {
    sinew::test::skip("strace cannot trace here");
    return;
  }
  const Place place;
  const TemporaryFolder elsewhere;
  place.put('o');
  REQUIRE(inject("rename", "signal=SIGKILL", 2, place.path(), {}, SINEW_PUT_OUTPUTS).happened);
  REQUIRE_FALSE(place.is_old());
  const FileSet expected = [] {
    const Place other;
    return tree(other.path(), false);
  }();
  fs::copy(place.path(), elsewhere.path() / "moved", fs::copy_options::recursive);
  fs::rename(place.path() / "model", place.path() / "away");  // the first place is no longer there
  recover_interrupted(elsewhere.path() / "moved" / "found");
  CHECK(tree(elsewhere.path() / "moved", false) == expected);
}

TEST_CASE("permissions of a file that is replaced stay; one that may not be written is refused") {
  const TemporaryFolder place;
  const fs::path file = place.path() / "run.csv";
  write_output(file, "one");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  write_output(file, "two");
  CHECK(reference::read_text(file) == "two");
  CHECK((fs::status(file).permissions() & fs::perms::mask) ==
        (fs::perms::owner_read | fs::perms::owner_write));
  CHECK(entries_in(place.path()) == 1);
}

TEST_CASE("what goes into a folder brings the folders that are missing in it") {
  // Planted defect: the folder of a file taken for there: "nothing can be written there".
  const TemporaryFolder place;
  Outputs first, second;
  first.into_folder(place.path() / "wrapper", {{"source/a.c", "1"}});
  first.commit();
  second.into_folder(place.path() / "wrapper",
                     {{"source/a.c", "2"}, {"source/host/b.c", "2"}, {"source/host/b.h", "2"}});
  second.commit();
  CHECK(tree(place.path(), false) == FileSet{{"wrapper/source/a.c", "2"},
                                             {"wrapper/source/host/b.c", "2"},
                                             {"wrapper/source/host/b.h", "2"}});
  CHECK(tree(place.path(), true).empty());
}

TEST_CASE("no output is an input that lies deep in the folder that is replaced") {
  // Planted defect: the folders in it not looked into: the input was replaced.
  const TemporaryFolder place;
  const fs::path log = place.path() / "output" / "host" / "e.c";
  replace_folder(place.path() / "output", lettered_files('o'));
  Inputs inputs;
  inputs.add(log);
  Outputs outputs;
  outputs.protect(std::move(inputs));
  CHECK_THROWS_WITH(outputs.folder(place.path() / "output", lettered_files('n')),
                    Catch::Contains("e.c"));
}

TEST_CASE("one place for two outputs is refused before anything is written") {
  const TemporaryFolder place;
  Outputs outputs;
  outputs.file(place.path() / "a", "1");
  CHECK_THROWS_WITH(outputs.file(place.path() / "." / "a", "2"), Catch::Contains("written twice"));
  outputs.folder(place.path() / "new" / "b", {{"x", "1"}});
  outputs.folder(place.path() / "new" / "c", {{"x", "1"}});
  CHECK_THROWS_WITH(outputs.folder(place.path() / "new" / "c", {{"x", "2"}}),
                    Catch::Contains("written twice"));
  outputs.commit();
  CHECK(tree(place.path(), false) == FileSet{{"a", "1"}, {"new/b/x", "1"}, {"new/c/x", "1"}});
  CHECK(tree(place.path(), true).empty());
}
