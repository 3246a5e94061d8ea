# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced: begin_wrapper <wrapper> <program> <source folder> <working folder> generates models/index
# with that wrapper into a working folder that is empty otherwise, and goes there.
# shellcheck shell=bash
set -euo pipefail

fail() {
  printf 'FAILED: %s\n' "$1" >&2
  exit 1
}

skip() {
  printf 'skipped: %s\n' "$1"
  exit 77
}

begin_wrapper() {
  wrapper=$1 program=$2 source=$3
  rm -rf "$4"
  mkdir -p "$4"
  cd "$4"
  "$program" generate "$source/models/index" "--$wrapper" >generated.log ||
    { cat generated.log; fail "not generated"; }
  made=wrappers/index/$wrapper
  # Again it is the same, and check says so; what was changed by hand is found.
  "$program" check "$source/models/index" "--$wrapper" >check.log || { cat check.log; fail "check"; }
  local file
  file=$(find "$made" -type f -name '*index*.*' | sort | head -n 1)
  cp "$file" kept
  printf 'more\n' >>"$file"
  if "$program" check "$source/models/index" "--$wrapper" >check.log; then
    fail "an edited $file passes check"
  fi
  grep -q -- '^-more' check.log || fail "the difference is not shown"
  cp kept "$file"
}
