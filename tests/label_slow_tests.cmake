# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -D PROGRAM=<test program> -D ROOM=<room> -D OUT=<file> -P label_slow_tests.cmake:
# writes what gives the test cases with the tag [slow] the label of that name in CTest, and those with
# [slow][thorough] both labels.
function(tests_with tags result)
  execute_process(COMMAND ${PROGRAM} "${tags}" --list-test-names-only OUTPUT_VARIABLE names
                  RESULT_VARIABLE count)
  if(NOT count MATCHES "^[0-9]+$")  # the number of tests, or a signal's name
    message(FATAL_ERROR "${PROGRAM} does not list its tests: ${count}\n${names}")
  endif()
  string(REGEX MATCHALL "[^\n]+" names "${names}")
  set(${result} "${names}" PARENT_SCOPE)
endfunction()

tests_with("[slow]~[thorough]" slow)
tests_with("[thorough]" thorough)
set(script "")
foreach(name IN LISTS slow)
  string(APPEND script "set_tests_properties([==[${ROOM}:${name}]==] PROPERTIES LABELS slow)\n")
endforeach()
foreach(name IN LISTS thorough)
  string(APPEND script "set_tests_properties([==[${ROOM}:${name}]==] PROPERTIES LABELS [[slow;thorough]])\n")
endforeach()
file(WRITE ${OUT} "${script}")
