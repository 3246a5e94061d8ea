// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <unistd.h>

#include "generator/outputs/draft.h"
#include "generator/outputs/outputs.h"
#include "generator/outputs/unfinished_run.h"

namespace sinew {

namespace fs = std::filesystem;

OutputFile::OutputFile(const fs::path& target, const Inputs& inputs)
    : place_(output_place(target)) {
  if (place_.real.empty()) return;
  inputs.refuse(place_.real);
  recover_interrupted(place_.real.parent_path());
  run_ = std::make_unique<UnfinishedRun>();
  run_->enter(place_.real);
  draft_ = new_draft(beside(place_.real, run_->name(), Beside::draft), place_.real);
}

OutputFile::~OutputFile() = default;

void OutputFile::write(std::string_view text) {
  write_all(place_.real.empty() ? place_.stream : draft_, text, place_.shown);
}

void OutputFile::commit() {
  if (place_.real.empty()) return place_.stream.close(place_.shown);
  if (::fsync(draft_.number()) != 0) fail_with_errno(place_.shown, "cannot be written");
  draft_.close(place_.shown);
  run_->end_drafts();
  const NotInterrupted together;
  put_in_place(beside(place_.real, run_->name(), Beside::draft), place_.real, false, run_->name());
  flush_folder(place_.real.parent_path());
  run_.reset();
}

}  // namespace sinew
