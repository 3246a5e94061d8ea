# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced after steps.sh by scripts that run CTest: adds up what passed, failed and was skipped.
# shellcheck shell=bash

# Sums over all runs of CTest, and a line for each skipped test.
passed=0
failed=0
skipped=0
skipped_tests=()

# count_results <JUnit file> <preset> <status of CTest>: adds the file's numbers up.
count_results() {
  local lines good bad not line
  mapfile -t lines < <(awk -f scripts/test_results.awk "$1")
  read -r good bad not <<<"${lines[0]}"
  # CTest may fail for a reason that is no test's.
  if [ "$3" -ne 0 ] && [ "$bad" -eq 0 ]; then bad=1; fi
  passed=$((passed + good))
  failed=$((failed + bad))
  skipped=$((skipped + not))
  printf '      %s passed, %s failed, %s skipped\n' "$good" "$bad" "$not"
  for line in "${lines[@]:1}"; do
    case $line in
      'not run: '*) printf '      %s\n' "$line" ;;
      *) skipped_tests+=("$2, $line") ;;
    esac
  done
}

# run_tests <preset> [<option of CTest>...]: a step that runs CTest; its numbers are added up.
run_tests() {
  local preset=$1 status=0
  local result=build/log/test-$preset.xml
  shift
  rm -f "$result"
  step "testing: $preset" ctest --preset "$preset" -j "$(nproc)" --test-output-size-passed 100000 \
    --output-junit "$PWD/$result" "$@" || status=$?
  if [ -s "$result" ]; then
    count_results "$result" "$preset" "$status"
  else
    failed=$((failed + 1))
  fi
}

# print_results: the skipped tests with their reasons, then the sums.
print_results() {
  local line
  if [ "$skipped" -eq 0 ]; then
    printf '%s passed, %s failed\n' "$passed" "$failed"
    return
  fi
  printf 'skipped:\n'
  for line in "${skipped_tests[@]}"; do printf '  %s\n' "$line"; done
  printf '%s passed, %s failed, %s skipped\n' "$passed" "$failed" "$skipped"
}
