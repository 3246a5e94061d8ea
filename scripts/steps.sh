# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by the other scripts: runs named steps, says what each does, and keeps its output in a log.
# shellcheck shell=bash

# begin_steps <name> <count>: later steps are numbered [1/<count>]; logs go to build/log/<name>-<n>.log
begin_steps() {
  steps_name=$1
  steps_count=$2
  steps_done=0
  steps_log=
  mkdir -p build/log
}

# step <what it does> <command> [<word>...]: runs the command with its output in the log. The status
# is the command's; on a failure the end of the log is shown.
step() {
  local what=$1 status=0 start=$SECONDS
  shift
  steps_done=$((steps_done + 1))
  steps_log=build/log/$steps_name-$steps_done.log
  printf '[%s/%s] %s\n' "$steps_done" "$steps_count" "$what"
  "$@" >"$steps_log" 2>&1 || status=$?
  if [ "$status" -ne 0 ]; then
    printf '[%s/%s] FAILED with status %s: %s\n' "$steps_done" "$steps_count" "$status" "$what" >&2
    printf '  command: %s\n  its last lines:\n' "$*" >&2
    tail -n 25 "$steps_log" | sed 's/^/    /' >&2
    printf '  log: %s\n' "$steps_log" >&2
    return "$status"
  fi
  printf '      done in %s s\n' "$((SECONDS - start))"
}

# use_ccache: compilers run through ccache where it is installed; objects are the same in every folder.
use_ccache() {
  if command -v ccache >/dev/null; then
    export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
    export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1
    # Without it ccache does not keep sources that use precompiled headers.
    export CCACHE_SLOPPINESS=pch_defines,time_macros
  fi
}

# build_preset <preset> [<target>...]: configures and builds.
build_preset() {
  local preset=$1
  shift
  cmake --preset "$preset"
  cmake --build --preset "$preset" ${1:+--target "$@"}
}
